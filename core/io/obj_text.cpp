#include "core/io/obj_text.h"

#include <algorithm>
#include <charconv>

#include "core/base/text.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

class ObjScanner {
 public:
  explicit ObjScanner(const Source& source) : source_(source) {
    const std::size_t zero = source.bytes.find('\0');
    if (zero != std::string_view::npos)
      source.fail_at_byte(zero, "a zero byte: this is not a text file");
    text_.cleaned = source.bytes;
  }

  ObjText run() {
    TextCursor cursor(source_, text_.cleaned);
    while (!cursor.skip_to_content()) element(cursor);
    if (text_.positions.empty()) source_.fail("no vertices: this is not an OBJ file");
    for (const ObjText::Line& line : text_.lines) check(line);
    return std::move(text_);
  }

 private:
  void element(TextCursor& cursor) {
    const std::size_t start = cursor.offset();
    const std::string_view keyword = cursor.word();
    if (keyword == "v" || keyword == "f" || keyword == "l") tidy(cursor.offset());
    if (keyword == "v") {
      vertex(cursor);
    } else if (keyword == "f") {
      text_.face_offsets.push_back(start);
      face(cursor);
    } else if (keyword == "l") {
      line(cursor);
      blank(start, cursor.offset());
    } else if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
      cursor.skip_line();
    } else {
      cursor.skip_line();
      blank(start, cursor.offset());
    }
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
    while (!cursor.line_done()) cursor.real("a weight or colour");
    cursor.end_line();
  }

  /// Checks the corners "7", "7/2", "7//3", "7/2/3"; tinyobjloader reads them again.
  void face(TextCursor& cursor) {
    std::size_t corners = 0;
    for (; !cursor.line_done(); ++corners) vertex_of(cursor);
    if (corners < 3)
      cursor.fail("a face needs 3 or more vertices, this one has " + std::to_string(corners));
    cursor.end_line();
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
    if (ends < 2) cursor.fail("a line needs 2 or more vertices");
    cursor.end_line();
  }

  /// The vertex index of one corner, as it stands there: from 1, or negative from the last vertex
  /// so far.
  static std::int64_t vertex_of(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    int vertex = 0, other = 0;
    const char *p = word.data(), *end = p + word.size();
    auto result = std::from_chars(p, end, vertex);
    bool sound = result.ec == std::errc{} && vertex != 0;
    for (int part = 0; sound && part < 2 && result.ptr != end; ++part) {
      sound = *result.ptr == '/';
      const bool left_out = sound && part == 0 && result.ptr + 1 != end && result.ptr[1] == '/';
      if (left_out) {
        ++result.ptr;
      } else if (sound) {
        result = std::from_chars(result.ptr + 1, end, other);
        sound = result.ec == std::errc{};
      }
    }
    if (vertex == 0 && result.ec == std::errc{}) cursor.fail("vertex index 0: OBJ counts from 1");
    if (!sound || result.ptr != end) cursor.fail("expected a vertex index, found " + shown(word));
    return vertex;
  }

  void check(const ObjText::Line& line) const {
    const auto n = static_cast<std::int64_t>(text_.positions.size());
    for (const std::int64_t v : {line.a, line.b}) {
      if (v < 0 || v >= n)
        source_.fail_at_line(line.offset, "vertex index " + std::to_string(v + 1) +
                                              " is out of range (1.." + std::to_string(n) + ")");
    }
    if (line.a == line.b)
      source_.fail_at_line(line.offset, "the line repeats vertex " + std::to_string(line.a + 1));
  }

  const Source& source_;
  ObjText text_;
};

}  // namespace

ObjText scan_obj(const Source& source) { return ObjScanner(source).run(); }

}  // namespace aomd::io::detail
