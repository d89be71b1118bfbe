// The C interface of what is done to meshes.

#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>

#include "core/base/parallel.h"
#include "core/c/handles.h"
#include "core/decimate/counted_values.h"
#include "core/decimate/decimation.h"
#include "core/fields/seams.h"
#include "core/io/error.h"
#include "core/io/left_out.h"
#include "core/measure/distance.h"
#include "core/measure/normals.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/repair/repair.h"

// NOLINTBEGIN(google-global-names-in-headers): functions of C stand in no namespace.
using aomd::Mesh;
using aomd::c::BadArgument;
using aomd::c::guarded;
// NOLINTEND(google-global-names-in-headers)

namespace {

aomd_decimate_options usual_options() {
  aomd_decimate_options options{};
  options.size = sizeof options;
  options.factor = 4;
  options.regularity = 0.5;
  options.feature_angle = 20;
  options.attributes = 1;
  return options;
}

/// What an older program does not know of is as usual.
aomd_decimate_options known(const aomd_decimate_options* given) {
  aomd_decimate_options options = usual_options();
  if (given == nullptr) return options;
  if (given->size < sizeof(std::size_t)) throw BadArgument("options: their size is not set");
  std::memcpy(&options, given, std::min(given->size, sizeof options));
  if (!(options.factor > 0)) throw BadArgument("factor: must be more than 0");
  if (!(options.regularity >= 0 && options.regularity <= 1))
    throw BadArgument("regularity: must be 0 to 1");
  return options;
}

aomd::DecimationOptions for_library(const aomd_decimate_options& given) {
  aomd::DecimationOptions options;
  options.strategy = given.paper ? aomd::Strategy::Paper : aomd::Strategy::Quality;
  options.target_faces = given.target;
  options.factor = given.factor;
  options.coarsest = given.coarsest != 0;
  options.angle_deg =
      given.angle > 0 ? given.angle : aomd::usual_angle_deg(options.strategy, options.coarsest);
  options.min_angle_deg = given.min_angle;
  options.regularity = given.regularity;
  options.max_distance = given.max_distance;
  options.no_intersections = given.no_intersections != 0;
  options.threads = aomd::thread_count(given.threads);
  return options;
}

aomd::ClassifyOptions by_angle(double feature_angle) {
  aomd::ClassifyOptions options;
  options.feature_angle_deg.reset();
  if (feature_angle > 0) options.feature_angle_deg = feature_angle;
  return options;
}

void classify_for(Mesh& mesh, const aomd::MeshData& data, const aomd_decimate_options& options) {
  aomd::ClassifyOptions how = by_angle(options.feature_angle);
  if (data.regions.empty()) how.seams = aomd::fields::seams_of(data);
  how.complete = options.paper != 0;
  classify(mesh, how);
  if (mesh.count(3) > 0) mesh.keep_model_faces_only();
  // The paper's strategy goes over listed edges first.
  if (!options.paper || (mesh.count(3) == 0 && data.edges.shapes.empty()))
    keep_edges_for_quality(mesh);
}

void ask(const aomd_decimate_options& options, double done) {
  if (options.progress && options.progress(done, options.user) != 0) throw aomd::c::Cancelled();
}

void run(aomd::Decimation& decimation, const aomd_decimate_options& options) {
  using namespace std::chrono_literals;
  ask(options, 0);
  while (decimation.run(100ms) == aomd::Decimation::Stop::Budget)
    ask(options, decimation.progress());
}

aomd_mesh* mesh_of(const Mesh& mesh) { return new aomd_mesh{to_data(mesh), {}}; }

}  // namespace

aomd_status aomd_decimate_options_init(aomd_decimate_options* options, size_t size) {
  return guarded([&] {
    if (size < sizeof(std::size_t)) throw BadArgument("options: too small");
    const aomd_decimate_options usual = usual_options();
    std::memset(options, 0, size);
    std::memcpy(options, &usual, std::min(size, sizeof usual));
    options->size = size;
  });
}

aomd_status aomd_decimate(const aomd_mesh* mesh, const aomd_decimate_options* options,
                          aomd_mesh** result) {
  return guarded([&] {
    const aomd_decimate_options told = known(options);
    Mesh work(mesh->data);
    if (const char* obstacle = aomd::decimation_obstacle(work))
      throw aomd::io::LimitError("mesh", {}, obstacle);
    classify_for(work, mesh->data, told);
    aomd::DecimationOptions steps = for_library(told);
    if (told.attributes && !told.paper && mesh->data.regions.empty())
      steps.values = counted_values(mesh->data, work, aomd::usual_weights(mesh->data));
    {
      aomd::Decimation decimation(work, steps);
      run(decimation, told);
    }
    if (const auto findings = verify(work); !findings.empty())
      throw aomd::io::ReadError("mesh", {}, "cannot be decimated: " + findings.front().text);
    std::unique_ptr<aomd_mesh> made(mesh_of(work));
    made->notes = aomd::io::carry_along(mesh->data, made->data, steps.threads).notes;
    *result = made.release();
  });
}

aomd_status aomd_classify(const aomd_mesh* mesh, double feature_angle, aomd_mesh** result) {
  return guarded([&] {
    Mesh work(mesh->data);
    classify(work, by_angle(feature_angle));
    *result = mesh_of(work);
  });
}

aomd_status aomd_repair(const aomd_mesh* mesh, int weld, size_t* mended, aomd_mesh** result) {
  return guarded([&] {
    auto made = std::make_unique<aomd_mesh>(*mesh);
    aomd::RepairOptions options;
    options.weld = weld != 0;
    const aomd::RepairReport report = repair(made->data, options);
    *mended = 0;
    for (const aomd::RepairItem& item : report.done) *mended += item.count;
    *result = made.release();
  });
}

aomd_status aomd_check(const aomd_mesh* mesh, size_t* findings) {
  return guarded([&] {
    const auto found = verify(Mesh(mesh->data));
    *findings = found.size();
    if (!found.empty()) aomd::c::set_last_error(found.front().text);
  });
}

aomd_status aomd_compare(const aomd_mesh* original, const aomd_mesh* result, size_t samples,
                         aomd_distance* distance) {
  return guarded([&] {
    const int threads = aomd::thread_count(0);
    const Mesh before(original->data), after(result->data);
    const aomd::measure::Surface from(before, threads), to(after, threads);
    const auto apart = aomd::measure::mutual_distance(from, to, samples, threads);
    aomd_distance found{distance->size, apart.max(), apart.rms(), apart.mean(), 0};
    found.flips = aomd::measure::measure_normals(from.tree(), after, threads).flips;
    std::memcpy(distance, &found, std::min(distance->size, sizeof found));
  });
}
