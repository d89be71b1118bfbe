#include "core/io/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {
namespace {

NumberType type_named(TextCursor& cursor) {
  constexpr std::array<std::pair<std::string_view, NumberType>, 16> named{{
      {"char", NumberType::Int8},
      {"int8", NumberType::Int8},
      {"uchar", NumberType::UInt8},
      {"uint8", NumberType::UInt8},
      {"short", NumberType::Int16},
      {"int16", NumberType::Int16},
      {"ushort", NumberType::UInt16},
      {"uint16", NumberType::UInt16},
      {"int", NumberType::Int32},
      {"int32", NumberType::Int32},
      {"uint", NumberType::UInt32},
      {"uint32", NumberType::UInt32},
      {"float", NumberType::Float32},
      {"float32", NumberType::Float32},
      {"double", NumberType::Float64},
      {"float64", NumberType::Float64},
  }};
  const std::string_view word = cursor.word();
  for (const auto& [name, type] : named) {
    if (name == lower(word)) return type;
  }
  cursor.fail("unknown property type " + shown(word));
}

PlyEncoding encoding_named(TextCursor& cursor) {
  const std::string word = lower(cursor.word());
  if (word == "ascii") return PlyEncoding::Ascii;
  if (word == "binary_little_endian") return PlyEncoding::LittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::BigEndian;
  cursor.fail("unknown PLY format " + shown(word));
}

PlyElement element_declared(TextCursor& cursor) {
  PlyElement element;
  element.line_offset = cursor.offset();
  element.name = lower(cursor.word());
  const std::int64_t count = cursor.integer("the number of elements");
  if (element.name.empty() || count < 0) cursor.fail("an element needs a name and a number from 0");
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty property_declared(TextCursor& cursor) {
  PlyProperty property;
  TextCursor ahead = cursor;
  property.list = lower(ahead.word()) == "list";
  if (property.list) {
    cursor = ahead;
    property.count_type = type_named(cursor);
  }
  property.type = type_named(cursor);
  property.name = cursor.word();
  if (property.name.empty()) cursor.fail("a property needs a name");
  return property;
}

void check(const Source& source, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty() && element.count > 0) {
      source.fail_at_line(element.line_offset,
                          "element " + shown(element.name) + " has no properties");
    }
  }
}

}  // namespace

std::size_t PlyElement::least_size(PlyEncoding encoding) const {
  if (encoding == PlyEncoding::Ascii)
    return 2 * properties.size();  // a digit and what separates it
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += size_of(p.list ? p.count_type : p.type);
  return size;
}

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list; });
}

bool is_corner_list(const PlyProperty& property) {
  const std::string name = lower(property.name);
  return property.list && (name == "vertex_indices" || name == "vertex_index");
}

int axis_of(const PlyProperty& property) {
  const std::string name = lower(property.name);
  return name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : -1;
}

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto at = std::find_if(elements.begin(), elements.end(),
                               [&](const PlyElement& e) { return e.name == name; });
  return at == elements.end() ? nullptr : &*at;
}

PlyHeader read_ply_header(const Source& source) {
  TextCursor cursor(source, source.bytes);
  cursor.pass_comment_lines();
  cursor.skip_to_content();
  if (lower(cursor.word()) != "ply") cursor.fail("not a PLY file: it does not start with \"ply\"");
  cursor.end_line();
  PlyHeader header;
  for (bool format_known = false;;) {
    if (cursor.skip_to_content()) cursor.fail("the file ends within the PLY header");
    const std::string keyword = lower(cursor.word());
    if (keyword == "comment" || keyword == "obj_info") {
      const std::string_view text = cursor.rest_of_line();
      if (text != own_comment) header.remarks.push_back({keyword, std::string(text)});
      continue;
    }
    if (keyword == "end_header") {
      if (!format_known) cursor.fail("the PLY header has no format line");
      break;
    }
    if (keyword == "format") {
      header.encoding = encoding_named(cursor);
      format_known = true;
      cursor.word();  // the version, always 1.0
    } else if (keyword == "element") {
      header.elements.push_back(element_declared(cursor));
    } else if (keyword == "property") {
      if (header.elements.empty()) cursor.fail("a property before the first element");
      header.elements.back().properties.push_back(property_declared(cursor));
    } else {
      cursor.fail("unknown word in the PLY header: " + shown(keyword));
    }
    cursor.end_line();
  }
  cursor.end_line();
  header.body = cursor.offset();
  check(source, header);
  return header;
}

}  // namespace aomd::io::detail
