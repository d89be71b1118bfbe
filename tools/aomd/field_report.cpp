#include "tools/aomd/field_report.h"

#include <algorithm>
#include <ostream>

#include "core/base/text.h"
#include "core/mesh/names.h"

namespace aomd::cli {
namespace {

using fields::CarriedField;
using fields::ComponentFacts;
using fields::FieldFacts;

constexpr std::size_t most_lines = 20;

template <typename Value>
Json by_component(const FieldFacts& facts, Value&& value) {
  Json list = Json::array();
  for (const ComponentFacts& c : facts.components) list.push_back(value(c));
  return list;
}

Json facts_json(const FieldFacts& facts) {
  return {{"min", by_component(facts, [](const ComponentFacts& c) { return c.low; })},
          {"max", by_component(facts, [](const ComponentFacts& c) { return c.high; })},
          {"integral", by_component(facts, [](const ComponentFacts& c) { return c.integral; })},
          {"missing", facts.missing}};
}

std::string range_words(const FieldFacts& facts) {
  const ComponentFacts& c = facts.components.front();
  return number_text(c.low) + " to " + number_text(c.high);
}

std::string change_words(const CarriedField& field) {
  if (field.components > 1)
    return counted(static_cast<std::uint64_t>(field.components), "component");
  const std::string before = range_words(field.before), after = range_words(field.after);
  std::string text = before == after ? before : before + " -> " + after;
  if (field.kind == fields::FieldKind::Label) return text;
  const std::string sum = number_text(field.before.components[0].integral, 12),
                    now = number_text(field.after.components[0].integral, 12);
  return text + ", integral " + sum + (sum == now ? " kept" : " -> " + now);
}

}  // namespace

Json fields_json(const std::vector<CarriedField>& list) {
  Json json = Json::array();
  for (const CarriedField& field : list)
    json.push_back({{"name", field.name},
                    {"on", entity_plural(field.dimension)},
                    {"components", field.components},
                    {"kind", kind_name(field.kind)},
                    {"before", facts_json(field.before)},
                    {"after", facts_json(field.after)}});
  return json;
}

void print_fields(std::ostream& out, const std::vector<CarriedField>& list) {
  const std::size_t shown_lines = std::min(list.size(), most_lines);
  for (std::size_t i = 0; i < shown_lines; ++i)
    out << "  " << shown(list[i].name) << " on " << entity_plural(list[i].dimension) << ", "
        << kind_name(list[i].kind) << ": " << change_words(list[i]) << '\n';
  if (shown_lines < list.size())
    out << "  and " << list.size() - shown_lines << " more; --report has all\n";
}

}  // namespace aomd::cli
