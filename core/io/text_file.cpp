#include "core/io/text_file.h"

namespace aomd::io::detail {

Source without_mark(const Source& text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (!text.bytes.starts_with(mark)) return text;
  return {text.name, text.bytes.substr(mark.size()), text.skipped + mark.size()};
}

TextFile::TextFile(const std::filesystem::path& path)
    : bytes_(path), source_(without_padding(without_mark({path.string(), bytes_.view()}))) {}

}  // namespace aomd::io::detail
