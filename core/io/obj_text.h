#pragma once
// The first pass over an OBJ file: what tinyobjloader does not check, or would lose.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/notes.h"
#include "core/io/source.h"

namespace aomd::io::detail {

/// What the first pass keeps. tinyobjloader turns decimal text into doubles with an error of a few
/// units in the last place, reads "x" as 0 and 2^32 + 1 as 1, and its callbacks know neither lines
/// nor `l` elements.
struct ObjText {
  struct Line {
    std::int64_t a, b;   ///< 0-based vertices
    std::size_t offset;  ///< where it stands
  };

  /// Values of `vt` or `vn` elements, and which of them each corner of a face names. Corners count
  /// over the faces of 3 or more; where none names any the list is empty.
  struct Values {
    int components = 0;
    std::vector<double> numbers;
    std::vector<std::uint32_t> corners;  ///< 0-based, or no_index

    [[nodiscard]] std::size_t size() const {
      return components == 0 ? 0 : numbers.size() / static_cast<std::size_t>(components);
    }
  };
  /// A smoothing group that holds from a face on.
  struct Smoothing {
    std::size_t face;
    std::int64_t group;
  };

  std::vector<glm::dvec3> positions;  ///< exactly rounded
  Values colours;                     ///< of vertices; one without has NaN
  Values texture, normals;
  std::vector<Smoothing> smoothing;
  std::vector<std::string> libraries;     ///< of materials, as `mtllib` names them
  std::vector<Line> lines;                ///< the segments of all `l` elements
  std::vector<std::size_t> face_offsets;  ///< where each `f` element of 3 or more corners stands
  std::size_t short_faces = 0;            ///< `f` elements of fewer corners, which are blanked
  std::size_t short_lines = 0;            ///< `l` elements of one vertex or none
  ItemList left_out;                      ///< what the file holds besides
  std::string cleaned;  ///< the elements that tinyobjloader is to see; offsets as in the source
};

/// Checks every `v`, `vt`, `vn`, `f` and `l` element word by word. Throws ReadError with the line.
[[nodiscard]] ObjText scan_obj(const Source& source);

}  // namespace aomd::io::detail
