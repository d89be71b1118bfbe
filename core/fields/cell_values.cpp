#include "core/fields/cell_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/parallel.h"
#include "core/fields/field.h"

namespace aomd::fields {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The mean over the parts, within their range. What is no number has no say unless it is the most.
template <typename ValueOf>
double mean(std::span<const CellPart> parts, ValueOf&& value_of) {
  double all = 0, known = 0, sum = 0;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const CellPart& part : parts) {
    const double x = value_of(part.cell);
    all += part.amount;
    if (!std::isfinite(x)) continue;
    known += part.amount;
    sum += part.amount * x;
    low = std::min(low, x), high = std::max(high, x);
  }
  return known > all / 2 ? std::clamp(sum / known, low, high) : no_number;
}

/// The value of the largest amount; the smallest of several.
template <typename ValueOf>
double prevailing(std::span<const CellPart> parts, ValueOf&& value_of) {
  std::map<double, double> amounts;
  for (const CellPart& part : parts) amounts[value_of(part.cell)] += part.amount;
  const auto most = std::max_element(amounts.begin(), amounts.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  return most == amounts.end() ? 0 : most->first;
}

/// Each class by a number from 0 on, in both meshes.
struct Classes {
  std::vector<std::uint32_t> original, result;
  std::uint32_t count = 0;

  explicit Classes(const CellPairing& cells) {
    std::map<ModelRef, std::uint32_t> numbers;
    const bool none = cells.original.mesh().list(cells.original.dimension()).classes.empty() ||
                      cells.result.mesh().list(cells.result.dimension()).classes.empty();
    const auto number = [&](const Cells& list, std::vector<std::uint32_t>& into) {
      for (std::uint32_t i = 0; i < list.size(); ++i)
        into.push_back(numbers
                           .try_emplace(none ? ModelRef() : list.model(i),
                                        static_cast<std::uint32_t>(numbers.size()))
                           .first->second);
    };
    number(cells.original, original);
    number(cells.result, result);
    count = static_cast<std::uint32_t>(numbers.size());
  }
};

/// What one component of an array comes to on a class.
struct Total {
  Sum before, after;
  Sum size;     ///< of what is new: its values without their signs, by their measures
  Sum measure;  ///< likewise without the values
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool missing = false;

  [[nodiscard]] bool settled() const { return missing || !(low < high); }
  /// What a new value becomes, so that the integral is what it was. Values of 0 stay, and signs, as
  /// long as the others can make up for what is lacking.
  [[nodiscard]] double balanced(double x) const {
    const double lack = before.value() - after.value();
    if (!std::isfinite(lack)) return x;  // too large to be added up
    if (std::abs(lack) < size.value()) return x + lack / size.value() * std::abs(x);
    return measure.value() > 0 ? x + lack / measure.value() : x;
  }
};

class Balance {
 public:
  explicit Balance(const CellPairing& cells)
      : cells_(cells),
        classes_(cells),
        before_(measures(cells.original.mesh(), cells.original.dimension())),
        after_(measures(cells.result.mesh(), cells.result.dimension())) {}

  /// Twice, since the first time leaves what rounding makes of it.
  void keep_integrals(const Attribute& original, std::size_t component, Attribute& result) const {
    for (int round = 0; round < 2; ++round) {
      const std::vector<Total> totals = add_up(original, component, result);
      each(result, component, [&](std::uint32_t i, double& x) {
        const Total& total = totals[classes_.result[i]];
        if (is_new(i) && !total.settled()) x = total.balanced(x);
      });
    }
  }

 private:
  [[nodiscard]] bool is_new(std::uint32_t i) const { return cells_.same[i] == no_index; }

  template <typename Array, typename Visit>
  static void each(Array& array, std::size_t component, Visit&& visit) {
    const auto stride = static_cast<std::size_t>(array.components);
    for (std::size_t at = component, i = 0; at < array.values.size(); at += stride, ++i)
      visit(static_cast<std::uint32_t>(i), array.values[at]);
  }

  [[nodiscard]] std::vector<Total> add_up(const Attribute& original, std::size_t component,
                                          const Attribute& result) const {
    std::vector<Total> totals(classes_.count);
    each(original, component, [&](std::uint32_t i, double x) {
      Total& total = totals[classes_.original[i]];
      total.missing = total.missing || !std::isfinite(x);
      total.low = std::min(total.low, x), total.high = std::max(total.high, x);
      total.before.add(before_[i] * x);
    });
    each(result, component, [&](std::uint32_t i, double x) {
      Total& total = totals[classes_.result[i]];
      total.missing = total.missing || !std::isfinite(x);
      total.after.add(after_[i] * x);
      if (!is_new(i)) return;
      total.size.add(after_[i] * std::abs(x));
      total.measure.add(after_[i]);
    });
    return totals;
  }

  const CellPairing& cells_;
  Classes classes_;
  std::vector<double> before_, after_;
};

/// The array on the cells of the result, filled in where these are the same.
Attribute of_same(const Attribute& array, const CellPairing& cells) {
  const auto stride = static_cast<std::size_t>(array.components);
  Attribute result = like(array);
  result.values.resize(stride * cells.result.size());
  for (std::size_t i = 0; i < cells.same.size(); ++i)
    for (std::size_t k = 0; cells.same[i] != no_index && k < stride; ++k)
      result.values[stride * i + k] = array.values[stride * cells.same[i] + k];
  return result;
}

/// Writes the values of all arrays at cell i of the result.
void fill(std::span<const Attribute* const> arrays, std::uint32_t i,
          std::span<const CellPart> parts, std::vector<Attribute>& results) {
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    const Attribute& array = *arrays[a];
    const bool mixes = kind_of(array) != FieldKind::Label;
    const auto stride = static_cast<std::size_t>(array.components);
    for (std::size_t k = 0; k < stride; ++k) {
      const auto value_of = [&](std::uint32_t cell) { return array.values[stride * cell + k]; };
      results[a].values[stride * i + k] =
          mixes ? mean(parts, value_of) : prevailing(parts, value_of);
    }
    if (mixes) settle(array, std::span(results[a].values).subspan(stride * i, stride));
  }
}

/// Cells that are no longer those of the original, neighbours one after the other: what they cover
/// is then near in memory too.
std::vector<std::uint32_t> new_cells(const CellPairing& cells, int threads) {
  std::vector<BoxTree::Item> items;
  for (std::uint32_t i = 0; i < cells.result.size(); ++i)
    if (cells.same[i] == no_index) items.push_back({cells.result.centre(i), i});
  const BoxTree tree(items, threads);
  std::vector<std::uint32_t> order(tree.size());
  for (std::uint32_t n = 0; n < tree.size(); ++n) order[n] = tree.source(n);
  return order;
}

}  // namespace

std::vector<Attribute> at_cells(std::span<const Attribute* const> arrays, const CellPairing& cells,
                                int threads) {
  std::vector<Attribute> results;
  for (const Attribute* array : arrays) results.push_back(of_same(*array, cells));
  const std::vector<std::uint32_t> order = new_cells(cells, threads);
  parallel_for(order.size(), threads, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<CellPart> parts;
    for (std::size_t n = begin; n < end; ++n) {
      parts.clear();
      cells.parts.of(order[n], parts);
      fill(arrays, order[n], parts, results);
    }
  });
  const Balance balance(cells);
  for (std::size_t a = 0; a < arrays.size(); ++a)
    for (std::size_t k = 0; kind_of(*arrays[a]) == FieldKind::Conserved &&
                            k < static_cast<std::size_t>(arrays[a]->components);
         ++k)
      balance.keep_integrals(*arrays[a], k, results[a]);
  return results;
}

}  // namespace aomd::fields
