#include "core/io/msh_mesh.h"

#include <algorithm>
#include <numeric>

#include "core/io/entities.h"

namespace aomd::io::detail {

std::vector<std::uint32_t> ascending_order(const std::vector<std::uint64_t>& tags) {
  std::vector<std::uint32_t> order;
  if (std::is_sorted(tags.begin(), tags.end())) return order;
  order.resize(tags.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return tags[a] < tags[b]; });
  return order;
}

void MshTagList::push_back(std::uint64_t tag) {
  if (size_ == 0) first_ = tag;
  if (is_run_ && tag != first_ + size_) {
    tags_ = take();
    size_ = tags_.size();
    is_run_ = false;
  }
  if (!is_run_) tags_.push_back(tag);
  ++size_;
}

void MshTagList::pop_back() {
  if (!is_run_) tags_.pop_back();
  --size_;
}

std::vector<std::uint64_t> MshTagList::take() {
  std::vector<std::uint64_t> all = std::move(tags_);
  if (is_run_) {
    all.resize(size_);
    std::iota(all.begin(), all.end(), first_);
  }
  *this = MshTagList();
  return all;
}

std::vector<std::uint32_t> MshTagList::ascending_order() const {
  return is_run_ ? std::vector<std::uint32_t>() : detail::ascending_order(tags_);
}

void MshTags::build(MshTagList&& ascending) {
  if (!ascending.is_run()) return build(ascending.take());
  *this = MshTags();
  first_ = ascending.empty() ? 0 : ascending[0];
  count_ = ascending.size();
}

void MshTags::build(std::vector<std::uint64_t> ascending) {
  tags_ = std::move(ascending);
  table_.clear();
  first_ = tags_.empty() ? 0 : tags_.front();
  const std::uint64_t range = tags_.empty() ? 0 : tags_.back() - first_ + 1;
  contiguous_ =
      range == tags_.size() && std::adjacent_find(tags_.begin(), tags_.end()) == tags_.end();
  count_ = tags_.size();
  if (contiguous_) tags_ = std::vector<std::uint64_t>();
  if (contiguous_ || range > 8 * tags_.size() + 1024) return;
  table_.assign(static_cast<std::size_t>(range), no_index);
  for (std::size_t i = tags_.size(); i-- > 0;)
    table_[static_cast<std::size_t>(tags_[i] - first_)] = static_cast<std::uint32_t>(i);
}

std::uint32_t MshTags::search(std::uint64_t tag) const {
  const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
  return at == tags_.end() || *at != tag ? no_index
                                         : static_cast<std::uint32_t>(at - tags_.begin());
}

void MshMesh::reserve_nodes(std::size_t n) {
  mesh_.positions.reserve(n);
  mesh_.vertex_classes.reserve(n);
  node_tags_.reserve(n);
}

void MshMesh::add_node_tag(std::uint64_t tag, ModelRef model) {
  node_tags_.push_back(tag);
  mesh_.vertex_classes.push_back(model);
}

std::string MshMesh::finish_nodes() {
  const std::vector<std::uint32_t> order = ascending_order(node_tags_);
  if (!order.empty()) {
    permute(node_tags_, order);
    permute(mesh_.positions, order);
    permute(mesh_.vertex_classes, order);
  }
  const auto twin = std::adjacent_find(node_tags_.begin(), node_tags_.end());
  if (twin != node_tags_.end()) return "node " + std::to_string(*twin) + " is there twice";
  corner_.assign(node_tags_.size(), false);
  inner_.assign(node_tags_.size(), false);
  nodes_.build(std::move(node_tags_));
  return {};
}

// Twice as much, as vectors do, but no more than what is promised can fill.
template <class Value>
void MshMesh::make_room(std::vector<Value>& values, std::size_t each) const {
  const std::size_t needed = values.size() + each;
  if (needed <= values.capacity()) return;
  const std::size_t to_come = promised_ > added_ ? promised_ - added_ : 1;
  values.reserve(std::max(needed, std::min(2 * needed, values.size() + each * to_come)));
}

namespace {

/// The first node that is there twice; there is one.
std::uint64_t repeated_node(std::span<const std::uint64_t> nodes) {
  std::size_t i = 1;
  while (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(i), nodes[i]) ==
         nodes.begin() + static_cast<std::ptrdiff_t>(i))
    ++i;
  return nodes[i];
}

}  // namespace

std::string MshMesh::add(std::uint64_t tag, MshType type, std::span<const std::uint64_t> nodes,
                         ModelRef model, std::int32_t physical) {
  const auto corners = static_cast<std::size_t>(shape_template(type.shape).vertex_count);
  Elements& elements = elements_[static_cast<std::size_t>(shape_template(type.shape).dimension)];
  std::vector<std::uint32_t>& vertices = elements.list.vertices;
  const std::size_t start = vertices.size();
  bool repeats = false;
  make_room(vertices, corners);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t v = nodes_.find(nodes[i]);
    if (v == no_index)
      return "element " + std::to_string(tag) + " refers to node " +
             std::to_string(static_cast<std::int64_t>(nodes[i])) + ", which is not there";
    (i < corners ? corner_ : inner_)[v] = true;
    if (i >= corners) continue;
    const auto first = vertices.begin() + static_cast<std::ptrdiff_t>(start);
    repeats = repeats || std::find(first, vertices.end(), v) != vertices.end();
    vertices.push_back(v);
  }
  make_room(elements.list.shapes, 1);
  make_room(elements.list.classes, 1);
  elements.list.shapes.push_back(type.shape);
  elements.list.classes.push_back(model);
  if (physical != 0) elements.physical.resize(elements.tags.size());
  if (physical != 0 || !elements.physical.empty()) elements.physical.push_back(physical);
  elements.tags.push_back(tag);
  ++added_;
  higher_order_ += nodes.size() > corners;
  return repeats ? mend_last(elements, nodes.first(corners)) : std::string();
}

/// Cuts the repeated corners out of the element added last, or takes it away.
std::string MshMesh::mend_last(Elements& elements, std::span<const std::uint64_t> nodes) {
  EntityList& list = elements.list;
  const std::size_t start = list.vertices.size() - nodes.size();
  const std::vector<std::int64_t> vertices(
      list.vertices.begin() + static_cast<std::ptrdiff_t>(start), list.vertices.end());
  const auto left = without_repeats(list.shapes.back(), vertices, corner_.size(), repeats_);
  if (!left) {
    return "element " + std::to_string(elements.tags.back()) + " repeats node " +
           std::to_string(static_cast<std::int64_t>(repeated_node(nodes))) +
           ": a region that collapses must be listed as what it becomes";
  }
  list.vertices.resize(start);
  list.shapes.pop_back();
  if (!left->empty()) {
    append(list, Shape::Triangle, *left);
    return {};
  }
  dropped_.push_back(elements.tags.back());
  list.classes.pop_back();
  elements.tags.pop_back();
  if (!elements.physical.empty()) elements.physical.pop_back();
  return {};
}

std::uint32_t MshMesh::vertex(std::uint64_t tag, bool& known) const {
  const std::uint32_t v = nodes_.find(tag);
  known = v != no_index;
  return known && !new_vertices_.empty() ? new_vertices_[v] : v;
}

MshMesh::Place MshMesh::element(std::uint64_t tag, bool& known) const {
  known = true;
  for (int dim = 1; dim <= 3; ++dim) {
    const std::uint32_t i = element_tags_[static_cast<std::size_t>(dim)].find(tag);
    if (i != no_index) return {dim, i};
  }
  known = element_tags_[0].find(tag) != no_index ||
          std::binary_search(dropped_.begin(), dropped_.end(), tag);
  return {};
}

}  // namespace aomd::io::detail
