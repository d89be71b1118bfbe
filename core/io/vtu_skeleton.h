#pragma once
// The elements of a VTK XML file without the numbers in them, for files that need not fit into
// memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <pugixml.hpp>

namespace aomd::io::detail {

class VtuSkeleton {
 public:
  /// Goes through the file once, but not through appended data. Throws ReadError.
  explicit VtuSkeleton(const std::filesystem::path& path);

  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
  /// Where offset 0 of the appended data lies in the file; none where it has none.
  [[nodiscard]] const std::optional<std::uint64_t>& appended() const { return appended_; }

  /// Bytes of the file.
  struct Range {
    std::uint64_t begin = 0, end = 0;
  };
  /// What stands in an element DataArray.
  [[nodiscard]] Range text_of(const pugi::xml_node& array) const;

 private:
  class Scan;

  pugi::xml_document document_;
  std::optional<std::uint64_t> appended_;
  std::unordered_map<std::size_t, Range> texts_;  ///< by the hash of the node
};

}  // namespace aomd::io::detail
