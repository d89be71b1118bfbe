#pragma once
// What stands behind the coordinates of OFF's vertices and behind the corners of its faces:
// normals, colours, texture coordinates.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/io/face_sink.h"
#include "core/io/notes.h"

namespace aomd::io::detail {

/// What the header word says of a vertex.
struct OffHeader {
  bool texture = false, colour = false, normal = false;
  bool weight = false;  ///< a fourth coordinate, which divides the other three

  /// How many values may follow the coordinates.
  [[nodiscard]] std::size_t extra() const {
    return (texture ? 2u : 0u) + (colour ? 4u : 0u) + (normal ? 3u : 0u);
  }
};

/// Nothing where the word is none of ours. Not all programs keep to one order of the prefixes, and
/// some write small letters; "nOFF" among capitals is of another dimension.
[[nodiscard]] std::optional<OffHeader> off_header(std::string_view word);

/// Collects the numbers of a file into arrays.
class OffArrays {
 public:
  explicit OffArrays(const OffHeader& header) : header_(header) {}

  /// A number, and whether it has no decimal point: a colour of such is 0 to 255.
  struct Number {
    double value = 0;
    bool whole = false;
  };
  using Numbers = std::span<const Number>;

  /// What stands behind a vertex: normal, colour, texture coordinates.
  void add_vertex(Numbers numbers);
  /// The colour of the next face of the file, or nothing.
  void add_face(Numbers numbers) { face_.add(numbers); }
  /// True where the next face is the first, and has a colour.
  [[nodiscard]] bool begins_face_colours(Numbers numbers) const {
    return !face_.known && !numbers.empty();
  }
  /// Once the mesh has its faces. `type` is how the file stores numbers that are not whole.
  void finish(MeshData& mesh, const FaceSink& faces, NumberType type, ItemList& left_out);

 private:
  struct Colours {
    std::vector<double> values;
    std::size_t components = 0;
    bool known = false;  ///< of how many components they are
    bool whole = true;
    bool mixed = false;  ///< not all are of one kind: they are no array
    void add(Numbers numbers);
    [[nodiscard]] Attribute array(int dimension, NumberType type) const;
  };
  void give_up(ItemList& left_out);

  OffHeader header_;
  Colours vertex_, face_;
  std::vector<double> normals_, texture_;
};

}  // namespace aomd::io::detail
