#pragma once
// What a selection comes to in lengths, angles, areas and volumes.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"
#include "viewer/document/selection.h"

namespace aomd::scene {

/// Two or three vertices: what lies between them. Entities of one kind: what they have together.
struct Measures {
  std::vector<std::pair<std::string, std::string>> facts;  ///< "Distance", "0.25"
  std::vector<double> values;                              ///< of each, as numbers
};

/// Empty for other selections. Five digits. O(selection).
[[nodiscard]] Measures measure_selection(const Mesh& mesh, const Selection& selection);

/// The two ends of a line along which something is measured.
using Ruler = std::array<Vertex, 2>;
/// Between two or three vertices that are selected and nothing else; else none. O(1).
[[nodiscard]] std::vector<Ruler> rulers_of(const Selection& selection);
/// The length of one, as it is written in the picture.
[[nodiscard]] std::string ruler_text(const Mesh& mesh, const Ruler& ruler);

}  // namespace aomd::scene
