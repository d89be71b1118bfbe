// Scales of colours: where they begin and end, their steps, maps and labels.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/view_helpers.h"

namespace aomd::scene::scales_test {
namespace {

using test::drive;

FieldScale scale_of(double low, double high) {
  FieldScale scale;
  scale.low = low, scale.high = high;
  return scale;
}

std::vector<std::string> texts(const std::vector<ScaleTick>& ticks) {
  std::vector<std::string> all;
  for (const ScaleTick& tick : ticks) all.push_back(tick.text);
  return all;
}

std::vector<float> one_to_hundred() {
  std::vector<float> values;
  for (int i = 1; i <= 100; ++i) values.push_back(static_cast<float>(i));
  return values;
}

TEST(Scale, RangesAreFixedOrFollowTheValues) {
  ScaleChoice choice;
  EXPECT_EQ(chosen_scale(scale_of(1, 100), choice, one_to_hundred()), scale_of(1, 100));
  choice.range = ScaleChoice::Range::Fixed;
  choice.low = 20, choice.high = 60;
  FieldScale scale = chosen_scale(scale_of(1, 100), choice, one_to_hundred());
  EXPECT_DOUBLE_EQ(scale.low, 20);
  EXPECT_DOUBLE_EQ(scale.high, 60);
  EXPECT_TRUE(scale.beyond);
  EXPECT_EQ(scale.color(10), scale.color(20));
  EXPECT_EQ(scale.color(99), ramp_color(1));
  EXPECT_EQ(scale.color(40), ramp_color(0.5f));
  choice.low = 0, choice.high = 100;
  EXPECT_FALSE(chosen_scale(scale_of(1, 100), choice, one_to_hundred()).beyond);
  choice.range = ScaleChoice::Range::Percentile;
  choice.percentile = 90;
  scale = chosen_scale(scale_of(1, 100), choice, one_to_hundred());
  EXPECT_DOUBLE_EQ(scale.low, 11);
  EXPECT_DOUBLE_EQ(scale.high, 90);
}

TEST(Scale, UnknownValuesAreLeftOutOfPercentiles) {
  ScaleChoice choice;
  choice.range = ScaleChoice::Range::Percentile;
  choice.percentile = 100;
  const std::vector<float> values{3, std::numeric_limits<float>::quiet_NaN(), 1};
  const FieldScale scale = chosen_scale(scale_of(0, 9), choice, values);
  EXPECT_DOUBLE_EQ(scale.low, 1);
  EXPECT_DOUBLE_EQ(scale.high, 3);
}

TEST(Scale, ALogarithmBeginsAboveZero) {
  ScaleChoice choice;
  choice.logarithmic = true;
  FieldScale scale = chosen_scale(scale_of(0, 100), choice, {0, 0.5f, 100});
  EXPECT_DOUBLE_EQ(scale.low, 0.5);
  scale = chosen_scale(scale_of(0, 100), choice, {0, 1e-9f, 100});
  EXPECT_DOUBLE_EQ(scale.low, 0.01);
  EXPECT_EQ(scale.color(1), ramp_color(0.5f));
  EXPECT_EQ(scale.color(0), plain_face_color());
}

TEST(Scale, StepsHaveOneColourEach) {
  FieldScale scale = scale_of(0, 10);
  scale.steps = 5;
  EXPECT_EQ(scale.color(0), scale.color(1.9));
  EXPECT_NE(scale.color(1.9), scale.color(2.1));
  EXPECT_EQ(scale.color(0), ramp_color(0.1f));
  EXPECT_EQ(scale.color(10), ramp_color(0.9f));
}

TEST(Scale, LabelsAreRoundNumbersBetweenTheEnds) {
  EXPECT_EQ(texts(scale_ticks(scale_of(0, 60), 6)),
            (std::vector<std::string>{"0", "10", "20", "30", "40", "50", "60"}));
  EXPECT_EQ(texts(scale_ticks(scale_of(0, 1.35), 5)),
            (std::vector<std::string>{"0", "0.5", "1", "1.35"}));
  FieldScale scale = scale_of(0.02, 3);
  scale.logarithmic = scale.beyond = true;
  EXPECT_EQ(
      texts(scale_ticks(scale, 8)),
      (std::vector<std::string>{"\u2264 0.02", "0.05", "0.1", "0.2", "0.5", "1", "2", "\u2265 3"}));
  scale = scale_of(0, 8);
  scale.steps = 4;
  EXPECT_EQ(texts(scale_ticks(scale, 4)), (std::vector<std::string>{"0", "2", "4", "6", "8"}));
  EXPECT_TRUE(scale_ticks(scale_of(2, 2), 4).empty());
  EXPECT_TRUE(scale_ticks(FieldScale(), 4).empty());
}

/// CIE 1976 lightness of an sRGB colour.
double lightness(Color color) {
  const glm::vec4 c = unpack_color(color);
  const auto linear = [](float v) {
    return v <= 0.04045f ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(Scale, LightnessRisesEvenlyAlongEachMap) {
  constexpr int parts = 20;
  for (const ColorMap map :
       {ColorMap::Viridis, ColorMap::Magma, ColorMap::Cividis, ColorMap::Grey}) {
    const double span = lightness(ramp_color(1, map)) - lightness(ramp_color(0, map));
    EXPECT_GT(span, 40);
    for (int i = 0; i < parts; ++i) {
      const double step = lightness(ramp_color(static_cast<float>(i + 1) / parts, map)) -
                          lightness(ramp_color(static_cast<float>(i) / parts, map));
      EXPECT_GT(step, 0.4 * span / parts) << static_cast<int>(map) << ", " << i;
      EXPECT_LT(step, 1.8 * span / parts) << static_cast<int>(map) << ", " << i;
    }
  }
}

TEST(ScaleCommands, StayOverRunsAndFiles) {
  Session s;
  drive(s,
        {"sample torus 20", "color quality", "range 10 40", "scale map cividis", "scale steps 6"});
  const auto expect_chosen = [&] {
    const FieldScale& scale = s.sheet().field()->scale;
    EXPECT_DOUBLE_EQ(scale.low, 10);
    EXPECT_DOUBLE_EQ(scale.high, 40);
    EXPECT_EQ(scale.map, ColorMap::Cividis);
    EXPECT_EQ(scale.steps, 6);
  };
  expect_chosen();
  drive(s, {"run"});
  expect_chosen();
  drive(s, {"sample tet-ball 2"});
  expect_chosen();
  drive(s, {"color distance"});
  EXPECT_EQ(s.sheet().field()->scale.steps, 0) << "each kind of colours has its own";
  drive(s, {"color quality", "range auto"});
  EXPECT_GT(s.sheet().field()->scale.high, 70);
}

TEST(ScaleCommands, RedrawWhatIsThere) {
  Session s;
  drive(s, {"sample torus 20", "color quality"});
  const std::vector<Corner> before(test::corners(s).begin(), test::corners(s).end());
  drive(s, {"range 50 60"});
  EXPECT_NE(test::corners(s)[0].color, before[0].color);
  drive(s, {"range auto"});
  EXPECT_EQ(test::corners(s)[0].color, before[0].color);
}

TEST(ScaleCommands, RefuseWhatMakesNoScale) {
  Session s;
  drive(s, {"sample torus 20", "color quality"});
  for (const char* line : {"range 5 5", "range 6 5", "range percentile 20", "range 1",
                           "scale steps 30", "scale map rainbow", "scale"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  drive(s, {"color classification"});
  EXPECT_THROW(execute(s, "range auto"), CommandError) << "there is no scale";
  EXPECT_EQ(s.view.scales[static_cast<std::size_t>(Coloring::Quality) - 1], ScaleChoice());
}

}  // namespace
}  // namespace aomd::scene::scales_test
