// What an original stands on while the mesh changes: segments along a line, by hand.

#include <gtest/gtest.h>

#include "core/decimate/guard/covered_cells.h"

namespace aomd::covered_cells_test {
namespace {

const ModelRef curve(1, 1);

ModelCell piece(std::uint32_t id, double from, double to, double height = 0) {
  return {id, curve, {glm::dvec3(from, height, 0), {to, height, 0}, {to, height, 0}}};
}

using Ids = std::vector<std::uint32_t>;
using Cells = std::vector<ModelCell>;

//   original   0---------------4
//   then       0---0---2---1---4
//   then       0---0---2-2-3-1-4     what stays, 0 and 1, is known as it is now
TEST(CoveredCells, WhatStaysIsKnownAsItIsNow) {
  CoveredCells covered({piece(0, 0, 4)}, 0.1);
  EXPECT_EQ(covered.uncovered(Ids{0}, Cells{piece(0, 0, 2), piece(1, 2, 4)}), 0);
  covered.hand_over(Ids{0}, Cells{piece(0, 0, 2), piece(1, 2, 4)});
  covered.hand_over(Ids{1}, Cells{piece(1, 3, 4), piece(2, 2, 3)});
  EXPECT_EQ(covered.uncovered(Ids{2}, Cells{piece(2, 2, 3, 0.09)}), 0);
  EXPECT_NEAR(covered.uncovered(Ids{2}, Cells{piece(2, 2, 2.4)}), 0.3, 0.15) << "up to 3";
  EXPECT_EQ(covered.uncovered(Ids{3}, Cells{}), 0) << "stands for nothing";
}

TEST(CoveredCells, WhatLiesOnAnotherModelEntityCoversNothing) {
  CoveredCells covered({piece(0, 0, 4)}, 0.1);
  ModelCell other = piece(0, 0, 4);
  other.model = ModelRef(1, 2);
  EXPECT_GT(covered.uncovered(Ids{0}, Cells{other}), 1e300);
}

// What is further off than the distance may stay as far, and gets no further.
TEST(CoveredCells, AfterAChangeFromOutside) {
  CoveredCells covered({piece(0, 0, 4)}, 0.1);
  covered.attach(Cells{piece(7, 0, 2, 0.3), piece(8, 2, 4, 0.05)});
  EXPECT_EQ(covered.uncovered(Ids{7}, Cells{piece(7, 0, 2, 0.25)}), 0);
  EXPECT_NEAR(covered.uncovered(Ids{7}, Cells{piece(7, 0, 2, 0.9)}), 0.9, 1e-12);
}

}  // namespace
}  // namespace aomd::covered_cells_test
