#include "core/operators/link_condition.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"

namespace aomd {
namespace {

void mark_neighbours(const Mesh& mesh, Vertex kept, const Star& star, VertexMarks& marks) {
  marks.clear(mesh);
  for (const StarFace& f : star) {
    marks.set(f.next);
    marks.set(f.previous);
  }
  marks.set(kept);
}

// A collapse takes faces out of the rows of the apexes, which nothing reads before: they come from
// memory while it is judged.
void fetch_rows(const Mesh& mesh, const std::vector<Vertex>& apexes) {
  for (const Vertex apex : apexes) __builtin_prefetch(mesh.row<2>(apex).indices().data());
}

// Where two faces meet at the edge, as nearly everywhere: whether the ends have no neighbours in
// common but these apexes, each has a further face around the first end, and no face there joins
// them. Then nothing speaks against a collapse. Without branches: which faces have one of them
// cannot be foretold.
bool is_plain(const Star& star, Vertex other_end, const std::vector<Vertex>& apexes,
              const VertexMarks& marks) {
  const Vertex a = apexes[0], b = apexes[1];
  bool at_a = false, at_b = false, others = false;
  for (const StarFace& f : star) {
    const bool stays = !f.uses(other_end);
    const bool next = stays & marks.has(f.next), previous = stays & marks.has(f.previous);
    const bool next_a = f.next == a, next_b = f.next == b;
    const bool previous_a = f.previous == a, previous_b = f.previous == b;
    at_a |= (next & next_a) | (previous & previous_a);
    at_b |= (next & next_b) | (previous & previous_b);
    others |=
        (next & previous) | (next & !(next_a | next_b)) | (previous & !(previous_a | previous_b));
  }
  return at_a & at_b & !others;
}

}  // namespace

// The third vertices of the faces at the edge. False where two of them are one: those faces enclose
// a pocket.
bool LinkCondition::gather_apexes(const Star& star, Vertex other_end) {
  apexes_.clear();
  for (const StarFace& f : star) {
    if (!f.uses(other_end)) continue;
    const Vertex apex = f.third(other_end);
    if (apex_bit(apex) != 0) return false;
    apexes_.push_back(apex);
  }
  return true;
}

// One bit for each apex; those past the 63rd share the last, which only makes a later check look
// closer.
std::uint64_t LinkCondition::apex_bit(Vertex v) const {
  for (std::size_t i = 0; i < apexes_.size(); ++i)
    if (apexes_[i] == v) return std::uint64_t{1} << std::min<std::size_t>(i, 63);
  return 0;
}

// The two other edges of a removed face fall together. If neither has a further face, the one that
// stays has none.
bool leaves_bare_edge(const EdgeEnds& ends, const StarPair& stars, Vertex apex) {
  for (std::size_t i = 0; i < 2; ++i)
    for (const StarFace& f : stars[i])
      if (f.uses(apex) && !f.uses(ends[1 - i])) return false;
  return true;
}

Vertex closes_chain(const Mesh& mesh, const EdgeEnds& ends, const Star& around_first) {
  Vertex third;
  for_edges_at(mesh, ends[0], around_first, [&](Edge e, Vertex far) {
    if (far != ends[1] && on_model_edge(mesh, e) &&
        on_model_edge(mesh, mesh.find_edge(ends[1], far)))
      third = far;
  });
  return third;
}

// Whether the faces that stay around both ends hang together beside the edge, from apex to apex:
// else they would meet in nothing but the kept vertex.
bool LinkCondition::stay_together(const EdgeEnds& ends, const StarPair& stars) const {
  std::vector<Vertex> around;
  const auto for_staying = [&](auto&& visit) {
    for (std::size_t i = 0; i < 2; ++i)
      for (const StarFace& f : stars[i])
        if (!f.uses(ends[1 - i])) visit(f);
  };
  for_staying([&](const StarFace& f) { around.insert(around.end(), {f.next, f.previous}); });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  const auto place = [&](Vertex v) {
    return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), v) -
                                      around.begin());
  };
  DisjointSets sheets(around.size());
  for_staying([&](const StarFace& f) { sheets.unite(place(f.next), place(f.previous)); });
  const auto ends_here = [&](Vertex apex) {  // no face is left beside the edge: judged elsewhere
    return !std::binary_search(around.begin(), around.end(), apex);
  };
  const auto first = std::find_if_not(apexes_.begin(), apexes_.end(), ends_here);
  return std::all_of(first, apexes_.end(), [&](Vertex apex) {
    return ends_here(apex) || sheets.find(place(apex)) == sheets.find(place(*first));
  });
}

// What the faces around the kept vertex need to form no more fans than before. Two apexes: the
// edge must not cut both fans in two, as it does between two points of the border.
bool LinkCondition::keeps_fans(const EdgeEnds& ends, const StarPair& stars) const {
  if (apexes_.empty()) return stars[0].empty() || stars[1].empty();
  if (apexes_.size() == 2) return !is_open(stars[0]) || !is_open(stars[1]);
  return apexes_.size() == 1 || stay_together(ends, stars);
}

Verdict LinkCondition::judge(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                             const StarPair& stars, VertexMarks& marks) {
  mark_neighbours(mesh, ends[1], stars[1], marks);
  if (!gather_apexes(stars[0], ends[1])) return {Reason::Topology, edge};
  fetch_rows(mesh, apexes_);
  if (!keeps_fans(ends, stars)) return {Reason::Topology, edge};
  if (apexes_.size() == 2 && is_plain(stars[0], ends[1], apexes_, marks)) return {};
  std::uint64_t has_further_face = 0;
  for (const StarFace& f : stars[0]) {
    const bool next = marks.has(f.next), previous = marks.has(f.previous);
    if (!(next | previous) || f.uses(ends[1])) continue;
    const std::uint64_t next_bit = next ? apex_bit(f.next) : 0,
                        previous_bit = previous ? apex_bit(f.previous) : 0;
    if (next && !next_bit) return {Reason::Topology, f.next};
    if (previous && !previous_bit) return {Reason::Topology, f.previous};
    has_further_face |= next_bit | previous_bit;
    if (!next || !previous) continue;
    for (const StarFace& g : stars[1])
      if (g.uses(f.next) && g.uses(f.previous)) return {Reason::Topology, g.face};
  }
  for (const Vertex apex : apexes_)
    if (!(has_further_face & apex_bit(apex)) && leaves_bare_edge(ends, stars, apex))
      return {Reason::Topology, apex};
  return {};
}

}  // namespace aomd
