#include "core/io/streamed_ply.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/ply_body.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

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

StreamedPly::StreamedPly(const std::filesystem::path& path) : path_(path), name_(path.string()) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) throw ReadError(name_, {}, "is no file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(name_, {}, "cannot be opened");
  const std::string head = first_bytes(file);
  if (!head.starts_with("ply")) refuse(name_, "what is no PLY");
  const PlyHeader header = read_ply_header(Source{name_, head});
  encoding_ = header.encoding;
  if (encoding_ == PlyEncoding::Ascii) refuse(name_, "PLY as text");
  header_ = head.substr(0, header.body);
  take(header, std::filesystem::file_size(path));
}

void StreamedPly::take(const PlyHeader& header, std::uint64_t file_size) {
  std::uint64_t at = header.body;
  for (const PlyElement& element : header.elements) {
    const bool of_vertices = element.name == "vertex", of_faces = element.name == "face";
    if (of_vertices || of_faces) {
      Records& records = of_vertices ? vertices_ : faces_;
      if (records.size > 0) refuse(name_, "a second element " + element.name);
      records = {element, at, record_size(element)};
    } else if (faces_.size == 0 || vertices_.size == 0) {
      if (element.has_list()) refuse(name_, "the element " + shown(element.name));
    } else {
      break;
    }
    name_what_is_left_out(element);
    if (element.count >= no_index) throw LimitError(name_, {}, "has more than 4294967294 elements");
    at += element.count * record_size(element);
    if (at > file_size)
      throw ReadError(name_, Place{.byte = file_size}, "the file ends within its data");
  }
  if (vertices_.size == 0 || faces_.size == 0)
    throw ReadError(name_, {}, "has no vertices or no faces");
  axes_ = axes_of(vertices_.element, name_);
  if (std::none_of(faces_.element.properties.begin(), faces_.element.properties.end(),
                   is_corner_list))
    throw ReadError(name_, {}, "element face needs a list vertex_indices");
}

std::size_t StreamedPly::record_size(const PlyElement& element) const {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) {
    if (p.list && !(element.name == "face" && is_corner_list(p)))
      refuse(name_, "the list " + shown(p.name));
    size += size_of(p.type) * (p.list ? 3 : 1) + (p.list ? size_of(p.count_type) : 0);
  }
  return size;
}

void StreamedPly::name_what_is_left_out(const PlyElement& element) {
  const bool goes_along = element.name == "vertex" || element.name == "face";
  for (const PlyProperty& p : element.properties)
    if (!goes_along || is_class(p)) left_out_.push_back(element.name + ' ' + shown(p.name));
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

template <typename Visit>
void StreamedPly::pieces(const Records& records, const Visit& visit) const {
  std::ifstream file(path_, std::ios::binary);
  if (!file) throw ReadError(name_, {}, "cannot be opened");
  const std::uint64_t a_piece = std::max<std::uint64_t>(1, bytes_a_piece / records.size);
  std::string bytes;
  file.seekg(static_cast<std::streamoff>(records.begin));
  for (std::uint64_t first = 0; first < records.element.count; first += a_piece) {
    const std::uint64_t count = std::min(a_piece, records.element.count - first);
    bytes.resize(count * records.size);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw ReadError(name_, {}, "has become shorter while it was read");
    visit(Source{name_, bytes, records.begin + first * records.size}, count);
  }
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

void StreamedPly::each_vertices(
    const std::function<void(std::span<const glm::dvec3>, std::string_view)>& visit) const {
  std::vector<glm::dvec3> positions;
  pieces(vertices_, [&](const Source& piece, std::size_t count) {
    positions.clear();
    const auto add = [&](const glm::dvec3& p) { positions.push_back(p); };
    if (encoding_ == PlyEncoding::LittleEndian)
      vertices_in<std::endian::little>(piece, count, add);
    else
      vertices_in<std::endian::big>(piece, count, add);
    visit(positions, piece.bytes);
  });
}

void StreamedPly::each_faces(
    const std::function<void(std::span<const Triangle>, std::string_view)>& visit) const {
  std::vector<Triangle> triangles;
  pieces(faces_, [&](const Source& piece, std::size_t count) {
    triangles.clear();
    const auto add = [&](const Triangle& t) { triangles.push_back(t); };
    if (encoding_ == PlyEncoding::LittleEndian)
      faces_in<std::endian::little>(piece, count, add);
    else
      faces_in<std::endian::big>(piece, count, add);
    visit(triangles, piece.bytes);
  });
}

bool StreamedPly::has_records_of(const StreamedPly& other) const {
  const auto alike = [](const Records& a, const Records& b) {
    return std::ranges::equal(a.element.properties, b.element.properties,
                              [](const PlyProperty& p, const PlyProperty& q) {
                                return p.name == q.name && p.type == q.type && p.list == q.list &&
                                       p.count_type == q.count_type;
                              });
  };
  return encoding_ == other.encoding_ && alike(vertices_, other.vertices_) &&
         alike(faces_, other.faces_);
}

std::string StreamedPly::file_of(const std::string& vertex_records, std::string face_records,
                                 const std::vector<Triangle>& corners) const {
  const std::size_t count = vertex_records.size() / vertices_.size;
  put_corners(face_records, corners);
  const bool vertices_first = vertices_.begin < faces_.begin;
  return header_for(count, corners.size()) +
         (vertices_first ? vertex_records + face_records : face_records + vertex_records);
}

}  // namespace aomd::io::detail
