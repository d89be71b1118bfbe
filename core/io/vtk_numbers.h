#pragma once
// The numbers of VTK files, legacy and XML: their types, as text and as bytes.

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/io/text_cursor.h"

namespace aomd::io::detail {

enum class NumberType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/// Bytes that one number takes in binary files.
[[nodiscard]] constexpr std::size_t size_of(NumberType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool is_integer(NumberType type) { return type < NumberType::Float32; }

/// "Int32" and so on, as XML files name types.
[[nodiscard]] std::optional<NumberType> number_type_of_xml(std::string_view name);
/// "int", "vtktypeint64" and so on, in small letters, as legacy files name types.
[[nodiscard]] std::optional<NumberType> number_type_of_legacy(std::string_view name);

/// Appends the numbers that `bytes` hold one after the other; an incomplete last one is left out.
void decode(std::string_view bytes, NumberType type, std::endian order, std::vector<double>& out);
/// Appends the whole numbers that `bytes` hold; a type of real numbers gives none.
void decode(std::string_view bytes, NumberType type, std::endian order,
            std::vector<std::int64_t>& out);

inline constexpr std::size_t all_words = std::numeric_limits<std::size_t>::max();

/// Appends the next n words, wherever the lines end, as numbers ("nan" and "inf" too); all_words
/// reads to the end. Throws ReadError where a word is no number, or no whole one where `integer`
/// says so, or words lack.
void read_text(TextCursor& cursor, std::size_t n, bool integer, std::vector<double>& out);
/// Appends the next n words as indices: whole numbers, with what the function above throws.
void read_text(TextCursor& cursor, std::size_t n, std::vector<std::int64_t>& out);

/// Moves over n words: to the place of what turned out wrong later.
void skip_words(TextCursor& cursor, std::size_t n);

}  // namespace aomd::io::detail
