#include "viewer/document/volume_changes.h"

#include <algorithm>

namespace aomd::scene {
namespace {

/// Beyond so many words of records for each region a fresh start costs less than following.
constexpr std::size_t words_per_region = 1;

/// What an entity is made of; nothing where it is dead or of a shape that no operator edits.
template <std::size_t N>
std::array<Vertex, N> corners_of(const Mesh& mesh, EntityRef e) {
  std::array<Vertex, N> corners{};
  if (!mesh.alive(e)) return corners;
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  if (vertices.size() == N)
    for (std::size_t i = 0; i < N; ++i) corners[i] = Vertex(vertices[i]);
  return corners;
}

bool classifies(const Journal& journal, std::size_t first, std::size_t last) {
  const auto steps = journal.steps().subspan(first, last - first);
  return std::any_of(steps.begin(), steps.end(),
                     [](const JournalStep& s) { return s.kind == StepKind::Classify; });
}

}  // namespace

bool VolumeChangeReader::can_patch(const Mesh& mesh, const Journal& journal,
                                   const HistoryPlace& now) const {
  if (!place_ || !can_follow(*place_, now)) return false;
  const auto [first, last] = std::minmax(place_->cursor, now.cursor);
  return journal.words_of(first, last) <= words_per_region * mesh.count(3) &&
         !classifies(journal, first, last);
}

VolumeChanges VolumeChangeReader::read(const Mesh& mesh, const Journal& journal,
                                       const HistoryPlace& now) {
  VolumeChanges changes;
  if (now == place_) return changes;
  changes.everything = !can_patch(mesh, journal, now);
  if (changes.everything)
    remember(mesh);
  else
    collect(mesh, journal, now.cursor, changes);
  place_ = now;
  return changes;
}

void VolumeChangeReader::collect(const Mesh& mesh, const Journal& journal, std::size_t cursor,
                                 VolumeChanges& changes) {
  auto& [vertices, edges, faces, regions] = touched_;
  const auto [first, last] = std::minmax(place_->cursor, cursor);
  journal.touched(first, last, [&](EntityRef e) {
    touched_[static_cast<std::size_t>(e.dimension)].add(e.index);
  });
  changes.vertices = vertices.take<Vertex>();
  // A moved vertex takes its regions and faces with it.
  for (const Vertex v : changes.vertices) {
    vertices.add(v.index);
    if (!mesh.alive(v)) continue;
    for (const Region r : mesh.row<3>(v)) regions.add(r.index);
    for (const Face f : mesh.row<2>(v)) faces.add(f.index);
  }
  changes.regions = regions.take<Region>();
  changes.faces = faces.take<Face>();
  changes.edges = edges.take<Edge>();
  look(mesh, changes.regions, regions_, changes.regions_before);
  look(mesh, changes.faces, faces_, changes.faces_before);
  look(mesh, changes.edges, edges_, changes.edges_before);
  changes.surroundings = vertices.take<Vertex>();
}

/// Notes the vertices of entities, before and after, and remembers them as they are now.
template <typename H, std::size_t N>
void VolumeChangeReader::look(const Mesh& mesh, const std::vector<H>& entities,
                              std::vector<std::array<Vertex, N>>& known,
                              std::vector<std::array<Vertex, N>>& before) {
  if (known.size() < mesh.capacity(H::dimension)) known.resize(mesh.capacity(H::dimension));
  for (const H h : entities) {
    // What came and went between two looks is beyond all that is there.
    if (h.index >= known.size()) known.resize(h.index + std::size_t{1});
    before.push_back(known[h.index]);
    known[h.index] = corners_of<N>(mesh, h);
    for (const auto* corners : {&before.back(), &known[h.index]})
      for (const Vertex v : *corners)
        if (v.valid()) touched_[0].add(v.index);
  }
}

void VolumeChangeReader::remember(const Mesh& mesh) {
  const auto all = [&]<std::size_t N>(int dim, std::vector<std::array<Vertex, N>>& known) {
    known.resize(mesh.capacity(dim));
    for (std::uint32_t id = 0; id < known.size(); ++id) known[id] = corners_of<N>(mesh, {dim, id});
  };
  all(3, regions_);
  all(2, faces_);
  all(1, edges_);
}

}  // namespace aomd::scene
