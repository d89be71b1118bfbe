#pragma once
// What readers and writers say about a file beside its mesh: in few lines, whatever it holds.

#include <string>
#include <string_view>
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
  static constexpr std::size_t most_listed = 12;

  std::unordered_set<std::string> known_;
  std::string listed_;
};

/// Faces and edges that name a vertex more than once, or too few.
struct Repeats {
  std::size_t edges = 0;  ///< of fewer than 2 different ends
  std::size_t faces = 0;  ///< of fewer than 3 different corners
  std::size_t cut = 0;    ///< faces that give triangles without their repeated corners

  void note(std::vector<std::string>& notes) const;
};

/// Says what kinds of data do not come along, where there are any: "left out: normals, colours".
void note_left_out(std::vector<std::string>& notes, const ItemList& kinds);

/// Says that `rest`, what a file holds after the last thing that it promises, was passed over.
/// Blanks and line ends are not spoken of.
void note_rest(std::vector<std::string>& notes, std::string_view rest, std::string_view last);

/// True where note_rest() has nothing to say.
[[nodiscard]] bool is_blank(std::string_view rest);

/// Gives attributes of one name and dimension names of their own, "u (2)" for the second "u", so
/// that a Mesh can hold all of them. The note, if any, lists the new names. Linear.
void rename_repeated(std::vector<Attribute>& attributes, std::vector<std::string>& notes);

}  // namespace aomd::io::detail
