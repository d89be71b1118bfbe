#pragma once
// What readers say about names: in one line, however many there are.

#include <string>
#include <unordered_set>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// Items of one note: the first few as they are, of the others only how many.
class ItemList {
 public:
  /// An item that was added before is not listed again. O(1).
  void add(std::string item);
  [[nodiscard]] bool empty() const { return known_.empty(); }
  /// "a, b and 3 more".
  [[nodiscard]] std::string text() const;

 private:
  static constexpr std::size_t most_listed = 8;

  std::unordered_set<std::string> known_;
  std::string listed_;
};

/// Gives attributes of one name and dimension names of their own, "u (2)" for the second "u", so
/// that a Mesh can hold all of them. The note, if any, lists the new names. Linear.
void rename_repeated(std::vector<Attribute>& attributes, std::vector<std::string>& notes);

}  // namespace aomd::io::detail
