#include "core/decimate/volume/region_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mesh/tet_geometry.h"

namespace aomd {

VolumeCondition& RegionBalance::of(ModelRef region) {
  for (VolumeCondition& c : conditions_)
    if (c.region == region) return c;
  conditions_.push_back({.region = region});
  return conditions_.back();
}

void RegionBalance::lose(const Mesh& mesh, Vertex centre, const BallRegion& r) {
  of(mesh.classification(r.region)).offset -=
      six_volumes(mesh.position(centre), mesh.position(r.others[0]), mesh.position(r.others[1]),
                  mesh.position(r.others[2]));
}

void RegionBalance::stretch(const Mesh& mesh, const BallRegion& r) {
  const glm::dvec3 a = mesh.position(r.others[0]) - origin_,
                   b = mesh.position(r.others[1]) - origin_,
                   c = mesh.position(r.others[2]) - origin_;
  const glm::dvec3 inward = glm::cross(c - a, b - a);
  VolumeCondition& condition = of(mesh.classification(r.region));
  condition.normal += inward;
  condition.offset -= glm::dot(inward, a);
  condition.outside += glm::length(inward);
}

void RegionBalance::add(const Mesh& mesh, Vertex centre, const Ball& ball) {
  for (const BallRegion& r : ball) {
    lose(mesh, centre, r);
    stretch(mesh, r);
  }
}

void RegionBalance::add(const Mesh& mesh, Vertex deleted, const Ball& around_deleted, Vertex kept,
                        const Ball& around_kept) {
  for (const BallRegion& r : around_deleted) {
    lose(mesh, deleted, r);
    if (!r.uses(kept)) stretch(mesh, r);
  }
  for (const BallRegion& r : around_kept) {
    if (r.uses(deleted)) continue;
    lose(mesh, kept, r);
    stretch(mesh, r);
  }
}

void VolumeDebts::reset(std::size_t vertices) {
  first_.assign(vertices, no_index);
  debts_.clear();
  sums_.clear();
  unused_ = no_index;
}

std::uint32_t VolumeDebts::find(Vertex v, ModelRef region) const {
  std::uint32_t i = first_[v];
  while (i != no_index && debts_[i].region != region) i = debts_[i].next;
  return i;
}

double VolumeDebts::of(Vertex v, ModelRef region) const {
  const std::uint32_t i = find(v, region);
  return i == no_index ? 0 : debts_[i].amount;
}

void VolumeDebts::set(Vertex v, ModelRef region, double amount) {
  if (const std::uint32_t known = find(v, region); known != no_index) {
    debts_[known].amount = amount;
    return;
  }
  if (amount == 0) return;
  std::uint32_t i = unused_;
  if (i == no_index) {
    i = static_cast<std::uint32_t>(debts_.size());
    debts_.emplace_back();
  } else {
    unused_ = debts_[i].next;
  }
  debts_[i] = {region, first_[v], amount};
  first_[v] = i;
}

void VolumeDebts::add(Vertex v, ModelRef region, double amount) {
  sums_[region.bits()].total += amount;
  set(v, region, of(v, region) + amount);
}

double VolumeDebts::in_limits(ModelRef region, double change) const {
  const auto sum = sums_.find(region.bits());
  return sum == sums_.end() ? 0 : (sum->second.total + change) / sum->second.most;
}

bool VolumeDebts::bears(ModelRef region, double change) const {
  const auto sum = sums_.find(region.bits());
  if (sum == sums_.end()) return true;
  const auto [now, most] = sum->second;
  const double then = std::abs(now + change);
  return then <= most || then <= std::abs(now);
}

void VolumeDebts::hand_over(Vertex from, Vertex to) {
  std::uint32_t i = std::exchange(first_[from], no_index);
  while (i != no_index) {
    const Debt debt = debts_[i];
    debts_[i] = {{}, unused_, 0};
    unused_ = std::exchange(i, debt.next);
    set(to, debt.region, of(to, debt.region) + debt.amount);
  }
}

void VolumeDebts::charge(Vertex v, std::span<VolumeCondition> conditions) const {
  for (VolumeCondition& c : conditions) c.debt += of(v, c.region);
}

void VolumeDebts::settle(Vertex v, const glm::dvec3& x,
                         std::span<const VolumeCondition> conditions) {
  for (const VolumeCondition& c : conditions) {
    sums_[c.region.bits()].total += c.change(x);
    set(v, c.region, c.debt + c.change(x));
  }
}

double VolumeDebts::total(ModelRef region) const {
  const auto sum = sums_.find(region.bits());
  return sum == sums_.end() ? 0 : sum->second.total;
}

}  // namespace aomd
