// The search for the coarsest result within an error.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/decimate/error_search.h"

namespace aomd::error_search_test {
namespace {

struct Found {
  std::optional<double> guard;
  double error = 0;
  int tries = 0;
};

std::uint32_t faces_of(double guard) { return 4 + static_cast<std::uint32_t>(1000 / guard); }

// What it finds where a run with a guard has the error `of(guard)`.
Found search(double limit, const std::function<double(double)>& of,
             const std::function<std::uint32_t(double)>& faces = faces_of) {
  ErrorSearch search(limit);
  while (const auto guard = search.next()) {
    EXPECT_GT(*guard, 0);
    search.tried(*guard, faces(*guard), of(*guard));
  }
  Found found{search.best(), 0, search.tries()};
  if (found.guard) found.error = of(*found.guard);
  return found;
}

TEST(ErrorSearchTest, MeetsTheLimitWithinThreePercentInFewRuns) {
  for (const double factor : {0.1, 0.7, 1.0, 1.02, 1.8, 9.0})
    for (const double limit : {1e-6, 0.3, 40.0}) {
      const Found found = search(limit, [factor](double guard) { return factor * guard; });
      ASSERT_TRUE(found.guard) << factor;
      EXPECT_LE(found.error, limit);
      EXPECT_GE(found.error, 0.97 * limit);
      EXPECT_LE(found.tries, 5) << factor;
    }
}

TEST(ErrorSearchTest, MeetsItWhereErrorsGrowInAnotherWay) {
  for (const double power : {0.5, 1.5, 2.0}) {
    const auto of = [power](double guard) { return std::pow(guard, power); };
    const Found found = search(1.7, of);
    ASSERT_TRUE(found.guard) << power;
    EXPECT_LE(found.error, 1.7);
    EXPECT_GE(found.error, 0.97 * 1.7) << power;
  }
}

TEST(ErrorSearchTest, KeepsToTheLimitWhereErrorsJump) {
  for (std::uint32_t seed = 1; seed < 20; ++seed) {
    const auto of = [seed](double guard) {
      const auto cell = static_cast<std::uint32_t>(guard * 1e6);
      return guard * (1 + 0.2 * ((cell * 2654435761u + seed * 40503u) % 1000) / 1000.0);
    };
    const Found found = search(0.7, of);
    ASSERT_TRUE(found.guard);
    EXPECT_LE(found.error, 0.7);
    EXPECT_GE(found.error, 0.8 * 0.7);
    EXPECT_LE(found.tries, 12);
  }
}

TEST(ErrorSearchTest, StopsWhereSomethingElseStopsTheRuns) {
  const Found found = search(
      5, [](double) { return 0.1; }, [](double) { return 20u; });
  EXPECT_EQ(found.guard, 0.95 * 5);
  EXPECT_EQ(found.tries, 2);
}

TEST(ErrorSearchTest, FindsNothingWhereNothingFits) {
  const Found found = search(1, [](double) { return 2.0; });
  EXPECT_FALSE(found.guard);
  EXPECT_EQ(found.tries, 12);
  EXPECT_FALSE(search(1, [](double) { return std::nan(""); }).guard);
}

}  // namespace
}  // namespace aomd::error_search_test
