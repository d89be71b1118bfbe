#include "core/io/streamed_ply.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/io.h"
#include "core/io/ply_body.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

constexpr std::size_t most_header_bytes = 1 << 16;

std::string first_bytes(std::ifstream& file) {
  std::string bytes(most_header_bytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  return bytes;
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

StreamedPly::StreamedPly(const std::filesystem::path& path) : StreamedFile(path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(name(), {}, "cannot be opened");
  const std::string head = first_bytes(file);
  const PlyHeader header = read_ply_header(Source{name(), head});
  encoding_ = header.encoding;
  if (encoding_ == PlyEncoding::Ascii) refuse("PLY as text");
  header_ = head.substr(0, header.body);
  take(header, std::filesystem::file_size(path));
}

void StreamedPly::take(const PlyHeader& header, std::uint64_t file_size) {
  std::uint64_t at = header.body;
  for (const PlyElement& element : header.elements) {
    const bool of_vertices = element.name == "vertex", of_faces = element.name == "face";
    if (of_vertices || of_faces) {
      Records& records = of_vertices ? vertices_ : faces_;
      if (records.size > 0) refuse("a second element " + element.name);
      records = {element, at, record_size(element)};
    } else if (faces_.size == 0 || vertices_.size == 0) {
      if (element.has_list()) refuse("the element " + shown(element.name));
    } else {
      break;
    }
    name_what_is_left_out(element);
    if (element.count >= no_index)
      throw LimitError(name(), {}, "has more than 4294967294 elements");
    at += element.count * record_size(element);
    if (at > file_size)
      throw ReadError(name(), Place{.byte = file_size}, "the file ends within its data");
  }
  if (vertices_.size == 0 || faces_.size == 0)
    throw ReadError(name(), {}, "has no vertices or no faces");
  axes_ = axes_of(vertices_.element, name());
  if (std::none_of(faces_.element.properties.begin(), faces_.element.properties.end(),
                   is_corner_list))
    throw ReadError(name(), {}, "element face needs a list vertex_indices");
}

std::size_t StreamedPly::record_size(const PlyElement& element) const {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) {
    if (p.list && !(element.name == "face" && is_corner_list(p)))
      refuse("the list " + shown(p.name));
    size += size_of(p.type) * (p.list ? 3 : 1) + (p.list ? size_of(p.count_type) : 0);
  }
  return size;
}

void StreamedPly::name_what_is_left_out(const PlyElement& element) {
  const bool goes_along = element.name == "vertex" || element.name == "face";
  for (const PlyProperty& p : element.properties)
    if (!goes_along || is_class(p)) leave_out(element.name + ' ' + shown(p.name));
}

// The lines of the file's own one, but for other elements and other counts.
std::string StreamedPly::header_for(std::size_t vertex_count, std::size_t face_count) const {
  std::istringstream lines(header_);
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
void StreamedPly::put_corners(std::string& records, const std::vector<Triangle>& corners) const {
  std::size_t begin = 0, size = 0;
  for (const PlyProperty& p : faces_.element.properties) {
    size = size_of(p.type);
    begin += p.list ? size_of(p.count_type) : size;
    if (p.list) break;
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      put_integer(&records[i * faces_.size + begin + k * size], corners[i][k], size, encoding_);
}

template <std::endian Order, typename Visit>
void StreamedPly::vertices_in(const Source& piece, std::size_t count, const Visit& visit) const {
  PlyBinary<Order> body(piece, PlyHeader{});
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 at(0.0);
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const NumberType type = vertices_.element.properties[k].type;
      if (axes_[k] >= 0)
        at[axes_[k]] = body.real(type, "a coordinate");
      else
        body.skip(type);
    }
    visit(at);
  }
}

template <std::endian Order, typename Visit>
void StreamedPly::faces_in(const Source& piece, std::size_t count, const Visit& visit) const {
  PlyBinary<Order> body(piece, PlyHeader{});
  for (std::size_t i = 0; i < count; ++i) {
    Triangle corners{};
    for (const PlyProperty& p : faces_.element.properties) {
      if (!p.list) {
        body.skip(p.type);
        continue;
      }
      if (body.integer(p.count_type, "a number of corners") != 3)
        body.fail("only triangles can be read in blocks");
      for (std::uint32_t& corner : corners) {
        const std::int64_t v = body.integer(p.type, "a corner");
        if (v < 0 || std::uint64_t(v) >= vertices_.element.count)
          body.fail("there is no vertex " + std::to_string(v));
        corner = static_cast<std::uint32_t>(v);
      }
    }
    visit(corners);
  }
}

void StreamedPly::each_vertices(const VisitVertices& visit) const {
  std::vector<glm::dvec3> positions;
  const auto decode = [&](const Source& piece, std::size_t count) {
    positions.clear();
    const auto add = [&](const glm::dvec3& p) { positions.push_back(p); };
    if (encoding_ == PlyEncoding::LittleEndian)
      vertices_in<std::endian::little>(piece, count, add);
    else
      vertices_in<std::endian::big>(piece, count, add);
    visit(positions, piece.bytes);
  };
  each_piece(vertices_.begin, vertices_.size, vertices_.element.count, decode);
}

void StreamedPly::each_faces(const VisitFaces& visit) const {
  std::vector<Triangle> triangles;
  const auto decode = [&](const Source& piece, std::size_t count) {
    triangles.clear();
    const auto add = [&](const Triangle& t) { triangles.push_back(t); };
    if (encoding_ == PlyEncoding::LittleEndian)
      faces_in<std::endian::little>(piece, count, add);
    else
      faces_in<std::endian::big>(piece, count, add);
    visit(triangles, piece.bytes);
  };
  each_piece(faces_.begin, faces_.size, faces_.element.count, decode);
}

std::string StreamedPly::kind_of_records() const {
  std::ostringstream kind;
  kind << "ply " << static_cast<int>(encoding_);
  for (const Records* records : {&vertices_, &faces_}) {
    kind << '\n' << records->element.name;
    for (const PlyProperty& p : records->element.properties) {
      kind << '\n' << p.name << ' ' << static_cast<int>(p.type);
      if (p.list) kind << ' ' << static_cast<int>(p.count_type);
    }
  }
  return kind.str();
}

MeshData StreamedPly::mesh_of(const std::string& vertex_records, std::string face_records,
                              const std::vector<Triangle>& corners) const {
  const std::size_t count = vertex_records.size() / vertices_.size;
  put_corners(face_records, corners);
  const bool vertices_first = vertices_.begin < faces_.begin;
  const std::string file =
      header_for(count, corners.size()) +
      (vertices_first ? vertex_records + face_records : face_records + vertex_records);
  return read_bytes(name(), file).mesh;
}

}  // namespace aomd::io::detail
