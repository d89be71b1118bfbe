#include "core/decimate/spacing/vertex_neighbours.h"

#include <algorithm>
#include <queue>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "core/mesh/bulk.h"

namespace aomd {
namespace {

template <typename Visit>
void visit_sides(const Mesh& mesh, int dim, Visit&& visit) {
  const VertexRows rows(mesh, dim);
  if (dim == 1) {
    rows.each([&](std::uint32_t, const std::uint32_t* v) { visit(v[0], v[1]); });
  } else if (dim == 2 && rows.uniform() && rows.uniform()->vertex_count == 3) {
    rows.each([&](std::uint32_t, const std::uint32_t* v) {
      visit(v[0], v[1]), visit(v[1], v[2]), visit(v[2], v[0]);
    });
  } else {
    rows.each([&](std::uint32_t id, const std::uint32_t* v) {
      const ShapeTemplate& shape = rows.shape(id);
      for (int k = 0; k < shape.edge_count; ++k) {
        const auto& ends = shape.sub(1, k).vertices;
        visit(v[ends[0]], v[ends[1]]);
      }
    });
  }
}

// Where level 1 is complete it holds them all; else sides are met once for each entity that has
// them.
template <typename Visit>
void each_side(const Mesh& mesh, Visit&& visit) {
  const int highest = mesh.complete(1) ? 1 : 3;
  for (int dim = 1; dim <= highest; ++dim)
    if (mesh.count(dim) > 0) visit_sides(mesh, dim, visit);
}

double distance(const Mesh& mesh, Vertex a, Vertex b) {
  return glm::length(mesh.position(a) - mesh.position(b));
}

}  // namespace

VertexNeighbours::VertexNeighbours(const Mesh& mesh)
    : begin_(mesh.capacity(0) + std::size_t{1}, 0) {
  const std::uint32_t n = mesh.capacity(0);
  each_side(mesh,
            [begin = begin_.data()](std::uint32_t a, std::uint32_t b) { ++begin[a], ++begin[b]; });
  std::size_t sum = 0;
  for (std::size_t& begin : begin_) sum += std::exchange(begin, sum);
  end_.assign(begin_.begin(), begin_.end() - 1);
  all_.resize(sum);
  each_side(mesh, [end = end_.data(), all = all_.data()](std::uint32_t a, std::uint32_t b) {
    all[end[a]++] = b;
    all[end[b]++] = a;
  });
  std::vector<std::uint32_t> met_at(n, no_index);
  for (std::uint32_t v = 0; v < n; ++v) {
    std::size_t kept = begin_[v];
    for (std::size_t i = begin_[v]; i < end_[v]; ++i)
      if (std::exchange(met_at[all_[i]], v) != v) all_[kept++] = all_[i];
    end_[v] = kept;
  }
}

Column<Vertex, double> average_edge_lengths(const Mesh& mesh, const VertexNeighbours& neighbours) {
  Column<Vertex, double> average(mesh.capacity(0), 0.0);
  for (const Vertex v : mesh.vertices()) {
    const auto around = neighbours.of(v);
    if (around.empty()) continue;
    double sum = 0;
    for (const std::uint32_t u : around) sum += distance(mesh, v, Vertex(u));
    average[v] = sum / static_cast<double>(around.size());
  }
  return average;
}

Box box_of_used(const Mesh& mesh, const VertexNeighbours& neighbours) {
  Box box;
  for (const Vertex v : mesh.vertices())
    if (!neighbours.of(v).empty()) box.add(mesh.position(v));
  return box;
}

namespace {

/// Lowers values; in whatever order, the result is the same: the largest field that the limit
/// allows.
class GrowthLimit {
 public:
  GrowthLimit(const Mesh& mesh, const VertexNeighbours& neighbours, double growth,
              Column<Vertex, double>& values)
      : mesh_(mesh), neighbours_(neighbours), growth_(growth), values_(values) {}

  /// Lowers a vertex to what its neighbours allow.
  void pull(Vertex v) {
    double most = values_[v];
    for (const std::uint32_t u : neighbours_.of(v)) most = std::min(most, allowed(Vertex(u), v));
    values_[v] = most;
  }
  /// Lowers what is left, the smallest value that is too small for a neighbour first.
  void finish();

 private:
  using Entry = std::pair<double, std::uint32_t>;
  [[nodiscard]] double allowed(Vertex from, Vertex to) const {
    return values_[from] + growth_ * distance(mesh_, from, to);
  }
  void push(Vertex from);

  const Mesh& mesh_;
  const VertexNeighbours& neighbours_;
  double growth_;
  Column<Vertex, double>& values_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

void GrowthLimit::push(Vertex from) {
  for (const std::uint32_t u : neighbours_.of(from)) {
    const double most = allowed(from, Vertex(u));
    if (values_[Vertex(u)] <= most) continue;
    values_[Vertex(u)] = most;
    queue_.emplace(most, u);
  }
}

void GrowthLimit::finish() {
  for (const Vertex v : mesh_.vertices()) push(v);
  while (!queue_.empty()) {
    const auto [value, v] = queue_.top();
    queue_.pop();
    if (value <= values_[Vertex(v)]) push(Vertex(v));
  }
}

}  // namespace

void limit_growth(const Mesh& mesh, const VertexNeighbours& neighbours, double growth,
                  Column<Vertex, double>& values) {
  if (!(growth >= 0))
    throw std::invalid_argument("spacings cannot grow by less than 0 per unit of length");
  GrowthLimit limit(mesh, neighbours, growth, values);
  // Two sweeps without decisions do most of it where neighbours are near in memory; the queue
  // bounds the rest.
  const IdPool& ids = mesh.ids(0);
  for (const Vertex v : mesh.vertices()) limit.pull(v);
  for (std::uint32_t id = ids.capacity(); id-- > 0;)
    if (ids.alive(id)) limit.pull(Vertex(id));
  limit.finish();
}

}  // namespace aomd
