#pragma once
// T(I,J) of a mesh in numbers and words, for the panel that shows it and the command that changes
// it.

#include <cstddef>
#include <string>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// One cell of T(I,J): I != J.
struct AdjacencyCell {
  bool stored = false;
  bool set = false;  ///< by the user: it stays when no request is left
  int requests = 0;  ///< of algorithms and of the viewer
  bool defines =
      false;  ///< the last downward relation of a level with entities: it cannot be freed
  std::size_t bytes = 0;
};

/// 0 <= i, j <= 3, i != j. O(1).
[[nodiscard]] AdjacencyCell adjacency_cell(const Mesh& mesh, int i, int j);
/// Average length of the rows of a stored relation, from the shapes that there are. O(entities).
[[nodiscard]] double mean_row_length(const Mesh& mesh, int i, int j);

/// "The faces around each vertex, sorted", "The vertices of each face, in template order".
[[nodiscard]] std::string relation_words(int i, int j);
/// Whether, how and for whom a relation is stored, in sentences; with `times`, how long building
/// took. O(entities).
[[nodiscard]] std::string adjacency_words(const Mesh& mesh, int i, int j, bool times);
/// Who holds it: "drawing, the paper's loop (2)". Empty where nobody asked.
[[nodiscard]] std::string askers(const Mesh& mesh, int i, int j);

/// What a change of T came to.
struct AdjacencyChange {
  int i = 0, j = 0;
  bool on = false;
  double ms = 0;        ///< what building or freeing took
  std::string refusal;  ///< why the database would not; empty where it did
};

/// Mesh::set or Mesh::unset. A refusal is a value: the relations are then as before.
[[nodiscard]] AdjacencyChange change_adjacency(Mesh& mesh, int i, int j, bool on);
/// One line: "T(0,2) is stored: 92.1 KB", or the refusal.
[[nodiscard]] std::string change_words(const Mesh& mesh, const AdjacencyChange& change);

}  // namespace aomd::scene
