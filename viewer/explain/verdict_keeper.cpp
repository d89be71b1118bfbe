#include "viewer/explain/verdict_keeper.h"

#include "viewer/base/sort_once.h"

namespace aomd::scene {

namespace {

std::shared_ptr<const EdgeCodes> codes_of_skin(const EdgeCodes& codes, const Mesh& mesh,
                                               const SkinSurface& skin) {
  auto of_skin = std::make_shared<EdgeCodes>(skin.mesh.capacity(1), unjudged);
  for (const Edge e : skin.mesh.edges()) {
    const auto [a, b] = skin.mesh.edge_vertices(e);
    const Edge own = mesh.find_edge(skin.vertices[a.index], skin.vertices[b.index]);
    if (own.valid() && own.index < codes.size()) (*of_skin)[e] = codes[own];
  }
  return of_skin;
}

/// Those that changed, and those at vertices around which something did.
std::vector<Edge> edges_around(const Mesh& mesh, const VolumeChanges& changes) {
  std::vector<Edge> edges = changes.edges;
  for (const Vertex v : changes.surroundings)
    if (mesh.alive(v))
      for (const Edge e : mesh.row<1>(v)) edges.push_back(e);
  sort_once(edges);
  return edges;
}

}  // namespace

void VerdictKeeper::note(const Document& document, const View& view, const SurfaceChanges& changes,
                         bool busy) {
  if (view.coloring != Coloring::Verdict || !document.hindrance().empty()) return verdicts_.reset();
  const std::uint64_t options = document.options_revision();
  const bool anew = !verdicts_ || changes.everything || options_ != options || was_busy_;
  if (!busy && anew) {
    verdicts_.emplace().start(document.mesh());
    options_ = options;
  } else if (verdicts_) {
    verdicts_->note(document.mesh(), changes);
  }
  was_busy_ = busy;
}

void VerdictKeeper::note_volume(const Document& document, const View& view,
                                const VolumeChanges& changes, bool busy) {
  SurfaceChanges around;
  around.everything = changes.everything;
  if (view.coloring == Coloring::Verdict) around.edges = edges_around(document.mesh(), changes);
  note(document, view, around, busy);
}

void VerdictKeeper::update(const Document& document, const View& view,
                           const SurfaceChanges& changes, bool busy, SurfaceDrawing& drawing) {
  note(document, view, changes, busy);
  drawing.set_edge_codes(verdicts_ ? verdicts_->codes() : nullptr);
}

void VerdictKeeper::judge(Document& document, std::optional<std::chrono::microseconds> budget,
                          bool busy, SurfaceDrawing& drawing) {
  const std::vector<Edge> others = judge_on(document, budget, busy);
  if (!others.empty()) drawing.recode(document.mesh(), others);
}

/// The edges of which something else is said now. Where nothing can be judged, nothing is shown.
std::vector<Edge> VerdictKeeper::judge_on(Document& document,
                                          std::optional<std::chrono::microseconds> budget,
                                          bool busy) {
  if (!pending() || busy) return {};
  if (Decimation* decimation = document.build_decimation_to_judge())
    return verdicts_->judge(*decimation, document.mesh(), budget);
  verdicts_.reset();
  return {};
}

void VerdictKeeper::judge_skin(Document& document, const SkinSurface& skin,
                               std::optional<std::chrono::microseconds> budget, bool busy,
                               SurfaceDrawing& drawing, bool anew) {
  const bool others = !judge_on(document, budget, busy).empty();
  if (!verdicts_)
    skin_codes_.reset();
  else if (others || anew || !skin_codes_)
    skin_codes_ = codes_of_skin(*verdicts_->codes(), document.mesh(), skin);
  drawing.set_edge_codes(skin_codes_);
}

std::vector<EntityRef> find_edges_refused_for(Document& document, Reason reason) {
  document.prepare();  // of a volume, all edges become entities
  EdgeVerdicts verdicts;
  verdicts.start(document.mesh());
  if (Decimation* decimation = document.build_decimation_to_judge())
    static_cast<void>(verdicts.judge(*decimation, document.mesh(), std::nullopt));
  std::vector<EntityRef> edges;
  for (const Edge e : document.mesh().edges())
    if ((*verdicts.codes())[e] == static_cast<std::uint8_t>(reason)) edges.emplace_back(e);
  return edges;
}

}  // namespace aomd::scene
