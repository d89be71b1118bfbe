#pragma once
// A number at each vertex or face as colours, and what a legend says about it.

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/handle.h"
#include "viewer/drawing/palette.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// From numbers to colours. Nothing has a colour on an empty scale.
struct FieldScale {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool logarithmic = false;  ///< then values that are not positive have no colour
  bool beyond = false;       ///< there are values outside: they get the colour of the end
  int steps = 0;             ///< of colour; 0: even
  ColorMap map = ColorMap::Viridis;

  [[nodiscard]] bool empty() const { return low > high; }
  void add(double value) { low = std::fmin(low, value), high = std::fmax(high, value); }
  /// The value at a part 0..1 of the scale.
  [[nodiscard]] double at(double part) const;
  /// The part at which a value stands; outside of 0..1 for one that lies beyond.
  [[nodiscard]] double part_of(double value) const;
  /// The colour at a part.
  [[nodiscard]] Color color_at(double part) const;
  /// plain_face_color() for what has none.
  [[nodiscard]] Color color(double value) const;
  friend bool operator==(const FieldScale&, const FieldScale&) = default;
};

/// What a legend says.
struct FieldText {
  std::string_view title, help, unit;
};
/// Spacing to Curvature.
[[nodiscard]] FieldText field_text(Coloring coloring, bool volume);

/// A scale as somebody wants it, of numbers whose usual one is known.
[[nodiscard]] FieldScale chosen_scale(const FieldScale& usual, const ScaleChoice& choice,
                                      std::vector<float> values);

/// A value that a scale is labelled with.
struct ScaleTick {
  double part = 0;  ///< of the scale
  std::string text;
};
/// The ends, with what lies beyond, and round numbers in between: about one for each of `count`
/// parts of the scale. Where it has steps, where these meet.
[[nodiscard]] std::vector<ScaleTick> scale_ticks(const FieldScale& scale, int count);

/// One of the two columns is empty. NaN: not known yet, without a colour.
struct ScalarField {
  Coloring kind = Coloring::Spacing;
  FieldScale scale;
  Column<Vertex, float> vertices;
  Column<Face, float> faces;
  std::uint64_t version = 0;  ///< changes when more than the values of changed faces did

  [[nodiscard]] bool by_face() const { return faces.size() > 0; }
  [[nodiscard]] Color color(Face face, Vertex corner) const {
    if (by_face()) return face.index < faces.size() ? scale.color(faces[face]) : plain_face_color();
    return corner.index < vertices.size() ? scale.color(vertices[corner]) : plain_face_color();
  }
};

}  // namespace aomd::scene
