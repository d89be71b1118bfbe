#include "core/model/triangle_tree.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"

namespace aomd {

namespace {

void append(Triangles& all, Face face, std::span<const std::uint32_t> vertices,
            const auto& position) {
  for (std::size_t k = 2; k < vertices.size(); ++k) {
    all.corners.push_back(
        {position(vertices[0]), position(vertices[k - 1]), position(vertices[k])});
    all.faces.push_back(face);
  }
}

double half_surface(const Box& box) {
  const glm::dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace

Triangles triangles_of(const Mesh& mesh) {
  Triangles all;
  all.corners.reserve(mesh.count(2));
  all.faces.reserve(mesh.count(2));
  std::array<std::uint32_t, max_shape_vertices> buffer;
  const auto position = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
  for (const Face f : mesh.faces()) append(all, f, mesh.vertices_of(f, buffer), position);
  return all;
}

Triangles triangles_of(const MeshData& data) {
  Triangles all;
  all.corners.reserve(data.faces.size());
  all.faces.reserve(data.faces.size());
  std::size_t begin = 0;
  const auto position = [&](std::uint32_t v) { return data.positions[v]; };
  for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
    const auto n = static_cast<std::size_t>(shape_template(data.faces.shapes[f]).vertex_count);
    append(all, Face(f), std::span(data.faces.vertices).subspan(begin, n), position);
    begin += n;
  }
  return all;
}

/// A triangle while the tree is built: what sorting needs lies together.
struct TriangleTree::Item {
  glm::dvec3 centre;
  std::uint32_t source;
};

TriangleTree::TriangleTree(std::span<const Triangle> triangles, int threads) {
  constexpr std::size_t grain = 4096;
  const auto n = static_cast<std::uint32_t>(triangles.size());
  if (n == 0) return;
  std::vector<Item> items(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Triangle& t = triangles[i];
    items[i] = {t[0] + t[1] + t[2], i};
  }
  nodes_.reserve(n);
  build(items, 0, threads, nodes_);
  triangles_.resize(n);
  boxes_.resize(n);
  source_.resize(n);
  parallel_for(n, threads, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      source_[i] = items[i].source;
      triangles_[i] = triangles[source_[i]];
      for (const glm::dvec3& p : triangles_[i]) boxes_[i].add(p);
    }
  });
  add_boxes();
  if (boxes_overlap()) add_tilted_boxes();
}

void TriangleTree::add_boxes() {
  for (std::size_t id = nodes_.size(); id-- > 0;) {  // children stand after their parents
    Node& node = nodes_[id];
    if (node.leaf()) {
      for (std::uint32_t k = node.begin; k < node.end; ++k) node.box.add(boxes_[k]);
    } else {
      node.box = nodes_[id + 1].box;
      node.box.add(nodes_[node.right].box);
    }
  }
}

// A line through the box of all meets as many leaves as their surfaces are larger than its own: a
// few of a surface, thousands of a fan of thin triangles.
bool TriangleTree::boxes_overlap() const {
  constexpr double most_met = 64;
  const double whole = half_surface(nodes_[0].box);
  double leaves = 0;
  for (const Node& node : nodes_) leaves += node.leaf() ? half_surface(node.box) : 0;
  return leaves > most_met * whole;
}

// Along the sides of the triangle in the middle: where those of a node lie side by side, it lies as
// all of them do.
void TriangleTree::add_tilted_boxes() {
  tilted_.resize(nodes_.size());
  const Box all = box();
  for (std::size_t id = nodes_.size(); id-- > 0;) {
    const Node& node = nodes_[id];
    TiltedBox& tilted = tilted_[id];
    tilted = TiltedBox(triangles_[(node.begin + node.end) / 2], all);
    if (!node.leaf()) {
      tilted.add(tilted_[id + 1]);
      tilted.add(tilted_[node.right]);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      for (const glm::dvec3& p : triangles_[k]) tilted.add(p);
  }
}

double TriangleTree::diagonal2() const {
  if (nodes_.empty()) return 0;
  const glm::dvec3 size = nodes_[0].box.high - nodes_[0].box.low;
  return glm::dot(size, size);
}

// Sorts the items into two halves and returns the size of the first.
std::size_t TriangleTree::split(std::span<Item> items) {
  Box centres;
  for (const Item& item : items) centres.add(item.centre);
  const glm::dvec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double middle = 0.5 * (centres.low[axis] + centres.high[axis]);
  const auto second = std::partition(items.begin(), items.end(), [axis, middle](const Item& item) {
    return item.centre[axis] < middle;
  });
  auto half = static_cast<std::size_t>(second - items.begin());
  if (std::min(half, items.size() - half) * lopsided < items.size()) {
    half = items.size() / 2;
    std::nth_element(
        items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
        [axis](const Item& a, const Item& b) { return a.centre[axis] < b.centre[axis]; });
  }
  return half;
}

// Where threads share the halves, the right one gets nodes of its own, to be put behind those of
// the left.
void TriangleTree::build(std::span<Item> items, std::uint32_t begin, int threads,
                         std::vector<Node>& nodes) {
  constexpr std::size_t worth_a_thread = 4096;
  const std::size_t id = nodes.size();
  nodes.push_back({{}, begin, begin + static_cast<std::uint32_t>(items.size()), 0});
  if (items.size() <= leaf_size) return;
  const std::size_t half = split(items);
  const std::uint32_t middle = begin + static_cast<std::uint32_t>(half);
  if (threads <= 1 || items.size() < worth_a_thread) {
    build(items.first(half), begin, 1, nodes);
    nodes[id].right = static_cast<std::uint32_t>(nodes.size());
    return build(items.subspan(half), middle, 1, nodes);
  }
  std::vector<Node> rest;
  parallel_for(2, 2, 1, [&](std::size_t first, std::size_t) {
    if (first == 0) build(items.first(half), begin, threads - threads / 2, nodes);
    if (first == 1) build(items.subspan(half), middle, threads / 2, rest);
  });
  const auto right = static_cast<std::uint32_t>(nodes.size());
  nodes[id].right = right;
  for (Node& node : rest) node.right += node.leaf() ? 0 : right;
  nodes.insert(nodes.end(), rest.begin(), rest.end());
}

TriangleTree::Nearest TriangleTree::nearest(const glm::dvec3& p, std::uint32_t hint) const {
  Nearest best;
  if (nodes_.empty()) return best;
  const auto consider = [&](std::uint32_t n) {
    const glm::dvec3 q = nearest_point(triangles_[n], p), d = q - p;
    if (const double d2 = glm::dot(d, d); d2 < best.distance2) best = {n, q, d2};
  };
  if (hint != no_index) consider(hint);
  struct Waiting {
    std::uint32_t node;
    double distance2;
  } stack[stack_size];
  std::size_t top = 0;
  stack[top++] = {0, bound2(0, p)};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (!(next.distance2 < best.distance2)) continue;
    const Node& node = nodes_[next.node];
    if (node.leaf()) {
      for (std::uint32_t n = node.begin; n < node.end; ++n) consider(n);
      continue;
    }
    Waiting near{next.node + 1, bound2(next.node + 1, p)}, far{node.right, bound2(node.right, p)};
    if (far.distance2 < near.distance2) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

double nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c, glm::dvec3& at) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp),
               d4 = glm::dot(ac, bp);
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  double y = 0, z = 0;  // of b and c
  if (va > 0 && vb > 0 && vc > 0) {
    const double sum = va + vb + vc;
    y = vb / sum, z = vc / sum;
  } else if (d1 <= 0 && d2 <= 0) {
    y = z = 0;
  } else if (d3 >= 0 && d4 <= d3) {
    y = 1, z = 0;
  } else if (d6 >= 0 && d5 <= d6) {
    y = 0, z = 1;
  } else if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {
    y = d1 / (d1 - d3), z = 0;
  } else if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
    y = 0, z = d2 / (d2 - d6);
  } else {
    z = (d4 - d3) / ((d4 - d3) + (d5 - d6)), y = 1 - z;
  }
  at = {z == 1 || y == 1 || y + z == 1 ? 0.0 : 1 - y - z, y, z};
  const glm::dvec3 d = ap - y * ab - z * ac;
  return glm::dot(d, d);
}

glm::dvec3 nearest_point(const Triangle& t, const glm::dvec3& p) {
  glm::dvec3 at;
  nearest_barycentric(p, t[0], t[1], t[2], at);
  if (at.x == 0)
    return at.y == 0 ? t[2] : t[1] + at.z * (t[2] - t[1]);  // exact at corners and along sides
  return t[0] + at.y * (t[1] - t[0]) + at.z * (t[2] - t[0]);
}

}  // namespace aomd
