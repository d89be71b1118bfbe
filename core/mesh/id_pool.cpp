#include "core/mesh/id_pool.h"

#include "core/base/assertion.h"

namespace aomd {

IdPool::Created IdPool::create() {
  if (free_.empty()) return {create_many(1), true};
  const std::uint32_t id = free_.back();
  free_.pop_back();
  mark(id);
  return {id, false};
}

std::uint32_t IdPool::create_many(std::uint32_t count) {
  const std::uint32_t first = capacity_;
  capacity_ += count;
  bits_.resize((capacity_ + std::size_t{63}) / 64);
  for (std::uint32_t id = first; id < capacity_; ++id) mark(id);
  return first;
}

void IdPool::destroy(std::uint32_t id) {
  AOMD_CHECK(alive(id));
  clear(id);
  free_.push_back(id);
}

void IdPool::undo_create(std::uint32_t id, bool fresh) {
  AOMD_CHECK(alive(id));
  clear(id);
  if (!fresh) {
    free_.push_back(id);
    return;
  }
  AOMD_CHECK(id + 1 == capacity_);
  --capacity_;
  bits_.resize((capacity_ + std::size_t{63}) / 64);
}

void IdPool::undo_destroy(std::uint32_t id) {
  AOMD_CHECK(!free_.empty() && free_.back() == id);
  free_.pop_back();
  mark(id);
}

}  // namespace aomd
