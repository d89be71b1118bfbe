#include "core/io/notes.h"

#include <array>
#include <unordered_map>

#include "core/base/text.h"

namespace aomd::io::detail {

void ItemList::add(std::string item) {
  const bool first = known_.empty();
  const auto [known, fresh] = known_.insert(std::move(item));
  if (fresh && known_.size() <= most_listed) listed_ += (first ? "" : ", ") + *known;
}

std::string ItemList::text() const {
  if (known_.size() <= most_listed) return listed_;
  return listed_ + " and " + std::to_string(known_.size() - most_listed) + " more";
}

void Repeats::note(std::vector<std::string>& notes) const {
  if (faces > 0)
    notes.push_back(counted(faces, "face") + " of fewer than 3 different corners dropped");
  if (cut > 0) notes.push_back(counted(cut, "face") + " with repeated corners cut into triangles");
  if (edges > 0)
    notes.push_back(counted(edges, "edge") + " of fewer than 2 different ends dropped");
}

void note_left_out(std::vector<std::string>& notes, const ItemList& kinds) {
  if (!kinds.empty()) notes.push_back("left out: " + kinds.text());
}

bool is_blank(std::string_view rest) {
  return rest.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

void note_rest(std::vector<std::string>& notes, std::string_view rest, std::string_view last) {
  if (is_blank(rest)) return;
  notes.push_back(counted(rest.size(), "byte") + " after the last " + std::string(last) +
                  " passed over");
}

void rename_repeated(std::vector<Attribute>& attributes, std::vector<std::string>& notes) {
  std::array<std::unordered_map<std::string, std::size_t>, 4> uses;
  for (const Attribute& a : attributes) uses[static_cast<std::size_t>(a.dimension)][a.name] = 0;
  ItemList renamed;
  for (Attribute& a : attributes) {
    auto& of_dimension = uses[static_cast<std::size_t>(a.dimension)];
    std::size_t& use = of_dimension.find(a.name)->second;
    if (++use == 1) continue;
    std::string name = a.name + " (" + std::to_string(use) + ')';
    while (of_dimension.contains(name)) name = a.name + " (" + std::to_string(++use) + ')';
    renamed.add(shown(name));
    a.name = std::move(name);
  }
  if (!renamed.empty()) notes.push_back("further arrays of one name are called " + renamed.text());
}

}  // namespace aomd::io::detail
