#include "core/mesh/entity_hash.h"

#include <algorithm>

#include "core/base/assertion.h"

namespace aomd {
namespace {

constexpr std::size_t bucket_limit = 100'000'000;

}  // namespace

std::uint64_t EntityHash::mix(std::uint32_t vertex) {  // splitmix64
  std::uint64_t z = (vertex + std::uint64_t{1}) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

std::uint64_t EntityHash::key(std::span<const std::uint32_t> vertices) {
  std::uint64_t sum = 0;
  for (const std::uint32_t v : vertices) sum += mix(v);
  return sum;
}

EntityHash::Statistics EntityHash::statistics() const {
  const auto worst = std::max_element(length_.begin(), length_.end());
  return {static_cast<std::uint32_t>(first_.size()), used_, crowded_,
          worst == length_.end() ? 0u : *worst, static_cast<std::uint32_t>(rehashes_.size())};
}

std::vector<std::uint32_t> EntityHash::lengths() const {
  std::vector<std::uint32_t> counts(statistics().worst + std::size_t{1}, 0);
  for (const std::uint16_t length : length_) ++counts[length];
  return counts;
}

void EntityHash::build(std::uint32_t expected) {
  release();
  const std::size_t buckets = std::clamp<std::size_t>(expected, 61, bucket_limit) | 1u;
  first_.assign(buckets, no_index);
  length_.assign(buckets, 0);
  next_.reserve(expected);
  keys_.reserve(expected);
}

void EntityHash::link(std::uint32_t entity) {
  const std::size_t b = bucket(keys_[entity]);
  next_[entity] = first_[b];
  first_[b] = entity;
  if (length_[b] == 0xffff) return;
  ++length_[b];
  used_ += length_[b] == 1;
  crowded_ += length_[b] == crowded_length;
}

void EntityHash::insert(std::uint64_t key, std::uint32_t entity) {
  if (entity >= next_.size()) {
    next_.resize(std::size_t{entity} + 1, no_index);
    keys_.resize(std::size_t{entity} + 1, 0);
  }
  keys_[entity] = key;
  link(entity);
  grow_when_crowded();
}

void EntityHash::erase(std::uint32_t entity) {
  const std::size_t b = bucket(keys_[entity]);
  std::uint32_t* at = &first_[b];
  while (*at != no_index && *at != entity) at = &next_[*at];
  AOMD_CHECK(*at == entity);
  *at = next_[entity];
  if (length_[b] == 0xffff) return;
  crowded_ -= length_[b] == crowded_length;
  --length_[b];
  used_ -= length_[b] == 0;
}

void EntityHash::grow_when_crowded() {
  // With eight buckets an entity, chains are long because keys are equal: no number of buckets
  // parts those.
  const bool parts_nothing = first_.size() > 8 * keys_.size();
  if (crowded_ * std::uint64_t{10} <= used_ || first_.size() * 10 > bucket_limit || parts_nothing)
    return;
  std::vector<std::uint32_t> old = std::move(first_);
  std::vector<std::uint32_t> old_next = next_;
  first_.assign(old.size() * 10 | 1u, no_index);
  length_.assign(first_.size(), 0);
  used_ = crowded_ = 0;
  std::uint32_t entities = 0;
  for (const std::uint32_t head : old)
    for (std::uint32_t e = head; e != no_index; e = old_next[e], ++entities) link(e);
  rehashes_.push_back({entities, static_cast<std::uint32_t>(old.size()),
                       static_cast<std::uint32_t>(first_.size())});
}

}  // namespace aomd
