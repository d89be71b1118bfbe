// A ball inside a box, two materials, on a body-centred lattice that is bent to fit.

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/samples/build.h"
#include "core/samples/makers.h"
#include "core/samples/volume_build.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;
using Lattice = glm::ivec3;

constexpr double radius = 0.45;
constexpr int ball_region = 1, box_region = 2;

/// The box [-1, 1]^3 as 4n cells a side. Lattice points are corners of cells (all even) and their
/// centres (all odd); the tetrahedra around an edge between two centres fill the lattice. Its
/// planes cut out a rhombic dodecahedron, |x| + |y| = 2n and so on, half as wide as the box, whose
/// sides are bent onto the sphere: all points move along their rays, those on the box not at all.
class BallInBox {
 public:
  explicit BallInBox(int n) : ball_(2 * n), box_(4 * n) {}

  MeshData make() {
    each_point(box_, [this](const Lattice& p) { add_vertex(mesh_, position(p)); });
    each_point(box_ - 1, [this](const Lattice& p) { add_vertex(mesh_, position(p)); });
    for (const int region : {ball_region, box_region})
      each_point(box_ - 1, [&](const Lattice& p) { add_cell(p, region); });
    classify_below_regions(mesh_, [](const glm::dvec3& p) {
      return side_of_box(p, glm::dvec3(-1), glm::dvec3(1), 7);
    });
    return std::move(mesh_);
  }

 private:
  /// Every second point of a cube, along x first.
  template <class Visit>
  static void each_point(int half, Visit&& visit) {
    for (int z = -half; z <= half; z += 2)
      for (int y = -half; y <= half; y += 2)
        for (int x = -half; x <= half; x += 2) visit(Lattice(x, y, z));
  }

  /// The largest |x|, and the sum of the two largest: what is the same on a box, and on a
  /// dodecahedron.
  static int on_box(const Lattice& p) {
    const Lattice a = glm::abs(p);
    return std::max({a.x, a.y, a.z});
  }
  static int on_ball(const Lattice& p) {
    const Lattice a = glm::abs(p);
    return a.x + a.y + a.z - std::min({a.x, a.y, a.z});
  }

  [[nodiscard]] glm::dvec3 position(const Lattice& lattice) const {
    if (lattice == Lattice(0)) return glm::dvec3(0);
    const glm::dvec3 p(lattice), on_sphere = radius * glm::normalize(p);
    const double inward = static_cast<double>(on_ball(lattice)) / ball_;
    if (inward <= 1) return on_sphere * inward;
    const double out = on_box(lattice), start = out / inward;
    return glm::mix(on_sphere, p / out, (out - start) / (box_ - start));
  }

  [[nodiscard]] Index vertex(const Lattice& p) const {
    const bool centre = p.x % 2 != 0;
    const int half = centre ? box_ - 1 : box_, side = half + 1;
    const Lattice at = (p + half) / 2;
    const int before = centre ? (box_ + 1) * (box_ + 1) * (box_ + 1) : 0;
    return static_cast<Index>(before + (at.z * side + at.y) * side + at.x);
  }

  /// Adds those of one region among the tetrahedra between the centre of a cell and those beyond
  /// its three upper sides; on the box the pyramid on the side, cut in two.
  void add_cell(const Lattice& centre, int region) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {1, -1}) {
        Lattice step(0);
        step[axis] = sign;
        const std::array<Lattice, 4> side = corners(centre + step, axis, sign);
        if (on_box(centre + 2 * step) > box_) {
          add(region, {centre, side[0], side[1], side[2]});
          add(region, {centre, side[0], side[2], side[3]});
        } else if (sign > 0) {
          for (std::size_t k = 0; k < 4; ++k)
            add(region, {centre, centre + 2 * step, side[k], side[(k + 1) % 4]});
        }
      }
  }

  /// The corners around the middle of a side, counter-clockwise from outside the cell.
  static std::array<Lattice, 4> corners(const Lattice& middle, int axis, int sign) {
    constexpr int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    std::array<Lattice, 4> result;
    for (std::size_t k = 0; k < 4; ++k) {
      Lattice& corner = result[sign > 0 ? k : 3 - k];
      corner = middle;
      corner[(axis + 1) % 3] += around[k][0];
      corner[(axis + 2) % 3] += around[k][1];
    }
    return result;
  }

  void add(int region, const std::array<Lattice, 4>& p) {
    const bool inside =
        std::all_of(p.begin(), p.end(), [this](const Lattice& q) { return on_ball(q) <= ball_; });
    if (inside == (region == ball_region))
      mesh_.regions.add(Shape::Tetrahedron,
                        {vertex(p[0]), vertex(p[1]), vertex(p[2]), vertex(p[3])},
                        ModelRef(3, region));
  }

  int ball_, box_;
  MeshData mesh_;
};

}  // namespace

MeshData make_ball_in_box(int layers) { return BallInBox(layers).make(); }

}  // namespace aomd::sample
