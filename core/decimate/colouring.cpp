#include "core/decimate/colouring.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/column.h"

namespace aomd {
namespace {

// The colour of each vertex, no_index where it has none; and how many vertices have each colour.
class Greedy {
 public:
  explicit Greedy(const Mesh& mesh) : mesh_(mesh), colour_(mesh.capacity(0), no_index) {}

  void paint(Vertex v) {
    for (const Face f : mesh_.row<2>(v))
      for (const Vertex w : mesh_.triangle(f))
        if (colour_[w] != no_index) taken_by_[colour_[w]] = v;
    const auto free = std::find_if(taken_by_.begin(), taken_by_.end(), [v](Vertex by) { return by != v; });
    const auto c = static_cast<std::size_t>(free - taken_by_.begin());
    if (free == taken_by_.end()) taken_by_.emplace_back(), count_.push_back(0);
    colour_[v] = static_cast<std::uint32_t>(c);
    ++count_[c];
  }
  [[nodiscard]] std::uint32_t colour(Vertex v) const { return colour_[v]; }
  [[nodiscard]] const std::vector<std::size_t>& count() const { return count_; }

 private:
  const Mesh& mesh_;
  Column<Vertex, std::uint32_t> colour_;
  std::vector<Vertex> taken_by_;  ///< by colour: the vertex beside which it was seen last
  std::vector<std::size_t> count_;
};

}  // namespace

Colouring::Colouring(const Mesh& mesh, const std::function<bool(Vertex)>& wanted) {
  Greedy greedy(mesh);
  for (const Vertex v : mesh.vertices())
    if (wanted(v)) greedy.paint(v);
  ends_.resize(greedy.count().size());
  std::exclusive_scan(greedy.count().begin(), greedy.count().end(), ends_.begin(), std::size_t{0});
  vertices_.resize(std::accumulate(greedy.count().begin(), greedy.count().end(), std::size_t{0}));
  for (const Vertex v : mesh.vertices())
    if (greedy.colour(v) != no_index) vertices_[ends_[greedy.colour(v)]++] = v;
}

}  // namespace aomd
