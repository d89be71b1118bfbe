#include "core/io/left_out.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

#include "core/base/text.h"
#include "core/fields/carry_corners.h"
#include "core/io/formats.h"
#include "core/io/medit.h"
#include "core/io/notes.h"
#include "core/io/vtk_dataset.h"
#include "core/mesh/names.h"

namespace aomd::io {
namespace {

using detail::for_each_entity;

bool same_entities(const MeshData& a, const MeshData& b, int dim) {
  return dim == 0 ? a.positions == b.positions : a.list(dim).vertices == b.list(dim).vertices;
}

bool unchanged(const MeshData& original, const MeshData& result) {
  return same_entities(original, result, 0) && same_entities(original, result, 2) &&
         same_entities(original, result, 3);
}

/// The arrays of a mesh by dimension and name.
class Held {
 public:
  explicit Held(const MeshData& mesh) {
    for (const Attribute& a : mesh.attributes)
      names_[static_cast<std::size_t>(a.dimension)].insert(a.name);
  }
  [[nodiscard]] bool has(const Attribute& a) const {
    return names_[static_cast<std::size_t>(a.dimension)].contains(a.name);
  }

 private:
  std::array<std::unordered_set<std::string>, 4> names_;
};

bool is_mark(const Attribute& a) {
  return a.name == detail::medit_required || a.name == detail::medit_ridge ||
         a.name == detail::medit_reference;
}

/// An entity by where its vertices are, in any order.
using Corners = std::vector<std::array<double, 3>>;

template <class Visit>
void each_place(const MeshData& mesh, int dim, Visit&& visit) {
  const auto place_of = [&](auto vertices) {
    Corners place;
    for (const std::uint32_t v : vertices) {
      const glm::dvec3& p = mesh.positions[v];
      place.push_back({p.x, p.y, p.z});
    }
    std::sort(place.begin(), place.end());
    return place;
  };
  std::size_t i = 0;
  if (dim > 0)
    return for_each_entity(mesh.list(dim),
                           [&](auto vertices, ModelRef) { visit(i++, place_of(vertices)); });
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    visit(v, place_of(std::array<std::uint32_t, 1>{v}));
}

/// Takes the marks from what is not where it was. Returns whether there was any such.
bool unmark_moved(const MeshData& original, const MeshData& result, Attribute& marks) {
  std::set<Corners> required;
  for (const Attribute& a : original.attributes) {
    if (a.dimension != marks.dimension || a.name != marks.name || a.components != 1) continue;
    each_place(original, a.dimension, [&](std::size_t i, Corners place) {
      if (a.values[i] != 0) required.insert(std::move(place));
    });
  }
  bool moved = false;
  each_place(result, marks.dimension, [&](std::size_t i, const Corners& place) {
    if (marks.values[i] == 0 || required.contains(place)) return;
    marks.values[i] = 0;
    moved = true;
  });
  return moved;
}

bool is_label(const Attribute& a) {
  const auto& names = detail::label_names;
  return a.dimension > 0 && a.integer && a.components == 1 &&
         std::find(names.begin(), names.end(), a.name) != names.end();
}

using LabelOfClass = std::map<ModelRef, double>;

/// Nothing where entities of one class have different labels, or some have no class.
std::optional<LabelOfClass> label_of_class(const EntityList& list, const Attribute& labels) {
  LabelOfClass result;
  for (std::size_t i = 0; i < list.classes.size(); ++i) {
    const ModelRef m = list.classes[i];
    if (!m.valid() || result.try_emplace(m, labels.values[i]).first->second != labels.values[i])
      return {};
  }
  return result;
}

/// What says no more of entities than their class, as the materials of VTK, follows it.
void follow_classes(const MeshData& original, const Attribute& labels, MeshData& result) {
  const auto label = label_of_class(original.list(labels.dimension), labels);
  const EntityList& list = result.list(labels.dimension);
  if (!label || list.classes.empty()) return;
  Attribute followed = fields::like(labels);
  for (const ModelRef m : list.classes) {
    const auto found = label->find(m);
    if (found == label->end()) return;
    followed.values.push_back(found->second);
  }
  result.attributes.push_back(std::move(followed));
}

/// Gives back what a Mesh does not hold.
void restore(const MeshData& original, MeshData& result) {
  const Held held(result);
  for (const Attribute& a : original.attributes)
    if (same_entities(original, result, a.dimension) && !held.has(a))
      result.attributes.push_back(a);
  result.periodic = original.periodic;
  result.corners = original.corners;
}

/// What Medit says of entities is no field, and is followed by its own rules or not at all.
bool is_of_medit(const Attribute& a) { return a.name.starts_with("medit:"); }

/// The arrays that are still to be followed.
std::vector<const Attribute*> open_arrays(const MeshData& original, const MeshData& result) {
  const Held held(result);
  std::vector<const Attribute*> arrays;
  for (const Attribute& a : original.attributes)
    if (!held.has(a) && !is_of_medit(a)) arrays.push_back(&a);
  return arrays;
}

std::vector<std::string> missing_notes(const std::vector<fields::CarriedField>& list) {
  detail::ItemList missing;
  for (const fields::CarriedField& field : list)
    if (field.before.missing + field.after.missing > 0)
      missing.add(shown(field.name) + " on " + entity_plural(field.dimension) + ' ' +
                  std::to_string(field.before.missing) + " before and " +
                  std::to_string(field.after.missing) + " after");
  if (missing.empty()) return {};
  return {"values that are no numbers: " + missing.text()};
}

/// Follows what can be followed; `gone` takes what has lost something though it stays.
std::vector<fields::CarriedField> follow(const MeshData& original, MeshData& result, int threads,
                                         detail::ItemList& gone) {
  std::erase_if(result.attributes, [](const Attribute& a) { return !is_mark(a); });
  for (Attribute& a : result.attributes)
    if (a.name == detail::medit_required && unmark_moved(original, result, a))
      gone.add(shown(a.name));
  for (const Attribute& a : original.attributes)
    if (is_label(a)) follow_classes(original, a, result);
  return fields::carry(open_arrays(original, result), original, result, threads);
}

}  // namespace

CarriedAlong carry_along(const MeshData& original, MeshData& result, int threads) {
  detail::ItemList gone;
  CarriedAlong done;
  result.remarks = original.remarks;
  result.appearance = original.appearance;
  if (unchanged(original, result)) {
    done.fields = fields::unmoved(open_arrays(original, MeshData()), original);
    restore(original, result);
  } else {
    done.fields = follow(original, result, threads, gone);
    if (result.regions.empty()) result.corners = fields::carried_corners(original, result, threads);
    if (!original.periodic.empty()) gone.add("periodic links");
  }
  done.notes = missing_notes(done.fields);
  const Held held(result);
  for (const Attribute& a : original.attributes)
    if (!held.has(a)) gone.add(shown(a.name));
  for (const Attribute& a : original.corners)
    if (result.corners.empty()) gone.add(shown(a.name));
  if (!gone.empty())
    done.notes.push_back("left out, as it does not follow the operations: " + gone.text());
  return done;
}

}  // namespace aomd::io
