#include "viewer/scene/vertex_field.h"

#include <algorithm>
#include <cmath>

namespace aomd::scene {

VertexField make_vertex_field(const Mesh& mesh, const Column<Vertex, double>& values) {
  const auto shown = [&](Vertex v) { return values[v] > 0 && std::isfinite(values[v]); };
  VertexField field;
  for (const Vertex v : mesh.vertices()) {
    if (!shown(v)) continue;
    field.low = std::min(field.low, values[v]);
    field.high = std::max(field.high, values[v]);
  }
  auto colors = std::make_shared<Column<Vertex, Color>>(values.size(), plain_face_color());
  const double decades = std::log(field.high / field.low);
  for (const Vertex v : mesh.vertices()) {
    if (!shown(v)) continue;
    const double t = decades > 0 ? std::log(values[v] / field.low) / decades : 0.5;
    (*colors)[v] = ramp_color(static_cast<float>(t));
  }
  field.colors = std::move(colors);
  return field;
}

}  // namespace aomd::scene
