#pragma once
// The rules that a classification keeps (paper, section 2.1), and a new one on top of the present:
// judged as a whole, then applied.

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd {

/// What a classification must not break.
enum class ClassRule : std::uint8_t {
  None,
  Nothing,    ///< no rule: nothing would change
  Dimension,  ///< M^I on G^J only if J >= I
  Closure,    ///< what bounds an entity lies on the same model entity, or on one of lower dimension
  Border,     ///< of a surface, an edge inside a model face has two faces
  Curve,      ///< a vertex inside a model edge has just two mesh edges on it
  Point       ///< a model vertex holds one vertex
};

/// Yes, or the rule that is broken, by which entity and with which other one.
struct ClassVerdict {
  ClassRule rule = ClassRule::None;
  EntityRef entity;         ///< what breaks it
  EntityRef other;          ///< with whom: Closure, Point; else invalid
  ModelRef model;           ///< what `entity` would lie on
  ModelRef other_model;     ///< what `other` would lie on
  std::uint32_t count = 0;  ///< faces of a border, edges on a curve
  [[nodiscard]] bool accepted() const { return rule == ClassRule::None; }
};

/// The rule in words with what breaks it: "edge 40 ...". No full stop.
[[nodiscard]] std::string class_words(const ClassVerdict& verdict);

/// New classes of some entities; all others have the mesh's. The mesh must not change meanwhile.
class ClassOverlay {
 public:
  explicit ClassOverlay(const Mesh& mesh) : mesh_(&mesh) {}

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] ModelRef of(EntityRef e) const;
  void set(EntityRef e, ModelRef model);
  /// What differs from the mesh, by level and id. O(n log n).
  [[nodiscard]] std::vector<EntityRef> changed() const;

 private:
  const Mesh* mesh_;
  std::array<std::unordered_map<std::uint32_t, ModelRef>, 4> classes_;
};

/// Whether the rules hold wherever something changes; else one that is broken. What
/// the mesh breaks elsewhere does not matter. Adjacency through core/mesh/derive.h: throws
/// std::logic_error where T leads to none. O(changed entities and what is adjacent to them).
[[nodiscard]] ClassVerdict judge_classes(const ClassOverlay& classes);

/// Writes them into the mesh that the overlay was made for: one step in the journal. They must be
/// accepted.
void apply_classes(Mesh& mesh, const ClassOverlay& classes);

}  // namespace aomd
