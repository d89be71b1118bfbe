#include "core/decimate/paper/surface_edges.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"

namespace aomd {
namespace {

constexpr std::array<std::uint8_t, 3> next_side{1, 2, 0}, previous_side{2, 0, 1};

constexpr std::size_t vertices_a_piece = 16384, faces_a_piece = 16384;

// One for each thread, since each piece takes memory for all vertices.
std::size_t pieces_for(std::size_t vertices, int threads) {
  return std::clamp<std::size_t>(vertices / vertices_a_piece, 1, static_cast<std::size_t>(threads));
}

std::size_t piece_size(std::size_t vertices, std::size_t pieces) {
  return (vertices + pieces - 1) / pieces;
}

std::size_t slot_of(const std::array<Vertex, 3>& t, Vertex v) {
  return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

bool uses(const std::array<Vertex, 3>& t, Vertex v) { return t[0] == v || t[1] == v || t[2] == v; }

}  // namespace

SurfaceEdges::SurfaceEdges(const Mesh& mesh, int threads)
    : sides_(3 * std::size_t{mesh.capacity(2)}) {
  const std::size_t vertices = mesh.capacity(0);
  std::vector<std::vector<EdgeEnds>> pieces(pieces_for(vertices, threads));
  const std::size_t size = piece_size(vertices, pieces.size());
  parallel_for(pieces.size(), threads, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      pieces[i] = number(mesh, size * i, std::min(vertices, size * (i + 1)));
  });
  if (pieces.size() == 1)
    ends_ = std::move(pieces[0]);
  else
    join(mesh, pieces, threads);
  ids_.create_many(static_cast<std::uint32_t>(ends_.size()));
}

// Those whose smaller vertex is one of these, numbered from 0. Each edge is met at that vertex: it
// was met before where it has a number since the vertex had its turn.
std::vector<EdgeEnds> SurfaceEdges::number(const Mesh& mesh, std::size_t begin, std::size_t end) {
  std::vector<EdgeEnds> ends;
  ends.reserve((3 * (end - begin) + (end - begin) / 16) + 16);
  Column<Vertex, std::uint32_t> met(mesh.capacity(0), 0);  // the number of the last edge to it + 1
  each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
    const std::size_t first = ends.size();
    for (const Face f : mesh.row<2>(Vertex(id))) {
      const auto t = mesh.triangle(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex from = t[k], to = t[next_side[k]];
        if (std::min(from, to).index != id) continue;
        std::uint32_t& last = met[std::max(from, to)];
        if (last <= first) {
          ends.push_back({from, to});
          last = static_cast<std::uint32_t>(ends.size());
        }
        sides(f)[k] = last - 1;
      }
    }
  });
  return ends;
}

// The numbers of each piece follow those of the pieces before.
void SurfaceEdges::join(const Mesh& mesh, const std::vector<std::vector<EdgeEnds>>& pieces,
                        int threads) {
  std::vector<std::uint32_t> first;
  for (const auto& piece : pieces) {
    first.push_back(static_cast<std::uint32_t>(ends_.size()));
    ends_.insert(ends_.end(), piece.begin(), piece.end());
  }
  const std::size_t size = piece_size(mesh.capacity(0), pieces.size());
  parallel_for(mesh.capacity(2), threads, faces_a_piece, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(2), begin, end, [&](std::uint32_t id) {
      const auto t = mesh.triangle(Face(id));
      for (std::size_t k = 0; k < 3; ++k)
        sides(Face(id))[k] += first[std::min(t[k], t[next_side[k]]).index / size];
    });
  });
}

Edge SurfaceEdges::find(const Mesh& mesh, Vertex a, Vertex b) const {
  for (const Face f : fewer_faces(mesh, a, b)) {
    const auto t = mesh.triangle(f);
    if (!uses(t, a) || !uses(t, b)) continue;
    const std::size_t slot = slot_of(t, a);
    const std::size_t k = t[next_side[slot]] == b ? slot : previous_side[slot];
    return Edge(sides_[3 * std::size_t{f.index} + k]);
  }
  return {};
}

// Around most vertices each edge is the side before a face as well as the one after another.
std::span<const Vertex> SurfaceEdges::neighbours(const Mesh& mesh, Vertex v,
                                                 Scratch& scratch) const {
  const Row<2> faces = mesh.row<2>(v);
  std::vector<std::uint64_t>& edges = scratch.edges_around_;
  edges.resize(2 * faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto t = mesh.triangle(faces[i]);
    const std::uint32_t* const side = sides(faces[i]);
    const std::size_t k = slot_of(t, v), before = previous_side[k];
    edges[i] = std::uint64_t{side[k]} << 32 | t[next_side[k]].index;
    edges[faces.size() + i] = std::uint64_t{side[before]} << 32 | t[before].index;
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(faces.size());
  const auto end = std::remove_if(middle, edges.end(), [&](std::uint64_t edge) {
    return std::find(edges.begin(), middle, edge) != middle;
  });
  std::sort(edges.begin(), end);
  edges.erase(std::unique(edges.begin(), end), edges.end());
  std::vector<Vertex>& around = scratch.around_;
  around.clear();
  for (const std::uint64_t edge : edges) around.emplace_back(static_cast<std::uint32_t>(edge));
  return around;
}

Column<Vertex, double> SurfaceEdges::average_lengths(const Mesh& mesh) const {
  Column<Vertex, double> average(mesh.capacity(0), 0.0);
  Column<Vertex, std::uint32_t> count(mesh.capacity(0), 0);
  for (const Edge e : EntityRange<1>(ids_)) {
    const double length = glm::length(mesh.position(ends(e)[0]) - mesh.position(ends(e)[1]));
    for (const Vertex v : ends(e)) average[v] += length, ++count[v];
  }
  for (const Vertex v : mesh.vertices())
    if (count[v] > 0) average[v] /= count[v];
  return average;
}

void SurfaceEdges::end(Edge e, Scratch& scratch) {
  EdgeEnds& ends = ends_[e.index];
  if (ends[0].valid()) scratch.ended_.push_back(e);
  ends = {};
}

void SurfaceEdges::settle(Scratch& scratch) {
  for (const Edge e : scratch.ended_) ids_.destroy(e.index);
  scratch.ended_.clear();
}

// Beside a face that goes, the edge from the deleted end falls together with that from the kept
// one.
void SurfaceEdges::merge_beside(const StarFace& gone, Vertex kept, Scratch& scratch) {
  const std::uint32_t* const side = sides(gone.face);
  const std::uint32_t after = side[gone.slot], before = side[previous_side[gone.slot]];
  const bool ahead = gone.next == kept;
  end(Edge(ahead ? after : before), scratch);
  add_merge({ahead ? before : after, side[next_side[gone.slot]]}, scratch);
}

// Without the link condition the ends may have other neighbours in common.
void SurfaceEdges::merge_others(const Contraction& c, const Mesh& mesh, const StarPair& stars,
                                Scratch& scratch) {
  if (!scratch.marks_) scratch.marks_.emplace(mesh);
  VertexMarks& marks = *scratch.marks_;
  Column<Vertex, std::uint32_t>& edge_to = scratch.edge_to_;
  marks.clear(mesh);
  edge_to.resize(mesh.capacity(0));
  for (const StarFace& f : stars[1]) {
    marks.set(f.next);
    marks.set(f.previous);
    edge_to[f.next] = sides(f.face)[f.slot];
    edge_to[f.previous] = sides(f.face)[previous_side[f.slot]];
  }
  for (const StarFace& f : stars[0]) {
    if (f.uses(c.kept)) continue;
    if (marks.has(f.next)) add_merge({sides(f.face)[f.slot], edge_to[f.next]}, scratch);
    if (marks.has(f.previous))
      add_merge({sides(f.face)[previous_side[f.slot]], edge_to[f.previous]}, scratch);
  }
}

void SurfaceEdges::add_merge(Merge merge, Scratch& scratch) {
  end(Edge(merge.gone), scratch);
  scratch.merges_.push_back(merge);
}

void SurfaceEdges::stretch(std::uint32_t& side, const Contraction& c, const Scratch& scratch) {
  for (const Merge& merge : scratch.merges_)
    if (side == merge.gone) {
      side = merge.stays;
      return;
    }
  for (Vertex& v : ends_[side])
    if (v == c.deleted) v = c.kept;
}

void SurfaceEdges::collapse(const Mesh& mesh, const Contraction& c, const StarPair& stars,
                            TopologyRule topology, Scratch& scratch) {
  scratch.merges_.clear();
  for (const StarFace& f : stars[0])
    if (f.uses(c.kept)) merge_beside(f, c.kept, scratch);
  if (topology != TopologyRule::Safe) merge_others(c, mesh, stars, scratch);
  for (const StarFace& f : stars[0]) {
    if (f.uses(c.kept)) continue;
    stretch(sides(f.face)[f.slot], c, scratch);
    stretch(sides(f.face)[previous_side[f.slot]], c, scratch);
  }
  for (const StarFace& f : stars[0])  // the last face of an edge may go, but not with Safe
    if (topology != TopologyRule::Safe && f.uses(c.kept) &&
        leaves_bare_edge({c.deleted, c.kept}, stars, f.third(c.kept)))
      end(Edge(sides(f.face)[next_side[f.slot]]), scratch);
}

void SurfaceEdges::swap(const Mesh& mesh, const EdgePair& pair) {
  const std::size_t a = slot_of(mesh.triangle(pair.f), pair.a),
                    b = slot_of(mesh.triangle(pair.g), pair.b);
  std::uint32_t *f = sides(pair.f), *g = sides(pair.g);
  const std::uint32_t diagonal = f[a];
  f[a] = std::exchange(g[previous_side[b]], diagonal);
  g[b] = std::exchange(f[previous_side[a]], diagonal);
  EdgeEnds& ends = ends_[diagonal];
  ends = ends[0] == pair.a ? EdgeEnds{pair.c, pair.d} : EdgeEnds{pair.d, pair.c};
}

}  // namespace aomd
