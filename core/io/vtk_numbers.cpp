#include "core/io/vtk_numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace aomd::io::detail {
namespace {

using TypeName = std::pair<std::string_view, NumberType>;

// "long" has 8 bytes wherever VTK runs but on Windows. vtkIdType is written as int.
constexpr TypeName legacy_names[] = {{"char", NumberType::Int8},
                                     {"signed_char", NumberType::Int8},
                                     {"unsigned_char", NumberType::UInt8},
                                     {"short", NumberType::Int16},
                                     {"unsigned_short", NumberType::UInt16},
                                     {"int", NumberType::Int32},
                                     {"unsigned_int", NumberType::UInt32},
                                     {"vtkidtype", NumberType::Int32},
                                     {"long", NumberType::Int64},
                                     {"unsigned_long", NumberType::UInt64},
                                     {"vtktypeint64", NumberType::Int64},
                                     {"vtktypeuint64", NumberType::UInt64},
                                     {"float", NumberType::Float32},
                                     {"double", NumberType::Float64}};

constexpr TypeName xml_names[] = {
    {"Int8", NumberType::Int8},       {"UInt8", NumberType::UInt8},
    {"Int16", NumberType::Int16},     {"UInt16", NumberType::UInt16},
    {"Int32", NumberType::Int32},     {"UInt32", NumberType::UInt32},
    {"Int64", NumberType::Int64},     {"UInt64", NumberType::UInt64},
    {"Float32", NumberType::Float32}, {"Float64", NumberType::Float64}};

template <std::size_t N>
std::optional<NumberType> find(const TypeName (&names)[N], std::string_view name) {
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return {};
}

template <class Value, class Out>
void decode_as(std::string_view bytes, std::endian order, std::vector<Out>& out) {
  out.reserve(out.size() + bytes.size() / sizeof(Value));
  for (std::size_t at = 0; at + sizeof(Value) <= bytes.size(); at += sizeof(Value)) {
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), bytes.data() + at, sizeof(Value));
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    out.push_back(static_cast<Out>(std::bit_cast<Value>(raw)));
  }
}

template <class Out>
void decode_any(std::string_view bytes, NumberType type, std::endian order, std::vector<Out>& out) {
  switch (type) {
    case NumberType::Int8:
      return decode_as<std::int8_t>(bytes, order, out);
    case NumberType::UInt8:
      return decode_as<std::uint8_t>(bytes, order, out);
    case NumberType::Int16:
      return decode_as<std::int16_t>(bytes, order, out);
    case NumberType::UInt16:
      return decode_as<std::uint16_t>(bytes, order, out);
    case NumberType::Int32:
      return decode_as<std::int32_t>(bytes, order, out);
    case NumberType::UInt32:
      return decode_as<std::uint32_t>(bytes, order, out);
    case NumberType::Int64:
      return decode_as<std::int64_t>(bytes, order, out);
    case NumberType::UInt64:
      return decode_as<std::uint64_t>(bytes, order, out);
    case NumberType::Float32:
    case NumberType::Float64:
      break;
  }
  if constexpr (std::is_same_v<Out, double>) {
    if (type == NumberType::Float32) return decode_as<float>(bytes, order, out);
    decode_as<double>(bytes, order, out);
  }
}

double value_of(const TextCursor& cursor, std::string_view word) {
  double value = 0;
  const auto [next, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc{} && next == word.data() + word.size()) return value;
  const auto unusual = number_of(word);
  if (!unusual) cursor.fail("expected a number, found " + shown_no_number(word));
  return *unusual;
}

/// Calls use() at the start of each of the next n words.
template <class Use>
void each_word(TextCursor& cursor, std::size_t n, Use&& use) {
  for (std::size_t i = 0; i < n; ++i) {
    if (cursor.skip_to_content()) {
      if (n == all_words) return;
      cursor.fail("the file ends after " + std::to_string(i) + " of " + counted(n, "value"));
    }
    use();
  }
}

/// No more than the rest of the text can hold.
std::size_t believable(const TextCursor& cursor, std::size_t n) {
  return std::min(n, cursor.left() / 2 + 1);
}

}  // namespace

std::optional<NumberType> number_type_of_xml(std::string_view name) {
  return find(xml_names, name);
}
std::optional<NumberType> number_type_of_legacy(std::string_view name) {
  return find(legacy_names, name);
}

std::string_view xml_name(NumberType type) {
  return xml_names[static_cast<std::size_t>(type)].first;
}
std::string_view legacy_name(NumberType type) {
  constexpr std::string_view names[] = {"char",  "unsigned_char", "short",        "unsigned_short",
                                        "int",   "unsigned_int",  "vtktypeint64", "vtktypeuint64",
                                        "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

void decode(std::string_view bytes, NumberType type, std::endian order, std::vector<double>& out) {
  decode_any(bytes, type, order, out);
}

void decode(std::string_view bytes, NumberType type, std::endian order,
            std::vector<std::int64_t>& out) {
  decode_any(bytes, type, order, out);
}

void read_text(TextCursor& cursor, std::size_t n, bool integer, std::vector<double>& out) {
  out.reserve(out.size() + believable(cursor, n));
  each_word(cursor, n, [&] {
    const TextCursor start = cursor;
    const std::string_view word = cursor.word();
    out.push_back(value_of(start, word));
    if (integer && out.back() != std::floor(out.back()))
      start.fail("expected a whole number, found " + shown(word));
  });
}

void read_text(TextCursor& cursor, std::size_t n, std::vector<std::int64_t>& out) {
  out.reserve(out.size() + believable(cursor, n));
  each_word(cursor, n, [&] { out.push_back(cursor.integer("an index")); });
}

void skip_words(TextCursor& cursor, std::size_t n) {
  each_word(cursor, n, [&] { (void)cursor.word(); });
  cursor.skip_to_content();
}

}  // namespace aomd::io::detail
