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

  std::vector<glm::dvec3> positions;      ///< exactly rounded
  std::vector<Line> lines;                ///< the segments of all `l` elements
  std::vector<std::size_t> face_offsets;  ///< where each `f` element of 3 or more corners stands
  std::size_t short_faces = 0;            ///< `f` elements of fewer corners, which are blanked
  std::size_t short_lines = 0;            ///< `l` elements of one vertex or none
  ItemList left_out;                      ///< what the file holds besides
  std::string cleaned;  ///< the elements that tinyobjloader is to see; offsets as in the source
};

/// Checks every `v`, `f` and `l` element word by word. Throws ReadError with the line.
[[nodiscard]] ObjText scan_obj(const Source& source);

}  // namespace aomd::io::detail
