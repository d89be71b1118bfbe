#pragma once
// How those who share out the blocks of a surface hand over what they made.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace aomd {

/// Processes that work on one surface together, numbered from 0. All of them make the same calls in
/// the same order.
class Exchange {
 public:
  virtual ~Exchange() = default;
  [[nodiscard]] virtual std::size_t rank() const = 0;
  [[nodiscard]] virtual std::size_t ranks() const = 0;
  /// Hands over to the first one, who gets what all have handed over, in the order of ranks. The
  /// others get nothing.
  [[nodiscard]] virtual std::vector<std::string> gather(std::string bytes) = 0;
  /// What the first one says, for all.
  [[nodiscard]] virtual bool told(bool by_first) = 0;
};

/// One process, which works alone.
class NoExchange final : public Exchange {
 public:
  [[nodiscard]] std::size_t rank() const override { return 0; }
  [[nodiscard]] std::size_t ranks() const override { return 1; }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) override {
    std::vector<std::string> all;
    all.push_back(std::move(bytes));
    return all;
  }
  [[nodiscard]] bool told(bool by_first) override { return by_first; }
};

}  // namespace aomd
