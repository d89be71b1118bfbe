#pragma once
// What moving or contracting a vertex does to the volumes of the regions around it, and what
// earlier operations owe them.

#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/operators/ball.h"

namespace aomd {

/// The change of one region's volume, as a function of where a vertex goes: six times it is
/// dot(normal, x) + offset, which is linear, because the tetrahedra around the vertex stand on
/// faces that stay (Lindstrom, Turk 1998, there for a closed surface).
struct VolumeCondition {
  ModelRef region;
  glm::dvec3 normal{0.0};
  double offset = 0;
  double outside = 0;  ///< twice the area of the faces that stay
  double debt = 0;     ///< six times the volume that the region has gained too much before

  [[nodiscard]] double change(const glm::dvec3& x) const { return glm::dot(normal, x) + offset; }
};

/// The conditions at a place, one for each region around it. Reused, it allocates nothing.
class RegionBalance {
 public:
  /// Positions count from `origin` from now on.
  void begin(const glm::dvec3& origin) {
    origin_ = origin;
    conditions_.clear();
  }
  /// The tetrahedra around `centre` go along with it.
  void add(const Mesh& mesh, Vertex centre, const Ball& ball);
  /// The tetrahedra around both ends of an edge go along with the one that stays; those that use
  /// both vanish.
  void add(const Mesh& mesh, Vertex deleted, const Ball& around_deleted, Vertex kept,
           const Ball& around_kept);

  [[nodiscard]] const glm::dvec3& origin() const { return origin_; }
  [[nodiscard]] std::span<VolumeCondition> conditions() { return conditions_; }
  [[nodiscard]] std::span<const VolumeCondition> conditions() const { return conditions_; }

 private:
  [[nodiscard]] VolumeCondition& of(ModelRef region);
  void lose(const Mesh& mesh, Vertex centre, const BallRegion& r);
  void stretch(const Mesh& mesh, const BallRegion& r);

  glm::dvec3 origin_{0.0};
  std::vector<VolumeCondition> conditions_;
};

/// What operations around each vertex have added to regions and not taken back: six times the
/// volume, by vertex and region. Contractions onto a given place and swaps leave debts; placements
/// pay them. What a region owes in all is what its volume has changed by, and stays small for it.
/// 24 bytes a debt, 4 a vertex.
class VolumeDebts {
 public:
  void reset(std::size_t vertices);
  /// Six times the volume by which a region may change in all; without, by any.
  void limit(ModelRef region, double most) { sums_[region.bits()].most = most; }
  /// What a region would have changed by in all after so much more, in limits; 0 without a limit.
  [[nodiscard]] double in_limits(ModelRef region, double change) const;
  /// Whether a region may change by so much more: what leads back is always allowed.
  [[nodiscard]] bool bears(ModelRef region, double change) const;
  [[nodiscard]] double of(Vertex v, ModelRef region) const;
  void add(Vertex v, ModelRef region, double amount);
  /// What one vertex owes becomes another's.
  void hand_over(Vertex from, Vertex to);
  /// Adds the debts of a vertex to those of the conditions.
  void charge(Vertex v, std::span<VolumeCondition> conditions) const;
  /// The vertex has gone to `x`, with all that the conditions were charged with.
  void settle(Vertex v, const glm::dvec3& x, std::span<const VolumeCondition> conditions);
  /// The sum over all vertices.
  [[nodiscard]] double total(ModelRef region) const;

 private:
  struct Debt {
    ModelRef region;
    std::uint32_t next = no_index;
    double amount = 0;
  };
  struct Sum {
    double total = 0;
    double most = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] std::uint32_t find(Vertex v, ModelRef region) const;
  void set(Vertex v, ModelRef region, double amount);

  std::vector<Debt> debts_;
  std::unordered_map<std::uint32_t, Sum> sums_;  ///< by the bits of the region
  std::uint32_t unused_ = no_index;              ///< the first of the debts that nobody has
  Column<Vertex, std::uint32_t> first_;          ///< by vertex, of its debts
};

}  // namespace aomd
