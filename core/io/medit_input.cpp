#include "core/io/medit_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/medit.h"

namespace aomd::io::detail {
namespace {

std::string version_error(std::int64_t version) {
  return "version " + std::to_string(version) + " is not read, only 1 to 4";
}

bool is_keyword(std::string_view word) {
  return std::isalpha(static_cast<unsigned char>(word[0])) && !is_number(word);
}

/// The number of nodes of an element whose sides have so many steps.
std::size_t nodes_of(Shape shape, std::size_t order) {
  const std::size_t n = order + 1;
  switch (shape) {
    case Shape::Point:
      return 1;
    case Shape::Line:
      return n;
    case Shape::Triangle:
      return n * (n + 1) / 2;
    case Shape::Quad:
      return n * n;
    case Shape::Tetrahedron:
      return n * (n + 1) * (n + 2) / 6;
    case Shape::Pyramid:
      return n * (n + 1) * (2 * n + 1) / 6;
    case Shape::Prism:
      return n * n * (n + 1) / 2;
    case Shape::Hexahedron:
      break;
  }
  return n * n * n;
}

}  // namespace

std::optional<MeditElements> medit_elements(std::string keyword) {
  std::size_t order = 1;
  const std::size_t n = keyword.size();
  if (n > 2 && keyword[n - 1] >= '2' && keyword[n - 1] <= '4' &&
      (keyword[n - 2] == 'p' || keyword[n - 2] == 'q')) {
    order = static_cast<std::size_t>(keyword[n - 1] - '0');
    keyword.resize(n - 2);
  }
  if (keyword == "pentahedra") keyword = "prisms";
  for (const MeditList& list : medit_lists) {
    if (keyword == lower(list.keyword))
      return MeditElements{list.shape, order, nodes_of(list.shape, order)};
  }
  return {};
}

MeditText::MeditText(const Source& source)
    : source_(source), cursor_(source, source.bytes, 0, '#') {
  cursor_.skip_to_content();
  const std::string_view first = cursor_.word();
  if (lower(first.substr(0, 32)) != "meshversionformatted")
    fail("does not start with MeshVersionFormatted but with " + shown(first));
  const std::int64_t version = integer("the version");
  if (version < 1 || version > 4) fail(version_error(version));
}

bool MeditText::next(std::string& keyword) {
  if (cursor_.skip_to_content()) return false;
  const std::string_view word = cursor_.word();
  if (!is_keyword(word)) fail("expected a keyword, found " + shown(word));
  keyword = word;
  return lower(word) != "end";
}

void MeditText::pass_over() {
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

void MeditText::expect_more(const char* what) {
  if (cursor_.skip_to_content()) fail(std::string("the file ends before ") + what);
}

std::int64_t MeditText::integer(const char* what) {
  expect_more(what);
  return cursor_.integer(what);
}

std::int64_t MeditText::dimension() { return integer("the dimension"); }

double MeditText::real(const char* what) {
  expect_more(what);
  return cursor_.real(what);
}

MeditBinary::MeditBinary(const Source& source)
    : source_(source),
      order_(source.bytes[0] == '\1' ? std::endian::little : std::endian::big),
      at_(4) {
  version_ = take<std::int32_t>("the version");
  if (version_ < 1 || version_ > 4) fail(version_error(version_));
  next_ = at_;
}

bool MeditBinary::next(std::string& keyword) {
  if (next_ == 0) return false;
  at_ = next_;
  const auto code = take<std::int32_t>("a keyword");
  const std::size_t keyword_at = number_at_;
  const std::uint64_t next = version_ < 3 ? take<std::uint32_t>("the end of a section")
                                          : take<std::uint64_t>("the end of a section");
  if (next != 0 && (next < at_ || next > source_.bytes.size()))
    fail("a section that ends at byte " + std::to_string(next));
  next_ = static_cast<std::size_t>(next);
  number_at_ = keyword_at;
  const auto* known = std::find_if(std::begin(medit_codes), std::end(medit_codes),
                                   [&](const MeditCode& each) { return each.code == code; });
  keyword = known != std::end(medit_codes) ? std::string(known->keyword)
                                           : "keyword " + std::to_string(code);
  return keyword != "End";
}

template <class Value>
Value MeditBinary::take(const char* what) {
  number_at_ = at_;
  if (source_.bytes.size() - at_ < sizeof(Value)) fail(std::string("the file ends before ") + what);
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), source_.bytes.data() + at_, sizeof(Value));
  if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  at_ += sizeof(Value);
  return std::bit_cast<Value>(bytes);
}

std::int64_t MeditBinary::integer(const char* what) {
  return version_ == 4 ? take<std::int64_t>(what) : take<std::int32_t>(what);
}

std::int64_t MeditBinary::dimension() { return take<std::int32_t>("the dimension"); }

double MeditBinary::real(const char* what) {
  const double value = version_ == 1 ? static_cast<double>(take<float>(what)) : take<double>(what);
  if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number");
  return value;
}

}  // namespace aomd::io::detail
