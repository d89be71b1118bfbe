#include "tools/aomd/field_report.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <ostream>

#include "core/base/text.h"
#include "core/fields/cells.h"
#include "core/fields/seams.h"
#include "core/mesh/names.h"

namespace aomd::cli {
namespace {

using fields::CarriedField;
using fields::ComponentFacts;
using fields::FieldFacts;

constexpr std::size_t most_arrays = 20;

template <typename Value>
Json by_component(const FieldFacts& facts, Value&& value) {
  Json list = Json::array();
  for (const ComponentFacts& c : facts.components) list.push_back(value(c));
  return list;
}

Json array_facts_json(const FieldFacts& facts) {
  return {{"min", by_component(facts, [](const ComponentFacts& c) { return c.low; })},
          {"max", by_component(facts, [](const ComponentFacts& c) { return c.high; })},
          {"integral", by_component(facts, [](const ComponentFacts& c) { return c.integral; })},
          {"missing", facts.missing}};
}

/// Over all components.
std::string range_words(const FieldFacts& facts) {
  double low = facts.components.front().low, high = facts.components.front().high;
  for (const ComponentFacts& c : facts.components)
    low = std::min(low, c.low), high = std::max(high, c.high);
  return number_text(low) + " to " + number_text(high);
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

const char* type_name(const Attribute& a) { return a.integer ? "whole" : "real"; }

/// How the file stores the numbers, where that is not the usual way.
std::string storage_words(const Attribute& a) {
  constexpr const char* names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                   "uint32", "int64", "uint64", "float32", "float64"};
  return a.type ? names[static_cast<std::size_t>(*a.type)] : a.integer ? "int32" : "float64";
}

template <typename... Values>
void columns(std::ostream& out, const std::string& label, const Values&... values) {
  out << "  " << std::left << std::setw(24) << label << std::right;
  ((out << ' ' << std::setw(15) << values), ...) << '\n';
}

/// An array on corners, as one on vertices is treated.
Attribute on_corners(const Attribute& array) {
  Attribute a = fields::like(array);
  a.dimension = 0;
  return a;
}

template <typename Visit>
void each_on_corners(const MeshData& mesh, Visit&& visit) {
  if (mesh.corners.empty()) return;
  const fields::Cells faces(mesh, 2);
  const std::vector<double> measures = fields::corner_measures(mesh);
  for (const Attribute& a : mesh.corners)
    visit(a, fields::facts_of(a, measures), fields::Charts(faces, a).seams().size());
}

/// Without what it is called and where it is.
Json array_json(const Attribute& a, const FieldFacts& facts, fields::FieldKind kind) {
  Json json{{"components", a.components},
            {"type", type_name(a)},
            {"stored", storage_words(a)},
            {"kind", kind_name(kind)}};
  json.update(array_facts_json(facts));
  return json;
}

std::string array_words(const Attribute& a, const FieldFacts& facts) {
  std::string text =
      counted(static_cast<std::uint64_t>(a.components), std::string(type_name(a)) + " number") +
      ": " + range_words(facts);
  if (facts.missing > 0) text += ", " + counted(facts.missing, "value") + " no number";
  return text;
}

const char* place_name(const measure::FieldDifference& d) {
  return d.corners ? "corners" : entity_plural(d.dimension);
}

template <typename Visit>
void each_array(const MeshData& mesh, Visit&& visit) {
  std::array<std::vector<double>, 4> measures;
  for (const Attribute& a : mesh.attributes) {
    std::vector<double>& own = measures[static_cast<std::size_t>(a.dimension)];
    if (own.empty()) own = fields::measures(mesh, a.dimension);
    visit(a, fields::facts_of(a, own));
  }
}

}  // namespace

Json fields_json(const std::vector<CarriedField>& list) {
  Json json = Json::array();
  for (const CarriedField& field : list)
    json.push_back({{"name", field.name},
                    {"on", entity_plural(field.dimension)},
                    {"components", field.components},
                    {"kind", kind_name(field.kind)},
                    {"before", array_facts_json(field.before)},
                    {"after", array_facts_json(field.after)}});
  return json;
}

void print_fields(std::ostream& out, const std::vector<CarriedField>& list) {
  const std::size_t shown_lines = std::min(list.size(), most_arrays);
  for (std::size_t i = 0; i < shown_lines; ++i)
    out << "  " << shown(list[i].name) << " on " << entity_plural(list[i].dimension) << ", "
        << kind_name(list[i].kind) << ": " << change_words(list[i]) << '\n';
  if (shown_lines < list.size())
    out << "  and " << list.size() - shown_lines << " more; --report has all\n";
}

Json arrays_json(const MeshData& mesh) {
  Json json = Json::array();
  each_array(mesh, [&](const Attribute& a, const FieldFacts& facts) {
    json.push_back({{"name", a.name}, {"on", entity_plural(a.dimension)}});
    json.back().update(array_json(a, facts, fields::kind_of(a)));
  });
  each_on_corners(mesh, [&](const Attribute& a, const FieldFacts& facts, std::size_t seams) {
    json.push_back({{"name", a.name}, {"on", "corners"}, {"seams", seams}});
    json.back().update(array_json(a, facts, fields::kind_of(on_corners(a))));
  });
  return json;
}

void print_arrays(std::ostream& out, const MeshData& mesh) {
  std::size_t lines = 0;
  each_array(mesh, [&](const Attribute& a, const FieldFacts& facts) {
    if (++lines > most_arrays) return;
    out << "  " << shown(a.name) << " on " << entity_plural(a.dimension) << ", "
        << array_words(a, facts) << '\n';
  });
  each_on_corners(mesh, [&](const Attribute& a, const FieldFacts& facts, std::size_t seams) {
    if (++lines > most_arrays) return;
    out << "  " << shown(a.name) << " on corners, " << array_words(a, facts) << "; it jumps across "
        << counted(seams, "edge") << '\n';
  });
  if (lines > most_arrays) out << "  and " << lines - most_arrays << " more; --json has all\n";
}

Json materials_json(const MeshData& mesh) {
  const Appearance& looks = mesh.appearance;
  Json json = Json::array();
  for (const Material& m : looks.materials) {
    json.push_back({{"name", m.name}, {"color", m.colour}});
    if (m.picture < looks.pictures.size()) json.back()["picture"] = looks.pictures[m.picture].name;
  }
  return json;
}

void print_materials(std::ostream& out, const MeshData& mesh) {
  const Appearance& looks = mesh.appearance;
  const std::size_t shown_lines = std::min(looks.materials.size(), most_arrays);
  for (std::size_t i = 0; i < shown_lines; ++i) {
    const Material& m = looks.materials[i];
    out << "  material " << shown(m.name);
    if (m.picture < looks.pictures.size())
      out << ", picture " << shown(looks.pictures[m.picture].name);
    out << '\n';
  }
  if (shown_lines < looks.materials.size())
    out << "  and " << looks.materials.size() - shown_lines << " more; --json has all\n";
}

Json differences_json(const std::vector<measure::FieldDifference>& list) {
  Json json = Json::array();
  for (const measure::FieldDifference& d : list)
    json.push_back({{"name", d.name},
                    {"on", place_name(d)},
                    {"components", d.components},
                    {"rms", d.label ? Json(nullptr) : Json(d.rms)},
                    {"largest", d.label ? Json(nullptr) : Json(d.largest)},
                    {"rms_pct", d.label ? Json(nullptr) : Json(d.percent(d.rms))},
                    {"largest_pct", d.label ? Json(nullptr) : Json(d.percent(d.largest))},
                    {"rms_deg", d.directions ? Json(d.rms_deg) : Json(nullptr)},
                    {"largest_deg", d.directions ? Json(d.largest_deg) : Json(nullptr)},
                    {"differing_pct", d.label ? Json(100 * d.differing) : Json(nullptr)},
                    {"missing", d.missing},
                    {"original", array_facts_json(d.before)},
                    {"result", array_facts_json(d.after)}});
  return json;
}

void print_differences(std::ostream& out, const std::vector<measure::FieldDifference>& list,
                       const std::string& extent) {
  if (list.empty()) return;
  out << std::fixed << std::setprecision(4);
  columns(out, "field, % of its range", "rms", "max", "% of " + extent);
  const std::size_t shown_lines = std::min(list.size(), most_arrays);
  for (std::size_t i = 0; i < shown_lines; ++i) {
    const measure::FieldDifference& d = list[i];
    const std::string name = "  " + shown(d.name) + " on " + place_name(d);
    if (d.label)
      columns(out, name, "-", "-", 100 * d.differing);
    else
      columns(out, name, d.percent(d.rms), d.percent(d.largest));
    if (d.directions) columns(out, name + ", deg", d.rms_deg, d.largest_deg);
  }
  if (shown_lines < list.size())
    out << "  and " << list.size() - shown_lines << " more; --json has all\n";
}

}  // namespace aomd::cli
