#include "core/mesh/orient_regions.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "core/base/buckets.h"
#include "core/mesh/side_index.h"
#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

using Positions = std::span<const glm::dvec3>;

// Six times the signed volume. Each side is cut from its smallest vertex, so that the volume of a
// region that is listed the other way round is the negative one, however bent its sides are.
double six_volumes_of(const ShapeTemplate& shape, Positions positions, const std::uint32_t* v) {
  double sum = 0;
  for (int k = 0; k < shape.face_count; ++k) {
    SideVertices side(shape.sub(2, k), v);
    const auto begin = side.ids.begin(), end = begin + side.count;
    std::rotate(begin, std::min_element(begin, end), end);
    const auto at = [&](std::uint32_t i) { return positions[side.ids[i]]; };
    for (std::uint32_t i = 1; i + 1 < side.count; ++i)
      sum += six_volumes(positions[v[0]], at(0), at(i), at(i + 1));
  }
  return sum;
}

// Calls visit(its first corner, six times its volume) for each region, until one says false.
template <typename Visit>
bool each_volume(const MeshData& mesh, Visit&& visit) {
  const Positions positions(mesh.positions);
  const std::uint32_t* const corners = mesh.regions.vertices.data();
  std::size_t first = 0;
  for (const Shape shape : mesh.regions.shapes) {
    const std::uint32_t* const v = corners + first;
    const double volume =
        shape == Shape::Tetrahedron
            ? six_volumes(positions[v[0]], positions[v[1]], positions[v[2]], positions[v[3]])
            : six_volumes_of(shape_template(shape), positions, v);
    if (!visit(first, volume)) return false;
    first += static_cast<std::size_t>(shape_template(shape).vertex_count);
  }
  return true;
}

// Regions that hang together, each with whether it is to be listed the other way round where the
// one that stands for all of them is listed as it is.
class Bodies {
 public:
  struct Place {
    std::uint32_t body;
    bool turned;
  };

  explicit Bodies(std::size_t regions) : parent_(regions), torn_(regions, false) {
    for (std::uint32_t i = 0; i < regions; ++i) parent_[i] = {i, false};
  }
  Place find(std::uint32_t i) {
    bool turned = false;
    while (parent_[i].body != i) {
      const Place up = parent_[i], next = parent_[up.body];
      parent_[i] = {next.body, up.turned != next.turned};
      turned ^= parent_[i].turned;
      i = next.body;
    }
    return {i, turned};
  }
  // One of two is to be turned where the other is not, or both are to be listed alike.
  void join(std::uint32_t a, std::uint32_t b, bool turned) {
    const Place p = find(a), q = find(b);
    const bool turn = turned != (p.turned != q.turned);
    if (p.body == q.body) {
      if (turn) torn_[p.body] = true;
      return;
    }
    const auto [low, high] = std::minmax(p.body, q.body);
    parent_[high] = {low, turn};
    if (torn_[high]) torn_[low] = true;
  }
  // True where no way to list them makes all agree.
  [[nodiscard]] bool torn(std::uint32_t body) const { return torn_[body]; }

 private:
  std::vector<Place> parent_;
  std::vector<bool> torn_;
};

// A side of a region.
struct Use {
  std::uint64_t tag = 0;
  std::uint32_t region = 0;
  bool forward = false;
};

class Orienter {
 public:
  explicit Orienter(MeshData& mesh) : mesh_(mesh), bodies_(mesh.regions.size()) {
    each_volume(mesh, [this](std::size_t first, double volume) {
      first_.push_back(first);
      volumes_.push_back(volume);
      return true;
    });
  }

  std::vector<std::uint32_t> run() {
    join_at_sides();
    std::vector<double> whole(volumes_.size(), 0);
    for (std::uint32_t r = 0; r < volumes_.size(); ++r) {
      const Bodies::Place place = bodies_.find(r);
      whole[place.body] += place.turned ? -volumes_[r] : volumes_[r];
    }
    std::vector<std::uint32_t> turned;
    for (std::uint32_t r = 0; r < volumes_.size(); ++r) {
      const Bodies::Place place = bodies_.find(r);
      const double sum = whole[place.body];
      if (bodies_.torn(place.body) || (sum < 0) == place.turned) continue;
      turn(r);
      turned.push_back(r);
    }
    return turned;
  }

 private:
  void join_at_sides() {
    Buckets<Use> sides(mesh_.positions.size(), [this](auto&& file) {
      for (std::uint32_t r = 0; r < first_.size(); ++r) file_sides(r, file);
    });
    for (std::size_t v = 0; v < sides.count(); ++v) {
      const std::span<Use> at = sides[v];
      std::sort(at.begin(), at.end(), [](const Use& a, const Use& b) { return a.tag < b.tag; });
      for (std::size_t i = 0, begin = 0; i < at.size(); begin = i) {
        while (i < at.size() && at[i].tag == at[begin].tag) ++i;
        if (i - begin == 2) join(at[begin], at[begin + 1]);
      }
    }
  }

  template <typename File>
  void file_sides(std::uint32_t region, File&& file) const {
    const ShapeTemplate& shape = shape_template(mesh_.regions.shapes[region]);
    const std::uint32_t* const v = mesh_.regions.vertices.data() + first_[region];
    for (int k = 0; k < shape.face_count; ++k) {
      const SideVertices side(shape.sub(2, k), v);
      const FaceKey key(side.span());
      file(key.low, Use{key.tag, region, key.forward});
    }
  }

  // Where both look at the side the same way round and have volumes of one sign, they lie on one
  // side of it, whatever their numbering. What has no volume lies nowhere.
  void join(const Use& a, const Use& b) {
    const int product = sign(a.region) * sign(b.region);
    const bool alike = a.forward == b.forward;
    if (product == 0 || (alike && product > 0)) return;
    bodies_.join(a.region, b.region, alike);
  }
  [[nodiscard]] int sign(std::uint32_t region) const {
    return (volumes_[region] > 0) - (volumes_[region] < 0);
  }

  // The first three or four vertices are the base; prisms and hexahedra have another one above it.
  void turn(std::uint32_t region) {
    const Shape shape = mesh_.regions.shapes[region];
    const auto v = mesh_.regions.vertices.begin() + static_cast<std::ptrdiff_t>(first_[region]);
    const std::ptrdiff_t base = shape == Shape::Tetrahedron || shape == Shape::Prism ? 3 : 4;
    std::reverse(v + 1, v + base);
    if (shape == Shape::Prism || shape == Shape::Hexahedron)
      std::reverse(v + base + 1, v + 2 * base);
  }

  MeshData& mesh_;
  Bodies bodies_;
  std::vector<std::size_t> first_;  ///< by region: its first corner in the list
  std::vector<double> volumes_;     ///< six times each
};

}  // namespace

std::vector<std::uint32_t> orient_regions(MeshData& mesh) {
  const auto is_positive = [](std::size_t, double volume) { return volume > 0; };
  if (each_volume(mesh, is_positive)) return {};
  return Orienter(mesh).run();
}

}  // namespace aomd
