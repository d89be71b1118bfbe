#pragma once
// The numbers of VTK files, legacy and XML: their types, as text and as bytes.

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/io/text_cursor.h"
#include "core/mesh/number_type.h"

namespace aomd::io::detail {

/// "Int32" and so on, as XML files name types.
[[nodiscard]] std::optional<NumberType> number_type_of_xml(std::string_view name);
/// "int", "vtktypeint64" and so on, in small letters, as legacy files name types.
[[nodiscard]] std::optional<NumberType> number_type_of_legacy(std::string_view name);

/// How our writers name types: "Int32", and "int" in legacy files.
[[nodiscard]] std::string_view xml_name(NumberType type);
[[nodiscard]] std::string_view legacy_name(NumberType type);

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
