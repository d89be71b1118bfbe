#include "tools/aomd/surface_lines.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/measure/intersections.h"
#include "tools/aomd/repair_items.h"

namespace aomd::cli {
namespace {

// Dirt in a smaller share of a surface is told only where a target is missed.
constexpr std::size_t least_share = 20;
constexpr std::size_t most_named = 8;

// Nothing where no command mends it.
std::string command_of(const SurfaceFinding& finding, const std::string& file) {
  std::string repair = "aomd repair " + file + " OUT";
  switch (finding.remedy) {
    case Remedy::Repair:
      return repair;
    case Remedy::Weld:
      return repair + " " + weld_words(finding);
    case Remedy::DropUnused:
      return repair + " --drop-unused";
    case Remedy::None:
      break;
  }
  return {};
}

// Whether a share of the surface may be dirt that counts alone tell: soups are all border, or many
// pieces; repeated faces make edges of three or more.
bool may_be_dirty(const measure::Counts& counts) {
  return std::max(counts.boundary_edges, counts.nonmanifold_edges) * least_share >= counts.edges ||
         counts.components * least_share >= counts.faces;
}

// What a decimation cannot get past. Where a file classifies, faces are meant to meet in edges of
// three or more.
bool hinders(const SurfaceFinding& finding, bool classified) {
  switch (finding.breaks) {
    case SurfaceProperty::Welded:
    case SurfaceProperty::Distinct:
      return true;
    case SurfaceProperty::Manifold:
      return !classified;
    case SurfaceProperty::Oriented:
      return finding.remedy == Remedy::Repair;
    default:
      return false;
  }
}

}  // namespace

std::string weld_words(const SurfaceFinding& finding) {
  return finding.tolerance > 0 ? "--weld " + number_text(finding.tolerance) : "--weld";
}

std::string line_of(const SurfaceFinding& finding, const std::string& file) {
  const std::string command = command_of(finding, file);
  return finding.dirt.name + ": " + line_of(finding.dirt) + (command.empty() ? "" : ": ") + command;
}

Json surface_json(const std::vector<SurfaceFinding>& findings, const std::string& file) {
  Json list = Json::array();
  for (const SurfaceFinding& finding : findings) {
    Json item = items_json({finding.dirt})[0];
    const std::string command = command_of(finding, file);
    item["breaks"] = property_name(finding.breaks);
    item["tolerance"] = finding.tolerance > 0 ? Json(finding.tolerance) : Json(nullptr);
    item["mend"] = command.empty() ? Json(nullptr) : Json(command);
    list.push_back(item);
  }
  return list;
}

std::vector<SurfaceFinding> self_intersection_findings(const Mesh& mesh) {
  const measure::IntersectionCount cuts = measure::count_self_intersections(mesh, thread_count(0));
  if (cuts.pairs == 0) return {};
  RepairItem item{"self-intersections",
                  counted(cuts.pairs, "pair") + " of faces cut each other",
                  cuts.pairs,
                  2,
                  {}};
  if (cuts.pairs == 1) item.text = "1 pair of faces cuts each other";
  for (const auto& [f, g] : cuts.first)
    for (const Face face : {f, g})
      if (std::find(item.first.begin(), item.first.end(), face.index) == item.first.end())
        item.first.push_back(face.index);
  return {{item, SurfaceProperty::Embedded, Remedy::None}};
}

std::vector<SurfaceFinding> hanging_findings(const Mesh& mesh, int threads, measure::Skin skin) {
  const std::vector<Vertex> hanging = measure::hanging_vertices(mesh, threads, skin);
  if (hanging.empty()) return {};
  RepairItem item{"hanging vertices",
                  counted(hanging.size(), "vertex") + (hanging.size() == 1 ? " lies" : " lie") +
                      " on faces without being a corner of them",
                  hanging.size(),
                  0,
                  {}};
  for (std::size_t i = 0; i < std::min(hanging.size(), most_named); ++i)
    item.first.push_back(hanging[i].index);
  return {{item, SurfaceProperty::Welded, Remedy::None}};
}

std::vector<std::string> dirt_notes(const MeshData& mesh, const measure::Counts& counts,
                                    bool missed, const std::string& mending) {
  const bool dirty = may_be_dirty(counts);
  if (!missed && !dirty) return {};
  std::vector<std::string> notes;
  for (const SurfaceFinding& finding : survey(mesh)) {
    const std::size_t all = finding.dirt.dimension == 1   ? counts.edges
                            : finding.dirt.dimension == 2 ? counts.faces
                                                          : counts.vertices;
    const bool large = dirty && finding.dirt.count * least_share >= all;
    if (!hinders(finding, mesh.classified()) || large == missed) continue;
    const bool weld = finding.remedy == Remedy::Weld;
    notes.push_back(finding.dirt.name + ": " + finding.dirt.text + " (" + mending +
                    (weld ? " " + weld_words(finding) : "") + ")");
  }
  return notes;
}

}  // namespace aomd::cli
