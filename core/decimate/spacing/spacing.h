#pragma once
// Where edges should be how long: the spacing field that decimation follows (paper, section 3), and
// what it can come from.

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// The mean length of the edges at a vertex, so many times.
struct SpacingByFactor {
  double factor = 4;
  friend bool operator==(const SpacingByFactor&, const SpacingByFactor&) = default;
};

/// One positive number for each vertex of the mesh as read, in order of their ids, separated by
/// blanks or line ends; comments run from # to the end of the line.
struct SpacingFile {
  std::filesystem::path path;
  friend bool operator==(const SpacingFile&, const SpacingFile&) = default;
};

/// A formula: see SpacingExpression.
struct SpacingFormula {
  std::string text;
  friend bool operator==(const SpacingFormula&, const SpacingFormula&) = default;
};

/// The length at which an edge between two points of a curved surface leaves it by the chord error:
/// sqrt(8 chord_error / curvature); no less than the mean length of the edges there and no more
/// than `largest`, the former where they contradict each other. Both are parts of the diagonal of
/// the mesh's box.
struct SpacingByCurvature {
  double chord_error = 0.001;
  double largest = 0.1;
  friend bool operator==(const SpacingByCurvature&, const SpacingByCurvature&) = default;
};

/// Of a volume: on model faces the mean length of the edges there that lie on model faces, so many
/// times; inside regions whatever the growth from there allows.
struct SpacingBySurface {
  double factor = 4;
  friend bool operator==(const SpacingBySurface&, const SpacingBySurface&) = default;
};

/// What a spacing field comes from. Plain data; costs nothing until it is evaluated.
struct SpacingSource {
  std::variant<SpacingByFactor, SpacingFile, SpacingFormula, SpacingByCurvature, SpacingBySurface>
      from;
  /// How much spacings may differ per unit of length between them: along each edge by no more than
  /// this times its length. They are only ever lowered (limit_growth).
  std::optional<double> growth;

  friend bool operator==(const SpacingSource&, const SpacingSource&) = default;
};

inline constexpr double default_spacing_growth = 0.3;

/// What the command line says: a file where there is one of this name, else one of the words
/// "curvature" and "surface" (with default_spacing_growth, and `factor` for the latter), else a
/// formula. Throws std::invalid_argument for what is no formula either: one line with the character
/// and the reason.
[[nodiscard]] SpacingSource parse_spacing(const std::string& text, double factor = 4);

/// The spacing at each vertex, how long edges should be, in the mesh's units. Vertices without
/// edges get 0 unless a file gives them more. O(entities), with growth O(n log n); needs no stored
/// adjacency and changes nothing. Throws io::ReadError for files (missing, no number, not positive,
/// too many or too few values) and std::invalid_argument for formulas and for options that are not
/// positive and finite.
[[nodiscard]] Column<Vertex, double> evaluate_spacing(const Mesh& mesh,
                                                      const SpacingSource& source);

}  // namespace aomd
