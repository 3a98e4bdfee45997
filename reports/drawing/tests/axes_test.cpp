#include "reports/drawing/axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh::reports::axes_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Figure figure_of(std::vector<double> x, std::vector<double> y) {
  Figure figure;
  figure.curves.push_back({"curve", std::move(x), std::move(y), {}});
  return figure;
}

Curve long_curve(std::size_t samples) {
  Curve curve;
  for (std::size_t i = 0; i < samples; ++i) {
    curve.x.push_back(static_cast<double>(i));
    curve.y.push_back(std::sin(0.01 * static_cast<double>(i)));
  }
  return curve;
}

TEST(DrawnSamples, OfAShortCurveAreAllOfThem) {
  const Curve curve = long_curve(100);
  const auto drawn = drawn_samples(Figure{}, curve, 1500);
  ASSERT_EQ(drawn.size(), 100u);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(drawn[i], i);
}

TEST(DrawnSamples, OfALongCurveKeepItsExtremesAndEndsWithinTheLimit) {
  Curve curve = long_curve(100'000);
  curve.y[31'417] = 5.0;  // spikes of one sample
  curve.y[77'777] = -7.0;
  const auto drawn = drawn_samples(Figure{}, curve, 1500);
  EXPECT_LE(drawn.size(), 1500u);
  EXPECT_GT(drawn.size(), 900u);
  for (const std::size_t kept : {0, 31'417, 77'777, 99'999}) {
    EXPECT_NE(std::find(drawn.begin(), drawn.end(), std::optional(kept)), drawn.end()) << kept;
  }
  EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
}

TEST(DrawnSamples, KeepAGapOfOneSampleInALongCurve) {
  Curve curve = long_curve(100'000);
  curve.y[50'000] = nan;
  const auto drawn = drawn_samples(Figure{}, curve, 1500);
  EXPECT_LE(drawn.size(), 1500u);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), std::nullopt), 1);
}

TEST(DrawnSamples, LeaveGapsForWhatALogarithmicAxisCannotShow) {
  Figure figure = figure_of({1, 2, 3}, {1, -1, infinity});
  figure.log_y = true;
  const auto drawn = drawn_samples(figure, figure.curves[0], 1500);
  EXPECT_EQ(drawn, (std::vector<std::optional<std::size_t>>{0, std::nullopt, std::nullopt}));
}

TEST(DrawnSamples, OfAnEmptyCurveAreNone) {
  EXPECT_TRUE(drawn_samples(Figure{}, Curve{}, 1500).empty());
}

TEST(AxisRanges, HoldTheDataAndIgnoreWhatIsNotFinite) {
  const Figure figure = figure_of({0, 1, nan, 3, 4}, {-2, infinity, 9, 5, nan});
  const AxisRange x = horizontal_range(figure), y = vertical_range(figure, x);
  EXPECT_EQ(x.lower, 0);
  EXPECT_EQ(x.upper, 3);
  EXPECT_LT(y.lower, -2);
  EXPECT_GT(y.upper, 5);
  EXPECT_LT(y.upper, 6);
}

TEST(AxisRanges, HoldBandsMarkersAndErrorBars) {
  Figure figure = figure_of({0, 1}, {0, 1});
  figure.curves[0].y_error = {3, 0};
  figure.bands = {{"tolerance", -infinity, 8}};
  figure.markers = {{"predicted", 2}};
  const AxisRange x = horizontal_range(figure), y = vertical_range(figure, x);
  EXPECT_GE(x.upper, 2);
  EXPECT_GT(y.upper, 8);
  EXPECT_LT(y.lower, -3);
}

TEST(AxisRanges, LeaveOutACurveThatSetsNoScaleWithItsBand) {
  Figure figure = figure_of({0, 1}, {0, 1});
  figure.curves.push_back({"bad", {0, 5}, {0, 100}, {}, Curve::Style::line});
  figure.curves[1].look = Look{false, 3, 0};
  figure.curves[1].sets_scale = false;
  figure.bands = {{"tolerance", -60, 60, Look{false, 3, 0}}};
  EXPECT_LT(vertical_range(figure, horizontal_range(figure)).upper, 2);
  figure.equal_axes = true;
  EXPECT_LT(horizontal_range(figure).upper, 2);
}

TEST(AxisRanges, HoldHorizontalErrorBarsOnEitherKindOfAxis) {
  Figure figure = figure_of({10, 100, 200}, {1, 2, 3});
  figure.curves[0].x_error = {2, 300, nan};
  EXPECT_GT(horizontal_range(figure).upper, 400);
  EXPECT_LT(horizontal_range(figure).lower, -200);
  figure.log_x = true;  // a bar that reaches below zero sets no end there
  EXPECT_GE(horizontal_range(figure).upper, 400);
  EXPECT_EQ(horizontal_range(figure).lower, 5);
}

TEST(AxisRanges, AreScaledToWhatIsInsideAGivenHorizontalRange) {
  Figure figure = figure_of({0, 1, 2}, {0, 1, 1000});
  figure.x_range = {0, 1.5};
  const AxisRange x = horizontal_range(figure);
  EXPECT_EQ(x.upper, 1.5);
  EXPECT_LT(vertical_range(figure, x).upper, 2);
}

TEST(AxisRanges, AreNeverEmpty) {
  for (const bool logarithmic : {false, true}) {
    for (const auto& y :
         {std::vector<double>{nan, nan}, std::vector<double>{3, 3}, std::vector<double>{0, 0}}) {
      Figure figure = figure_of({1, 1}, y);
      figure.log_x = figure.log_y = logarithmic;
      const AxisRange x = horizontal_range(figure), range = vertical_range(figure, x);
      EXPECT_LT(x.lower, x.upper);
      EXPECT_LT(range.lower, range.upper);
      EXPECT_TRUE(!logarithmic || range.lower > 0);
    }
  }
}

TEST(LogarithmicTicks, NameOneTwoAndFiveOverFewDecades) {
  const std::string ticks = logarithmic_ticks({2, 50});
  for (const char* tick : {"'2' 2", "'5' 5", "'10' 10", "'20' 20", "'50' 50"}) {
    EXPECT_NE(ticks.find(tick), std::string::npos) << tick << " in " << ticks;
  }
}

TEST(LogarithmicTicks, NamePowersOfTenOverManyDecades) {
  const std::string ticks = logarithmic_ticks({1e-12, 1e3});
  EXPECT_NE(ticks.find("'10^{-12}'"), std::string::npos) << ticks;
  EXPECT_LE(std::count(ticks.begin(), ticks.end(), ','), 8);
}

TEST(LogarithmicTicks, AreFewWhereTheQuotientOfTheEndsIsBeyondTheLargestNumber) {
  const std::string ticks = logarithmic_ticks({1e-200, 1e250});
  EXPECT_LE(std::count(ticks.begin(), ticks.end(), ','), 9) << ticks;
}

}  // namespace
}  // namespace slosh::reports::axes_test
