#include "viewer/drawing/scalar_field.h"

#include <algorithm>

#include "viewer/base/text.h"

namespace aomd::scene {

double FieldScale::at(double part) const {
  return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

double FieldScale::part_of(double value) const {
  const double span = logarithmic ? std::log(high / low) : high - low;
  const double from_low = logarithmic ? std::log(value / low) : value - low;
  // Where all values are the same a logarithm has no zero to start from.
  const double alone = logarithmic ? 0.5 : 0;
  return span > 0 ? from_low / span : alone;
}

Color FieldScale::color_at(double part) const {
  part = std::clamp(part, 0.0, 1.0);
  if (steps > 0) part = (std::min(std::floor(part * steps), steps - 1.0) + 0.5) / steps;
  return ramp_color(static_cast<float>(part), map);
}

Color FieldScale::color(double value) const {
  if (empty() || !std::isfinite(value) || (logarithmic && value <= 0)) return plain_face_color();
  return color_at(part_of(value));
}

namespace {

constexpr double widest_log_span = 1e4;  // from the end downward, where values go down to zero

/// Only those that have a colour, sorted.
void keep_colored(std::vector<float>& values, bool logarithmic) {
  std::erase_if(values, [&](float v) { return !std::isfinite(v) || (logarithmic && v <= 0); });
  std::sort(values.begin(), values.end());
}

void take_percentile(FieldScale& scale, double percent, const std::vector<float>& sorted) {
  if (sorted.empty()) return;
  const auto last = static_cast<double>(sorted.size() - 1);
  const auto at = [&](double part) {
    return double{sorted[static_cast<std::size_t>(std::lround(part * last))]};
  };
  scale.low = at(1 - percent / 100);
  scale.high = at(percent / 100);
}

/// A logarithm begins above zero.
void raise_low(FieldScale& scale, const std::vector<float>& sorted) {
  if (scale.low > 0) return;
  const double least = sorted.empty() ? 0 : double{sorted.front()};
  scale.low = std::max(least, scale.high / widest_log_span);
}

/// 1, 2 or 5 times a power of ten: the least that is not below.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double each : {1.0, 2.0, 5.0})
    if (each * power >= value * (1 - 1e-9)) return each * power;
  return 10 * power;
}

void add_even(const FieldScale& scale, int count, std::vector<ScaleTick>& ticks) {
  const double step = round_up((scale.high - scale.low) / count);
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  for (double k = std::ceil(scale.low / step - 1e-9); k * step <= scale.high + 1e-9 * step; ++k)
    ticks.push_back({scale.part_of(k * step), short_number(k * step, digits)});
}

/// 1, 2 and 5 in each power of ten.
void add_powers(const FieldScale& scale, std::vector<ScaleTick>& ticks) {
  for (double k = std::floor(std::log10(scale.low)); k <= std::log10(scale.high); ++k)
    for (const double each : {1.0, 2.0, 5.0}) {
      const double value = each * std::pow(10, k);
      if (value >= scale.low && value <= scale.high)
        ticks.push_back({scale.part_of(value), significant(value)});
    }
}

}  // namespace

FieldScale chosen_scale(const FieldScale& usual, const ScaleChoice& choice,
                        std::vector<float> values) {
  FieldScale scale = usual;
  scale.map = choice.map.value_or(usual.map);
  scale.steps = choice.steps;
  scale.logarithmic = choice.logarithmic.value_or(usual.logarithmic);
  const bool as_usual =
      choice.range == ScaleChoice::Range::Automatic && scale.logarithmic == usual.logarithmic;
  if (as_usual) return scale;
  keep_colored(values, scale.logarithmic);
  if (choice.range == ScaleChoice::Range::Fixed) scale.low = choice.low, scale.high = choice.high;
  if (choice.range == ScaleChoice::Range::Percentile)
    take_percentile(scale, choice.percentile, values);
  if (scale.logarithmic && !scale.empty()) raise_low(scale, values);
  scale.beyond = !values.empty() && (values.front() < scale.low || values.back() > scale.high);
  return scale;
}

std::vector<ScaleTick> scale_ticks(const FieldScale& scale, int count) {
  if (scale.empty() || !(scale.high > scale.low)) return {};
  std::vector<ScaleTick> ticks;
  for (int k = 1; k < scale.steps; ++k) {
    const double part = static_cast<double>(k) / scale.steps;
    ticks.push_back({part, significant(scale.at(part))});
  }
  if (scale.steps == 0 && scale.logarithmic) add_powers(scale, ticks);
  if (scale.steps == 0 && !scale.logarithmic) add_even(scale, count, ticks);
  const double near = 0.5 / count;
  std::erase_if(ticks, [&](const ScaleTick& t) { return t.part < near || t.part > 1 - near; });
  const auto text = [&](double value, const char* sign) {
    return (scale.beyond ? std::string(sign) + " " : std::string()) + significant(value);
  };
  ticks.insert(ticks.begin(), {0, text(scale.low, "\u2264")});
  ticks.push_back({1, text(scale.high, "\u2265")});
  return ticks;
}

namespace {

constexpr FieldText dihedral_text = {
    "Smallest dihedral angle",
    "The smallest angle between two faces of each region: 70.5 degrees in a regular tetrahedron. "
    "The surface has the colours of the regions behind it.",
    "degrees"};
constexpr FieldText model_face_text = {
    "Distance to the original",
    "How far the points of each face on a model face get from that model face as loaded, at most, "
    "in percent of the diagonal of the mesh's box. Measured at 15 points a face, when nothing "
    "runs. What lies inside has none.",
    "% of the diagonal"};

}  // namespace

FieldText field_text(Coloring coloring, bool volume) {
  if (volume && coloring == Coloring::Quality) return dihedral_text;
  if (volume && coloring == Coloring::Distance) return model_face_text;
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
