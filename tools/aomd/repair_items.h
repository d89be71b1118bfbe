#pragma once
// What a repair did, as lines and as JSON: for `aomd repair` and `aomd decimate --repair`.

#include <string>
#include <vector>

#include "core/repair/repair.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// "1 repeated face removed (face 2)": the first few entities, as numbered before.
[[nodiscard]] std::string line_of(const RepairItem& item);

/// Throws io::LimitError for a mesh with regions: only surfaces are mended.
void check_mendable(const std::string& file, const MeshData& mesh);

/// One object an item: name, count, entity, first_vertices or first_faces, text.
[[nodiscard]] Json items_json(const std::vector<RepairItem>& items);

}  // namespace aomd::cli
