// From what an MSH file lists to a mesh: order, repetitions, higher order, classification.

#include <algorithm>
#include <functional>
#include <map>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/msh_mesh.h"
#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

std::vector<std::size_t> starts_of(const EntityList& list) {
  std::vector<std::size_t> starts;
  starts.reserve(list.size());
  std::size_t start = 0;
  for (const Shape shape : list.shapes) {
    starts.push_back(start);
    start += static_cast<std::size_t>(shape_template(shape).vertex_count);
  }
  return starts;
}

/// Some of a list's entities, or all, in the order given.
EntityList picked(const EntityList& list, const std::vector<std::uint32_t>& order) {
  const std::vector<std::size_t> starts = starts_of(list);
  EntityList result;
  result.vertices.reserve(list.vertices.size());
  result.shapes.reserve(order.size());
  result.classes.reserve(order.size());
  for (const std::uint32_t i : order) {
    const auto from = list.vertices.begin() + static_cast<std::ptrdiff_t>(starts[i]);
    result.vertices.insert(result.vertices.end(), from,
                           from + shape_template(list.shapes[i]).vertex_count);
    result.shapes.push_back(list.shapes[i]);
    result.classes.push_back(list.classes[i]);
  }
  return result;
}

std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

/// Finds entities with the vertices and class of an earlier one, in any order of the vertices.
class Repetitions {
 public:
  explicit Repetitions(const EntityList& list) : list_(list) {
    const bool one_shape = std::adjacent_find(list.shapes.begin(), list.shapes.end(),
                                              std::not_equal_to<>()) == list.shapes.end();
    if (!one_shape) starts_ = starts_of(list);
    std::size_t size = 16;
    while (3 * size < 4 * list.size()) size *= 2;
    slots_.assign(size, no_index);
  }

  /// True where an earlier call had the same entity.
  bool seen(std::uint32_t i) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(i) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == no_index) {
        slots_[slot] = i;
        return false;
      }
      if (same(slots_[slot], i)) return true;
    }
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::uint32_t i) const {
    const auto n = static_cast<std::size_t>(shape_template(list_.shapes[i]).vertex_count);
    return std::span(list_.vertices).subspan(starts_.empty() ? i * n : starts_[i], n);
  }
  [[nodiscard]] std::uint64_t hash(std::uint32_t i) const {
    std::uint64_t sum = list_.classes[i].bits();
    for (const std::uint32_t v : vertices(i)) sum += scrambled(v + 1);
    return scrambled(sum);
  }
  [[nodiscard]] bool same(std::uint32_t a, std::uint32_t b) const {
    const auto x = vertices(a), y = vertices(b);
    return list_.shapes[a] == list_.shapes[b] && list_.classes[a] == list_.classes[b] &&
           std::is_permutation(x.begin(), x.end(), y.begin(), y.end());
  }

  const EntityList& list_;
  std::vector<std::size_t> starts_;  ///< of the vertices; none where all have one shape
  std::vector<std::uint32_t> slots_;
};

}  // namespace

void MshMesh::finish(NodeClasses known, bool make_table) {
  std::size_t repeated = 0;
  for (int dim = 0; dim <= 3; ++dim) {
    sort(elements_[static_cast<std::size_t>(dim)]);
    repeated += drop_repeated(dim);
  }
  std::sort(dropped_.begin(), dropped_.end());
  if (repeated > 0) notes_.push_back(counted(repeated, "repeated element") + " dropped");
  repeats_.note(notes_);
  drop_unused_nodes();
  for (int dim = 1; dim <= 3; ++dim)
    mesh_.list(dim) = std::move(elements_[static_cast<std::size_t>(dim)].list);
  classify_vertices(known);
  if (make_table) make_model();
  drop_empty_classes(mesh_);
  if (make_table) set_boxes(mesh_, mesh_.model.entities);
  for (std::size_t dim = 0; dim < 4; ++dim)
    element_tags_[dim].build(std::move(elements_[dim].tags));
}

void MshMesh::Elements::permute(const std::vector<std::uint32_t>& order) {
  list = picked(list, order);
  MshTagList permuted;
  for (const std::uint32_t i : order) permuted.push_back(tags[i]);
  tags = std::move(permuted);
  if (!physical.empty()) detail::permute(physical, order);
}

void MshMesh::sort(Elements& elements) {
  const std::vector<std::uint32_t> order = elements.tags.ascending_order();
  if (!order.empty()) elements.permute(order);
}

std::size_t MshMesh::drop_repeated(int dim) {
  Elements& elements = elements_[static_cast<std::size_t>(dim)];
  std::vector<std::uint32_t> repeated;
  {
    Repetitions repetitions(elements.list);
    for (std::uint32_t i = 0; i < elements.tags.size(); ++i)
      if (repetitions.seen(i)) repeated.push_back(i);
  }
  if (repeated.empty()) return 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0, next = 0; i < elements.tags.size(); ++i) {
    if (next == repeated.size() || repeated[next] != i) {
      kept.push_back(i);
      continue;
    }
    ++next;
    dropped_.push_back(elements.tags[i]);
    further_groups_.emplace_back(elements.list.classes[i], elements.physical_of(i));
  }
  elements.permute(kept);
  return repeated.size();
}

void MshMesh::drop_unused_nodes() {
  if (higher_order_ == 0) return;
  notes_.push_back(counted(higher_order_, "higher-order element") + " read by their corners");
  new_vertices_.assign(corner_.size(), no_index);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < corner_.size(); ++v) {
    if (inner_[v] && !corner_[v]) continue;
    new_vertices_[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(v);
  }
  permute(mesh_.positions, kept);
  permute(mesh_.vertex_classes, kept);
  for (Elements& elements : elements_)
    for (std::uint32_t& v : elements.list.vertices) v = new_vertices_[v];
}

// A writer without $Entities may put all nodes into one block of the highest dimension.
bool MshMesh::blocks_classify() const {
  int dimensions = 0, highest = 0;
  for (int dim = 0; dim <= 3; ++dim) {
    if (elements_[static_cast<std::size_t>(dim)].tags.empty()) continue;
    ++dimensions;
    highest = dim;
  }
  const std::vector<ModelRef>& classes = mesh_.vertex_classes;
  const bool one =
      std::adjacent_find(classes.begin(), classes.end(), std::not_equal_to<>()) == classes.end();
  return !one || dimensions < 2 || (!classes.empty() && classes.front().dimension() != highest);
}

void MshMesh::classify_vertices(NodeClasses known) {
  std::vector<ModelRef> lowest = lowest_classes(mesh_);
  for_each_entity(elements_[0].list, [&](auto vertices, ModelRef point) {
    if (point < lowest[vertices[0]]) lowest[vertices[0]] = point;
  });
  std::vector<ModelRef>& classes = mesh_.vertex_classes;
  if (known == NodeClasses::None || (known == NodeClasses::Blocks && !blocks_classify())) {
    classes = std::move(lowest);
    return;
  }
  std::size_t lowered = 0;
  for (std::size_t v = 0; v < classes.size(); ++v) {
    if (!lowest[v].valid() || lowest[v].dimension() >= classes[v].dimension()) continue;
    if (!classes[v].valid() && lowest[v].dimension() > 0) continue;
    lowered += classes[v].valid();
    classes[v] = lowest[v];
  }
  if (lowered > 0)
    notes_.push_back(counted(lowered, "vertex") +
                     " moved to the model entity of a lower element that has them");
}

void MshMesh::make_model() {
  std::map<ModelRef, std::vector<std::int32_t>> groups;
  std::size_t others = 0;
  for (int dim = 0; dim <= 3; ++dim) {
    const EntityList& list = dim == 0 ? elements_[0].list : mesh_.list(dim);
    const std::vector<std::int32_t>& physical = elements_[static_cast<std::size_t>(dim)].physical;
    for (std::size_t i = 0; i < physical.size(); ++i) {
      if (physical[i] == 0) continue;
      std::vector<std::int32_t>& of_entity = groups[list.classes[i]];
      if (of_entity.empty()) of_entity.push_back(physical[i]);
      others += of_entity.front() != physical[i];
    }
  }
  if (others > 0)
    notes_.push_back(counted(others, "element") +
                     " in another physical group than the first of their entity");
  std::sort(further_groups_.begin(), further_groups_.end());
  further_groups_.erase(std::unique(further_groups_.begin(), further_groups_.end()),
                        further_groups_.end());
  for (const auto& [ref, group] : further_groups_) {
    const auto at = groups.find(ref);
    if (at != groups.end() && group != 0 && group != at->second.front())
      at->second.push_back(group);
  }
  for (auto& [ref, of_entity] : groups)
    mesh_.model.entities.push_back({ref, std::move(of_entity), {}, {}});
}

}  // namespace aomd::io::detail
