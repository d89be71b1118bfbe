// OFF: [ST][C][N]OFF in text and binary. Colours, normals and texture coordinates are passed over.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/text_cursor.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

/// How many values a vertex line may have after its coordinates, by the header word; nothing where
/// the word is none of ours.
std::optional<std::size_t> extra_values(std::string_view word) {
  std::size_t extra = 0;
  const auto take = [&](std::string_view prefix, std::size_t values) {
    if (!word.starts_with(prefix)) return;
    word.remove_prefix(prefix.size());
    extra += values;
  };
  take("ST", 2);
  take("C", 4);
  take("N", 3);
  if (word != "OFF") return {};
  return extra;
}

struct Counts {
  std::uint64_t vertices = 0, faces = 0;
};

class OffText {
 public:
  OffText(const Source& source, const TextCursor& cursor, std::size_t extra)
      : source_(source), cursor_(cursor), extra_(extra) {}

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
    if (!cursor_.skip_to_content())
      cursor_.fail("data after the last face: " + shown(cursor_.word()));
    note_polygons(result.notes, faces.finish(result.mesh));
    return result;
  }

 private:
  Counts read_counts() {
    if (cursor_.skip_to_content())
      cursor_.fail("the file ends before the numbers of vertices and faces");
    const std::int64_t vertices = cursor_.integer("the number of vertices");
    const std::int64_t faces = cursor_.integer("the number of faces");
    if (vertices < 0 || faces < 0) cursor_.fail("a negative number of vertices or faces");
    if (!cursor_.line_done()) cursor_.integer("the number of edges");
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
    for (std::size_t i = 0; i < extra_ && !cursor_.line_done(); ++i) pass_over_number();
    cursor_.end_line();
    return {x, y, z};
  }

  void face(FaceSink& faces) {
    const std::int64_t n = cursor_.integer("the number of vertices of a face");
    if (n < 0 || static_cast<std::uint64_t>(n) > cursor_.left()) {
      cursor_.fail("a face cannot have " + std::to_string(n) + " vertices");
    }
    polygon_.resize(static_cast<std::size_t>(n));
    for (std::int64_t& index : polygon_) index = cursor_.integer("a vertex index");
    const std::string wrong = faces.add(polygon_);
    if (!wrong.empty()) cursor_.fail(wrong);
    while (!cursor_.line_done()) pass_over_number();  // a colour
    cursor_.end_line();
  }

  void pass_over_number() {
    const std::string_view word = cursor_.word();
    if (!is_number(word)) cursor_.fail("expected a number, found " + shown(word));
  }

  const Source& source_;
  TextCursor cursor_;
  std::size_t extra_;
  std::vector<std::int64_t> polygon_;
};

/// "OFF BINARY": 32-bit integers and floats, big-endian.
class OffBinary {
 public:
  OffBinary(const Source& source, std::size_t start, std::size_t extra)
      : source_(source), at_(start), extra_(extra) {}

  ReadResult read() {
    const std::uint32_t vertices = count("vertices"), faces = count("faces");
    take();  // the number of edges, often 0 or wrong
    require(std::uint64_t{vertices} * 4 * (3 + extra_) + std::uint64_t{faces} * 8);
    ReadResult result;
    result.format = Format::Off;
    result.mesh.positions.reserve(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) result.mesh.positions.push_back(vertex());
    FaceSink sink(vertices);
    sink.reserve(faces);
    for (std::uint32_t i = 0; i < faces; ++i) face(sink);
    if (at_ != source_.bytes.size()) source_.fail_at_byte(at_, "data after the last face");
    note_polygons(result.notes, sink.finish(result.mesh));
    return result;
  }

 private:
  void require(std::uint64_t bytes) const {
    if (bytes <= source_.bytes.size() - at_) return;
    source_.fail_at_byte(source_.bytes.size(), "the file ends early: " + std::to_string(bytes) +
                                                   " or more bytes are needed from byte " +
                                                   std::to_string(at_));
  }

  std::uint32_t take() {
    require(4);
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>(source_.bytes[at_++]);
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
    require(4 * extra_);
    at_ += 4 * extra_;
    return {x, y, z};
  }

  void face(FaceSink& sink) {
    const std::size_t start = at_;
    const std::uint64_t n = take();
    require(4 * n);
    polygon_.resize(n);
    for (std::int64_t& index : polygon_) index = static_cast<std::int32_t>(take());
    const std::string wrong = sink.add(polygon_);
    if (!wrong.empty()) source_.fail_at_byte(start, wrong);
    const std::uint64_t colours = take();
    require(4 * colours);
    at_ += 4 * colours;
  }

  const Source& source_;
  std::size_t at_, extra_;
  std::vector<std::int64_t> polygon_;
};

std::string write_off_binary(const MeshData& mesh) {
  ByteWriter out;
  const auto integer = [&](std::size_t n) {
    out.raw<std::endian::big>(static_cast<std::uint32_t>(n));
  };
  out << "OFF BINARY\n";
  for (const std::size_t n : {mesh.positions.size(), mesh.faces.size(), std::size_t{0}}) integer(n);
  for (const glm::dvec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) out.raw<std::endian::big>(static_cast<float>(p[axis]));
  }
  for_each_entity(mesh.faces, [&](auto corners, ModelRef) {
    integer(corners.size());
    for (const std::uint32_t v : corners) integer(v);
    integer(0);  // no colours
  });
  return out.take();
}

}  // namespace

bool is_off(std::string_view first_word) { return extra_values(first_word).has_value(); }

ReadResult read_off(const Source& source) {
  TextCursor cursor(source, source.bytes, 0, '#');
  cursor.skip_to_content();
  TextCursor ahead = cursor;
  const std::string_view word = ahead.word();
  const auto extra = extra_values(word);
  if (!extra && word.ends_with("OFF"))
    cursor.fail("only three-dimensional OFF is read, not " + shown(word));
  // Some programs leave the word out.
  if (!extra && !is_number(word)) cursor.fail("not an OFF file: it starts with " + shown(word));
  if (!extra) return OffText(source, cursor, 0).read();
  TextCursor after = ahead;
  if (after.word() == "BINARY") {
    after.end_line();
    return OffBinary(source, after.offset(), *extra).read();
  }
  return OffText(source, ahead, *extra).read();
}

std::string write_off(const MeshData& mesh, bool binary) {
  if (binary) return write_off_binary(mesh);
  ByteWriter out;
  out.reserve(48 * mesh.positions.size() + 24 * mesh.faces.size());
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const glm::dvec3& p : mesh.positions) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for_each_entity(mesh.faces, [&](auto corners, ModelRef) {
    out << corners.size();
    for (const std::uint32_t v : corners) out << ' ' << v;
    out << '\n';
  });
  return out.take();
}

}  // namespace aomd::io::detail
