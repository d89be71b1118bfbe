#pragma once
// Items filed under numbers, by a counting sort.

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace aomd {

/// The items of each number below a count, in the order in which they came. Eight bytes a number
/// beside the items.
template <typename Item>
class Buckets {
 public:
  /// `each(file)` calls file(number, item) for every item, the same on both of its calls. O(items +
  /// count).
  template <typename Each>
  Buckets(std::size_t count, Each&& each) : begin_(count + 2, 0) {
    each([this](std::size_t number, const Item&) { ++begin_[number + 2]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    each([this](std::size_t number, const Item& item) { items_[begin_[number + 1]++] = item; });
  }

  [[nodiscard]] std::size_t count() const { return begin_.size() - 2; }
  /// Of all numbers, one after the other.
  [[nodiscard]] std::span<const Item> items() const { return items_; }
  [[nodiscard]] std::span<Item> operator[](std::size_t number) {
    return std::span(items_).subspan(begin_[number], begin_[number + 1] - begin_[number]);
  }
  [[nodiscard]] std::span<const Item> operator[](std::size_t number) const {
    return std::span(items_).subspan(begin_[number], begin_[number + 1] - begin_[number]);
  }

 private:
  std::vector<std::size_t> begin_;  ///< of a number's items; one number further while they come
  std::vector<Item> items_;
};

}  // namespace aomd
