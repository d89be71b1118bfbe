// SU2's native mesh format, text: two or three dimensions, one zone or several.

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/formats.h"
#include "core/io/notes.h"
#include "core/io/text_cursor.h"
#include "core/io/vtk_cells.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

class Su2Reader {
 public:
  explicit Su2Reader(const Source& source)
      : source_(source), cursor_(source, source.bytes, 0, '%') {
    cursor_.pass_comment_lines();
  }

  ReadResult read() {
    scan();
    while (!cursor_.skip_to_content()) section();
    end_zone();
    ReadResult result{std::move(mesh_), Format::Su2, {}};
    repeats_.note(result.notes);
    if (!passed_over_.empty()) result.notes.push_back("passed over: " + passed_over_.text());
    if (points_of_.size() > 1)
      result.notes.push_back(counted(points_of_.size(), "zone") + " joined: model " +
                             plural(dimension_ == 3 ? "region" : "face") + " 1, 2, ...");
    if (marker_points_ > 0)
      result.notes.push_back(counted(marker_points_, "vertex") + " of markers passed over");
    return result;
  }

 private:
  /// Elements may come before points: what their indices and corners may be is found out first.
  void scan() {
    bool in_zone = false;
    for (TextCursor ahead = cursor_; !ahead.skip_to_content(); ahead.skip_line()) {
      TextCursor value = ahead;
      const std::string key = key_of(value);
      if (key == "NDIME") dimension(ahead, number(value, "the dimension"));
      if (key == "NPOIN") points_of_.back() = number(value, "the number of points");
      if (key != "IZONE") continue;
      if (in_zone) points_of_.push_back(0);
      in_zone = true;
    }
    if (dimension_ == 0) cursor_.fail("NDIME is missing, or neither 2 nor 3");
    std::uint64_t sum = 0;
    for (const std::uint64_t n : points_of_) {
      if (n >= no_index || (sum += n) >= no_index)
        throw LimitError(source_.name, {}, "more than 2^32 - 2 points");
    }
  }

  void dimension(const TextCursor& line, std::uint64_t n) {
    if (n != 2 && n != 3) line.fail("NDIME is missing, or neither 2 nor 3");
    if (dimension_ != 0 && dimension_ != n) line.fail("zones of two and of three dimensions");
    dimension_ = n;
  }

  /// The key of a line "KEY= value", in capitals, and past the sign; empty where the line is none.
  std::string key_of(TextCursor& cursor) const {
    TextCursor line = cursor;
    std::string_view text = line.rest_of_line();
    if (text.empty() || !std::isalpha(static_cast<unsigned char>(text[0]))) return {};
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return {};
    const auto start = static_cast<std::size_t>(text.data() - source_.bytes.data());
    cursor.move_to(start + sign + 1);
    text = text.substr(0, sign);
    std::string key(text.substr(0, text.find_last_not_of(" \t") + 1));
    for (char& c : key) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return key;
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
      const ModelRef zone = points_of_.size() > 1 ? start_zone() : ModelRef();
      elements(number(cursor_, "the number of elements"), zone, false);
    } else if (key == "NMARK") {
      promised_markers_ += number(cursor_, "the number of markers");
      cursor_.skip_line();
    } else if (key == "NZONE") {
      cursor_.skip_line();  // zones are counted as they come
    } else if (key == "IZONE") {
      if (in_zone_) next_zone();
      in_zone_ = true;
      cursor_.skip_line();
    } else if (key == "MARKER_TAG") {
      marker();
    } else {
      pass_over(start, key);
    }
  }

  void end_zone() {
    if (!has_points_) cursor_.fail("the file has no NPOIN");
    if (!has_elements_) cursor_.fail("the file has no NELEM");
    if (static_cast<std::uint64_t>(markers_) < promised_markers_)
      cursor_.fail("the file ends after " + std::to_string(markers_) + " of " +
                   counted(promised_markers_, "marker"));
  }

  void next_zone() {
    end_zone();
    has_points_ = has_elements_ = false;
    first_point_ += points_of_[zone_++];
  }

  /// What the elements of this one of several zones lie on.
  ModelRef start_zone() {
    const int d = static_cast<int>(dimension_);
    const auto tag = static_cast<std::int32_t>(zone_) + 1;
    mesh_.model.groups.push_back({d, tag, "zone " + std::to_string(tag)});
    mesh_.model.entities.push_back({ModelRef(d, tag), {tag}, {}, {}});
    return {d, tag};
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
    const std::uint64_t n = points_of_[zone_];
    check_lines(n);
    mesh_.positions.reserve(mesh_.positions.size() + static_cast<std::size_t>(n));
    const bool has_z = dimension_ == 3 || has_third_coordinate();
    for (std::uint64_t i = 0; i < n; ++i) {
      expect_line(i, n, "points");
      const double x = cursor_.real("x"), y = cursor_.real("y"), z = has_z ? cursor_.real("z") : 0;
      mesh_.positions.emplace_back(x, y, z);
      end_of_item();
    }
  }

  /// Whether points in the plane come with z: what stands third is no index, which counts up.
  bool has_third_coordinate() const {
    TextCursor line = cursor_;
    std::optional<std::int64_t> before;
    for (int i = 0; i < 2 && !line.skip_to_content(); ++i, line.skip_line()) {
      (void)line.word(), (void)line.word();
      const std::string_view third = line.word();
      if (third.empty()) return false;
      std::int64_t index = 0;
      const auto [end, error] = std::from_chars(third.data(), third.data() + third.size(), index);
      const bool whole = error == std::errc{} && end == third.data() + third.size();
      if (!whole || (before && index != *before + 1)) return is_number(third);
      before = index;
    }
    return false;
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
    const std::uint64_t points = points_of_[zone_];
    const std::string wrong = entity_defect(kind->shape, corners, points);
    if (wrong.empty()) {
      push(kind->shape, corners, model);
    } else {
      const auto left = without_repeats(kind->shape, corners, points, repeats_);
      if (!left) cursor_.fail(wrong);
      if (!left->empty()) push(Shape::Triangle, *left, model);
    }
    end_of_item();
  }

  /// Corners count from the first point of the zone.
  void push(Shape shape, std::span<const std::int64_t> corners, ModelRef model) {
    EntityList& list = mesh_.list(shape_template(shape).dimension);
    list.shapes.push_back(shape);
    for (const std::int64_t corner : corners)
      list.vertices.push_back(static_cast<std::uint32_t>(first_point_) +
                              static_cast<std::uint32_t>(corner));
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
    const std::int32_t tag = ++markers_;
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
    passed_over_.add(key);
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
  std::uint64_t dimension_ = 0;
  std::vector<std::uint64_t> points_of_{0};  ///< of each zone
  std::size_t zone_ = 0;                     ///< the present one
  std::uint64_t first_point_ = 0;            ///< of the present zone, in the mesh
  bool in_zone_ = false, has_points_ = false, has_elements_ = false;
  std::int32_t markers_ = 0;
  std::uint64_t promised_markers_ = 0;
  std::size_t marker_points_ = 0;
  Repeats repeats_;
  ItemList passed_over_;
};

}  // namespace

ReadResult read_su2(const Source& source) { return Su2Reader(without_padding(source)).read(); }

}  // namespace aomd::io::detail
