// Medit .mesh, text: versions 1 to 4 differ only in the precision they promise.

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/formats.h"
#include "core/io/medit.h"
#include "core/io/text_cursor.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

bool same(std::string_view word, std::string_view keyword) {
  return word.size() == keyword.size() &&
         std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) ==
                  std::tolower(static_cast<unsigned char>(b));
         });
}

/// One list of elements as read: where it stands among those of its dimension.
struct Part {
  bool read = false;
  std::size_t first = 0, count = 0;
  std::vector<std::size_t> dropped{};  ///< places in the list that gave no element; ascending
};

/// A 1-based number of something that may follow later, and the end of its word.
struct Mark {
  std::int64_t number = 0;
  std::size_t offset = 0;
};

/// Vectors given once and referred to by vertices.
struct Vectors {
  std::vector<glm::dvec3> values;
  std::vector<std::pair<std::uint32_t, Mark>> uses;
};

class MeditReader {
 public:
  explicit MeditReader(const Source& source)
      : source_(source), cursor_(source, source.bytes, 0, '#') {}

  ReadResult read() {
    header();
    while (!cursor_.skip_to_content()) {
      const TextCursor start = cursor_;
      const std::string_view keyword = cursor_.word();
      if (same(keyword, "End")) break;
      section(start, keyword);
    }
    if (!has_vertices_) cursor_.fail("the file has no Vertices");
    classify();
    add_attributes();
    ReadResult result{std::move(mesh_), Format::Medit, {}};
    repeats_.note(result.notes);
    if (!passed_over_.empty()) result.notes.push_back("passed over: " + passed_over_);
    return result;
  }

 private:
  void header() {
    if (is_binary_medit(source_.bytes))
      source_.fail_at_byte(0, "binary Medit (.meshb) is not read, only text");
    cursor_.skip_to_content();
    const std::string_view first = cursor_.word();
    if (!same(first, "MeshVersionFormatted"))
      cursor_.fail("does not start with MeshVersionFormatted but with " + shown(first));
    const std::int64_t version = integer("the version");
    if (version < 1 || version > 4)
      cursor_.fail("version " + std::to_string(version) + " is not read, only 1 to 4");
  }

  void expect_more(const char* what) {
    if (cursor_.skip_to_content()) cursor_.fail(std::string("the file ends before ") + what);
  }
  std::int64_t integer(const char* what) {
    expect_more(what);
    return cursor_.integer(what);
  }
  double real(const char* what) {
    expect_more(what);
    return cursor_.real(what);
  }

  /// The number of items that take at least so many numbers each.
  std::size_t count(std::string_view keyword, std::size_t numbers) {
    const std::int64_t n = integer("the number of items");
    if (n < 0) cursor_.fail("a negative number of " + std::string(keyword));
    if (static_cast<std::uint64_t>(n) >= no_index)
      throw LimitError(source_.name, {}, "more than 2^32 - 2 " + std::string(keyword));
    if (static_cast<std::uint64_t>(n) > cursor_.left() / (2 * numbers) + 1)
      cursor_.fail("the file is too short for " + std::to_string(n) + ' ' + std::string(keyword));
    return static_cast<std::size_t>(n);
  }

  void section(const TextCursor& start, std::string_view keyword) {
    if (same(keyword, "Dimension")) return dimension();
    if (same(keyword, "Vertices")) return vertices(keyword);
    if (const MeditList* list = list_of(keyword)) return elements(start, *list);
    if (same(keyword, "Corners")) return marks(keyword, corners_);
    if (same(keyword, "RequiredVertices")) return marks(keyword, required_[0]);
    if (same(keyword, "Ridges")) return marks(keyword, ridges_);
    if (keyword.size() > 8 && same(keyword.substr(0, 8), "Required")) {
      if (const MeditList* list = list_of(keyword.substr(8)))
        return marks(keyword, required_[static_cast<std::size_t>(list->shape)]);
    }
    if (same(keyword, "Normals")) return vectors(keyword, normals_);
    if (same(keyword, "Tangents")) return vectors(keyword, tangents_);
    if (same(keyword, "NormalAtVertices")) return vector_uses(keyword, normals_);
    if (same(keyword, "TangentAtVertices")) return vector_uses(keyword, tangents_);
    pass_over(start, keyword);
  }

  static const MeditList* list_of(std::string_view keyword) {
    if (same(keyword, "Pentahedra")) keyword = "Prisms";
    for (const MeditList& list : medit_lists) {
      if (same(keyword, list.keyword)) return &list;
    }
    return nullptr;
  }

  /// Up to the next word that starts with a letter.
  void pass_over(const TextCursor& start, std::string_view keyword) {
    const auto is_keyword = [](std::string_view word) {
      return std::isalpha(static_cast<unsigned char>(word[0])) && !is_number(word);
    };
    if (!is_keyword(keyword)) start.fail("expected a keyword, found " + shown(keyword));
    passed_over_ += (passed_over_.empty() ? "" : ", ") + shown(keyword);
    while (!cursor_.skip_to_content()) {
      TextCursor ahead = cursor_;
      const std::string_view word = ahead.word();
      if (is_keyword(word)) return;
      if (word[0] == '"') {
        cursor_.skip_line();
      } else {
        cursor_ = ahead;
      }
    }
  }

  void dimension() {
    const std::int64_t d = integer("the dimension");
    if (d != 2 && d != 3) cursor_.fail("dimension " + std::to_string(d) + "; it is 2 or 3");
    dimension_ = static_cast<int>(d);
  }

  void vertices(std::string_view keyword) {
    if (dimension_ == 0) cursor_.fail("Vertices before Dimension");
    if (has_vertices_) cursor_.fail("Vertices are listed twice");
    has_vertices_ = true;
    const std::size_t n = count(keyword, static_cast<std::size_t>(dimension_) + 1);
    mesh_.positions.reserve(n);
    references_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double x = real("x"), y = real("y"), z = dimension_ == 3 ? real("z") : 0;
      mesh_.positions.emplace_back(x, y, z);
      references_.push_back(reference());
    }
  }

  std::int32_t reference() {
    const std::int64_t tag = integer("a reference");
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      cursor_.fail("reference " + std::to_string(tag) + " is out of range");
    return static_cast<std::int32_t>(tag);
  }

  void elements(const TextCursor& start, const MeditList& kind) {
    if (!has_vertices_) start.fail(std::string(kind.keyword) + " before Vertices");
    const ShapeTemplate& shape = shape_template(kind.shape);
    Part& part = parts_[static_cast<std::size_t>(kind.shape)];
    if (part.read) start.fail(std::string(kind.keyword) + " are listed twice");
    const auto corners = static_cast<std::size_t>(shape.vertex_count);
    EntityList& list = mesh_.list(shape.dimension);
    part = {true, list.size(), count(kind.keyword, corners + 1)};
    list.shapes.reserve(list.size() + part.count);
    list.vertices.reserve(list.vertices.size() + corners * part.count);
    std::array<std::int64_t, 8> v{};
    const std::span<std::int64_t> used(v.data(), corners);
    for (std::size_t i = 0; i < part.count; ++i) {
      for (std::int64_t& index : used) index = integer("a vertex index") - 1;
      const std::string wrong = entity_defect(kind.shape, used, mesh_.positions.size(), 1);
      if (wrong.empty()) {
        append(list, kind.shape, used);
      } else if (!add_rest(kind.shape, used, list, wrong)) {
        part.dropped.push_back(i);
        reference();
        continue;
      }
      const std::int32_t tag = reference();
      list.classes.emplace_back(shape.dimension, tag);
      tagged_ = tagged_ || tag != 0;
    }
  }

  /// Adds what is left of an edge or a face without its repeated corners; false where nothing is.
  bool add_rest(Shape shape, std::span<const std::int64_t> used, EntityList& list,
                const std::string& wrong) {
    const auto left = without_repeats(shape, used, mesh_.positions.size(), repeats_);
    if (!left) cursor_.fail(wrong);
    if (!left->empty()) append(list, Shape::Triangle, *left);
    return !left->empty();
  }

  Mark number() {
    const std::int64_t n = integer("an index");
    return {n, cursor_.offset()};
  }

  /// Marked items by their numbers; checked once all lists are there.
  void marks(std::string_view keyword, std::vector<Mark>& into) {
    const std::size_t n = count(keyword, 1);
    for (std::size_t i = 0; i < n; ++i) into.push_back(number());
  }

  void vectors(std::string_view keyword, Vectors& into) {
    if (dimension_ == 0) cursor_.fail(std::string(keyword) + " before Dimension");
    const std::size_t n = count(keyword, static_cast<std::size_t>(dimension_));
    for (std::size_t i = 0; i < n; ++i) {
      const double x = real("x"), y = real("y"), z = dimension_ == 3 ? real("z") : 0;
      into.values.emplace_back(x, y, z);
    }
  }

  void vector_uses(std::string_view keyword, Vectors& into) {
    const std::size_t n = count(keyword, 2);
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t vertex = integer("a vertex index") - 1;
      if (outside(vertex, mesh_.positions.size()))
        cursor_.fail(out_of_range(vertex, mesh_.positions.size(), 1));
      into.uses.emplace_back(static_cast<std::uint32_t>(vertex), number());
    }
  }

  /// References classify, unless there are only zeros and nothing else that tells of a model.
  void classify() {
    if (!tagged_ && corners_.empty() && ridges_.empty()) {
      for (int d = 1; d <= 3; ++d) mesh_.list(d).classes.clear();
      return;
    }
    mesh_.vertex_classes = lowest_classes(mesh_);
    std::int32_t number = 0;
    std::vector<bool> seen(mesh_.positions.size());
    for (const Mark& corner : corners_) {
      const std::size_t v = checked(corner, mesh_.positions.size());
      if (seen[v]) continue;
      seen[v] = true;
      mesh_.vertex_classes[v] = ModelRef(0, ++number);
    }
  }

  /// The 0-based place of what is marked.
  std::size_t checked(const Mark& mark, std::size_t count) const {
    if (mark.number >= 1 && static_cast<std::uint64_t>(mark.number) <= count)
      return static_cast<std::size_t>(mark.number) - 1;
    source_.fail_at_line(mark.offset, "index " + std::to_string(mark.number) +
                                          " is out of range (1.." + std::to_string(count) + ")");
  }

  void add_attributes() {
    const std::size_t n = mesh_.positions.size();
    if (std::any_of(references_.begin(), references_.end(), [](std::int32_t r) { return r != 0; }))
      add(medit_reference, 0, 1, true).assign(references_.begin(), references_.end());
    if (!required_[0].empty()) mark(add(medit_required, 0, 1, true, n), required_[0], {true, 0, n});
    add_vectors(medit_normal, normals_, 0);
    add_vectors(medit_tangent, tangents_, normals_.values.size());
    for (int d = 1; d <= 3; ++d) {
      add_required(d);
      if (d == 1 && !ridges_.empty())
        mark(add(medit_ridge, 1, 1, true, mesh_.edges.size()), ridges_,
             parts_[static_cast<std::size_t>(Shape::Line)]);
    }
  }

  std::vector<double>& add(std::string_view name, int d, int components, bool integer,
                           std::size_t n = 0) {
    mesh_.attributes.push_back({std::string(name), d, components, integer, std::vector<double>(n)});
    return mesh_.attributes.back().values;
  }

  void mark(std::vector<double>& values, const std::vector<Mark>& marks, const Part& part) const {
    for (const Mark& m : marks) {
      const std::size_t place = checked(m, part.count);
      const auto gone = std::lower_bound(part.dropped.begin(), part.dropped.end(), place);
      if (gone != part.dropped.end() && *gone == place) continue;
      values[part.first + place - static_cast<std::size_t>(gone - part.dropped.begin())] = 1;
    }
  }

  void add_required(int d) {
    std::vector<double>* values = nullptr;
    for (const MeditList& list : medit_lists) {
      const auto k = static_cast<std::size_t>(list.shape);
      if (shape_template(list.shape).dimension != d || required_[k].empty()) continue;
      if (!values) values = &add(medit_required, d, 1, true, mesh_.list(d).size());
      mark(*values, required_[k], parts_[k]);
    }
  }

  /// Mmg's files count tangents on from the last normal: then every number lies beyond the
  /// tangents' own.
  static std::int64_t first_number(const Vectors& vectors, std::size_t others) {
    const bool beyond = std::all_of(vectors.uses.begin(), vectors.uses.end(), [&](const auto& use) {
      return use.second.number > static_cast<std::int64_t>(std::max(vectors.values.size(), others));
    });
    return beyond ? static_cast<std::int64_t>(others) : 0;
  }

  void add_vectors(std::string_view name, const Vectors& vectors, std::size_t others) {
    if (vectors.uses.empty()) return;
    std::vector<double>& values = add(name, 0, 3, false, 3 * mesh_.positions.size());
    const std::int64_t first = first_number(vectors, others);
    for (const auto& [vertex, use] : vectors.uses) {
      const glm::dvec3& vector =
          vectors.values[checked({use.number - first, use.offset}, vectors.values.size())];
      for (int axis = 0; axis < 3; ++axis)
        values[3 * std::size_t{vertex} + static_cast<std::size_t>(axis)] = vector[axis];
    }
  }

  const Source& source_;
  TextCursor cursor_;
  MeshData mesh_;
  int dimension_ = 0;
  bool has_vertices_ = false;
  bool tagged_ = false;  ///< an element has a reference other than 0
  std::vector<std::int32_t> references_;
  std::array<Part, builtin_shapes> parts_;
  std::array<std::vector<Mark>, builtin_shapes> required_;  ///< by shape; vertices first
  std::vector<Mark> corners_, ridges_;
  Vectors normals_, tangents_;
  Repeats repeats_;
  std::string passed_over_;
};

}  // namespace

bool is_binary_medit(std::string_view bytes) {
  const std::string_view one = bytes.substr(0, 4);
  return one == std::string_view("\1\0\0\0", 4) || one == std::string_view("\0\0\0\1", 4);
}

ReadResult read_medit(const Source& source) { return MeditReader(source).read(); }

}  // namespace aomd::io::detail
