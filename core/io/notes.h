#pragma once
// What readers and writers say about a file beside its mesh.

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aomd::io::detail {

/// Faces and edges that name a vertex more than once, or too few.
struct Repeats {
  std::size_t edges = 0;  ///< of fewer than 2 different ends
  std::size_t faces = 0;  ///< of fewer than 3 different corners
  std::size_t cut = 0;    ///< faces that give triangles without their repeated corners

  void note(std::vector<std::string>& notes) const;
};

/// The kinds of data that do not come along, each named once.
class LeftOut {
 public:
  void add(std::string what);
  /// One note, where there is anything: "left out: normals, colours".
  void note(std::vector<std::string>& notes) const;

 private:
  std::vector<std::string> names_;  ///< in the order of their coming
  std::set<std::string> known_;
};

/// Says that `rest`, what a file holds after the last thing that it promises, was passed over.
/// Blanks and line ends are not spoken of.
void note_rest(std::vector<std::string>& notes, std::string_view rest, std::string_view last);

/// True where note_rest() has nothing to say.
[[nodiscard]] bool is_blank(std::string_view rest);

}  // namespace aomd::io::detail
