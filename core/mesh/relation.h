#pragma once
// One stored adjacency T(I,J): rows of indices. Downward rows (I > J) have a fixed length by shape;
// upward rows (I < J) grow and shrink in a pool and are always sorted, so that they depend on the
// mesh alone, never on the order of the edits that led to it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/raw_vector.h"
#include "core/mesh/handle.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A stored row seen as handles. Valid until the next edit of the mesh.
template <int Dim>
class Row {
 public:
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = Handle<Dim>;
    Iterator() = default;
    explicit Iterator(const std::uint32_t* p) : p_(p) {}
    Handle<Dim> operator*() const { return Handle<Dim>(*p_); }
    Iterator& operator++() { return ++p_, *this; }
    Iterator operator++(int) { return Iterator(p_++); }
    friend bool operator==(Iterator, Iterator) = default;

   private:
    const std::uint32_t* p_ = nullptr;
  };

  Row() = default;
  explicit Row(std::span<const std::uint32_t> indices) : indices_(indices) {}
  [[nodiscard]] Iterator begin() const { return Iterator(indices_.data()); }
  [[nodiscard]] Iterator end() const { return Iterator(indices_.data() + indices_.size()); }
  [[nodiscard]] std::size_t size() const { return indices_.size(); }
  [[nodiscard]] bool empty() const { return indices_.empty(); }
  [[nodiscard]] Handle<Dim> operator[](std::size_t i) const { return Handle<Dim>(indices_[i]); }
  [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }

 private:
  std::span<const std::uint32_t> indices_;
};

/// Downward rows: `stride` indices each, of which the entity's shape uses the first ones.
class DownRows {
 public:
  [[nodiscard]] bool stored() const { return stride_ != 0; }
  [[nodiscard]] std::uint32_t stride() const { return stride_; }
  [[nodiscard]] const std::uint32_t* row(std::uint32_t i) const {
    return data_.data() + std::size_t{i} * stride_;
  }
  [[nodiscard]] std::uint32_t* row(std::uint32_t i) {
    return data_.data() + std::size_t{i} * stride_;
  }
  /// Bit k: the row's k-th entity is used in its own direction. Kept for T(2,1) and T(3,2) only.
  [[nodiscard]] std::uint16_t directions(std::uint32_t i) const { return directions_[i]; }
  void set_directions(std::uint32_t i, std::uint16_t bits) { directions_[i] = bits; }
  [[nodiscard]] std::size_t bytes() const {
    return data_.capacity() * 4 + directions_.capacity() * 2;
  }

  /// Rows to be filled: no_index first, or nothing where every place is written anyway.
  void allocate(std::uint32_t rows, std::uint32_t stride, bool with_directions, bool fill = true);
  void resize(std::uint32_t rows);
  /// Makes room for a shape with more lower entities. O(rows).
  void widen(std::uint32_t stride);
  void release() { *this = DownRows(); }

 private:
  RawVector<std::uint32_t> data_;
  std::vector<std::uint16_t> directions_;
  std::uint32_t stride_ = 0;
  bool with_directions_ = false;
};

/// Upward rows, sorted. insert and erase cost O(row), of a long row erase no more than the shorter
/// way to its begin or end. Blocks that a grown row leaves behind are used again.
class UpRows {
 public:
  static constexpr std::uint32_t max_row_size = (1u << 26) - 1;

  [[nodiscard]] bool stored() const { return stored_; }
  [[nodiscard]] std::span<const std::uint32_t> row(std::uint32_t i) const {
    return {pool_.data() + heads_[i].begin, heads_[i].size};
  }
  [[nodiscard]] std::size_t bytes() const;
  /// Values in all rows together.
  [[nodiscard]] std::size_t entries() const { return own_.entries_; }
  [[nodiscard]] std::size_t rows() const { return heads_.size(); }

  /// Makes rows of the given sizes and returns the pool that holds them, to be filled in ascending
  /// order of values: `sizes[i]` becomes the place of row i in it. O(rows + entries).
  std::uint32_t* allocate(std::span<std::uint32_t> sizes);
  void resize(std::uint32_t rows);
  /// Room for edits to come, so that the first of them does not move all rows. O(entries).
  void make_room() { pool_.reserve(pool_.size() + pool_.size() / 16); }
  void insert(std::uint32_t i, std::uint32_t value) { insert(i, value, own_); }
  /// False when the row does not hold the value.
  bool erase(std::uint32_t i, std::uint32_t value) { return erase(i, value, own_); }
  [[nodiscard]] bool contains(std::uint32_t i, std::uint32_t value) const;
  void release() { *this = UpRows(); }

  /// What rows grow into. Each thread that edits at the same time as others has one, and rows of
  /// its own.
  class alignas(64) Room {
   public:
    /// Places that are left; a row of a vertex that is not crowded takes no more than 2048.
    [[nodiscard]] std::uint32_t left() const { return end_ - begin_; }

   private:
    friend class UpRows;
    static constexpr std::size_t block_kinds = 64;
    Room() { free_blocks_.fill(no_index); }
    /// By block size: first free block, each holding the next one's place.
    std::array<std::uint32_t, block_kinds> free_blocks_;
    std::uint32_t begin_ = 0, end_ = 0;  ///< places that nobody has used yet; the own one's: none
    std::size_t entries_ = 0;            ///< more than there were, modulo 2^64
  };
  /// Makes `count` rooms with at least `places / 2` places each; what those of before still have
  /// stays theirs. Nobody else may edit meanwhile. O(entries) at times.
  void lend(std::size_t count, std::uint32_t places);
  [[nodiscard]] Room& room(std::size_t i) { return rooms_[i]; }
  /// Counts what was inserted and erased through the rooms. Called by one, before others ask.
  void settle();
  void insert(std::uint32_t i, std::uint32_t value, Room& room);
  bool erase(std::uint32_t i, std::uint32_t value, Room& room);

 private:
  struct Head {
    std::uint32_t begin = 0;
    std::uint32_t size : 26 = 0;
    std::uint32_t block : 6 = 0;  ///< capacity as an index into the table of block sizes
  };
  [[nodiscard]] std::uint32_t before(const Head& head) const;
  bool erase_long(Head& head, std::uint32_t value, Room& room);
  void grow(Head& head, Room& room);
  std::uint32_t take_block(std::uint32_t block, Room& room);
  void give_block(const Head& head, Room& room);
  void reserve_places(std::size_t places);
  std::uint32_t new_places(std::uint32_t places);

  std::vector<Head> heads_;
  RawVector<std::uint32_t> pool_;
  Room own_;                 ///< of who edits alone; counts all entries
  std::vector<Room> rooms_;  ///< that are lent
  bool stored_ = false;
};

}  // namespace aomd

#pragma GCC visibility pop
