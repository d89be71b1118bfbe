#include "viewer/drawing/scalar_field.h"

#include <algorithm>

namespace aomd::scene {

double FieldScale::at(double part) const {
  return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

Color FieldScale::color(double value) const {
  if (empty() || !std::isfinite(value) || (logarithmic && value <= 0)) return plain_face_color();
  const double span = logarithmic ? std::log(high / low) : high - low;
  const double from_low = logarithmic ? std::log(value / low) : value - low;
  // Where all values are the same a logarithm has no zero to start from.
  const double alone = logarithmic ? 0.5 : 0;
  return ramp_color(static_cast<float>(span > 0 ? std::clamp(from_low / span, 0.0, 1.0) : alone),
                    map);
}

FieldText field_text(Coloring coloring) {
  switch (coloring) {
    case Coloring::Quality:
      return {"Smallest angle",
              "The smallest angle of each face: 60 degrees in a regular triangle.", "degrees"};
    case Coloring::Distance:
      return {
          "Distance to the original",
          "How far the points of each face get from the mesh as loaded, at most, in percent of the "
          "diagonal of its box. Measured at 15 points a face, when nothing runs.",
          "% of the diagonal"};
    case Coloring::Curvature:
      return {"Curvature",
              "The larger principal curvature at each vertex, in 1 / unit of the mesh: 0.1 on a "
              "sphere of "
              "radius 10. The colours follow the logarithm and end where 2 % of the values lie "
              "beyond; flat "
              "faces are grey.",
              "1 / unit of the mesh, logarithmic"};
    default:
      return {"Spacing",
              "How long decimation wants the edges around a vertex to be, in the units of the "
              "mesh: an edge "
              "that is shorter than half of it may collapse. Colours follow its logarithm.",
              "units of the mesh, logarithmic"};
  }
}

}  // namespace aomd::scene
