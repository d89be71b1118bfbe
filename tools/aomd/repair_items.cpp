#include "tools/aomd/repair_items.h"

#include "core/io/error.h"
#include "core/mesh/names.h"

namespace aomd::cli {
namespace {

// Edges have no numbers of their own: one of their faces is named.
std::string where(const RepairItem& item) {
  const int named = item.dimension == 1 ? 2 : item.dimension;
  std::string text = item.dimension == 1 ? "at " : "";
  text += item.first.size() > 1 ? entity_plural(named) : entity_name(named);
  for (std::size_t i = 0; i < item.first.size(); ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(item.first[i]);
  return text + (item.count > item.first.size() ? ", ..." : "");
}

}  // namespace

std::string line_of(const RepairItem& item) { return item.text + " (" + where(item) + ")"; }

void check_mendable(const std::string& file, const MeshData& mesh) {
  if (!mesh.regions.empty())
    throw io::LimitError(file, {}, "Repair mends surfaces; this mesh has regions");
}

Json items_json(const std::vector<RepairItem>& items) {
  Json list = Json::array();
  for (const RepairItem& item : items)
    list.push_back({{"name", item.name},
                    {"count", item.count},
                    {"entity", entity_name(item.dimension)},
                    {item.dimension == 0 ? "first_vertices" : "first_faces", item.first},
                    {"text", item.text}});
  return list;
}

}  // namespace aomd::cli
