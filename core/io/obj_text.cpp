#include "core/io/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <span>
#include <utility>

#include "core/base/text.h"
#include "core/io/text_cursor.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// What the lines of a keyword hold that we pass over.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> keyword_meanings{
    {{"p", "points"}, {"vp", "free-form geometry"}, {"cstype", "free-form geometry"}}};

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// Appends a value of `given` numbers; earlier ones of fewer get more.
void append(ObjText::Values& values, std::span<const double> given, double absent) {
  const auto n = static_cast<std::size_t>(values.components);
  if (given.size() > n) {
    std::vector<double> wider;
    for (std::size_t i = 0; n > 0 && i < values.numbers.size(); i += n) {
      wider.insert(wider.end(), values.numbers.begin() + static_cast<std::ptrdiff_t>(i),
                   values.numbers.begin() + static_cast<std::ptrdiff_t>(i + n));
      wider.resize(wider.size() + given.size() - n, absent);
    }
    values.numbers = std::move(wider);
    values.components = static_cast<int>(given.size());
  }
  values.numbers.insert(values.numbers.end(), given.begin(), given.end());
  values.numbers.resize(
      values.numbers.size() + static_cast<std::size_t>(values.components) - given.size(), absent);
}

class ObjScanner {
 public:
  explicit ObjScanner(const Source& source) : source_(source) {
    text_.cleaned = without_padding(source).bytes;
    const std::size_t zero = text_.cleaned.find('\0');
    if (zero != std::string::npos)
      source.fail_at_byte(zero, "a zero byte: this is not a text file");
  }

  ObjText run() {
    TextCursor cursor(source_, text_.cleaned);
    bool comments_alone = true;
    while (!cursor.skip_to_content()) {
      comments_alone = comments_alone && text_.cleaned[cursor.offset()] == '#';
      element(cursor);
    }
    if (text_.positions.empty() && !comments_alone)
      source_.fail("no vertices: this is not an OBJ file");
    if (!text_.colours.numbers.empty()) pad_colours();
    for (ObjText::Values* values : {&text_.texture, &text_.normals})
      if (!values->corners.empty()) values->corners.resize(corners_, no_index);
    return std::move(text_);
  }

 private:
  void element(TextCursor& cursor) {
    const std::size_t start = cursor.offset();
    const std::string_view keyword = small(start, cursor.word());
    if (keyword == "v" || keyword == "f" || keyword == "l" || keyword == "vt" || keyword == "vn")
      tidy(cursor.offset());
    if (keyword == "v") {
      vertex(cursor);
    } else if (keyword == "vt" || keyword == "vn") {
      keyword == "vt" ? value(cursor, text_.texture, 2) : value(cursor, text_.normals, 3);
      blank(start, cursor.offset());
    } else if (keyword == "f") {
      face(cursor, start);
    } else if (keyword == "l") {
      line(cursor);
      blank(start, cursor.offset());
    } else {
      other(cursor, keyword, start);
    }
  }

  /// The keyword at `start`, which some programs write in capitals, in small letters.
  std::string_view small(std::size_t start, std::string_view keyword) {
    if (keyword[0] < 'A' || keyword[0] > 'Z') return keyword;
    text_.cleaned.replace(start, keyword.size(), lower(keyword));
    return keyword;
  }

  /// Names count; of all else we say that it is there.
  void other(TextCursor& cursor, std::string_view keyword, std::size_t start) {
    const bool name = keyword == "g" || keyword == "o" || keyword == "usemtl";
    if (!name && !keyword.starts_with('#')) tidy(cursor.offset());
    TextCursor ahead = cursor;
    const std::string_view value = ahead.word();
    if (keyword == "mtllib") {
      TextCursor names = cursor;
      text_.libraries.emplace_back(names.rest_of_line());
    } else if (keyword == "s") {
      smoothing(value);
    } else if (!name && !keyword.starts_with('#')) {
      leave_out(keyword);
    }
    cursor.skip_line();
    if (!name) blank(start, cursor.offset());
  }

  void leave_out(std::string_view keyword) {
    const auto at = std::find_if(keyword_meanings.begin(), keyword_meanings.end(),
                                 [&](const auto& meaning) { return meaning.first == keyword; });
    if (at == keyword_meanings.end()) return text_.left_out.add(shown(keyword) + " lines");
    bool& said = said_[static_cast<std::size_t>(at - keyword_meanings.begin())];
    if (!said) text_.left_out.add(std::string(at->second));
    said = true;
  }

  /// Joins the lines that end with a backslash to the one at `offset` and removes a comment at its
  /// end; all by putting spaces, so that offsets stay.
  void tidy(std::size_t offset) {
    std::string& s = text_.cleaned;
    std::size_t i = offset;
    while (i < s.size() && !is_line_end(s[i])) {
      if (s[i] == '#') {
        while (i < s.size() && !is_line_end(s[i])) s[i++] = ' ';
      } else if (s[i] == '\\' && i + 1 < s.size() && is_line_end(s[i + 1])) {
        const bool two = s[i + 1] == '\r' && i + 2 < s.size() && s[i + 2] == '\n';
        std::fill_n(s.begin() + static_cast<std::ptrdiff_t>(i), two ? 3 : 2, ' ');
      } else {
        ++i;
      }
    }
  }

  void blank(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (!is_line_end(text_.cleaned[i])) text_.cleaned[i] = ' ';
    }
  }

  void vertex(TextCursor& cursor) {
    const double x = cursor.real("x"), y = cursor.real("y"), z = cursor.real("z");
    text_.positions.emplace_back(x, y, z);
    more_.clear();
    while (!cursor.line_done()) more_.push_back(cursor.real("a weight or colour"));
    if (more_.size() == 3 || more_.size() == 4)
      colour();
    else if (more_.size() > 1)
      text_.left_out.add("vertex colours");
    cursor.end_line();
  }

  /// Of the present vertex.
  void colour() {
    if (text_.colours.components == 0) text_.colours.components = static_cast<int>(more_.size());
    while (text_.colours.size() + 1 < text_.positions.size()) append(text_.colours, {}, not_given);
    append(text_.colours, more_, not_given);
  }
  void pad_colours() {
    while (text_.colours.size() < text_.positions.size()) append(text_.colours, {}, not_given);
  }

  /// Of `vt` (one number or more, of which three count) or `vn`. What is no number is NaN.
  void value(TextCursor& cursor, ObjText::Values& values, std::size_t least) {
    more_.clear();
    while (!cursor.line_done()) {
      const double x = number_of(cursor.word()).value_or(not_given);
      if (more_.size() < 3) more_.push_back(x);
    }
    more_.resize(std::max(more_.size(), least));
    append(values, more_, 0);
    cursor.end_line();
  }

  void smoothing(std::string_view value) {
    std::int64_t group = 0;
    std::from_chars(value.data(), value.data() + value.size(), group);
    text_.smoothing.push_back({text_.face_offsets.size(), group});
  }

  /// Checks the corners; tinyobjloader reads their vertices again.
  void face(TextCursor& cursor, std::size_t start) {
    const std::size_t first = corners_;
    for (; !cursor.line_done(); ++corners_) {
      vertex_of(cursor);
      name_value(text_.texture, others_[0]);
      name_value(text_.normals, others_[1]);
    }
    cursor.end_line();
    if (corners_ - first > 2) return text_.face_offsets.push_back(start);
    ++text_.short_faces;
    blank(start, cursor.offset());
    corners_ = first;
    for (ObjText::Values* values : {&text_.texture, &text_.normals})
      values->corners.resize(std::min(values->corners.size(), first));
  }

  /// The present corner has this value, as the file counts: from 1, or back from the last so far.
  void name_value(ObjText::Values& values, std::int64_t index) const {
    if (index == 0) return;
    const std::int64_t place =
        index > 0 ? index - 1 : static_cast<std::int64_t>(values.size()) + index;
    values.corners.resize(corners_, no_index);
    values.corners.push_back(place < 0 || place >= no_index ? no_index - 1
                                                            : static_cast<std::uint32_t>(place));
  }

  void line(TextCursor& cursor) {
    const std::size_t start = cursor.offset();
    std::int64_t previous = 0;
    std::size_t ends = 0;
    for (; !cursor.line_done(); ++ends) {
      const std::int64_t index = vertex_of(cursor);
      const std::int64_t vertex =
          index > 0 ? index - 1 : static_cast<std::int64_t>(text_.positions.size()) + index;
      if (ends > 0) text_.lines.push_back({previous, vertex, start});
      previous = vertex;
    }
    text_.short_lines += ends < 2;
    cursor.end_line();
  }

  /// The vertex index of one corner ("7", "7/2", "7//3", "7/2/3", or with nothing after a slash),
  /// as it stands there: from 1, or negative from the last vertex so far. The rest is blanked.
  std::int64_t vertex_of(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    const char* end = word.data() + word.size();
    int vertex = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, vertex);
    if (vertex == 0 && error == std::errc{}) cursor.fail("vertex index 0: OBJ counts from 1");
    if (error != std::errc{} || !other_indices(stop, end, others_))
      cursor.fail("expected a vertex index, found " + shown(word));
    if (stop != end) blank(cursor.offset() - static_cast<std::size_t>(end - stop), cursor.offset());
    return vertex;
  }

  /// True where up to two indices follow, each after a slash and each of them perhaps left out.
  static bool other_indices(const char* p, const char* end, std::array<std::int64_t, 2>& indices) {
    indices = {};
    for (std::size_t part = 0; part < 2 && p != end; ++part) {
      if (*p++ != '/') return false;
      const auto [stop, error] = std::from_chars(p, end, indices[part]);
      if (error == std::errc::result_out_of_range) return false;
      p = stop;
    }
    return p == end;
  }

  const Source& source_;
  ObjText text_;
  std::size_t corners_ = 0;               ///< of the faces so far
  std::array<std::int64_t, 2> others_{};  ///< what the present corner names besides its vertex
  std::vector<double> more_;
  std::array<bool, keyword_meanings.size()> said_{};
};

}  // namespace

ObjText scan_obj(const Source& source) { return ObjScanner(source).run(); }

}  // namespace aomd::io::detail
