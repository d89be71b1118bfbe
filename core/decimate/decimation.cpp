#include "core/decimate/decimation.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "core/base/edge_key.h"
#include "core/decimate/hanging.h"
#include "core/decimate/loop.h"
#include "core/decimate/paper/surface_paper_loop.h"
#include "core/decimate/paper/volume_paper_loop.h"
#include "core/decimate/quality/quality_loop.h"
#include "core/decimate/spacing/vertex_neighbours.h"
#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/extent.h"
#include "core/mesh/verify.h"

namespace aomd {

const char* phase_name(Phase phase) {
  constexpr const char* names[] = {"collapse", "swap", "smooth", "done"};
  return names[static_cast<std::size_t>(phase)];
}

const char* idea_name(Idea idea) {
  constexpr const char* names[] = {"placement",    "third-powers", "facing",
                                   "second-stage", "far-points",   "dense-points"};
  return names[static_cast<std::size_t>(idea)];
}

double usual_angle_deg(Strategy strategy, bool coarsest) {
  return strategy == Strategy::Paper || coarsest ? 10 : 60;
}

bool has_tetrahedra(const Mesh& mesh) {
  const auto regions = mesh.regions();
  for (const Region r : regions)
    if (mesh.shape(r) == Shape::Tetrahedron) return true;
  return false;
}

const char* decimation_obstacle(const Mesh& mesh) {
  if (mesh.count(3) > 0 && !has_tetrahedra(mesh))
    return "Of volumes only tetrahedra can be decimated, and there are none: --split-to-tets makes "
           "some.";
  for (const Face f : mesh.faces())
    if (mesh.count(3) == 0 && mesh.shape(f) != Shape::Triangle)
      return "Only triangles can be decimated, and there are quads: --triangulate cuts them.";
  if (!has_usual_extent(mesh))
    return "Only meshes from 1e-20 to 1e+18 across can be decimated: write it in another unit.";
  return nullptr;
}

namespace {

bool may_have_no_face(const Mesh& mesh, Edge e) {
  return !mesh.classification(e).valid() || mesh.classification(e).dimension() <= 1;
}

// Without T(1,2), which would cost more than what is let go of.
bool has_edges_without_face(const Mesh& mesh) {
  std::unordered_set<std::uint64_t> bare;
  Column<Vertex, std::uint8_t> ends(mesh.capacity(0), 0);
  for (const Edge e : mesh.edges()) {
    if (!may_have_no_face(mesh, e)) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    bare.insert(edge_key(a.index, b.index));
    ends[a] = ends[b] = 1;
  }
  for (const Face f : mesh.faces()) {
    const Row<0> v = mesh.row<0>(f);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (const Vertex a = v[k], b = v[k + 1 < v.size() ? k + 1 : 0]; ends[a] != 0 && ends[b] != 0)
        bare.erase(edge_key(a.index, b.index));
  }
  return !bare.empty();
}

void require_classified(const Mesh& mesh) {
  if (const auto finding = first_misclassified(mesh))
    throw std::invalid_argument(finding->text + ": classify() mends that");
}

Mesh& decimable(Mesh& mesh) {
  if (const char* obstacle = decimation_obstacle(mesh)) throw std::invalid_argument(obstacle);
  return mesh;
}

// Whether the edges inside model faces are no entities, and all others can be found without T(0,1),
// which takes a face around both ends, and ends where a model edge may end.
bool lists_model_edges_only(const Mesh& mesh) {
  if (mesh.complete(1)) return false;
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() > 1) return false;
    const auto [a, b] = mesh.edge_vertices(e);
    if (!may_end_model_edge(mesh, a) || !may_end_model_edge(mesh, b)) return false;
    const auto has = [](const std::array<Vertex, 3>& t, Vertex v) {
      return t[0] == v || t[1] == v || t[2] == v;
    };
    const auto has_both = [&, first = a, second = b](Face f) {
      const auto t = mesh.triangle(f);
      return has(t, first) && has(t, second);
    };
    const Row<2> faces = fewer_faces(mesh, a, b);
    if (std::none_of(faces.begin(), faces.end(), has_both)) return false;
  }
  return true;
}

// Until the loop is done, or `goes_on` ends; every few candidates it asks whether it is to stop
// before.
template <typename GoesOn>
Decimation::Stop run_while(Loop& loop, const GoesOn& goes_on,
                           std::optional<std::chrono::microseconds> budget,
                           const std::function<bool()>& cancelled) {
  constexpr int candidates_between_checks = 64;
  using Stop = Decimation::Stop;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (int i = 1; !loop.done() && goes_on(); ++i) {
    const bool parts = loop.advance_parts(cancelled);
    if (!parts) loop.advance();
    if (!parts && i % candidates_between_checks != 0) continue;
    if (cancelled && cancelled()) return Stop::Cancelled;
    if (budget && Clock::now() - start >= *budget) return loop.done() ? Stop::Done : Stop::Budget;
  }
  return Stop::Done;
}

}  // namespace

void keep_edges_for_quality(Mesh& mesh) {
  bool any_goes = false;
  for (const Edge e : mesh.edges()) any_goes = any_goes || !may_have_no_face(mesh, e);
  if (any_goes && !has_edges_without_face(mesh)) mesh.keep_model_edges_only();
}

Decimation::Decimation(Mesh& mesh, DecimationOptions options) : mesh_(decimable(mesh)) {
  begin(std::move(options));
}

Decimation::~Decimation() = default;

void Decimation::begin(DecimationOptions options) {
  given_ = options.without_original();
  if (mesh_.count(3) > 0) return begin_volume(options);
  const bool paper = options.strategy == Strategy::Paper;
  const char* name = paper ? PaperLoop::name : QualityLoop::name;
  std::vector<Request> needs;
  const auto need = [&](int i, int j) { needs.push_back(mesh_.request(i, j, name)); };
  need(2, 0);
  if (paper && options.exchange) {
    need(1, 0);
  } else {
    need(0, 2);
    if (!lists_model_edges_only(mesh_)) need(0, 1);
  }
  needs_ = std::move(needs);
  require_classified(mesh_);
  if (paper)
    loop_ = std::make_unique<SurfacePaperLoop>(mesh_, options);
  else
    loop_ = std::make_unique<QualityLoop>(mesh_, std::move(options));
}

// The printed loop goes over all edges, quality names them by their ends; faces inside regions need
// not be entities.
void Decimation::begin_volume(const DecimationOptions& options) {
  if (options.topology != TopologyRule::Safe)
    throw std::invalid_argument("collapses among tetrahedra always keep the topology");
  const bool paper = options.strategy == Strategy::Paper;
  const char* name = paper ? PaperLoop::name : VolumeQualityLoop::name;
  std::vector<Request> needs;
  for (const auto& [i, j] : {std::array{3, 0}, std::array{0, 3}})
    needs.push_back(mesh_.request(i, j, name));
  for (const auto& [i, j] : {std::array{1, 0}, std::array{0, 1}})
    needs.push_back(paper ? mesh_.request(i, j, name) : mesh_.request_listed(i, j, name));
  for (const auto& [i, j] : {std::array{2, 0}, std::array{0, 2}})
    needs.push_back(mesh_.request_listed(i, j, name));
  needs_ = std::move(needs);
  require_classified(mesh_);
  if (const auto finding = first_repeated_region(mesh_)) throw std::invalid_argument(finding->text);
  if (paper)
    loop_ = std::make_unique<VolumePaperLoop>(mesh_, for_loop(options));
  else
    loop_ = std::make_unique<VolumeQualityLoop>(mesh_, for_loop(options));
}

// A volume's loop looks at regions alone.
DecimationOptions Decimation::for_loop(const DecimationOptions& options) const {
  DecimationOptions result = options;
  if (mesh_.count(3) > 0) result.keep = keep_hanging(mesh_, options.keep);
  return result;
}

void Decimation::set_options(const DecimationOptions& options) {
  const DecimationOptions next = options.without_original();
  if (next == given_) return;
  if (options.strategy != given_.strategy || options.exchange != given_.exchange)
    return begin(options);
  given_ = next;
  loop_->restart(for_loop(next));
}

void Decimation::invalidate() { loop_->restart(DecimationOptions(loop_->options())); }

Phase Decimation::phase() const { return loop_->phase(); }
double Decimation::progress() const { return loop_->progress(); }
const std::vector<SweepStatistics>& Decimation::sweeps() const { return loop_->sweeps(); }
double Decimation::spacing(Vertex v) const { return loop_->spacing(v); }
Reason Decimation::last_refusal(Edge e) const { return loop_->last_refusal(e); }
OriginalSamples Decimation::original() { return loop_->original(); }
Verdict Decimation::judge(Edge edge, Vertex& deleted) { return loop_->judge(edge, deleted); }
std::uint32_t Decimation::swap_pass() { return loop_->swap_pass(); }
std::uint32_t Decimation::smooth_pass() { return loop_->smooth_pass(); }
std::vector<CollapseOutlook> Decimation::outlook(Edge edge) { return loop_->outlook(edge); }

std::optional<SwapOutlook> Decimation::swap_outlook(Edge edge) { return loop_->swap_outlook(edge); }

std::optional<MoveOutlook> Decimation::move_outlook(Vertex v) { return loop_->move_outlook(v); }

std::optional<Operation> Decimation::step() {
  while (!done())
    if (loop_->advance()) return loop_->last();
  return {};
}

std::uint32_t Decimation::sweep() {
  if (done()) invalidate();
  while (phase() == Phase::Swap || phase() == Phase::Smooth) loop_->advance();
  std::uint32_t collapses = 0;
  const std::size_t present = sweeps().size();
  while (phase() == Phase::Collapse && sweeps().size() == present) collapses += loop_->advance();
  return collapses;
}

EdgesByReason Decimation::edges_left() {
  constexpr std::uint32_t judged_at_once = 300'000;  // less than a second
  EdgesByReason edges{};
  const std::uint32_t all = mesh_.complete(1) ? mesh_.count(1) : mesh_.count(2) / 2 * 3;  // nearly
  if (options().strategy == Strategy::Paper && all > judged_at_once) {
    const auto& refused = sweeps().back().refused;
    std::copy(refused.begin(), refused.end(), edges.begin());
    return edges;
  }
  const auto count = [&](const Verdict& v) { ++edges[static_cast<std::size_t>(v.reason)]; };
  if (mesh_.complete(1)) {
    Vertex deleted;
    for (const Edge e : mesh_.edges()) count(judge(e, deleted));
    return edges;
  }
  const VertexNeighbours neighbours(mesh_);
  for (const Vertex v : mesh_.vertices())
    for (const std::uint32_t other : neighbours.of(v))
      if (v.index < other) count(loop_->judge(v, Vertex(other)));
  return edges;
}

Decimation::Stop Decimation::run_phase(const std::function<bool()>& cancelled) {
  const auto here = [&] { return std::pair(phase(), sweeps().size()); };
  const auto same_phase = [&, start = here()] { return here() == start; };
  return run_while(*loop_, same_phase, {}, cancelled);
}

Decimation::Stop Decimation::run(std::optional<std::chrono::microseconds> budget,
                                 const std::function<bool()>& cancelled) {
  const auto always = [] { return true; };
  return run_while(*loop_, always, budget, cancelled);
}

}  // namespace aomd
