#include <cstring>

#include "core/base/text.h"
#include "core/io/msh.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {
namespace {

MshVersion version_at(TextCursor& cursor) {
  TextCursor word = cursor;
  const std::string text(word.word());
  const double version = cursor.real("the version");
  if (version >= 2 && version < 3) return MshVersion::V2;
  if (version == 4) return MshVersion::V40;
  if (version == 4.1) return MshVersion::V41;
  cursor.fail(
      "MSH version " + text +
      " is not one that is known here: write 4.1, with gmsh FILE -save -format msh41 -o OUT");
}

/// Past the comments that may stand before anything else.
void skip_comments(TextCursor& cursor, const Source& source) {
  constexpr std::string_view end = "$EndComments";
  for (;;) {
    if (cursor.skip_to_content()) cursor.fail("not an MSH file");
    TextCursor ahead = cursor;
    if (ahead.word() != "$Comments") return;
    const std::size_t at = source.bytes.find(end, ahead.offset());
    if (at == std::string_view::npos) cursor.fail("the section has no " + shown(end));
    cursor.move_to(at + end.size());
  }
}

}  // namespace

MshHeader read_msh_header(const Source& source) {
  TextCursor cursor(source, source.bytes);
  cursor.pass_comment_lines();
  skip_comments(cursor, source);
  const std::size_t start = cursor.offset();
  const std::string_view word = cursor.word();
  if (word == "$NOD") return {MshVersion::V1, false, std::endian::native, start};
  if (word != "$MeshFormat") cursor.fail("not an MSH file: it starts with " + shown(word));
  cursor.skip_line();
  cursor.skip_to_content();
  MshHeader header;
  header.version = version_at(cursor);
  const std::int64_t kind = cursor.integer("the file type");
  if (kind != 0 && kind != 1) cursor.fail("the file type is neither 0 (text) nor 1 (binary)");
  header.binary = kind == 1;
  if (const std::int64_t size = cursor.integer("the data size"); size != 8)
    cursor.fail("a data size of " + std::to_string(size) + ", expected 8");
  cursor.end_line();
  if (header.binary) {
    if (cursor.left() < 4) cursor.fail("the file ends within its header");
    std::int32_t one = 0;
    std::memcpy(&one, source.bytes.data() + cursor.offset(), 4);
    constexpr bool native_is_little = std::endian::native == std::endian::little;
    if (one == 1 << 24) header.order = native_is_little ? std::endian::big : std::endian::little;
    if (one != 1 && one != 1 << 24)
      source.fail_at_byte(cursor.offset(),
                          "the number that tells the byte order is neither 1 nor 1 swapped");
    cursor.move_to(cursor.offset() + 4);
  }
  if (cursor.skip_to_content() || cursor.word() != "$EndMeshFormat")
    cursor.fail("expected $EndMeshFormat");
  cursor.end_line();
  header.end = cursor.offset();
  return header;
}

}  // namespace aomd::io::detail
