#include "core/model/triangle_tree.h"

#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"

namespace aomd {

namespace {

constexpr std::size_t grain = 4096;  // triangles that one thread takes

double half_surface(const Box& box) {
  const glm::dvec3 d = box.high - box.low;
  return box.empty() ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

BoxTree sorted_by_centres(std::span<const Triangle> triangles, int threads) {
  std::vector<BoxTree::Item> items(triangles.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Triangle& t = triangles[i];
    items[i] = {t[0] + t[1] + t[2], i};
  }
  return BoxTree(items, threads);
}

// `at` gives the triangles in the tree's order.
template <typename At>
void fit(BoxTree& tree, int threads, const At& at) {
  std::vector<Box> boxes(tree.size());
  parallel_for(boxes.size(), threads, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      for (const glm::dvec3& p : at(static_cast<std::uint32_t>(n))) boxes[n].add(p);
  });
  tree.fit(std::move(boxes));
}

void append(Triangles& all, Face face, std::span<const std::uint32_t> vertices,
            const auto& position) {
  for (std::size_t k = 2; k < vertices.size(); ++k) {
    all.corners.push_back(
        {position(vertices[0]), position(vertices[k - 1]), position(vertices[k])});
    all.faces.push_back(face);
  }
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

BoxTree boxes_of(std::span<const Triangle> triangles, int threads) {
  BoxTree tree = sorted_by_centres(triangles, threads);
  fit(tree, threads, [&](std::uint32_t n) -> const Triangle& { return triangles[tree.source(n)]; });
  return tree;
}

// Boxes are made of triangles that are in order already: what follows lies next to each other.
TriangleTree::TriangleTree(std::vector<Triangle> triangles, int threads)
    : boxes_(sorted_by_centres(triangles, threads)), triangles_(std::move(triangles)) {
  put_in_order();
  fit(boxes_, threads, [this](std::uint32_t n) -> const Triangle& { return triangles_[n]; });
  if (boxes_overlap()) add_tilted_boxes();
}

// Each cycle of places by itself: no second copy of all.
void TriangleTree::put_in_order() {
  std::vector<bool> done(size(), false);
  for (std::uint32_t first = 0; first < size(); ++first) {
    if (done[first]) continue;
    const Triangle taken = triangles_[first];
    std::uint32_t n = first;
    for (; source(n) != first; n = source(n)) {
      triangles_[n] = triangles_[source(n)];
      done[n] = true;
    }
    triangles_[n] = taken;
    done[n] = true;
  }
}

// A line through the box of all meets as many leaves as their surfaces are larger than its own: a
// few of a surface, thousands of a fan of thin triangles.
bool TriangleTree::boxes_overlap() const {
  constexpr double most_met = 64;
  double leaves = 0;
  for (std::uint32_t id = 0; id < boxes_.nodes(); ++id)
    if (boxes_.node(id).leaf()) leaves += half_surface(boxes_.node(id).box);
  return leaves > most_met * half_surface(box());
}

// Along the sides of the triangle in the middle: where those of a node lie side by side, it lies as
// all of them do. A box around boxes is wider than one around corners, and the wider the higher the
// node; for all nodes the corners would take n log n.
void TriangleTree::add_tilted_boxes() {
  constexpr std::uint32_t most_by_corners = 256;
  tilted_.resize(boxes_.nodes());
  const Box all = box();
  for (auto id = static_cast<std::uint32_t>(boxes_.nodes()); id-- > 0;) {
    const BoxTree::Node& node = boxes_.node(id);
    TiltedBox& tilted = tilted_[id];
    tilted = TiltedBox(triangles_[(node.begin + node.end) / 2], all);
    if (node.end - node.begin > most_by_corners) {
      tilted.add(tilted_[id + 1]);
      tilted.add(tilted_[node.right]);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      for (const glm::dvec3& p : triangles_[k]) tilted.add(p);
  }
}

double TriangleTree::diagonal2() const {
  if (triangles_.empty()) return 0;
  const glm::dvec3 size = box().high - box().low;
  return glm::dot(size, size);
}

TriangleTree::Nearest TriangleTree::nearest(const glm::dvec3& p, std::uint32_t hint) const {
  return nearest_of(
      p, [](std::uint32_t) { return true; }, std::numeric_limits<double>::infinity(), hint);
}

double nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c, glm::dvec3& barycentric) {
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
  barycentric = {z == 1 || y == 1 || y + z == 1 ? 0.0 : 1 - y - z, y, z};
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
