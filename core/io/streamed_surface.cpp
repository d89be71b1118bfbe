#include "core/io/streamed_surface.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/base/vertex_ranks.h"
#include "core/io/io.h"
#include "core/io/ply_body.h"
#include "core/io/ply_header.h"
#include "core/mesh/handle.h"

namespace aomd::io {
namespace {

using detail::axis_of;
using detail::is_corner_list;
using detail::PlyBinary;
using detail::PlyElement;
using detail::PlyEncoding;
using detail::PlyHeader;
using detail::PlyProperty;
using detail::Source;

constexpr std::size_t most_header_bytes = 1 << 16, bytes_a_piece = 1 << 20;

std::string first_bytes(std::ifstream& file) {
  std::string bytes(most_header_bytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  return bytes;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw ReadError(name, {}, what + " cannot be read in blocks, only as a whole");
}

/// Of the properties of vertices, one by one. Throws ReadError unless each axis is there once.
std::vector<int> axes_of(const PlyElement& element, const std::string& name) {
  std::vector<int> axes;
  for (const PlyProperty& p : element.properties) axes.push_back(axis_of(p));
  for (const int axis : {0, 1, 2})
    if (std::count(axes.begin(), axes.end(), axis) != 1)
      throw ReadError(name, {}, "element vertex needs x, y and z");
  return axes;
}

/// Of our own PLY files: what vertices and faces are classified on.
bool is_class(const PlyProperty& p) { return p.name.starts_with("model_"); }

void put_integer(char* at, std::uint32_t value, std::size_t size, PlyEncoding encoding) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = encoding == PlyEncoding::LittleEndian ? i : size - 1 - i;
    at[place] = static_cast<char>(i < sizeof value ? value >> (8 * i) & 0xffu : 0);
  }
}

}  // namespace

/// Where in the file the records of vertices and of faces lie.
struct StreamedSurface::Layout {
  /// The records of one element, all of one size: a face has three corners.
  struct Records {
    PlyElement element;
    std::uint64_t begin = 0;  ///< offset in the file
    std::size_t size = 0;     ///< bytes of one
  };

  std::filesystem::path path;
  std::string name;
  PlyEncoding encoding = PlyEncoding::LittleEndian;
  Records vertices, faces;
  std::string header;
  std::vector<int> axes;  ///< of the properties of vertices
  std::vector<std::string> left_out;

  explicit Layout(const std::filesystem::path& file_path);
  void take(const PlyHeader& parsed, std::uint64_t file_size);
  [[nodiscard]] std::size_t record_size(const PlyElement& element) const;
  void name_what_is_left_out(const PlyElement& element);
  [[nodiscard]] std::string header_for(std::uint64_t vertex_count, std::uint64_t face_count) const;
  void put_corners(std::string& records, const std::vector<Triangle>& triangles) const;

  /// Calls visit(source, first, count) for pieces of whole records.
  template <typename Visit>
  void pieces(const Records& records, const Visit& visit) const;
  template <std::endian Order, typename Visit>
  void vertices_in(const Source& piece, std::size_t count, const Visit& visit) const;
  template <std::endian Order, typename Visit>
  void faces_in(const Source& piece, std::size_t count, const Visit& visit) const;
  void triangles_in(const Source& piece, std::size_t count, std::vector<Triangle>& triangles) const;
};

StreamedSurface::Layout::Layout(const std::filesystem::path& file_path)
    : path(file_path), name(file_path.string()) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) throw ReadError(name, {}, "is no file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(name, {}, "cannot be opened");
  const std::string head = first_bytes(file);
  if (!head.starts_with("ply")) refuse(name, "what is no PLY");
  const PlyHeader parsed = read_ply_header(Source{name, head});
  encoding = parsed.encoding;
  if (encoding == PlyEncoding::Ascii) refuse(name, "PLY as text");
  header = head.substr(0, parsed.body);
  take(parsed, std::filesystem::file_size(path));
}

void StreamedSurface::Layout::take(const PlyHeader& parsed, std::uint64_t file_size) {
  std::uint64_t at = parsed.body;
  for (const PlyElement& element : parsed.elements) {
    const bool of_vertices = element.name == "vertex", of_faces = element.name == "face";
    if (of_vertices || of_faces) {
      Records& records = of_vertices ? vertices : faces;
      if (records.size > 0) refuse(name, "a second element " + element.name);
      records = {element, at, record_size(element)};
    } else if (faces.size == 0 || vertices.size == 0) {
      if (element.has_list()) refuse(name, "the element " + shown(element.name));
    } else {
      break;
    }
    name_what_is_left_out(element);
    if (element.count >= no_index) throw LimitError(name, {}, "has more than 4294967294 elements");
    at += element.count * record_size(element);
    if (at > file_size)
      throw ReadError(name, Place{.byte = file_size}, "the file ends within its data");
  }
  if (vertices.size == 0 || faces.size == 0)
    throw ReadError(name, {}, "has no vertices or no faces");
  axes = axes_of(vertices.element, name);
  if (std::none_of(faces.element.properties.begin(), faces.element.properties.end(),
                   is_corner_list))
    throw ReadError(name, {}, "element face needs a list vertex_indices");
}

std::size_t StreamedSurface::Layout::record_size(const PlyElement& element) const {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) {
    if (p.list && !(element.name == "face" && is_corner_list(p)))
      refuse(name, "the list " + shown(p.name));
    size += size_of(p.type) * (p.list ? 3 : 1) + (p.list ? size_of(p.count_type) : 0);
  }
  return size;
}

void StreamedSurface::Layout::name_what_is_left_out(const PlyElement& element) {
  const bool goes_along = element.name == "vertex" || element.name == "face";
  for (const PlyProperty& p : element.properties)
    if (!goes_along || is_class(p)) left_out.push_back(element.name + ' ' + shown(p.name));
}

// The lines of the file's own one, but for other elements and other counts.
std::string StreamedSurface::Layout::header_for(std::uint64_t vertex_count,
                                                std::uint64_t face_count) const {
  std::istringstream lines(header);
  std::string kept, line, word, element;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "element") words >> element;
    const bool of_vertices = element == "vertex", passed = !of_vertices && element != "face";
    if (word == "element" && !passed)
      kept += "element " + element + ' ' + std::to_string(of_vertices ? vertex_count : face_count);
    else if (word != "element" && (word != "property" || !passed))
      kept += line;
    else
      continue;
    kept += '\n';
  }
  return kept;
}

// Into the records of as many faces.
void StreamedSurface::Layout::put_corners(std::string& records,
                                          const std::vector<Triangle>& triangles) const {
  std::size_t begin = 0, size = 0;
  for (const PlyProperty& p : faces.element.properties) {
    size = size_of(p.type);
    begin += p.list ? size_of(p.count_type) : size;
    if (p.list) break;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      put_integer(&records[i * faces.size + begin + k * size], triangles[i][k], size, encoding);
}

template <typename Visit>
void StreamedSurface::Layout::pieces(const Records& records, const Visit& visit) const {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(name, {}, "cannot be opened");
  const std::uint64_t a_piece = std::max<std::uint64_t>(1, bytes_a_piece / records.size);
  std::string bytes;
  file.seekg(static_cast<std::streamoff>(records.begin));
  for (std::uint64_t first = 0; first < records.element.count; first += a_piece) {
    const std::uint64_t count = std::min(a_piece, records.element.count - first);
    bytes.resize(count * records.size);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw ReadError(name, {}, "has become shorter while it was read");
    visit(Source{name, bytes, records.begin + first * records.size}, first, count);
  }
}

template <std::endian Order, typename Visit>
void StreamedSurface::Layout::vertices_in(const Source& piece, std::size_t count,
                                          const Visit& visit) const {
  PlyBinary<Order> body(piece, PlyHeader{});
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 at(0.0);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const NumberType type = vertices.element.properties[k].type;
      if (axes[k] >= 0)
        at[axes[k]] = body.real(type, "a coordinate");
      else
        body.skip(type);
    }
    visit(at);
  }
}

template <std::endian Order, typename Visit>
void StreamedSurface::Layout::faces_in(const Source& piece, std::size_t count,
                                       const Visit& visit) const {
  PlyBinary<Order> body(piece, PlyHeader{});
  for (std::size_t i = 0; i < count; ++i) {
    Triangle corners{};
    for (const PlyProperty& p : faces.element.properties) {
      if (!p.list) {
        body.skip(p.type);
        continue;
      }
      if (body.integer(p.count_type, "a number of corners") != 3)
        body.fail("only triangles can be read in blocks");
      for (std::uint32_t& corner : corners) {
        const std::int64_t v = body.integer(p.type, "a corner");
        if (v < 0 || std::uint64_t(v) >= vertices.element.count)
          body.fail("there is no vertex " + std::to_string(v));
        corner = static_cast<std::uint32_t>(v);
      }
    }
    visit(corners);
  }
}

void StreamedSurface::Layout::triangles_in(const Source& piece, std::size_t count,
                                           std::vector<Triangle>& triangles) const {
  triangles.clear();
  const auto add = [&](const Triangle& t) { triangles.push_back(t); };
  if (encoding == PlyEncoding::LittleEndian)
    faces_in<std::endian::little>(piece, count, add);
  else
    faces_in<std::endian::big>(piece, count, add);
}

StreamedSurface::StreamedSurface(const std::filesystem::path& path)
    : layout_(std::make_unique<const Layout>(path)) {}
StreamedSurface::~StreamedSurface() = default;
StreamedSurface::StreamedSurface(StreamedSurface&&) noexcept = default;
StreamedSurface& StreamedSurface::operator=(StreamedSurface&&) noexcept = default;

const std::string& StreamedSurface::name() const { return layout_->name; }
std::vector<std::string> StreamedSurface::left_out() const { return layout_->left_out; }

std::uint32_t StreamedSurface::vertices() const {
  return static_cast<std::uint32_t>(layout_->vertices.element.count);
}

std::uint32_t StreamedSurface::faces() const {
  return static_cast<std::uint32_t>(layout_->faces.element.count);
}

void StreamedSurface::each_vertices(
    const std::function<void(std::uint32_t, std::span<const glm::dvec3>)>& visit) const {
  std::vector<glm::dvec3> positions;
  layout_->pieces(layout_->vertices,
                  [&](const Source& piece, std::uint64_t first, std::size_t count) {
                    positions.clear();
                    const auto add = [&](const glm::dvec3& p) { positions.push_back(p); };
                    if (layout_->encoding == PlyEncoding::LittleEndian)
                      layout_->vertices_in<std::endian::little>(piece, count, add);
                    else
                      layout_->vertices_in<std::endian::big>(piece, count, add);
                    visit(static_cast<std::uint32_t>(first), positions);
                  });
}

void StreamedSurface::each_faces(
    const std::function<void(std::uint32_t, std::span<const Triangle>)>& visit) const {
  std::vector<Triangle> triangles;
  layout_->pieces(layout_->faces, [&](const Source& piece, std::uint64_t first, std::size_t count) {
    layout_->triangles_in(piece, count, triangles);
    visit(static_cast<std::uint32_t>(first), triangles);
  });
}

// As a small file of the same kind, which the whole reader reads.
StreamedSurface::Part StreamedSurface::part(
    const std::function<bool(const Triangle&)>& wanted) const {
  std::string vertex_records, face_records;
  std::vector<Triangle> piece_of, triangles;
  VertexRanks used(vertices());
  layout_->pieces(layout_->faces, [&](const Source& piece, std::uint64_t, std::size_t count) {
    layout_->triangles_in(piece, count, piece_of);
    for (std::size_t i = 0; i < count; ++i) {
      if (!wanted(piece_of[i])) continue;
      triangles.push_back(piece_of[i]);
      face_records += piece.bytes.substr(i * layout_->faces.size, layout_->faces.size);
      for (const std::uint32_t v : piece_of[i]) used.add(v);
    }
  });
  used.finish();
  Part part;
  layout_->pieces(
      layout_->vertices, [&](const Source& piece, std::uint64_t first, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
          const auto v = static_cast<std::uint32_t>(first + i);
          if (!used.has(v)) continue;
          part.ids.push_back(v);
          vertex_records += piece.bytes.substr(i * layout_->vertices.size, layout_->vertices.size);
        }
      });
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = used.rank(v);
  layout_->put_corners(face_records, triangles);
  const bool vertices_first = layout_->vertices.begin < layout_->faces.begin;
  part.mesh = read_bytes(name(), layout_->header_for(part.ids.size(), triangles.size()) +
                                     (vertices_first ? vertex_records + face_records
                                                     : face_records + vertex_records))
                  .mesh;
  part.mesh.faces.classes.clear();
  part.mesh.vertex_classes.clear();
  return part;
}

}  // namespace aomd::io
