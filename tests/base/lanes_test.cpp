// Each lane against the same computed with one number, bit by bit: with what files hold, and with
// what they had better not.

#include "core/base/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "core/decimate/quality/edge_cost.h"
#include "core/mesh/geometry.h"
#include "core/model/nearest_lanes.h"
#include "core/model/triangle_tree.h"

namespace aomd::test::lanes_test {
namespace {

template <typename Number>
bool same(Number a, Number b) {
  using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (a != a && b != b);
}

template <typename Number>
std::vector<Number> awkward() {
  using Limits = std::numeric_limits<Number>;
  return {Number(0),      Number(-0.0),     Number(1),          Number(-2.5),
          Number(1) / 3,  Limits::min(),    Limits::max(),      Limits::denorm_min(),
          Number(1e-20f), Number(-1.5e20f), Limits::infinity(), Limits::quiet_NaN()};
}

template <typename Number>
void expect_lanes_like_numbers() {
  using N = LanesOf<Number>;
  for (const Number x : awkward<Number>())
    for (const Number y : awkward<Number>()) {
      const N a(x), b = N::each([&](std::size_t i) { return i == 0 ? y : Number(7); });
      EXPECT_TRUE(same((a + b)[0], x + y)) << x << " + " << y;
      EXPECT_TRUE(same((a - b)[0], x - y)) << x << " - " << y;
      EXPECT_TRUE(same((a * b)[0], x * y)) << x << " * " << y;
      EXPECT_TRUE(same((a / b)[0], x / y)) << x << " / " << y;
      EXPECT_TRUE(same((a * b)[N::count - 1], x * 7)) << x;
      EXPECT_EQ((a < b)[0] != 0, x < y) << x << " < " << y;
      EXPECT_EQ((a <= b)[0] != 0, x <= y) << x << " <= " << y;
      EXPECT_EQ((a > b)[0] != 0, x > y) << x << " > " << y;
      EXPECT_EQ((a >= b)[0] != 0, x >= y) << x << " >= " << y;
      EXPECT_EQ((a == b)[0] != 0, x == y) << x << " == " << y;
      EXPECT_TRUE(same(select(a < b, a, b)[0], select(x < y, x, y))) << x << " or " << y;
      EXPECT_TRUE(same((-a)[0], -x)) << x;
    }
  EXPECT_EQ(sqrt(N(Number(2)))[1], std::sqrt(Number(2)));
  EXPECT_EQ(abs(N(Number(-2)))[1], Number(2));
}

TEST(LanesTest, LikeNumbers) {
  expect_lanes_like_numbers<float>();
  expect_lanes_like_numbers<double>();
}

// Places on a coarse grid meet corners, sides, planes and faces without area often.
class Places {
 public:
  glm::dvec3 next() {
    const auto number = [&] { return 0.25 * static_cast<double>(random_() % 9) + jitter(); };
    const double x = number(), y = number();
    return {x, y, number()};
  }

 private:
  double jitter() { return random_() % 2 == 0 ? 0 : 1e-3 * static_cast<double>(random_() % 1000); }

  std::mt19937 random_{5};
};

TEST(LanesTest, NearestPlacesOnTwoTriangles) {
  Places places;
  for (int i = 0; i < 20000; ++i) {
    std::array<std::array<glm::dvec3, 3>, 2> t;
    for (auto& triangle : t)
      for (glm::dvec3& corner : triangle) corner = places.next();
    const glm::dvec3 p = places.next();
    TwoPoints at;
    const DoubleLanes both =
        nearest_barycentric(TwoPoints(p), two_points(t[0][0], t[1][0]),
                            two_points(t[0][1], t[1][1]), two_points(t[0][2], t[1][2]), at);
    for (std::size_t k = 0; k < 2; ++k) {
      glm::dvec3 alone;
      const double d2 = nearest_barycentric(p, t[k][0], t[k][1], t[k][2], alone);
      ASSERT_TRUE(same(both[k], d2)) << i;
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(same(at[c][k], alone[c])) << i;
    }
  }
}

TEST(LanesTest, AnglesOfTwoTriangles) {
  Places places;
  const TurnLimit narrow(30), wide(120);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 a = places.next(), b = places.next(), p = places.next(), q = places.next(),
                     r = places.next();
    const TwoPoints first = two_points(a, b);
    const TwoPoints after = area_normal(first, TwoPoints(p), TwoPoints(q));
    const TwoPoints before = area_normal(TwoPoints(r), TwoPoints(p), TwoPoints(q));
    const DoubleLanes cosine = smallest_angle_cosine(first, TwoPoints(p), TwoPoints(q));
    const std::array alone{a, b};
    for (std::size_t k = 0; k < 2; ++k) {
      const glm::dvec3 n = area_normal(alone[k], p, q), m = area_normal(r, p, q);
      ASSERT_TRUE(same(cosine[k], smallest_angle_cosine(alone[k], p, q))) << i;
      ASSERT_EQ(has_area(first, TwoPoints(p), TwoPoints(q), after)[k] == 0,
                is_flat(alone[k], p, q, n));
      for (const TurnLimit& limit : {narrow, wide})
        ASSERT_EQ(limit.allows(before, after)[k] != 0, limit.allows(m, n)) << i;
    }
  }
}

TEST(LanesTest, CostsOfFourEdges) {
  Places places;
  std::array<EdgeView<float>, Lanes::count> edges;
  CostRules rules;
  rules.edge_weight = 1e-3f;
  for (int i = 0; i < 5000; ++i) {
    rules.cubes = i % 2 == 0;
    for (EdgeView<float>& e : edges) {
      e = {};
      for (int plane = 0; plane < i % 4; ++plane)
        e.quadric.add_plane(glm::vec3(places.next()), float(places.next().x), 0.5f);
      e.along = glm::vec3(places.next());
      e.length2 = glm::dot(e.along, e.along);
      e.area = float(places.next().x);
    }
    const auto lanes = [&](auto&& number) {
      return Lanes::each([&](std::size_t k) { return number(edges[k]); });
    };
    EdgeView<Lanes> four;
    four.quadric = QuadricOf<Lanes>::of_each([&](std::size_t k) { return edges[k].quadric; });
    four.along = {lanes([](const auto& e) { return e.along.x; }),
                  lanes([](const auto& e) { return e.along.y; }),
                  lanes([](const auto& e) { return e.along.z; })};
    four.length2 = lanes([](const auto& e) { return e.length2; });
    four.area = lanes([](const auto& e) { return e.area; });
    const Lanes costs = cost_at(rules, four, place_of_least(four));
    for (std::size_t k = 0; k < edges.size(); ++k)
      ASSERT_TRUE(same(costs[k], cost_at(rules, edges[k], place_of_least(edges[k])))) << i;
  }
}

}  // namespace
}  // namespace aomd::test::lanes_test
