#include "core/io/streamed_stl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/stl_marks.h"

namespace aomd::io::detail {
namespace {

constexpr std::size_t place_size = 12;  // of a corner: three floats

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Where a corner stands among the bytes of facets: after the normals.
std::size_t corner_place(std::size_t corner) {
  return corner / 3 * facet_size + place_size + corner % 3 * place_size;
}

FacetPoint corner_at(const Source& piece, std::size_t corner) {
  FacetPoint p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t place = corner_place(corner) + 4 * k;
    p[k] = std::bit_cast<float>(number_at(piece.bytes, place));
    if (!std::isfinite(p[k])) piece.fail_at_byte(place, "a coordinate is not a finite number");
  }
  return p;
}

std::uint16_t mark_at(const Source& piece, std::size_t facet) {
  const std::size_t last_word = (facet + 1) * facet_size - 4;
  return static_cast<std::uint16_t>(number_at(piece.bytes, last_word) >> 16);
}

}  // namespace

bool StreamedStl::is_binary(std::string_view head, std::uint64_t file_size) {
  return head.size() >= data_start &&
         file_size == data_start + facet_size * std::uint64_t{number_at(head, header_size)};
}

StreamedStl::StreamedStl(const std::filesystem::path& path) : StreamedFile(path) {
  take_header(std::filesystem::file_size(path));
  std::vector<FacetPoint> some;
  corners_ = FacetCorners(facets_, [&](const FacetCorners::Take& take) {
    each_facets([&](const Source& piece, std::size_t count) {
      some.clear();
      for (std::size_t c = 0; c < 3 * count; ++c) some.push_back(corner_at(piece, c));
      take(some);
    });
  });
  look_at_marks();
}

void StreamedStl::take_header(std::uint64_t file_size) {
  std::ifstream file(path(), std::ios::binary);
  std::string head(data_start, '\0');
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())))
    throw ReadError(name(), Place{.byte = file_size},
                    "too short for an STL file: 84 bytes or more");
  facets_ = number_at(head, header_size);
  const std::uint64_t expected = data_start + facet_size * std::uint64_t{facets_};
  if (file_size < expected)
    throw ReadError(name(), Place{.byte = file_size},
                    "the file ends early: " + std::to_string(facets_) + " facets need " +
                        std::to_string(expected) + " bytes");
  if (facets_ == 0) throw ReadError(name(), {}, "has no facets");
  if (facets_ > FacetCorners::most_facets)
    throw LimitError(name(), {},
                     "has more than " + std::to_string(FacetCorners::most_facets) + " facets");
  magics_ = head.find("COLOR=") != std::string::npos;
  if (file_size > expected)
    leave_out(counted(static_cast<std::size_t>(file_size - expected), "byte") +
              " after the last facet");
}

// Colours where every facet that the whole reader keeps has one, else the marks as they are.
void StreamedStl::look_at_marks() {
  bool marked = false, coloured = true;
  std::size_t first = 0;
  each_facets([&](const Source& piece, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle t = facet(first + i);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      const std::uint16_t mark = mark_at(piece, i);
      marked |= mark != 0;
      coloured &= stl_colour_is_valid(mark, magics_);
    }
    first += count;
  });
  if (marked && coloured)
    layout_.of_faces = {{"color", NumberType::UInt8, 3, Meaning::Colour}};
  else if (marked)
    layout_.of_faces = {{stl_mark, NumberType::UInt16, 1, Meaning::Any}};
}

void StreamedStl::each_facets(const VisitPiece& visit) const {
  each_piece(data_start, facet_size, facets_, visit);
}

std::string StreamedStl::kind_of_records() const { return "stl " + layout_.text(); }

// Vertices are numbered as they appear: a corner with the next number is where that one is.
void StreamedStl::each_vertices(const VisitVertices& visit) const {
  std::uint32_t next = 0;
  std::size_t first = 0;
  std::vector<glm::dvec3> positions;
  std::string records;
  each_facets([&](const Source& piece, std::size_t count) {
    positions.clear();
    records.clear();
    for (std::size_t c = 0; c < 3 * count; ++c) {
      if (corners_[first + c] != next) continue;
      ++next;
      const FacetPoint p = corner_at(piece, c);
      positions.emplace_back(p[0], p[1], p[2]);
      records += piece.bytes.substr(corner_place(c), place_size);
    }
    first += 3 * count;
    visit(positions, records);
  });
}

void StreamedStl::each_faces(const VisitFaces& visit) const {
  std::size_t first = 0;
  std::vector<Triangle> triangles;
  std::string records;
  each_facets([&](const Source& piece, std::size_t count) {
    triangles.clear();
    records.clear();
    for (std::size_t i = 0; i < count; ++i) {
      triangles.push_back(facet(first + i));
      put_mark(mark_at(piece, i), records);
    }
    first += count;
    visit(triangles, records);
  });
}

void StreamedStl::put_mark(std::uint16_t mark, std::string& records) const {
  if (layout_.of_faces.empty()) return;
  if (layout_.of_faces[0].components == 1) {
    records += static_cast<char>(mark & 0xffu);
    records += static_cast<char>(mark >> 8);
    return;
  }
  for (int k = 0; k < 3; ++k)
    records += static_cast<char>(static_cast<unsigned char>(stl_shade(mark, k, magics_)));
}

MeshData StreamedStl::mesh_of(const std::string& vertex_records, std::string face_records,
                              const std::vector<Triangle>& corners) const {
  return layout_.mesh_of(vertex_records, face_records, corners);
}

}  // namespace aomd::io::detail
