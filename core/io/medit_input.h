#pragma once
// The keywords and numbers of Medit files: text (.mesh) and binary (.meshb) behind one interface.

#include <bit>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/text_cursor.h"
#include "core/mesh/shape.h"

namespace aomd::io::detail {

/// Elements of one shape and order.
struct MeditElements {
  Shape shape = Shape::Point;
  std::size_t order = 1, nodes = 0;
};

/// What a keyword in small letters lists: "triangles", "trianglesp2", "quadrilateralsq2".
[[nodiscard]] std::optional<MeditElements> medit_elements(std::string keyword);

/// Text: words, wherever the lines end.
class MeditText {
 public:
  /// Reads the version. Throws ReadError for others than 1 to 4.
  explicit MeditText(const Source& source);

  /// Moves to the next section, behind its keyword. False at the end of the mesh.
  bool next(std::string& keyword);
  /// Moves over what a section that is not read holds: up to the next word that starts with a
  /// letter.
  void pass_over();

  std::int64_t dimension();
  std::int64_t integer(const char* what);
  double real(const char* what);
  /// False where the rest is too short for so many items.
  [[nodiscard]] bool has_room(std::uint64_t items, std::size_t integers, std::size_t reals) const {
    return items <= cursor_.left() / (2 * (integers + reals)) + 1;
  }
  [[nodiscard]] std::size_t offset() const { return cursor_.offset(); }
  /// Where what was last read ends, to move back to.
  [[nodiscard]] std::size_t place() const { return cursor_.offset(); }
  void move_to(std::size_t place) { cursor_.move_to(place); }
  [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const {
    source_.fail_at_line(offset, what);
  }

 private:
  void expect_more(const char* what);

  const Source& source_;
  TextCursor cursor_;
};

/// Binary, of either byte order. Versions 1 to 4 differ in the sizes of numbers. Each section
/// begins with the number of its keyword and the position of the next one. Source: libMeshb 7
/// (GMF), whose table of keywords and reader define the format.
class MeditBinary {
 public:
  explicit MeditBinary(const Source& source);

  bool next(std::string& keyword);
  void pass_over() {}  // next() knows where the section ends

  std::int64_t dimension();  ///< 32 bits in every version
  std::int64_t integer(const char* what);
  double real(const char* what);
  [[nodiscard]] bool has_room(std::uint64_t items, std::size_t integers, std::size_t reals) const {
    return items <= (source_.bytes.size() - at_) /
                        (integers * integer_size() + reals * (version_ == 1 ? 4 : 8));
  }
  [[nodiscard]] std::size_t offset() const { return number_at_; }
  [[nodiscard]] std::size_t place() const { return at_; }
  void move_to(std::size_t place) { at_ = place; }
  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(number_at_, what); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const {
    source_.fail_at_byte(offset, what);
  }

 private:
  [[nodiscard]] std::size_t integer_size() const { return version_ == 4 ? 8 : 4; }
  template <class Value>
  Value take(const char* what);

  const Source& source_;
  std::endian order_;
  std::int32_t version_ = 0;
  std::size_t at_ = 0, number_at_ = 0;
  std::size_t next_ = 0;  ///< where the next keyword stands, 0 where there is none
};

}  // namespace aomd::io::detail
