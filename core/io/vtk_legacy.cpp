#include "core/io/vtk_legacy.h"
#include "core/base/text.h"

#include <cctype>

namespace aomd::io::detail {
namespace {}  // namespace

std::string decoded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned value = 0;
    const char* digits = name.data() + i + 1;
    const bool code = name[i] == '%' && i + 2 < name.size() &&
                      std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2;
    text += code ? static_cast<char>(value) : name[i];
    if (code) i += 2;
  }
  return text;
}

void LegacyInput::fail_at(std::size_t offset, const std::string& what) const {
  if (binary_)
    source_.fail_at_byte(offset, what);  // lines mean nothing once bytes of data have gone by
  source_.fail_at_line(offset, what);
}

void LegacyInput::fail_at_value(std::size_t start, std::size_t k, std::size_t size,
                                const std::string& what) const {
  if (binary_) source_.fail_at_byte(start + k * size, what);
  TextCursor place(source_, source_.bytes, start);
  skip_words(place, k);
  place.fail(what);
}

void LegacyInput::read_as_text() {
  cursor_ = TextCursor(source_, without_padding(source_).bytes, cursor_.offset());
  cursor_.pass_comment_lines();
}

std::string_view LegacyInput::word(const char* what) {
  if (cursor_.skip_to_content()) fail(std::string("the file ends before ") + what);
  return cursor_.word();
}

std::uint64_t LegacyInput::count(const char* what) {
  const std::string_view text = word(what);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    fail(std::string("expected ") + what + ", found " + shown(text));
  return value;
}

void LegacyInput::keyword(const char* expected) {
  const std::string_view found = word(expected);
  if (lower(found) != lower(expected))
    fail(std::string("expected ") + expected + ", found " + shown(found));
}

NumberType LegacyInput::number_type(const char* what) {
  const std::string_view name = word(what);
  const auto type = number_type_of_legacy(lower(name));
  if (!type) fail("unknown type " + shown(name) + " of " + what);
  return *type;
}

std::size_t LegacyInput::data_start() const {
  TextCursor place = cursor_;
  if (binary_) place.skip_line();
  return place.offset();
}

void LegacyInput::check_room(std::uint64_t n) const {
  if (n > cursor_.left()) fail("the file is too short for " + counted(n, "value"));
}

std::string_view LegacyInput::take(std::uint64_t n, std::size_t size) {
  cursor_.skip_line();
  const std::size_t start = cursor_.offset();
  if (n > cursor_.left() / size) {
    fail("the file ends early: " + counted(n, "value") + " of " + counted(size, "byte") +
         " do not fit into " + counted(cursor_.left(), "byte"));
  }
  const auto bytes = static_cast<std::size_t>(n) * size;
  cursor_ = TextCursor(source_, source_.bytes, start + bytes);
  return source_.bytes.substr(start, bytes);
}

void LegacyInput::values(NumberType type, std::uint64_t n, std::vector<double>& out) {
  check_room(n);
  if (binary_) return decode(take(n, size_of(type)), type, std::endian::big, out);
  read_text(cursor_, static_cast<std::size_t>(n), is_integer(type), out);
}

void LegacyInput::values(NumberType type, std::uint64_t n, std::vector<std::int64_t>& out) {
  check_room(n);
  if (binary_) return decode(take(n, size_of(type)), type, std::endian::big, out);
  read_text(cursor_, static_cast<std::size_t>(n), out);
}

}  // namespace aomd::io::detail
