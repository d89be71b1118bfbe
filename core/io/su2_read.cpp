// SU2's native mesh format, text: one zone, two or three dimensions.

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/formats.h"
#include "core/io/text_cursor.h"
#include "core/io/vtk_cells.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

class Su2Reader {
 public:
  explicit Su2Reader(const Source& source)
      : source_(source), cursor_(source, source.bytes, 0, '%') {}

  ReadResult read() {
    scan();
    while (!cursor_.skip_to_content()) section();
    if (!has_points_) cursor_.fail("the file has no NPOIN");
    if (!has_elements_) cursor_.fail("the file has no NELEM");
    ReadResult result{std::move(mesh_), Format::Su2, {}};
    repeats_.note(result.notes);
    if (!passed_over_.empty()) result.notes.push_back("passed over: " + passed_over_);
    if (marker_points_ > 0)
      result.notes.push_back(counted(marker_points_, "vertex") + " of markers passed over");
    return result;
  }

 private:
  /// Elements may come before points: what their indices and corners may be is found out first.
  void scan() {
    for (TextCursor ahead = cursor_; !ahead.skip_to_content(); ahead.skip_line()) {
      const TextCursor line = ahead;
      TextCursor value = line;
      const std::string key = key_of(value);
      if (key == "NDIME") dimension_ = number(value, "the dimension");
      if (key == "NPOIN") points_ = number(value, "the number of points");
      if (key == "NZONE" && number(value, "the number of zones") != 1)
        line.fail("a mesh of several zones; only one is read");
    }
    if (dimension_ != 2 && dimension_ != 3) cursor_.fail("NDIME is missing, or neither 2 nor 3");
    if (points_ >= no_index) throw LimitError(source_.name, {}, "more than 2^32 - 2 points");
  }

  /// The key of a line "KEY= value", and past the sign; empty where the line is none.
  std::string key_of(TextCursor& cursor) const {
    TextCursor line = cursor;
    std::string_view text = line.rest_of_line();
    if (text.empty() || !std::isalpha(static_cast<unsigned char>(text[0]))) return {};
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return {};
    const auto start = static_cast<std::size_t>(text.data() - source_.bytes.data());
    cursor = TextCursor(source_, source_.bytes, start + sign + 1, '%');
    text = text.substr(0, sign);
    return std::string(text.substr(0, text.find_last_not_of(" \t") + 1));
  }

  static std::uint64_t number(TextCursor& cursor, const char* what) {
    const std::int64_t n = cursor.integer(what);
    if (n < 0) cursor.fail(std::string(what) + " is negative");
    return static_cast<std::uint64_t>(n);
  }

  void section() {
    const TextCursor start = cursor_;
    const std::string key = key_of(cursor_);
    if (key == "NDIME" || key == "NPOIN") {
      if (key == "NPOIN") return points(start);
      cursor_.skip_line();
    } else if (key == "NELEM") {
      if (has_elements_) start.fail("NELEM a second time");
      has_elements_ = true;
      elements(number(cursor_, "the number of elements"), ModelRef(), false);
    } else if (key == "NMARK") {
      cursor_.skip_line();  // the markers are counted as they come
    } else if (key == "MARKER_TAG") {
      marker();
    } else {
      pass_over(start, key);
    }
  }

  void check_lines(std::uint64_t n) const {
    if (n > cursor_.left() / 2 + 1) cursor_.fail("the file is too short for " + counted(n, "line"));
  }

  void expect_line(std::uint64_t i, std::uint64_t n, const char* what) {
    if (cursor_.skip_to_content())
      cursor_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(n) + ' ' +
                   what);
  }

  void points(const TextCursor& start) {
    if (has_points_) start.fail("NPOIN a second time");
    has_points_ = true;
    cursor_.skip_line();  // a second number counts the points without halo
    check_lines(points_);
    mesh_.positions.reserve(static_cast<std::size_t>(points_));
    for (std::uint64_t i = 0; i < points_; ++i) {
      expect_line(i, points_, "points");
      const double x = cursor_.real("x"), y = cursor_.real("y"),
                   z = dimension_ == 3 ? cursor_.real("z") : 0;
      mesh_.positions.emplace_back(x, y, z);
      end_of_item();
    }
  }

  /// An index, which says nothing new, may follow.
  void end_of_item() {
    while (!cursor_.line_done()) (void)cursor_.integer("an index");
    cursor_.skip_line();
  }

  /// Elements of the mesh, or of a marker, which are one dimension lower.
  void elements(std::uint64_t n, ModelRef model, bool of_marker) {
    cursor_.skip_line();
    check_lines(n);
    for (std::uint64_t i = 0; i < n; ++i) {
      expect_line(i, n, of_marker ? "elements of the marker" : "elements");
      element(model, of_marker);
    }
  }

  void element(ModelRef model, bool of_marker) {
    const std::int64_t type = cursor_.integer("the type of an element");
    const CellKind* kind = type >= 0 && type <= 14 ? cell_kind(static_cast<int>(type)) : nullptr;
    const int dimension = static_cast<int>(dimension_) - (of_marker ? 1 : 0);
    if (of_marker && type == 1) {
      ++marker_points_;
      return cursor_.skip_line();
    }
    if (!kind || kind->rule != CellRule::Corners ||
        shape_template(kind->shape).dimension != dimension ||
        kind->type != cell_type(kind->shape)) {
      cursor_.fail((of_marker ? "a marker" : "a mesh") + std::string(" of dimension ") +
                   std::to_string(dimension) + " has no elements of type " + std::to_string(type));
    }
    std::array<std::int64_t, 8> v{};
    for (const std::uint8_t k : corner_order(*kind)) v[k] = cursor_.integer("a vertex index");
    const std::span<const std::int64_t> corners(v.data(), kind->nodes);
    const std::string wrong = entity_defect(kind->shape, corners, points_);
    if (wrong.empty()) {
      push(kind->shape, corners, model);
    } else {
      const auto left = without_repeats(kind->shape, corners, points_, repeats_);
      if (!left) cursor_.fail(wrong);
      if (!left->empty()) push(Shape::Triangle, *left, model);
    }
    end_of_item();
  }

  void push(Shape shape, std::span<const std::int64_t> corners, ModelRef model) {
    EntityList& list = mesh_.list(shape_template(shape).dimension);
    append(list, shape, corners);
    if (model.valid()) list.classes.push_back(model);
  }

  void marker() {
    std::string name(cursor_.rest_of_line());
    name.resize(std::min(name.size(), name.find('%')));
    name.resize(name.find_last_not_of(" \t") + 1);
    if (cursor_.skip_to_content() || key_of(cursor_) != "MARKER_ELEMS")
      cursor_.fail("MARKER_ELEMS should follow MARKER_TAG");
    const std::uint64_t n = number(cursor_, "the number of elements");
    const int dimension = static_cast<int>(dimension_) - 1;
    const auto tag = static_cast<std::int32_t>(mesh_.model.groups.size()) + 1;
    mesh_.model.groups.push_back({dimension, tag, std::move(name)});
    mesh_.model.entities.push_back({ModelRef(dimension, tag), {tag}, {}, {}});
    elements(n, ModelRef(dimension, tag), true);
  }

  /// A key and the lines up to the next one.
  void pass_over(const TextCursor& start, const std::string& key) {
    if (key.empty()) {
      TextCursor line = start;
      start.fail("expected KEY= value, found " + shown(line.word()));
    }
    if (passed_over_.find(key) == std::string::npos)
      passed_over_ += (passed_over_.empty() ? "" : ", ") + key;
    cursor_.skip_line();
    while (!cursor_.skip_to_content()) {
      TextCursor line = cursor_;
      if (!key_of(line).empty()) return;
      cursor_.skip_line();
    }
  }

  const Source& source_;
  TextCursor cursor_;
  MeshData mesh_;
  std::uint64_t dimension_ = 0, points_ = 0;
  bool has_points_ = false, has_elements_ = false;
  std::size_t marker_points_ = 0;
  Repeats repeats_;
  std::string passed_over_;
};

}  // namespace

ReadResult read_su2(const Source& source) { return Su2Reader(source).read(); }

}  // namespace aomd::io::detail
