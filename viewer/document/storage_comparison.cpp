#include "viewer/document/storage_comparison.h"

#include <chrono>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/decimate/decimation.h"

namespace aomd::scene {
namespace {

using Clock = std::chrono::steady_clock;
using GoingOn = std::function<bool(double)>;

/// One way on one mesh, phase by phase.
class Runner {
 public:
  Runner(Mesh& mesh, const DecimationOptions& options, const GoingOn& going_on)
      : mesh_(mesh), decimation_(mesh, options), going_on_(going_on) {}

  /// False where it was told to stop.
  bool run(StorageRun& run) {
    std::optional<bool> collapsed;
    while (!decimation_.done()) {
      const bool collapses = decimation_.phase() == Phase::Collapse;
      run.exchanges += decimation_.options().exchange && collapsed && *collapsed != collapses;
      collapsed = collapses;
      if (!run_phase(collapses ? run.collapses : run.improvement)) return false;
    }
    for (int level = 0; level < 3; ++level)
      run.counts[static_cast<std::size_t>(level)] = mesh_.count(level);
    return true;
  }

 private:
  bool run_phase(StoragePart& part) {
    const auto before = Clock::now();
    const auto look = [&] {
      part.bytes = mesh_.adjacency_bytes();
      part.peak = std::max(part.peak, part.bytes);
      return going_on_ && !going_on_(decimation_.progress());
    };
    const bool stopped = decimation_.run_phase(look) == Decimation::Stop::Cancelled;
    part.ms += std::chrono::duration<double, std::milli>(Clock::now() - before).count();
    look();
    return !stopped;
  }

  Mesh& mesh_;
  Decimation decimation_;
  const GoingOn& going_on_;
};

bool same(const Mesh& a, const Mesh& b) {
  for (int level = 0; level < 3; ++level)
    if (!(a.ids(level) == b.ids(level))) return false;
  for (const Vertex v : a.vertices())
    if (a.position(v) != b.position(v)) return false;
  for (const Face f : a.faces())
    if (a.triangle(f) != b.triangle(f)) return false;
  for (const Edge e : a.edges())
    if (a.edge_vertices(e) != b.edge_vertices(e) || a.classification(e) != b.classification(e))
      return false;
  return true;
}

/// A column for a copy of the mesh.
template <typename T>
std::shared_ptr<const Column<Vertex, T>> closed_up(
    const Mesh& mesh, const std::shared_ptr<const Column<Vertex, T>>& column) {
  if (!column) return {};
  return std::make_shared<Column<Vertex, T>>(
      aomd::closed_up(*column, std::span<const Vertex>(mesh.vertices().list())));
}

nlohmann::ordered_json json_of(const StoragePart& part) {
  return {{"ms", part.ms}, {"bytes_after", part.bytes}, {"bytes_peak", part.peak}};
}

std::string row(const char* way, const char* name, const StoragePart& part) {
  return std::string(way) + "\t" + name + "\t" + std::to_string(part.ms) + "\t" +
         std::to_string(part.bytes) + "\t" + std::to_string(part.peak) + "\n";
}

}  // namespace

StorageComparison compare_storage(const MeshData& data, const DecimationOptions& options,
                                  const GoingOn& going_on) {
  StorageComparison result;
  std::array<Mesh, 2> meshes{Mesh(data), Mesh(data)};
  for (std::size_t way = 0; way < 2; ++way) {
    DecimationOptions each = options;
    each.strategy = Strategy::Paper;
    each.exchange = way == 1;
    each.model = nullptr;
    const GoingOn part = [&](double progress) {
      return !going_on || going_on(0.5 * (static_cast<double>(way) + progress));
    };
    // Without exchanges the loop would name edges by their ends where they are no entities.
    const Request edges = way == 0 ? meshes[way].request(0, 1, "the comparison") : Request();
    if (!Runner(meshes[way], each, part).run(result.ways[way])) return result;
  }
  result.same = same(meshes[0], meshes[1]);
  return result;
}

std::unique_ptr<Background<StorageComparison>> start_comparing(const Mesh& mesh,
                                                               const DecimationOptions& options) {
  DecimationOptions each = options;
  each.spacing = closed_up(mesh, options.spacing);
  each.keep = closed_up(mesh, options.keep);
  return std::make_unique<Background<StorageComparison>>(
      [data = to_data(mesh), each](const std::stop_token& stop, std::atomic<double>& progress) {
        return compare_storage(data, each, [&](double part) {
          progress = part;
          return !stop.stop_requested();
        });
      });
}

std::string storage_table(const StorageComparison& result) {
  std::string text = "Way\tPart\tMs\tBytes after it\tBytes at most\n";
  for (std::size_t way = 0; way < 2; ++way) {
    text += row(way_names[way], "collapses", result.ways[way].collapses);
    text += row(way_names[way], "swaps and smoothing", result.ways[way].improvement);
  }
  return text;
}

std::string storage_json(const StorageComparison& result) {
  nlohmann::ordered_json json;
  for (std::size_t way = 0; way < 2; ++way) {
    const StorageRun& run = result.ways[way];
    json[way == 0 ? "keep" : "exchange"] = {{"collapses", json_of(run.collapses)},
                                            {"swaps_and_smoothing", json_of(run.improvement)},
                                            {"exchanges", run.exchanges},
                                            {"vertices", run.counts[0]},
                                            {"edges", run.counts[1]},
                                            {"faces", run.counts[2]}};
  }
  json["same_result"] = result.same;
  return json.dump(2) + "\n";
}

}  // namespace aomd::scene
