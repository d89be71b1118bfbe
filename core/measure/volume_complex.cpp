#include "core/measure/volume_complex.h"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "core/base/buckets.h"
#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/bulk.h"
#include "core/mesh/column.h"

namespace aomd::measure {
namespace {

// Items filed under their smallest vertex and sorted there, so that equal ones lie together.
template <typename Item>
class Filed {
 public:
  template <typename Each>
  Filed(std::uint32_t vertices, int threads, Each&& each) : items_(vertices, each) {
    parallel_for(vertices, threads, 1024, [this](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) sort(items_[v]);
    });
  }

  /// Calls visit(items) for every run of items at one vertex that same(a, b) finds equal.
  template <typename Same, typename Visit>
  void each_run(Same&& same, Visit&& visit) const {
    for (std::size_t v = 0; v < items_.count(); ++v) {
      const std::span<const Item> items = items_[v];
      for (std::size_t i = 0, first = 0; i < items.size(); first = i) {
        while (i < items.size() && same(items[first], items[i])) ++i;
        visit(items.subspan(first, i - first));
      }
    }
  }

 private:
  static void sort(std::span<Item> items) { std::sort(items.begin(), items.end()); }

  Buckets<Item> items_;
};

// A side of a region, or a listed face.
struct Use {
  std::uint64_t tag = 0;
  std::uint32_t id = 0;
  std::uint8_t side = 0;
  bool listed = false, forward = false;

  friend bool operator<(const Use& a, const Use& b) {
    return std::tie(a.tag, a.listed, a.id) < std::tie(b.tag, b.listed, b.id);
  }
};

// An edge of a region of one model region.
struct EdgeUse {
  std::uint32_t high = 0, model = 0;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

class Assembler {
 public:
  Assembler(const Mesh& mesh, int threads)
      : mesh_(mesh), threads_(threads), rows_(mesh, 3), faces_(mesh, 2), parts_(mesh.capacity(3)) {}

  VolumeComplex run() {
    number_models();
    count_sides();
    count_edges();
    count_vertices();
    for (const Region r : mesh_.regions()) count_region(r);
    std::sort(result_.repeated.begin(), result_.repeated.end());
    result_.repeated.erase(std::unique(result_.repeated.begin(), result_.repeated.end()),
                           result_.repeated.end());
    return std::move(result_);
  }

 private:
  void number_models() {
    std::map<ModelRef, std::uint32_t> models;
    for (const Region r : mesh_.regions()) models[mesh_.classification(r)] = 0;
    for (auto& [model, number] : models) {
      number = static_cast<std::uint32_t>(result_.regions.size());
      result_.regions.push_back({model});
    }
    model_of_.resize(mesh_.capacity(3));
    for (const Region r : mesh_.regions()) model_of_[r] = models[mesh_.classification(r)];
  }

  void count_sides() {
    const Filed<Use> sides(mesh_.capacity(0), threads_, [this](auto&& file) {
      rows_.each([&](std::uint32_t id, const std::uint32_t* v) {
        const ShapeTemplate& shape = rows_.shape(id);
        for (int k = 0; k < shape.face_count; ++k)
          file_side(SideVertices(shape.sub(2, k), v).span(), id, k, false, file);
      });
      faces_.each([&](std::uint32_t id, const std::uint32_t*) {
        file_side(faces_.vertices(id), id, 0, true, file);
      });
    });
    sides.each_run([](const Use& a, const Use& b) { return a.tag == b.tag; },
                   [this](std::span<const Use> uses) { take_side(uses); });
  }

  // Triangles and other polygons have tags of their own.
  template <typename File>
  static void file_side(std::span<const std::uint32_t> v, std::uint32_t id, int side, bool listed,
                        File&& file) {
    const FaceKey key(v);
    file(key.low, Use{v.size() == 3 ? key.tag : ~key.tag, id, static_cast<std::uint8_t>(side),
                      listed, key.forward});
  }

  // All that has the same vertices; listed faces come last.
  void take_side(std::span<const Use> uses) {
    const auto end = std::find_if(uses.begin(), uses.end(), [](const Use& u) { return u.listed; });
    const auto regions = uses.first(static_cast<std::size_t>(end - uses.begin()));
    const auto faces = uses.subspan(regions.size());
    if (regions.empty()) {
      result_.dangling_faces += faces.size();
      return;
    }
    connect(regions);
    find_repeated(regions);
    if (regions.size() > 2) result_.crowded.emplace_back(regions[0].id);
    if (regions.size() == 2 && regions[0].forward == regions[1].forward)
      result_.folded.push_back({Region(regions[0].id), Region(regions[1].id)});
    take_skin(regions, model_face(faces));
  }

  // A side counts once for each model region that has it.
  void connect(std::span<const Use> regions) {
    order_.clear();
    for (const Use& use : regions) order_.push_back({model_of_[Region(use.id)], use.id});
    std::sort(order_.begin(), order_.end());
    for (std::size_t i = 0; i < order_.size(); ++i)
      if (i > 0 && order_[i].model == order_[i - 1].model)
        parts_.unite(order_[i].id, order_[i - 1].id);
      else
        ++result_.regions[order_[i].model].euler;
  }

  void find_repeated(std::span<const Use> regions) {
    if (regions.size() == 1 || (regions.size() == 2 && !same_set(rows_.vertices(regions[0].id),
                                                                 rows_.vertices(regions[1].id))))
      return;
    std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> sets;
    for (const Use& use : regions) {
      const auto v = rows_.vertices(use.id);
      sets.push_back({{v.begin(), v.end()}, use.id});
      std::sort(sets.back().first.begin(), sets.back().first.end());
    }
    std::sort(sets.begin(), sets.end());
    for (std::size_t i = 1; i < sets.size(); ++i)
      if (sets[i].first == sets[i - 1].first) result_.repeated.emplace_back(sets[i].second);
  }

  [[nodiscard]] ModelRef model_face(std::span<const Use> faces) const {
    for (const Use& use : faces)
      if (const ModelRef model = mesh_.classification(Face(use.id)); model.dimension() == 2)
        return model;
    return {};
  }

  void take_skin(std::span<const Use> regions, ModelRef face) {
    const bool boundary = regions.size() == 1;
    const Use *low = regions.data(), *high = &regions[boundary ? 0 : 1];
    if (model_of_[Region(high->id)] < model_of_[Region(low->id)]) std::swap(low, high);
    const ModelRef first = mesh_.classification(Region(low->id)),
                   second = mesh_.classification(Region(high->id));
    if (!boundary && first == second && !face.valid()) return;
    const SubEntity& sub = rows_.shape(low->id).sub(2, low->side);
    result_.skin.push_back(
        {SideVertices(sub, rows_.row(low->id)), {boundary, first, second, face}});
  }

  void count_edges() {
    const Filed<EdgeUse> edges(mesh_.capacity(0), threads_, [this](auto&& file) {
      rows_.each([&](std::uint32_t id, const std::uint32_t* v) {
        const ShapeTemplate& shape = rows_.shape(id);
        for (int k = 0; k < shape.edge_count; ++k) {
          const EdgeKey key(v[shape.sub(1, k).vertices[0]], v[shape.sub(1, k).vertices[1]]);
          file(key.low, EdgeUse{key.tag, model_of_[Region(id)]});
        }
      });
    });
    edges.each_run(
        [](const EdgeUse& a, const EdgeUse& b) { return a == b; },
        [this](std::span<const EdgeUse> uses) { --result_.regions[uses[0].model].euler; });
  }

  // By model region, so that one mark a vertex is enough.
  void count_vertices() {
    std::vector<std::vector<std::uint32_t>> regions(result_.regions.size());
    for (const Region r : mesh_.regions()) regions[model_of_[r]].push_back(r.index);
    std::vector<std::uint32_t> seen(mesh_.capacity(0), no_index);
    for (std::uint32_t model = 0; model < regions.size(); ++model)
      for (const std::uint32_t id : regions[model])
        for (const std::uint32_t v : rows_.vertices(id))
          if (std::exchange(seen[v], model) != model) ++result_.regions[model].euler;
  }

  void count_region(Region r) {
    RegionFacts& facts = result_.regions[model_of_[r]];
    ++facts.regions;
    --facts.euler;
    facts.volume += signed_volume(mesh_, r);
    facts.parts += parts_.find(r.index) == r.index;
  }

  const Mesh& mesh_;
  int threads_;
  VertexRows rows_, faces_;
  DisjointSets parts_;
  Column<Region, std::uint32_t> model_of_;  ///< as positions in result_.regions
  struct Part {
    std::uint32_t model, id;
    friend auto operator<=>(const Part&, const Part&) = default;
  };
  std::vector<Part> order_;  ///< what shares one side
  VolumeComplex result_;
};

}  // namespace

bool operator<(const Interface& a, const Interface& b) {
  if (a.boundary != b.boundary) return a.boundary;
  return std::tie(a.first, a.second, a.face) < std::tie(b.first, b.second, b.face);
}

std::vector<bool> used_by_regions(const Mesh& mesh) {
  std::vector<bool> used(mesh.capacity(0));
  const VertexRows rows(mesh, 3);
  rows.each([&](std::uint32_t id, const std::uint32_t*) {
    for (const std::uint32_t v : rows.vertices(id)) used[v] = true;
  });
  return used;
}

VolumeComplex analyse_volume(const Mesh& mesh, int threads) {
  return Assembler(mesh, threads).run();
}

}  // namespace aomd::measure
