// STL: loose facets, welded where their coordinates are exactly equal.

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>

#include <glm/geometric.hpp>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/class_names.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/notes.h"
#include "core/io/polygon.h"
#include "core/io/text_cursor.h"
#include "core/io/weld.h"

namespace aomd::io::detail {
namespace {

constexpr std::size_t header_size = 80, data_start = 84, facet_size = 50;

using Facet = std::array<glm::dvec3, 3>;

std::uint32_t little_u32(const char* p) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(p[i]);
  return value;
}

/// Welds facets into a mesh.
class FacetSink {
 public:
  void add(const Facet& facet, std::int32_t solid) {
    const std::array<std::uint32_t, 3> v{points_.add(facet[0]), points_.add(facet[1]),
                                         points_.add(facet[2])};
    corners_ += 3;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
      ++dropped_;
      return;
    }
    faces_.add(Shape::Triangle, {v[0], v[1], v[2]}, ModelRef(2, solid));
  }

  [[nodiscard]] bool empty() const { return corners_ == 0; }

  /// `rest` is what the file holds after the last facet or solid.
  ReadResult finish(const std::vector<std::string>& solids, std::string_view rest,
                    std::string_view last) {
    ReadResult result;
    result.format = Format::Stl;
    result.notes.push_back(std::to_string(corners_) + " corners welded into " +
                           counted(points_.size(), "vertex"));
    if (dropped_ > 0) result.notes.push_back(counted(dropped_, "facet") + " without area dropped");
    const std::vector<ModelRef> classes = classes_of_parts(solids);
    for (ModelRef& m : faces_.classes) m = classes[static_cast<std::size_t>(m.tag())];
    result.mesh.positions = points_.take();
    result.mesh.faces = std::move(faces_);
    drop_empty_classes(result.mesh);
    if (result.mesh.classified())
      result.notes.push_back("faces classified by " + counted(solids.size(), "solid"));
    note_rest(result.notes, rest, last);
    return result;
  }

 private:
  Welder points_;
  EntityList faces_;
  std::size_t corners_ = 0, dropped_ = 0;
};

class StlText {
 public:
  explicit StlText(const Source& source) : cursor_(source, source.bytes) {
    cursor_.pass_comment_lines();
  }

  ReadResult read() {
    while (!cursor_.skip_to_content() && !at_rest()) {
      expect("solid");
      solids_.emplace_back(cursor_.rest_of_line());
      while (!done()) facet();
      cursor_.skip_line();  // the name again
    }
    if (solids_.empty()) cursor_.fail("not an STL file");
    return sink_.finish(solids_, cursor_.rest(), "solid");
  }

 private:
  static bool same(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) {
             return std::tolower(static_cast<unsigned char>(a)) == b;
           });
  }

  /// True where what follows the solids is none, nor a part of one.
  [[nodiscard]] bool at_rest() const {
    constexpr std::string_view words[] = {"solid", "facet", "outer", "vertex"};
    TextCursor ahead = cursor_;
    const std::string_view word = ahead.word();
    return !sink_.empty() && std::none_of(std::begin(words), std::end(words),
                                          [&](std::string_view w) { return same(word, w); });
  }

  void expect(std::string_view keyword) {
    if (cursor_.skip_to_content())
      cursor_.fail("the file ends where \"" + std::string(keyword) + "\" should follow");
    const std::string_view word = cursor_.word();
    if (!same(word, keyword))
      cursor_.fail("expected \"" + std::string(keyword) + "\", found " + shown(word));
  }

  /// "endfacet", or "end facet" as some programs write.
  static bool ends(TextCursor& cursor, std::string_view what) {
    const std::string_view word = cursor.word();
    if (word.size() < 3 || !same(word.substr(0, 3), "end")) return false;
    return same(word.size() == 3 ? cursor.word() : word.substr(3), what);
  }

  void expect_end(std::string_view what) {
    if (cursor_.skip_to_content())
      cursor_.fail("the file ends where \"end" + std::string(what) + "\" should follow");
    TextCursor ahead = cursor_;
    if (!ends(ahead, what))
      cursor_.fail("expected \"end" + std::string(what) + "\", found " + shown(cursor_.word()));
    cursor_ = ahead;
  }

  /// True, and past it, where the solid ends.
  bool done() {
    if (cursor_.skip_to_content()) cursor_.fail("the file ends before \"endsolid\"");
    TextCursor ahead = cursor_;
    if (!ends(ahead, "solid")) return false;
    cursor_ = ahead;
    return true;
  }

  void facet() {
    expect("facet");
    cursor_.skip_line();  // the normal, which the corners give better
    expect("outer");
    expect("loop");
    Facet facet;
    for (glm::dvec3& p : facet) {
      expect("vertex");
      const double x = cursor_.real("x"), y = cursor_.real("y"), z = cursor_.real("z");
      p = {x, y, z};
      cursor_.end_line();
    }
    expect_end("loop");
    expect_end("facet");
    sink_.add(facet, static_cast<std::int32_t>(solids_.size()) - 1);
  }

  TextCursor cursor_;
  std::vector<std::string> solids_;
  FacetSink sink_;
};

ReadResult read_binary(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.size() < data_start)
    source.fail_at_byte(bytes.size(), "too short for an STL file: 84 bytes or more");
  const std::uint32_t n = little_u32(bytes.data() + header_size);
  const std::uint64_t expected = data_start + facet_size * std::uint64_t{n};
  if (bytes.size() < expected) {
    source.fail_at_byte(bytes.size(), "the file ends early: " + std::to_string(n) +
                                          " facets need " + std::to_string(expected) + " bytes");
  }
  if (n == 0 && !is_blank(bytes.substr(data_start)))
    source.fail_at_byte(data_start, "data after a header that promises no facets");
  FacetSink sink;
  for (std::size_t at = data_start; at < expected; at += facet_size) {
    Facet facet;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::size_t place = at + 12 + 4 * i;  // after the normal
      const auto value = std::bit_cast<float>(little_u32(bytes.data() + place));
      if (!std::isfinite(value)) source.fail_at_byte(place, "a coordinate is not a finite number");
      facet[i / 3][static_cast<int>(i % 3)] = value;
    }
    sink.add(facet, 0);
  }
  return sink.finish({"binary"}, bytes.substr(expected), "facet");
}

/// The faces as triangles; quads and the like are split.
template <class Use>
void for_each_facet(const MeshData& mesh, Use&& use) {
  std::vector<std::uint32_t> t;
  for_each_entity(mesh.faces, [&](auto corners, ModelRef model) {
    t.clear();
    triangulate(mesh.positions, corners, t);
    for (std::size_t i = 0; i < t.size(); i += 3) {
      use(Facet{mesh.positions[t[i]], mesh.positions[t[i + 1]], mesh.positions[t[i + 2]]}, model);
    }
  });
}

glm::dvec3 normal_of(const Facet& f) {
  const glm::dvec3 n = glm::cross(f[1] - f[0], f[2] - f[0]);
  const double length = glm::length(n);
  return length > 0 ? n / length : glm::dvec3(0);
}

std::string write_binary(const MeshData& mesh) {
  ByteWriter out;
  std::uint32_t n = 0;
  for_each_facet(mesh, [&](const Facet&, ModelRef) { ++n; });
  out.reserve(data_start + facet_size * n);
  // Not "solid": some readers take that for text.
  std::string header = "AOMD Studio binary STL";
  header.resize(header_size, ' ');
  out << header;
  const auto point = [&](const glm::dvec3& p) {
    for (int axis = 0; axis < 3; ++axis) out.raw<std::endian::little>(static_cast<float>(p[axis]));
  };
  out.raw<std::endian::little>(n);
  for_each_facet(mesh, [&](const Facet& f, ModelRef) {
    point(normal_of(f));
    for (const glm::dvec3& p : f) point(p);
    out.raw<std::endian::little>(std::uint16_t{0});
  });
  return out.take();
}

void write_facet(ByteWriter& out, const Facet& f) {
  const auto point = [&](const glm::dvec3& p) {
    out << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
  };
  out << "facet normal";
  const glm::dvec3 n = normal_of(f);
  out << ' ' << static_cast<float>(n.x) << ' ' << static_cast<float>(n.y) << ' '
      << static_cast<float>(n.z) << '\n';
  out << "outer loop\n";
  for (const glm::dvec3& p : f) {
    out << "vertex";
    point(p);
  }
  out << "endloop\nendfacet\n";
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= data_start &&
         bytes.size() ==
             data_start + facet_size * std::uint64_t{little_u32(bytes.data() + header_size)};
}

ReadResult read_stl(const Source& source, bool binary) {
  return binary ? read_binary(source) : StlText(without_padding(source)).read();
}

std::string write_stl(const MeshData& mesh, bool binary) {
  if (binary) return write_binary(mesh);
  std::map<ModelRef, ByteWriter> solids;
  for_each_facet(mesh, [&](const Facet& f, ModelRef model) { write_facet(solids[model], f); });
  if (solids.empty()) solids[ModelRef()];
  ByteWriter out;
  for (auto& [model, facets] : solids) {
    const std::string name = mesh.faces.classes.empty() ? "mesh" : class_name(model);
    out << "solid " << name << '\n' << facets.take() << "endsolid " << name << '\n';
  }
  return out.take();
}

}  // namespace aomd::io::detail
