#pragma once
// Is the database consistent? Named findings for tests, the command line and the viewer.

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// One thing that is wrong: its kind, the entity concerned, and a sentence.
struct Finding {
  std::string name;
  EntityRef entity;
  std::string text;
};

struct VerifyOptions {
  bool unused = false;  ///< report entities that no higher one uses
};

/// Checks everything that T stores against the entities' vertices, and returns what is wrong. An
/// empty result means:
///  - "dead reference", "repeated vertex": entities use living, different ones;
///  - "not finite": coordinates are numbers;
///  - "duplicate edge", "duplicate region": no two on the same vertices; "duplicate face": none
///  under a region;
///  - "missing edge", "missing face": a complete level has all sides of all higher entities;
///  - "wrong side", "wrong use direction": T(2,1), T(3,1) and T(3,2) agree with the vertices;
///  - "upward list": T(I,J), I < J, holds just what the entities say, sorted;
///  - "classification order": M^I on G^J only if J >= I (paper, section 2.1);
///  - "classification closure": no entity is on a model entity of higher dimension than one that it
///  bounds;
///  - "class list": the lists of model entities agree with the entities;
///  - "id stack": every id is alive or on the stack, once;
///  - "hash set": existence queries find every entity under its own key, and nothing else.
/// Edges with any number of faces and repeated faces of surfaces are legal, and so is what nothing
/// uses (scans leave thousands of vertices) unless it is asked for:
///  - "isolated vertex", "dangling edge", "dangling face": below the highest level, and a side of
///  nothing.
/// O(entities).
[[nodiscard]] std::vector<Finding> verify(const Mesh& mesh, const VerifyOptions& options = {});

/// The first vertex that breaks the closure which the operators trust: it lies on a model entity of
/// higher dimension than an entity that it bounds. Much cheaper than verify(), for meshes that come
/// from outside. O(entities), no memory.
[[nodiscard]] std::optional<Finding> first_misclassified(const Mesh& mesh);

/// The first region on the same vertices as an earlier one: among tetrahedra both would fall
/// together for ever. For meshes that come from outside. O(regions), eight bytes each for the
/// while.
[[nodiscard]] std::optional<Finding> first_repeated_region(const Mesh& mesh);

}  // namespace aomd

#pragma GCC visibility pop
