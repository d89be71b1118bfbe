#include "core/io/vtk_arrays.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

/// What a keyword says of the array that follows.
struct KnownKeyword {
  std::string_view name;
  std::size_t components;
  Meaning meaning;
};

const KnownKeyword* keyword_named(const std::string& keyword) {
  static constexpr KnownKeyword known[] = {
      {"vectors", 3, Meaning::Vectors}, {"normals", 3, Meaning::Normal},
      {"tensors", 9, Meaning::Tensors}, {"tensors6", 6, Meaning::Tensors},
      {"global_ids", 1, Meaning::Any},  {"pedigree_ids", 1, Meaning::Any},
      {"edge_flags", 1, Meaning::Any}};
  const auto found = std::find_if(std::begin(known), std::end(known),
                                  [&](const KnownKeyword& k) { return k.name == keyword; });
  return found == std::end(known) ? nullptr : &*found;
}

}  // namespace

void LegacyArrays::begin_data(std::vector<VtkArray>& target, std::uint64_t tuples) {
  target_ = &target;
  tuples_ = tuples;
  const std::uint64_t n = count("the number of values");
  if (n != tuples_) fail("data for " + std::to_string(n) + " of " + std::to_string(tuples_));
}

bool LegacyArrays::attribute(const std::string& keyword) {
  if (!target_) return false;
  if (keyword == "scalars") {
    scalars();
  } else if (keyword == "color_scalars") {
    color_scalars();
  } else if (keyword == "lookup_table") {
    lookup_table();
  } else if (keyword == "texture_coordinates") {
    const std::string name = decoded(word("a name"));
    const std::uint64_t n = count("the number of components");
    array(*target_, name, n, tuples_);
    mean(Meaning::Texture);
  } else {
    const KnownKeyword* const known = keyword_named(keyword);
    if (!known) return false;
    const std::string name = decoded(word("a name"));
    array(*target_, name, known->components, tuples_);
    mean(known->meaning);
  }
  return true;
}

/// Of the array that was read last.
void LegacyArrays::mean(Meaning meaning) {
  if (!target_->empty()) target_->back().meaning = meaning;
}

void LegacyArrays::scalars() {
  const std::string name = decoded(word("a name"));
  const std::string type(word("the type of the scalars"));
  const std::uint64_t n = cursor_.line_done() ? 1 : count("the number of components");
  TextCursor ahead = cursor_;
  if (!ahead.skip_to_content() && lower(ahead.word()) == "lookup_table") {
    (void)ahead.word();  // its name
    cursor_ = ahead;
  }
  array(*target_, name, n, tuples_, type);
  mean(Meaning::Scalars);
}

/// 0 to 1 in text, 0 to 255 in binary.
void LegacyArrays::color_scalars() {
  const std::string name = decoded(word("a name"));
  const std::uint64_t n = count("the number of components");
  array(*target_, name, n, tuples_, binary_ ? "unsigned_char" : "float");
  mean(Meaning::Colour);
}

void LegacyArrays::lookup_table() {
  (void)word("a name");
  std::vector<VtkArray> colours;
  array(colours, "", 4, count("the size of the table"), binary_ ? "unsigned_char" : "float");
}

void LegacyArrays::fields(std::vector<VtkArray>& of_the_whole) {
  (void)word("a name");
  const std::uint64_t n = count("the number of arrays");
  for (std::uint64_t i = 0; i < n; ++i) {
    if (cursor_.skip_to_content())
      fail("the file ends after " + std::to_string(i) + " of " + counted(n, "array"));
    TextCursor ahead = cursor_;
    if (lower(ahead.word()) == "metadata") {
      cursor_ = ahead;
      skip_metadata();
    }
    field(of_the_whole);
  }
}

void LegacyArrays::field(std::vector<VtkArray>& of_the_whole) {
  const std::string name = decoded(word("the name of an array"));
  if (name == "NULL_ARRAY") return;
  const std::uint64_t components = count("the number of components"),
                      tuples = count("the number of tuples");
  if (target_ && tuples != tuples_)
    fail("array " + shown(name) + " has " + std::to_string(tuples) + " tuples, not " +
         std::to_string(tuples_));
  std::vector<VtkArray> unused;
  array(target_                 ? *target_
        : name == coverage_name ? of_the_whole
                                : unused,
        name, components, tuples);
}

void LegacyArrays::array(std::vector<VtkArray>& into, const std::string& name,
                         std::uint64_t components, std::uint64_t tuples) {
  array(into, name, components, tuples, word("the type of an array"));
}

void LegacyArrays::array(std::vector<VtkArray>& into, const std::string& name,
                         std::uint64_t components, std::uint64_t tuples,
                         std::string_view type_name) {
  constexpr std::uint64_t most_components = 1u << 20;
  if (components == 0 || components > most_components)
    fail("an array of " + counted(components, "component"));
  check_room(tuples);
  const std::uint64_t n = components * tuples;
  const std::string type = lower(type_name);
  VtkArray result{name, static_cast<int>(components), true, {}, {}, Meaning::Any};
  if (type == "bit") {
    bits(n, result.values);
  } else if (type == "string" || type == "utf8_string") {
    return skip_strings(name, n);
  } else if (const auto number = number_type_of_legacy(type)) {
    store_as(result, *number);
    values(*number, n, result.values);
    round_as(*number, result.values);
  } else {
    fail("unknown type " + shown(type_name) + " of array " + shown(name));
  }
  into.push_back(std::move(result));
}

void LegacyArrays::bits(std::uint64_t n, std::vector<double>& out) {
  if (!binary_) return values(NumberType::UInt8, n, out);
  const std::string_view bytes = take((n + 7) / 8, 1);
  for (std::uint64_t i = 0; i < n; ++i)
    out.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
}

/// One a line in text, each behind its length in binary.
void LegacyArrays::skip_strings(const std::string& name, std::uint64_t n) {
  check_room(n);
  cursor_.skip_line();
  for (std::uint64_t i = 0; i < n; ++i) binary_ ? skip_binary_string() : cursor_.skip_line();
  passed_over_.add("text " + shown(name));
}

/// The two highest bits of the first byte tell how many bytes the length takes: 8, 4, 2 or 1.
void LegacyArrays::skip_binary_string() {
  const std::size_t start = cursor_.offset();
  if (start == source_.bytes.size()) fail("the file ends within an array of text");
  const auto byte = [&](std::size_t k) {
    return static_cast<unsigned char>(source_.bytes[start + k]);
  };
  const std::size_t size = std::size_t{8} >> (byte(0) >> 6);
  if (size > cursor_.left()) fail("the file ends within an array of text");
  std::uint64_t length = byte(0) & 0x3fu;
  for (std::size_t k = 1; k < size; ++k) length = length << 8 | byte(k);
  if (length > cursor_.left() - size) fail("the file ends within an array of text");
  cursor_ = TextCursor(source_, source_.bytes, start + size + static_cast<std::size_t>(length));
}

void LegacyArrays::skip_metadata() {
  cursor_.skip_line();
  while (cursor_.left() > 0 && !cursor_.line_done()) cursor_.skip_line();
}

}  // namespace aomd::io::detail
