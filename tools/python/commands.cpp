// What the commands of `aomd` come to, for meshes in memory.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/base/parallel.h"
#include "core/io/left_out.h"
#include "core/measure/intersections.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/repair/repair.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/repair_items.h"
#include "tools/python/arrays.h"

namespace aomd::python {
namespace {

std::string info_text(const MeshData& mesh) { return cli::info("mesh", mesh).dump(); }

std::string check_text(const MeshData& mesh, bool unused,
                       const std::vector<std::string>& required) {
  return cli::check("mesh", mesh, unused, required).dump();
}

cli::CompareArguments compare_arguments(std::size_t samples, int threads,
                                        std::optional<double> max_distance,
                                        std::optional<double> max_rms,
                                        std::optional<std::size_t> max_flips,
                                        std::optional<std::size_t> max_intersections,
                                        bool same_topology) {
  cli::CompareArguments options;
  options.original = "original";
  options.result = "result";
  options.quiet = true;
  options.samples = samples;
  options.threads = threads;
  options.max_distance = max_distance;
  options.max_rms = max_rms;
  options.max_flips = max_flips;
  options.max_intersections = max_intersections;
  options.same_topology = same_topology;
  return options;
}

std::string compare_text(const MeshData& original, const MeshData& result,
                         const cli::CompareArguments& options) {
  return cli::compare(options, original, result).dump();
}

std::pair<MeshHandle, std::string> repaired(const MeshData& mesh, const RepairOptions& options) {
  cli::check_mendable("mesh", mesh);
  auto result = std::make_shared<MeshData>(mesh);
  const RepairReport report = repair(*result, options);
  const cli::Json json{{"done", cli::items_json(report.done)},
                       {"left", cli::items_json(report.left)}};
  return {std::move(result), json.dump()};
}

struct ClassifiedMesh {
  MeshHandle mesh;
  ClassifyResult found;
  std::vector<std::string> notes;
};

ClassifiedMesh classified(const MeshData& given, const ClassifyOptions& options) {
  Mesh mesh(given);
  ClassifiedMesh result;
  result.found = classify(mesh, options);
  if (const auto findings = verify(mesh); !findings.empty())
    throw io::ReadError("mesh", {}, "cannot be classified: " + findings.front().text);
  result.mesh = std::make_shared<MeshData>(to_data(mesh));
  result.notes = io::carry_along(given, *result.mesh, thread_count(0)).notes;
  return result;
}

std::vector<std::uint32_t> intersections(const MeshData& data) {
  const Mesh mesh(data);
  std::vector<std::uint32_t> pairs;
  for (const measure::IntersectingPair& pair : measure::self_intersections(mesh, thread_count(0))) {
    pairs.push_back(pair.first.index);
    pairs.push_back(pair.second.index);
  }
  return pairs;
}

void add_repair_options(py::module_& module) {
  py::class_<RepairOptions>(module, "RepairOptions")
      .def(py::init<>())
      .def_readwrite("weld", &RepairOptions::weld)
      .def_readwrite("weld_tolerance", &RepairOptions::weld_tolerance)
      .def_readwrite("repeated_vertices", &RepairOptions::repeated_vertices)
      .def_readwrite("opposite_faces", &RepairOptions::opposite_faces)
      .def_readwrite("repeated_faces", &RepairOptions::repeated_faces)
      .def_readwrite("orient", &RepairOptions::orient)
      .def_readwrite("split", &RepairOptions::split)
      .def_readwrite("zero_area", &RepairOptions::zero_area)
      .def_readwrite("min_piece_pct", &RepairOptions::min_piece_pct)
      .def_readwrite("drop_unused", &RepairOptions::drop_unused);
  module.def("repair", &repaired, NoLock());
}

py::tuple classify_arrays(const MeshData& mesh, std::optional<double> angle, bool replace) {
  ClassifyOptions options;
  options.feature_angle_deg = angle;
  options.keep_present = !replace;
  ClassifiedMesh result;
  {
    const py::gil_scoped_release unlocked;
    result = classified(mesh, options);
  }
  py::dict counts;
  counts["model_vertices"] = result.found.model_vertices;
  counts["model_edges"] = result.found.model_edges;
  counts["model_faces"] = result.found.model_faces;
  counts["given"] = result.found.given;
  return py::make_tuple(std::move(result.mesh), counts, result.notes);
}

}  // namespace

void add_commands(py::module_& module) {
  module.def("info", &info_text, NoLock());
  module.def("check", &check_text, NoLock());
  py::class_<cli::CompareArguments>(module, "CompareArguments").def(py::init(&compare_arguments));
  module.def("compare", &compare_text, NoLock());
  add_repair_options(module);
  module.def("classify", &classify_arrays);
  module.def("self_intersections", [](const MeshData& mesh) {
    std::vector<std::uint32_t> pairs;
    {
      const py::gil_scoped_release unlocked;
      pairs = intersections(mesh);
    }
    return owned(std::move(pairs), 2);
  });
}

}  // namespace aomd::python
