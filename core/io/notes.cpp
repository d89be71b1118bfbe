#include "core/io/notes.h"

#include "core/base/text.h"

namespace aomd::io::detail {

void Repeats::note(std::vector<std::string>& notes) const {
  if (faces > 0)
    notes.push_back(counted(faces, "face") + " of fewer than 3 different corners dropped");
  if (cut > 0) notes.push_back(counted(cut, "face") + " with repeated corners cut into triangles");
  if (edges > 0)
    notes.push_back(counted(edges, "edge") + " of fewer than 2 different ends dropped");
}

void LeftOut::add(std::string what) {
  if (known_.insert(what).second) names_.push_back(std::move(what));
}

void LeftOut::note(std::vector<std::string>& notes) const {
  constexpr std::size_t most = 12;
  if (names_.empty()) return;
  std::string text = "left out: ";
  for (std::size_t i = 0; i < std::min(most, names_.size()); ++i)
    text += (i > 0 ? ", " : "") + names_[i];
  if (names_.size() > most) text += " and " + std::to_string(names_.size() - most) + " more";
  notes.push_back(std::move(text));
}

bool is_blank(std::string_view rest) {
  return rest.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

void note_rest(std::vector<std::string>& notes, std::string_view rest, std::string_view last) {
  if (is_blank(rest)) return;
  notes.push_back(counted(rest.size(), "byte") + " after the last " + std::string(last) +
                  " passed over");
}

}  // namespace aomd::io::detail
