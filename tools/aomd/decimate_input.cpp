#include "tools/aomd/decimate_input.h"

#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/decimate/decimation.h"
#include "core/io/error.h"
#include "core/mesh/split_tets.h"
#include "core/mesh/verify.h"
#include "core/model/mesh_on_model.h"
#include "core/repair/triangulate.h"
#include "tools/aomd/command.h"
#include "tools/aomd/repair_items.h"

namespace aomd::cli {

std::vector<std::string> cut_quads(MeshData& mesh) {
  const std::size_t quads = triangulate_quads(mesh);
  if (quads == 0) return {};
  return {counted(quads, "quad") + " cut into triangles"};
}

std::vector<std::string> cut_regions(MeshData& mesh) {
  SplitToTets split = split_to_tets(std::move(mesh));
  mesh = std::move(split.mesh);
  std::vector<std::string> notes;
  if (const std::string text = split.text(); !text.empty())
    notes.emplace_back("cut " + text);
  else
    notes.emplace_back(mesh.regions.empty() ? "has no regions to cut" : "nothing but tetrahedra");
  if (split.inverted > 0)
    notes.push_back(counted(split.inverted, "tetrahedron") +
                    " of regions that are not convex without positive volume");
  return notes;
}

RepairReport mend(MeshData& mesh, const DecimateOptions& options, std::vector<std::string>& notes) {
  check_mendable(options.input, mesh);
  RepairOptions how;
  options.weld.apply(how, mesh);
  RepairReport report = repair(mesh, how);
  for (const RepairItem& item : report.done) notes.push_back(line_of(item));
  for (const RepairItem& item : report.left) notes.push_back(line_of(item));
  return report;
}

void check_decimable(const Mesh& mesh, const std::string& file) {
  const char* obstacle = decimation_obstacle(mesh);
  if (mesh.count(3) > 0 && !has_tetrahedra(mesh))
    throw NothingToDo(printable(file) + ": " + obstacle);
  if (obstacle) throw io::LimitError(file, {}, obstacle);
  if (const auto finding = first_repeated_region(mesh))
    throw io::ReadError(file, {}, "cannot be decimated: " + finding->text);
}

void fit_to_model(Mesh& mesh, bool classified, const Model& model, const DecimateOptions& options) {
  try {
    if (classified)
      check_against(mesh, model);
    else
      classify_on(mesh, model);
  } catch (const ModelError& e) {
    throw io::ReadError(options.input, {}, e.what() + (" (" + options.model + ")"));
  }
}

void check_snapping(const Mesh& mesh, const Model& model, const DecimateOptions& options) {
  try {
    check_entities(mesh, model);
  } catch (const ModelError& e) {
    throw io::ReadError(options.input, {}, std::string("--snap model: ") + e.what());
  }
}

std::string dear_features(const ClassifyResult& found, std::uint32_t original,
                          std::uint32_t wanted) {
  const double sharp = found.features.sharp, share = double(wanted) / original;
  const double vertices = wanted / 2.0;
  std::string what;
  if (sharp > 0 && 2.0 * found.model_vertices > vertices)
    what = std::to_string(found.model_vertices) + " model vertices would take more than half of ";
  else if (share <= 0.1 && sharp * std::sqrt(share) > 0.75 * vertices)
    what = "sharp edges would take more than three quarters of the vertices of ";
  if (what.empty()) return what;
  return what + counted(wanted, "face") +
         ": only corners of 50 degrees and more are kept (--feature-angle 20 keeps all)";
}

}  // namespace aomd::cli
