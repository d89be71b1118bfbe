#include "core/io/vtu_skeleton.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string_view>

#include "core/io/error.h"

namespace aomd::io::detail {

/// Puts the tags together, and notes what stands between them in arrays.
class VtuSkeleton::Scan {
 public:
  explicit Scan(const std::filesystem::path& path) : name_(path.string()) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw ReadError(name_, {}, "cannot be opened");
    std::string bytes(std::size_t{1} << 18, '\0');
    while (!appended && (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())),
                         file.gcount() > 0)) {
      const std::string_view piece(bytes.data(), static_cast<std::size_t>(file.gcount()));
      for (std::size_t i = 0; i < piece.size() && !appended; ++i) take(piece, i);
      first_ += piece.size();
    }
    if (awaits_mark_) throw ReadError(name_, {}, "the file ends within AppendedData");
  }

  std::string elements;
  std::vector<Range> texts;  ///< of arrays, in their order
  std::optional<std::uint64_t> appended;

 private:
  static constexpr std::size_t most_bytes = 1 << 24;

  /// One byte, or up to the next that matters.
  void take(std::string_view piece, std::size_t& i) {
    if (awaits_mark_) return take_mark(piece[i], first_ + i);
    if (in_tag_) return take_of_tag(piece[i], first_ + i);
    i = std::min(piece.find('<', i), piece.size());
    if (i == piece.size()) return;
    if (!texts.empty() && texts.back().end == 0) texts.back().end = first_ + i;
    in_tag_ = true;
    tag_ = "<";
  }

  void take_of_tag(char c, std::uint64_t at) {
    tag_ += c;
    const bool comment = tag_.starts_with("<!--");
    if (quote_ != 0 && !comment) {
      if (c == quote_) quote_ = 0;
    } else if ((c == '"' || c == '\'') && !comment) {
      quote_ = c;
    } else if (c == '>' && (!comment || tag_.ends_with("-->"))) {
      end_tag(at + 1);
    }
    if (elements.size() + tag_.size() > most_bytes)
      throw ReadError(name_, {}, "has elements of more than 16 MB beside its arrays");
  }

  void end_tag(std::uint64_t after) {
    in_tag_ = false;
    quote_ = 0;
    elements += tag_;
    const bool closed = tag_.ends_with("/>");
    if (tag_.starts_with("<DataArray")) texts.push_back({after, closed ? after : 0});
    if (!tag_.starts_with("<AppendedData")) return;
    elements += "</AppendedData></VTKFile>";
    awaits_mark_ = true;
  }

  void take_mark(char c, std::uint64_t at) {
    if (c != '_') return;
    appended = at + 1;
    awaits_mark_ = false;
  }

  std::string name_, tag_;
  std::uint64_t first_ = 0;  ///< of the piece
  bool in_tag_ = false, awaits_mark_ = false;
  char quote_ = 0;  ///< that a value stands in
};

VtuSkeleton::VtuSkeleton(const std::filesystem::path& path) {
  Scan scan(path);
  const pugi::xml_parse_result parsed =
      document_.load_buffer(scan.elements.data(), scan.elements.size());
  if (!parsed) throw ReadError(path.string(), {}, std::string("XML: ") + parsed.description());
  appended_ = scan.appended;
  std::size_t next = 0;
  static_cast<void>(document_.find_node([&](const pugi::xml_node& node) {
    if (std::string_view(node.name()).starts_with("DataArray") && next < scan.texts.size())
      texts_[node.hash_value()] = scan.texts[next++];
    return false;
  }));
}

VtuSkeleton::Range VtuSkeleton::text_of(const pugi::xml_node& array) const {
  const auto found = texts_.find(array.hash_value());
  return found == texts_.end() ? Range{} : found->second;
}

}  // namespace aomd::io::detail
