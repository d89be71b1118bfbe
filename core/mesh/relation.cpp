#include "core/mesh/relation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assertion.h"
#include "core/base/buckets.h"

namespace aomd {
namespace {

// Block sizes: every number up to 16, then two an octave, so that typical rows fit exactly and 6
// bits name them all.
constexpr std::array<std::uint32_t, 64> block_sizes = [] {
  std::array<std::uint32_t, 64> sizes{};
  for (std::uint32_t i = 0; i < 64; ++i) {
    if (i <= 16) {
      sizes[i] = i;
    } else {
      const std::uint32_t octave = (i - 17) / 2;
      sizes[i] = std::min<std::uint64_t>(
          (i - 17) % 2 == 0 ? std::uint64_t{24} << octave : std::uint64_t{32} << octave,
          UpRows::max_row_size);
    }
  }
  return sizes;
}();

// Blocks from here on hold one number more, before the row: how many places of the block lie before
// that. So erasing moves whichever part of the row is shorter, and a long row from which values go
// in ascending order, as a sweep takes them, costs no more than its length.
constexpr std::uint32_t first_long_block = 27;
static_assert(block_sizes[first_long_block - 1] == 512);

bool is_long(std::uint32_t block) { return block >= first_long_block; }

std::uint32_t block_for(std::uint32_t size) {
  if (size <= 16) return size;
  const std::uint32_t places = size <= block_sizes[first_long_block - 1] ? size : size + 1;
  const auto it = std::lower_bound(block_sizes.begin() + 17, block_sizes.end(), places);
  AOMD_CHECK(it != block_sizes.end());
  return static_cast<std::uint32_t>(it - block_sizes.begin());
}

// The rows that have a block, in the order in which the pool holds them.
template <typename Heads>
Buckets<std::uint32_t> rows_in_order(const Heads& heads, std::size_t places) {
  constexpr std::uint32_t part = 16;  // of the pool: two rows or three, which are quickly sorted
  Buckets<std::uint32_t> rows(places / part + 1, [&](auto&& file) {
    for (std::uint32_t i = 0; i < heads.size(); ++i)
      if (heads[i].block != 0) file(heads[i].begin / part, i);
  });
  for (std::size_t k = 0; k < rows.count(); ++k)
    std::ranges::sort(rows[k], {}, [&](std::uint32_t i) { return heads[i].begin; });
  return rows;
}

// Moves all rows to the front, in their order, each into the smallest block that holds it; rows
// without values, as of vertices that are gone, have none any more. That takes away a quarter of
// the pool or more, and is not needed again before edits have used it up.
template <typename Heads>
void close_up(Heads& heads, RawVector<std::uint32_t>& pool) {
  for (auto& head : heads)
    if (head.size == 0) head = {};
  const Buckets<std::uint32_t> rows = rows_in_order(heads, pool.size());
  std::uint32_t end = 0;
  for (const std::uint32_t i : rows.items()) {
    const std::uint32_t size = heads[i].size, block = block_for(size), begin = end + is_long(block);
    std::copy_n(pool.begin() + heads[i].begin, size, pool.begin() + begin);
    if (is_long(block)) pool[begin - 1] = 0;
    heads[i].begin = begin;
    heads[i].block = block;
    end += block_sizes[block];
  }
  pool.resize(end);
}

}  // namespace

void DownRows::allocate(std::uint32_t rows, std::uint32_t stride, bool with_directions, bool fill) {
  AOMD_CHECK(stride > 0);
  stride_ = stride;
  with_directions_ = with_directions;
  if (fill)
    data_.assign(std::size_t{rows} * stride, no_index);
  else
    data_.resize(std::size_t{rows} * stride);
  if (with_directions) directions_.assign(rows, 0);
}

void DownRows::resize(std::uint32_t rows) {
  data_.resize(std::size_t{rows} * stride_, no_index);
  if (with_directions_) directions_.resize(rows, 0);
}

void DownRows::widen(std::uint32_t stride) {
  if (stride <= stride_) return;
  const std::size_t rows = data_.size() / stride_;
  RawVector<std::uint32_t> wider(rows * stride, no_index);
  for (std::size_t i = 0; i < rows; ++i)
    std::copy_n(data_.begin() + static_cast<std::ptrdiff_t>(i * stride_), stride_,
                wider.begin() + static_cast<std::ptrdiff_t>(i * stride));
  data_ = std::move(wider);
  stride_ = stride;
}

std::size_t UpRows::bytes() const {
  return heads_.capacity() * sizeof(Head) + pool_.capacity() * 4 + rooms_.capacity() * sizeof(Room);
}

std::uint32_t* UpRows::allocate(std::span<std::uint32_t> sizes) {
  release();
  stored_ = true;
  heads_.resize(sizes.size());
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::uint32_t size = sizes[i], block = block_for(size);
    const auto place = static_cast<std::uint32_t>(begin + is_long(block));
    heads_[i].begin = sizes[i] = place;
    heads_[i].size = size;
    heads_[i].block = block;
    begin += block_sizes[block];
    own_.entries_ += size;
  }
  AOMD_CHECK(begin < no_index);
  pool_.resize(begin);
  for (const Head& head : heads_)
    if (is_long(head.block)) pool_[head.begin - 1] = 0;
  return pool_.data();
}

void UpRows::resize(std::uint32_t rows) {
  for (std::size_t i = rows; i < heads_.size(); ++i) {
    give_block(heads_[i], own_);
    own_.entries_ -= heads_[i].size;
  }
  heads_.resize(rows);
}

// Places of its block that lie before a row.
std::uint32_t UpRows::before(const Head& head) const {
  return is_long(head.block) ? 1 + pool_[head.begin - 1] : 0;
}

void UpRows::give_block(const Head& head, Room& room) {
  if (head.block == 0) return;
  const std::uint32_t begin = head.begin - before(head);
  pool_[begin] = room.free_blocks_[head.block];
  room.free_blocks_[head.block] = begin;
}

// Closing up ends the free blocks and the places of all rooms.
void UpRows::reserve_places(std::size_t places) {
  const auto is_full = [&] { return pool_.size() + places > pool_.capacity(); };
  if (is_full() && pool_.size() > own_.entries_ / 8 * 11) {
    close_up(heads_, pool_);
    own_.free_blocks_.fill(no_index);
    rooms_.assign(rooms_.size(), Room());
  }
  if (is_full()) pool_.reserve(std::max(pool_.size() + places, pool_.capacity() / 8 * 9));
}

std::uint32_t UpRows::new_places(std::uint32_t places) {
  const std::size_t begin = pool_.size();
  AOMD_CHECK(begin + places < no_index);
  pool_.resize(begin + places);
  return static_cast<std::uint32_t>(begin);
}

std::uint32_t UpRows::take_block(std::uint32_t block, Room& room) {
  std::uint32_t& first = room.free_blocks_[block];
  if (first != no_index) {
    const std::uint32_t begin = first;
    first = pool_[begin];
    return begin;
  }
  const std::uint32_t size = block_sizes[block];
  if (&room == &own_) {
    reserve_places(size);
    return new_places(size);
  }
  AOMD_CHECK(room.left() >= size);
  return std::exchange(room.begin_, room.begin_ + size);
}

void UpRows::lend(std::size_t count, std::uint32_t places) {
  const auto has_enough = [places](const Room& room) { return room.left() >= places / 2; };
  rooms_.resize(count, Room());
  if (std::all_of(rooms_.begin(), rooms_.end(), has_enough)) return;
  reserve_places(count * places);
  for (Room& room : rooms_) {
    if (has_enough(room)) continue;
    room.begin_ = new_places(places);
    room.end_ = room.begin_ + places;
  }
}

void UpRows::settle() {
  for (Room& room : rooms_) own_.entries_ += std::exchange(room.entries_, 0);
}

void UpRows::grow(Head& head, Room& room) {
  const std::uint32_t block = block_for(head.size + 1);
  const std::uint32_t begin = take_block(block, room) + is_long(block);
  std::copy_n(pool_.begin() + head.begin, head.size, pool_.begin() + begin);
  give_block(head, room);
  head.begin = begin;
  head.block = block;
  if (is_long(block)) pool_[begin - 1] = 0;
}

bool UpRows::erase_long(Head& head, std::uint32_t value, Room& room) {
  const auto row = pool_.begin() + head.begin, end = row + head.size;
  const auto at = std::lower_bound(row, end, value);
  if (at == end || *at != value) return false;
  if (at - row < end - at) {
    const std::uint32_t places_before = before(head);
    std::copy_backward(row, at, at + 1);
    ++head.begin;
    pool_[head.begin - 1] = places_before;
  } else {
    std::copy(at + 1, end, at);
  }
  --head.size;
  --room.entries_;
  return true;
}

void UpRows::insert(std::uint32_t i, std::uint32_t value, Room& room) {
  Head& head = heads_[i];
  if (head.size + before(head) == block_sizes[head.block]) grow(head, room);
  std::uint32_t* row = pool_.data() + head.begin;
  std::uint32_t k = head.size;
  for (; k > 0 && row[k - 1] > value; --k) row[k] = row[k - 1];
  AOMD_DEBUG_CHECK(k == 0 || row[k - 1] != value);
  row[k] = value;
  ++head.size;
  ++room.entries_;
}

bool UpRows::erase(std::uint32_t i, std::uint32_t value, Room& room) {
  Head& head = heads_[i];
  if (is_long(head.block)) return erase_long(head, value, room);
  std::uint32_t* row = pool_.data() + head.begin;
  std::uint32_t k = head.size;
  while (k > 0 && row[k - 1] > value) --k;
  if (k == 0 || row[k - 1] != value) return false;
  for (; k < head.size; ++k) row[k - 1] = row[k];
  --head.size;
  --room.entries_;
  if (head.size == 0 && head.block > 12) {  // its vertex may have gone: others may have the block
    give_block(head, room);
    head = Head();
  }
  return true;
}

bool UpRows::contains(std::uint32_t i, std::uint32_t value) const {
  const auto values = row(i);
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace aomd
