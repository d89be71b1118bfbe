// OFF: [ST][C][N][4]OFF, with the prefixes in any order, in text and binary.

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/text.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/notes.h"
#include "core/io/off_arrays.h"
#include "core/io/text_cursor.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

/// From four coordinates to three; false where the quotients are not finite.
bool divide(glm::dvec3& p, double weight) {
  p /= weight;
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Counts {
  std::uint64_t vertices = 0, faces = 0;
};

/// Vertices and faces usually have a line each; their numbers may go on in the next one. A line
/// that lacks a number is found out all the same: it takes those of another, which then is missing.
class OffText {
 public:
  OffText(const Source& source, const TextCursor& cursor, const OffHeader& header)
      : source_(source), cursor_(cursor), header_(header), arrays_(header) {
    cursor_.join_lines();
  }

  ReadResult read() {
    const Counts counts = read_counts();
    ReadResult result;
    result.format = Format::Off;
    result.mesh.positions.reserve(at_most(counts.vertices, 6));
    for (std::uint64_t i = 0; i < counts.vertices; ++i) {
      expect_line(i, counts.vertices, "vertices");
      result.mesh.positions.push_back(vertex());
    }
    FaceSink faces(counts.vertices);
    faces.reserve(at_most(counts.faces, 8));
    for (std::uint64_t i = 0; i < counts.faces; ++i) {
      expect_line(i, counts.faces, "faces");
      face(faces);
    }
    faces.finish(result.mesh, result.notes);
    ItemList left_out;
    arrays_.finish(result.mesh, faces, NumberType::Float64, left_out);
    note_left_out(result.notes, left_out);
    cursor_.skip_to_content();
    note_rest(result.notes, cursor_.rest(), "face");
    return result;
  }

 private:
  /// On one line, where the third may be missing, or on a line each.
  Counts read_counts() {
    if (cursor_.skip_to_content())
      cursor_.fail("the file ends before the numbers of vertices and faces");
    const std::int64_t vertices = cursor_.integer("the number of vertices");
    const bool line_each = cursor_.line_done();
    const std::int64_t faces = cursor_.integer("the number of faces");
    if (vertices < 0 || faces < 0) cursor_.fail("a negative number of vertices or faces");
    if (line_each || !cursor_.line_done()) cursor_.integer("the number of edges");
    cursor_.end_line();
    return {static_cast<std::uint64_t>(vertices), static_cast<std::uint64_t>(faces)};
  }

  /// No more than the rest of the file can hold at so many bytes each.
  [[nodiscard]] std::size_t at_most(std::uint64_t promised, std::size_t bytes) const {
    const auto n =
        static_cast<std::size_t>(std::min<std::uint64_t>(promised, cursor_.left() / bytes + 1));
    if (n >= no_index) throw LimitError(source_.name, {}, "more than 2^32 - 2 vertices or faces");
    return n;
  }

  void expect_line(std::uint64_t i, std::uint64_t n, const char* what) {
    if (cursor_.skip_to_content()) {
      cursor_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(n) + ' ' +
                   what);
    }
  }

  glm::dvec3 vertex() {
    const double x = cursor_.real("x"), y = cursor_.real("y"), z = cursor_.real("z");
    glm::dvec3 p(x, y, z);
    if (header_.weight && !divide(p, cursor_.real("the fourth coordinate")))
      cursor_.fail("a vertex at infinity");
    more_.clear();
    while (more_.size() < header_.extra() && !cursor_.line_done()) take_number();
    cursor_.end_line();
    if (header_.extra() > 0) arrays_.add_vertex(more_);
    return p;
  }

  void face(FaceSink& faces) {
    const std::int64_t n = cursor_.integer("the number of vertices of a face");
    if (n < 0 || static_cast<std::uint64_t>(n) > cursor_.left()) {
      cursor_.fail("a face cannot have " + std::to_string(n) + " vertices");
    }
    polygon_.resize(static_cast<std::size_t>(n));
    for (std::int64_t& index : polygon_) index = cursor_.integer("a vertex index");
    more_.clear();
    while (!cursor_.line_done()) take_number();
    if (arrays_.begins_face_colours(more_)) faces.keep_origins();
    const std::string wrong = faces.add(polygon_);
    if (!wrong.empty()) cursor_.fail(wrong);
    cursor_.end_line();
    arrays_.add_face(more_);
  }

  void take_number() {
    const std::string_view word = cursor_.word();
    const auto number = number_of(word);
    if (!number) cursor_.fail("expected a number, found " + shown_no_number(word));
    more_.push_back({*number, word.find_first_not_of("+0123456789") == std::string_view::npos});
  }

  const Source& source_;
  TextCursor cursor_;
  OffHeader header_;
  OffArrays arrays_;
  std::vector<OffArrays::Number> more_;  ///< what stands behind the present vertex or face
  std::vector<std::int64_t> polygon_;
};

/// "OFF BINARY": 32-bit integers and floats, big-endian by the definition and little-endian as some
/// programs write them.
class OffBinary {
 public:
  OffBinary(const Source& source, std::size_t start, const OffHeader& header)
      : source_(source), at_(start), header_(header), arrays_(header) {
    if (fits()) return;
    little_ = true;
    little_ = fits();
  }

  ReadResult read() {
    const std::uint32_t vertices = count("vertices"), faces = count("faces");
    take();  // the number of edges, often 0 or wrong
    require(std::uint64_t{vertices} * vertex_size() + std::uint64_t{faces} * 8);
    ReadResult result;
    result.format = Format::Off;
    result.mesh.positions.reserve(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) result.mesh.positions.push_back(vertex());
    FaceSink sink(vertices);
    sink.reserve(faces);
    for (std::uint32_t i = 0; i < faces; ++i) face(sink);
    sink.finish(result.mesh, result.notes);
    ItemList left_out;
    arrays_.finish(result.mesh, sink, NumberType::Float32, left_out);
    note_left_out(result.notes, left_out);
    note_rest(result.notes, source_.bytes.substr(at_), "face");
    if (little_) result.notes.emplace_back("read as little-endian");
    return result;
  }

 private:
  [[nodiscard]] std::size_t vertex_size() const {
    return 4 * (3 + (header_.weight ? 1u : 0u) + header_.extra());
  }

  /// True where the file holds all the vertices and faces that it promises in the present byte
  /// order. Steps over the faces without looking at their vertices.
  bool fits() {
    const std::uint64_t size = source_.bytes.size(), start = at_;
    if (size - start < 12) return false;
    const std::uint64_t vertices = take(), faces = take();
    std::uint64_t at = start + 12 + vertices * vertex_size();
    const auto step = [&] {
      if (at + 4 > size) return false;
      at_ = static_cast<std::size_t>(at);
      at += 4 + 4 * std::uint64_t{take()};
      return at <= size;
    };
    bool inside = at <= size && faces <= size;
    for (std::uint64_t i = 0; inside && i < 2 * faces; ++i) inside = step();
    at_ = static_cast<std::size_t>(start);
    return inside;
  }

  void require(std::uint64_t bytes) const {
    if (bytes <= source_.bytes.size() - at_) return;
    source_.fail_at_byte(source_.bytes.size(), "the file ends early: " + std::to_string(bytes) +
                                                   " or more bytes are needed from byte " +
                                                   std::to_string(at_));
  }

  std::uint32_t take() {
    require(4);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>(source_.bytes[at_ + (little_ ? 3 - i : i)]);
    at_ += 4;
    return value;
  }

  std::uint32_t count(const char* what) {
    const std::uint32_t n = take();
    if (n > 0x7fffffffu) source_.fail_at_byte(at_ - 4, std::string("a negative number of ") + what);
    return n;
  }

  double real() {
    const auto value = std::bit_cast<float>(take());
    if (!std::isfinite(value)) source_.fail_at_byte(at_ - 4, "a coordinate is not a finite number");
    return value;
  }

  glm::dvec3 vertex() {
    const double x = real(), y = real(), z = real();
    glm::dvec3 p(x, y, z);
    if (header_.weight && !divide(p, real())) source_.fail_at_byte(at_ - 4, "a vertex at infinity");
    take_numbers(header_.extra());
    if (header_.extra() > 0) arrays_.add_vertex(more_);
    return p;
  }

  void face(FaceSink& sink) {
    const std::size_t start = at_;
    const std::uint64_t n = take();
    require(4 * n);
    polygon_.resize(n);
    for (std::int64_t& index : polygon_) index = static_cast<std::int32_t>(take());
    take_numbers(take());
    if (arrays_.begins_face_colours(more_)) sink.keep_origins();
    const std::string wrong = sink.add(polygon_);
    if (!wrong.empty()) source_.fail_at_byte(start, wrong);
    arrays_.add_face(more_);
  }

  void take_numbers(std::uint64_t n) {
    require(4 * n);
    more_.resize(n);
    for (OffArrays::Number& x : more_) x = {std::bit_cast<float>(take()), false};
  }

  const Source& source_;
  std::size_t at_;
  OffHeader header_;
  OffArrays arrays_;
  std::vector<OffArrays::Number> more_;
  bool little_ = false;
  std::vector<std::int64_t> polygon_;
};

}  // namespace

bool is_off(std::string_view first_word) { return off_header(first_word).has_value(); }

ReadResult read_off(const Source& source) {
  const Source text = without_padding(source);
  TextCursor cursor(text, text.bytes, 0, '#');
  cursor.skip_to_content();
  TextCursor ahead = cursor;
  const std::string_view word = ahead.word();
  const auto header = off_header(word);
  if (!header && lower(word).ends_with("off"))
    cursor.fail("only three-dimensional OFF is read, not " + shown(word) + ": export OFF or PLY");
  // Some programs leave the word out.
  if (!header && !is_number(word)) cursor.fail("not an OFF file: it starts with " + shown(word));
  if (!header) return OffText(text, cursor, {}).read();
  TextCursor after = ahead;
  if (lower(after.word()) == "binary") {
    after.end_line();
    return OffBinary(source, after.offset(), *header).read();
  }
  return OffText(text, ahead, *header).read();
}

}  // namespace aomd::io::detail
