#include "core/fields/field.h"

#include <algorithm>
#include <cmath>

namespace aomd::fields {
namespace {

ComponentFacts facts_of(const Attribute& array, std::size_t component,
                        std::span<const double> measures, std::size_t& missing) {
  const auto stride = static_cast<std::size_t>(array.components);
  ComponentFacts facts;
  Sum integral;
  bool any = false;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const double x = array.values[stride * i + component];
    if (!std::isfinite(x)) {
      ++missing;
      continue;
    }
    facts.low = any ? std::min(facts.low, x) : x;
    facts.high = any ? std::max(facts.high, x) : x;
    any = true;
    integral.add(measures[i] * x);
  }
  facts.integral = integral.value();
  return facts;
}

}  // namespace

FieldKind kind_of(const Attribute& array) {
  if (array.meaning == Meaning::Normal && !array.integer) return FieldKind::Unit;
  if (array.meaning == Meaning::Colour) return FieldKind::Colour;
  if (array.integer) return FieldKind::Label;
  return array.dimension == 0 ? FieldKind::Interpolated : FieldKind::Conserved;
}

std::string_view kind_name(FieldKind kind) {
  constexpr std::string_view names[] = {"interpolated", "conserved", "label", "unit vector",
                                        "colour"};
  return names[static_cast<std::size_t>(kind)];
}

Attribute like(const Attribute& array) {
  return {array.name, array.dimension, array.components, array.integer,
          {},         array.type,      array.meaning,    array.names};
}

void settle(const Attribute& array, std::span<double> values) {
  if (array.integer)
    for (double& x : values) x = std::isfinite(x) ? std::round(x) : 0;
  if (kind_of(array) != FieldKind::Unit) return;
  double squares = 0;
  for (const double x : values) squares += x * x;
  if (squares > 0 && std::isfinite(squares))
    for (double& x : values) x /= std::sqrt(squares);
}

FieldFacts facts_of(const Attribute& array, std::span<const double> measures) {
  FieldFacts facts;
  for (std::size_t k = 0; k < static_cast<std::size_t>(array.components); ++k)
    facts.components.push_back(facts_of(array, k, measures, facts.missing));
  return facts;
}

}  // namespace aomd::fields
