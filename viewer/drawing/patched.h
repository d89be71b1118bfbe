#pragma once
// An array that remembers which of its elements changed, so that only those travel to the GPU.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace aomd::scene {

/// Elements [begin, end) of an array.
struct ElementRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t size() const { return end - begin; }
  friend bool operator==(const ElementRange&, const ElementRange&) = default;
};

/// A few sorted, disjoint ranges. Ranges closer than `max_gap` elements become one; beyond
/// `max_ranges` the two nearest become one, so that adding costs O(max_ranges) whatever happened
/// before.
class DirtyRanges {
 public:
  static constexpr std::size_t max_ranges = 64;
  static constexpr std::size_t max_gap = 8;

  void add(ElementRange r) {
    if (r.begin >= r.end) return;
    auto first = std::find_if(ranges_.begin(), ranges_.end(),
                              [&](const ElementRange& q) { return q.end + max_gap >= r.begin; });
    auto last = first;
    for (; last != ranges_.end() && last->begin <= r.end + max_gap; ++last) {
      r.begin = std::min(r.begin, last->begin);
      r.end = std::max(r.end, last->end);
    }
    ranges_.insert(ranges_.erase(first, last), r);
    if (ranges_.size() > max_ranges) merge_nearest();
  }
  /// Forgets what lies at `size` or beyond.
  void cut(std::size_t size) {
    std::erase_if(ranges_, [&](const ElementRange& r) { return r.begin >= size; });
    if (!ranges_.empty()) ranges_.back().end = std::min(ranges_.back().end, size);
  }
  void clear() { ranges_.clear(); }
  [[nodiscard]] std::span<const ElementRange> ranges() const { return ranges_; }

 private:
  void merge_nearest() {
    std::size_t best = 0;
    const auto gap = [&](std::size_t i) { return ranges_[i + 1].begin - ranges_[i].end; };
    for (std::size_t i = 1; i + 1 < ranges_.size(); ++i)
      if (gap(i) < gap(best)) best = i;
    ranges_[best].end = ranges_[best + 1].end;
    ranges_.erase(ranges_.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }

  std::vector<ElementRange> ranges_;
};

/// A vector with dirty ranges. One consumer (the renderer) uploads dirty() and then calls clean().
/// Everything is dirty after assign(); reading never makes anything dirty.
template <typename T>
class Patched {
 public:
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] std::span<const T> values() const { return values_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }

  /// Replaces all elements.
  void assign(std::vector<T> values) {
    ++revision_;
    values_ = std::move(values);
    dirty_.clear();
    dirty_.add({0, values_.size()});
  }
  /// Appended elements are value-initialised and dirty; cut ones are forgotten.
  void resize(std::size_t size) {
    ++revision_;
    const std::size_t old = values_.size();
    values_.resize(size);
    dirty_.cut(size);
    dirty_.add({old, size});
  }
  void push_back(const T& value) {
    ++revision_;
    values_.push_back(value);
    dirty_.add({values_.size() - 1, values_.size()});
  }
  void set(std::size_t i, const T& value) {
    ++revision_;
    values_[i] = value;
    dirty_.add({i, i + 1});
  }
  /// `count` elements from `begin` on, to be written by the caller; dirty from now on. begin +
  /// count <= size().
  [[nodiscard]] std::span<T> edit(std::size_t begin, std::size_t count) {
    ++revision_;
    dirty_.add({begin, begin + count});
    return std::span<T>(values_).subspan(begin, count);
  }

  [[nodiscard]] std::span<const ElementRange> dirty() const { return dirty_.ranges(); }
  void clean() { dirty_.clear(); }
  /// Another number after each change, for whoever makes something of all of it.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  std::vector<T> values_;
  DirtyRanges dirty_;
  std::uint64_t revision_ = 0;
};

}  // namespace aomd::scene
