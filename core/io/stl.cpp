// STL: loose facets, welded where their coordinates are exactly equal.

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>

#include "core/base/text.h"
#include "core/io/class_names.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/named_faces.h"
#include "core/io/notes.h"
#include "core/io/stl_marks.h"
#include "core/io/text_cursor.h"
#include "core/io/weld.h"

namespace aomd::io::detail {
namespace {

using Facet = std::array<glm::dvec3, 3>;

std::uint32_t little_u32(const char* p) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(p[i]);
  return value;
}

/// Welds facets into a mesh.
class FacetSink {
 public:
  /// `mark` is the attribute of binary facets, by which programs say colours.
  void add(const Facet& facet, std::int32_t solid, std::uint16_t mark = 0) {
    const std::array<std::uint32_t, 3> v{points_.add(facet[0]), points_.add(facet[1]),
                                         points_.add(facet[2])};
    corners_ += 3;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
      ++dropped_;
      return;
    }
    if (mark != 0) marks_.resize(faces_.size());
    faces_.add(Shape::Triangle, {v[0], v[1], v[2]}, ModelRef(2, solid));
    if (mark != 0) marks_.push_back(mark);
  }

  [[nodiscard]] bool empty() const { return corners_ == 0; }

  /// Where colours of facets have the order of Magics.
  void use_magics() { magics_ = true; }

  /// `rest` is what the file holds after the last facet or solid.
  ReadResult finish(const std::vector<std::string>& solids, std::string_view rest,
                    std::string_view last) {
    ReadResult result;
    result.format = Format::Stl;
    result.notes.push_back(std::to_string(corners_) + " corners welded into " +
                           counted(points_.size(), "vertex"));
    if (dropped_ > 0) result.notes.push_back(counted(dropped_, "facet") + " without area dropped");
    const std::vector<ModelRef> classes = classes_of_parts(solids);
    add_names(solids, result.mesh);
    add_marks(result.mesh);
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
  /// The names of solids: of one alone a remark, but for those that our writer gives.
  void add_names(const std::vector<std::string>& solids, MeshData& mesh) const {
    const bool ours = std::all_of(solids.begin(), solids.end(), [](const std::string& name) {
      return name.empty() || class_of_name(name);
    });
    if (ours) return;
    if (solids.size() == 1) {
      if (solids[0] != stl_usual_name) mesh.remarks.push_back({stl_solid, solids[0]});
      return;
    }
    Attribute label{stl_solid, 2, 1, true, {}};
    for (const ModelRef m : faces_.classes) label.values.push_back(m.tag());
    label.names = solids;
    mesh.attributes.push_back(std::move(label));
  }

  /// Colours where every facet has one, else the marks as they are.
  void add_marks(MeshData& mesh) {
    if (marks_.empty()) return;
    marks_.resize(faces_.size());
    const bool coloured = std::all_of(marks_.begin(), marks_.end(), [this](std::uint16_t mark) {
      return stl_colour_is_valid(mark, magics_);
    });
    Attribute a{coloured ? "color" : stl_mark, 2, coloured ? 3 : 1, true, {}};
    for (const std::uint16_t mark : marks_) {
      if (!coloured) a.values.push_back(mark);
      for (int k = 0; coloured && k < 3; ++k) a.values.push_back(stl_shade(mark, k, magics_));
    }
    a.type = coloured ? NumberType::UInt8 : NumberType::UInt16;
    if (coloured) a.meaning = Meaning::Colour;
    mesh.attributes.push_back(std::move(a));
  }

  Welder points_;
  EntityList faces_;
  std::vector<std::uint16_t> marks_;  ///< up to the last facet that has one
  bool magics_ = false;
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
  if (bytes.substr(0, header_size).find("COLOR=") != std::string_view::npos) sink.use_magics();
  for (std::size_t at = data_start; at < expected; at += facet_size) {
    Facet facet;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::size_t place = at + 12 + 4 * i;  // after the normal
      const auto value = std::bit_cast<float>(little_u32(bytes.data() + place));
      if (!std::isfinite(value)) source.fail_at_byte(place, "a coordinate is not a finite number");
      facet[i / 3][static_cast<int>(i % 3)] = value;
    }
    const std::uint32_t mark = little_u32(bytes.data() + at + facet_size - 4) >> 16;
    sink.add(facet, 0, static_cast<std::uint16_t>(mark));
  }
  return sink.finish({""}, bytes.substr(expected), "facet");
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

}  // namespace aomd::io::detail
