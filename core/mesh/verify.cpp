#include "core/mesh/verify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/base/buckets.h"
#include "core/mesh/bulk.h"
#include "core/mesh/names.h"
#include "core/mesh/side_index.h"

namespace aomd {
namespace {

using Ids = std::vector<std::uint32_t>;

Finding not_closed(EntityRef lower, EntityRef e) {
  return {"classification closure", lower,
          name_of(lower) + " bounds " + name_of(e) + " but is on a higher model entity"};
}

bool above(ModelRef a, ModelRef b) { return a.valid() && a.dimension() > b.dimension(); }

class Verifier {
 public:
  Verifier(const Mesh& mesh, const VerifyOptions& options) : mesh_(mesh), options_(options) {}

  std::vector<Finding> run() {
    for (int dim = 0; dim < 4; ++dim) check_ids(dim);
    check_positions();
    if (check_vertices()) {  // the rest looks entities up by their vertices
      for (int dim = 1; dim < 4; ++dim) collect(dim);
      for (int dim = 2; dim < 4; ++dim)
        for (int k = 1; k < dim; ++k) check_downward(dim, k);
      for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j) check_upward(i, j);
      for (int dim = 0; options_.unused && dim < mesh_.dimension(); ++dim) check_used(dim);
      check_classes();
      for (int dim = 1; dim < 4; ++dim) check_hash(dim);
    }
    check_class_lists();
    return std::move(findings_);
  }

 private:
  void report(const char* name, EntityRef e, std::string text) {
    findings_.push_back({name, e, std::move(text)});
  }

  template <typename Visit>
  void each(int dim, Visit&& visit) const {
    for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
      if (mesh_.ids(dim).alive(id)) visit(EntityRef(dim, id));
  }

  void check_ids(int dim) {
    std::vector<std::uint8_t> seen(mesh_.capacity(dim), 0);
    for (const std::uint32_t id : mesh_.ids(dim).free_ids()) {
      const EntityRef e(dim, id);
      if (id >= mesh_.capacity(dim))
        report("id stack", e, name_of(e) + " is on the stack but was never given out");
      else if (mesh_.alive(e))
        report("id stack", e, name_of(e) + " is alive and on the stack");
      else if (seen[id]++)
        report("id stack", e, name_of(e) + " is on the stack twice");
    }
    for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
      if (const EntityRef e(dim, id); !mesh_.alive(e) && !seen[id])
        report("id stack", e, name_of(e) + " is neither alive nor on the stack: its id is lost");
  }

  void check_positions() {
    for (const Vertex v : mesh_.vertices()) {
      const glm::dvec3& p = mesh_.position(v);
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        report("not finite", v, name_of(v) + " has a coordinate that is no number");
    }
  }

  // Rows first: what they name must exist before vertices can be read through them.
  bool check_vertices() {
    bool sound = true;
    for (int dim = 1; dim <= 3; ++dim)
      for (int k = 0; k < dim; ++k)
        if (mesh_.stored(dim, k)) each(dim, [&](EntityRef e) { sound &= check_row(e, k); });
    if (!sound) return false;
    for (int dim = 1; dim <= 3; ++dim) {
      if (mesh_.count(dim) > 0 && !mesh_.representation().has_level(dim)) return false;
      each(dim, [&](EntityRef e) {
        VertexBuffer buffer;
        const auto row = mesh_.vertices_of(e, buffer);
        Ids v(row.begin(), row.end());
        std::sort(v.begin(), v.end());
        if (std::adjacent_find(v.begin(), v.end()) == v.end()) return;
        report("repeated vertex", e, name_of(e) + " uses a vertex twice");
        sound = false;
      });
    }
    return sound;
  }

  bool check_row(EntityRef e, int k) {
    bool sound = true;
    const std::uint32_t* row = mesh_.representation().down(e.dimension, k).row(e.index);
    for (int i = 0; i < shape_template(mesh_.shape(e)).count(k); ++i) {
      if (row[i] < mesh_.capacity(k) && mesh_.alive(EntityRef(k, row[i]))) continue;
      report("dead reference", e,
             name_of(e) + " uses " + name_of(EntityRef(k, row[i])) + ", which does not exist");
      sound = false;
    }
    return sound;
  }

  static Ids sorted(std::span<const std::uint32_t> v) {
    Ids key(v.begin(), v.end());
    std::sort(key.begin(), key.end());
    return key;
  }

  struct Hasher {
    std::size_t operator()(const Ids& key) const {
      return static_cast<std::size_t>(EntityHash::key(key));
    }
  };

  void collect(int dim) {
    auto& known = known_[static_cast<std::size_t>(dim)];
    known.reserve(mesh_.count(dim));
    each(dim, [&](EntityRef e) {
      VertexBuffer buffer;
      const auto [it, fresh] = known.emplace(sorted(mesh_.vertices_of(e, buffer)), e.index);
      if (fresh) return;
      if (dim == 2) return void(repeated_.emplace(it->second, e.index));
      report(dim == 1 ? "duplicate edge" : "duplicate region", e,
             name_of(e) + " has the same vertices as " + name_of(EntityRef(dim, it->second)));
    });
  }

  // The lower entities of an entity, from its vertices alone.
  Ids sides(EntityRef e, int k) const {
    VertexBuffer buffer;
    const auto v = mesh_.vertices_of(e, buffer);
    if (k == 0) return {v.begin(), v.end()};
    const ShapeTemplate& shape = shape_template(mesh_.shape(e));
    Ids result;
    for (int i = 0; i < shape.count(k); ++i) {
      const auto& known = known_[static_cast<std::size_t>(k)];
      const auto it = known.find(sorted(SideVertices(shape.sub(k, i), v.data()).span()));
      result.push_back(it == known.end() ? no_index : it->second);
    }
    return result;
  }

  void check_downward(int dim, int k) {
    if (!mesh_.complete(k)) return;
    each(dim, [&](EntityRef e) {
      const Ids expected = sides(e, k);
      for (std::size_t i = 0; i < expected.size(); ++i) check_side(e, k, i, expected[i]);
    });
  }

  void check_side(EntityRef e, int k, std::size_t i, std::uint32_t expected) {
    if (expected == no_index)
      return report(k == 1 ? "missing edge" : "missing face", e,
                    name_of(e) + " has a side without " + (k == 1 ? "an edge" : "a face"));
    if (k == 2)
      if (const auto it = repeated_.find(expected); it != repeated_.end())
        report("duplicate face", Face(it->second),
               name_of(Face(it->second)) + " has the same vertices as " + name_of(Face(expected)) +
                   ", which " + name_of(e) + " uses");
    if (!mesh_.stored(e.dimension, k)) return;
    const std::uint32_t side = mesh_.representation().down(e.dimension, k).row(e.index)[i];
    if (side != expected)
      return report("wrong side", e,
                    name_of(e) + " names " + name_of(EntityRef(k, side)) +
                        " where its vertices say " + name_of(EntityRef(k, expected)));
    if (k + 1 == e.dimension) check_direction(e, k, i, side);
  }

  void check_direction(EntityRef e, int k, std::size_t i, std::uint32_t side) {
    VertexBuffer buffer, own_buffer;
    const auto v = mesh_.vertices_of(e, buffer);
    const SideVertices expected(shape_template(mesh_.shape(e)).sub(k, static_cast<int>(i)),
                                v.data());
    const auto own = mesh_.vertices_of(EntityRef(k, side), own_buffer);
    Ids turned(expected.span().begin(), expected.span().end());
    std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), own[0]), turned.end());
    const bool along =
        k == 1 ? expected.ids[0] == own[0] : std::equal(own.begin(), own.end(), turned.begin());
    const bool stored =
        (mesh_.representation().down(e.dimension, k).directions(e.index) >> i & 1u) != 0;
    if (stored != along)
      report("wrong use direction", e,
             name_of(e) + " uses " + name_of(EntityRef(k, side)) + " the other way round");
  }

  void check_upward(int i, int j) {
    if (!mesh_.stored(i, j)) return;
    std::vector<Ids> expected(mesh_.capacity(i));
    each(j, [&](EntityRef e) {
      for (const std::uint32_t l : sides(e, i))
        if (l != no_index) expected[l].push_back(e.index);
    });
    each(i, [&](EntityRef e) {
      const auto row = mesh_.representation().up(i, j).row(e.index);
      if (!std::equal(row.begin(), row.end(), expected[e.index].begin(), expected[e.index].end()))
        report("upward list", e, name_of(e) + " has a wrong list of " + entity_plural(j));
    });
  }

  void check_used(int dim) {
    constexpr const char* names[] = {"isolated vertex", "dangling edge", "dangling face"};
    std::vector<std::uint8_t> used(mesh_.capacity(dim), 0);
    for (int j = dim + 1; j < 4; ++j)
      each(j, [&](EntityRef e) {
        for (const std::uint32_t l : sides(e, dim))
          if (l != no_index) used[l] = 1;
      });
    each(dim, [&](EntityRef e) {
      if (!used[e.index]) report(names[dim], e, name_of(e) + " is a side of nothing");
    });
  }

  void check_classes() {
    for (int dim = 0; dim <= 3; ++dim)
      each(dim, [&](EntityRef e) {
        const ModelRef m = mesh_.classification(e);
        if (!m.may_classify(dim))
          report(
              "classification order", e,
              name_of(e) + " is on a model entity of dimension " + std::to_string(m.dimension()));
        for (int k = 0; m.valid() && k < dim; ++k) check_closure(e, k, m);
      });
  }

  void check_closure(EntityRef e, int k, ModelRef model) {
    if (k > 0 && !mesh_.complete(k)) return;
    for (const std::uint32_t id : sides(e, k)) {
      if (id == no_index) continue;
      const EntityRef lower(k, id);
      if (above(mesh_.classification(lower), model)) findings_.push_back(not_closed(lower, e));
    }
  }

  void check_hash(int dim) {
    if (!mesh_.hash(dim).built()) return;
    std::vector<std::uint8_t> found(mesh_.capacity(dim), 0);
    mesh_.hash(dim).for_each([&](std::uint32_t id) {
      const EntityRef e(dim, id);
      VertexBuffer buffer;
      if (id >= mesh_.capacity(dim) || !mesh_.alive(e) || found[id]++)
        report("hash set", e, "the hash set holds " + name_of(e) + ", which it should not");
      else if (mesh_.hash(dim).key_of(id) != EntityHash::key(mesh_.vertices_of(e, buffer)))
        report("hash set", e,
               "the hash set holds " + name_of(e) + " under the key of other vertices");
    });
    each(dim, [&](EntityRef e) {
      if (!found[e.index]) report("hash set", e, name_of(e) + " is missing from the hash set");
    });
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
            report("class list", e,
                   name_of(e) + " is in the list of a model entity that it is not on");
        }
      if (listed != mesh_.count(dim))
        report("class list", EntityRef(dim, no_index),
               std::string("the lists miss some ") + entity_plural(dim));
    }
  }

  const Mesh& mesh_;
  VerifyOptions options_;
  std::array<std::unordered_map<Ids, std::uint32_t, Hasher>, 4>
      known_;                                        ///< by sorted vertices; smallest id
  std::map<std::uint32_t, std::uint32_t> repeated_;  ///< faces: the first one, another
  std::vector<Finding> findings_;
};

// The first entity of a level that a vertex of higher class bounds.
std::optional<Finding> first_misclassified_of(const Mesh& mesh, int dim) {
  std::optional<Finding> first;
  const VertexRows rows(mesh, dim);
  rows.each([&](std::uint32_t id, const std::uint32_t* v) {
    const EntityRef e(dim, id);
    const ModelRef model = mesh.classification(e);
    if (first || !model.valid()) return;
    for (int k = 0; k < rows.shape(id).vertex_count && !first; ++k)
      if (above(mesh.classification(Vertex(v[k])), model)) first = not_closed(Vertex(v[k]), e);
  });
  return first;
}

}  // namespace

std::vector<Finding> verify(const Mesh& mesh, const VerifyOptions& options) {
  return Verifier(mesh, options).run();
}

std::optional<Finding> first_misclassified(const Mesh& mesh) {
  for (int dim = 1; dim <= 3; ++dim)
    if (auto finding = first_misclassified_of(mesh, dim)) return finding;
  return {};
}

std::optional<Finding> first_repeated_region(const Mesh& mesh) {
  const VertexRows rows(mesh, 3);
  const Buckets<std::uint32_t> by_lowest(mesh.capacity(0), [&](auto&& file) {
    for (const Region r : mesh.regions()) file(std::ranges::min(rows.vertices(r.index)), r.index);
  });
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    const auto u = rows.vertices(a), v = rows.vertices(b);
    return u.size() == v.size() && std::is_permutation(u.begin(), u.end(), v.begin());
  };
  for (std::size_t v = 0; v < by_lowest.count(); ++v) {
    const auto regions = by_lowest[v];
    for (std::size_t i = 0; i < regions.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (same(regions[i], regions[k]))
          return Finding{"duplicate region", Region(regions[i]),
                         name_of(Region(regions[i])) + " has the same vertices as " +
                             name_of(Region(regions[k]))};
  }
  return {};
}

}  // namespace aomd
