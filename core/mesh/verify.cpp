#include "core/mesh/verify.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/mesh/entity_hash.h"

namespace aomd {
namespace {

std::string label(EntityRef e) {
  return std::string(entity_name(e.dimension)) + " " + std::to_string(e.index);
}

class Verifier {
 public:
  explicit Verifier(const Mesh& mesh) : mesh_(mesh) {}

  std::vector<Finding> run() {
    check_ids();
    check_positions();
    const bool sound = check_vertices();
    if (sound) {  // the rest looks entities up by their vertices
      collect_edges();
      check_faces();
      for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) check_upward(i, j);
      check_classes();
      check_hash();
    }
    check_class_lists();
    return std::move(findings_);
  }

 private:
  void report(const char* name, EntityRef e, std::string text) {
    findings_.push_back({name, e, std::move(text)});
  }

  std::vector<std::uint32_t> vertices(EntityRef e) const {
    std::array<std::uint32_t, max_shape_vertices> buffer;
    const auto v = mesh_.vertices_of(e, buffer);
    return {v.begin(), v.end()};
  }

  template <typename Visit>
  void each(int dim, Visit&& visit) const {
    for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
      if (mesh_.ids(dim).alive(id)) visit(EntityRef(dim, id));
  }

  void check_ids() {
    for (int dim = 0; dim < 4; ++dim) {
      std::vector<std::uint8_t> seen(mesh_.capacity(dim), 0);
      for (const std::uint32_t id : mesh_.ids(dim).free_ids()) {
        const EntityRef e(dim, id);
        if (id >= mesh_.capacity(dim))
          report("id stack", e, label(e) + " is on the stack but was never given out");
        else if (mesh_.alive(e))
          report("id stack", e, label(e) + " is alive and on the stack");
        else if (seen[id]++)
          report("id stack", e, label(e) + " is on the stack twice");
      }
      for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
        if (const EntityRef e(dim, id); !mesh_.alive(e) && !seen[id])
          report("id stack", e, label(e) + " is neither alive nor on the stack");
    }
  }

  void check_positions() {
    for (const Vertex v : mesh_.vertices()) {
      const glm::dvec3& p = mesh_.position(v);
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        report("not finite", v, label(v) + " has a coordinate that is no number");
    }
  }

  bool check_vertices() {
    bool sound = true;
    for (int dim = 1; dim <= 2; ++dim)
      each(dim, [&](EntityRef e) {
        std::vector<std::uint32_t> v = vertices(e);
        for (const std::uint32_t id : v)
          if (id >= mesh_.capacity(0) || !mesh_.alive(Vertex(id))) {
            report("dead reference", e,
                   label(e) + " uses vertex " + std::to_string(id) + ", which does not exist");
            sound = false;
          }
        std::sort(v.begin(), v.end());
        if (std::adjacent_find(v.begin(), v.end()) != v.end())
          report("repeated vertex", e, label(e) + " uses a vertex twice");
      });
    return sound;
  }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  void collect_edges() {
    edge_of_.reserve(mesh_.count(1));
    for (const Edge e : mesh_.edges()) {
      const auto [a, b] = mesh_.edge_vertices(e);
      const auto [it, fresh] = edge_of_.emplace(key(a.index, b.index), e.index);
      if (!fresh)
        report("duplicate edge", e,
               label(e) + " joins the same vertices as edge " + std::to_string(it->second));
    }
  }

  // The sides of a face as edges, from its vertices alone.
  std::vector<std::uint32_t> sides(const std::vector<std::uint32_t>& v) const {
    std::vector<std::uint32_t> result;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const auto it = edge_of_.find(key(v[k], v[(k + 1) % v.size()]));
      result.push_back(it == edge_of_.end() ? no_index : it->second);
    }
    return result;
  }

  void check_faces() {
    if (!mesh_.representation().has_level(1)) return;
    for (const Face f : mesh_.faces()) {
      const auto v = vertices(f);
      const auto expected = sides(v);
      for (std::size_t k = 0; k < expected.size(); ++k) check_side(f, v, k, expected[k]);
    }
  }

  void check_side(Face f, const std::vector<std::uint32_t>& v, std::size_t k, std::uint32_t expected) {
    if (expected == no_index) return report("missing edge", f, label(f) + " has a side without an edge");
    if (!mesh_.stored(2, 1)) return;
    const Edge e = mesh_.row<1>(f)[k];
    if (e.index != expected)
      return report("wrong side", f,
                    label(f) + " names edge " + std::to_string(e.index) +
                        " where its vertices are joined by edge " + std::to_string(expected));
    if (mesh_.use_direction(f, e) != (mesh_.edge_vertices(e)[0].index == v[k]))
      report("wrong use direction", f,
             label(f) + " uses edge " + std::to_string(e.index) + " the other way round");
  }

  void check_upward(int i, int j) {
    if (!mesh_.stored(i, j)) return;
    std::vector<std::vector<std::uint32_t>> expected(mesh_.capacity(i));
    each(j, [&](EntityRef e) {
      std::vector<std::uint32_t> lower = vertices(e);
      if (i == 1) lower = sides(lower);
      for (const std::uint32_t l : lower)
        if (l != no_index) expected[l].push_back(e.index);
    });
    each(i, [&](EntityRef e) {
      const auto row = mesh_.representation().up(i, j).row(e.index);
      if (!std::equal(row.begin(), row.end(), expected[e.index].begin(), expected[e.index].end()))
        report("upward list", e, label(e) + " has a wrong list of " + entity_name(j) + "s");
    });
  }

  void check_classes() {
    for (int dim = 0; dim <= 2; ++dim)
      each(dim, [&](EntityRef e) {
        const ModelRef m = mesh_.classification(e);
        if (!m.may_classify(dim))
          report("classification order", e,
                 label(e) + " is on a model entity of dimension " + std::to_string(m.dimension()));
        if (dim > 0 && m.valid()) check_closure(e, m);
      });
  }

  void check_closure(EntityRef e, ModelRef model) {
    const auto v = vertices(e);
    const auto above = [&](EntityRef lower) {
      const ModelRef m = mesh_.classification(lower);
      if (m.valid() && m.dimension() > model.dimension())
        report("classification closure", lower,
               label(lower) + " bounds " + label(e) + " but is on a higher model entity");
    };
    for (const std::uint32_t id : v) above(Vertex(id));
    if (e.dimension != 2 || !mesh_.representation().has_level(1)) return;
    for (const std::uint32_t id : sides(v))
      if (id != no_index) above(Edge(id));
  }

  void check_hash() {
    if (!mesh_.edge_hash().built()) return;
    std::vector<std::uint8_t> found(mesh_.capacity(1), 0);
    mesh_.edge_hash().for_each([&](std::uint32_t e) {
      if (e >= mesh_.capacity(1) || !mesh_.alive(Edge(e)) || found[e]++)
        report("hash set", EntityRef(1, e),
               "the hash set holds edge " + std::to_string(e) + ", which it should not");
    });
    for (const Edge e : mesh_.edges())
      if (!found[e.index]) report("hash set", e, label(e) + " is missing from the hash set");
  }

  void check_class_lists() {
    if (!mesh_.class_lists()) return;
    for (int dim = 0; dim < 4; ++dim) {
      std::size_t listed = 0;
      for (const ModelRef model : mesh_.class_lists()->models(dim))
        for (const std::uint32_t id : mesh_.class_lists()->entities(dim, model)) {
          const EntityRef e(dim, id);
          ++listed;
          if (!mesh_.alive(e) || mesh_.classification(e) != model)
            report("class list", e, label(e) + " is in the list of a model entity that it is not on");
        }
      if (listed != mesh_.count(dim))
        report("class list", EntityRef(dim, no_index),
               std::string("the lists miss some ") + entity_name(dim) + "s");
    }
  }

  const Mesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> edge_of_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> verify(const Mesh& mesh) { return Verifier(mesh).run(); }

}  // namespace aomd
