#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/drawing/figure_layout.hpp"
#include "verification/tests/messages.hpp"

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
  EXPECT_TRUE(drawn_samples(Figure{}, Curve{}, 1500).empty());
}

TEST(AxisRanges, HoldTheDataAndIgnoreWhatIsNotFinite) {
  const auto [x, y] = plot_ranges(figure_of({0, 1, nan, 3, 4}, {-2, infinity, 9, 5, nan}));
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
  const auto [x, y] = plot_ranges(figure);
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
  EXPECT_LT(plot_ranges(figure).vertical.upper, 2);
  figure.equal_axes = true;
  EXPECT_LT(plot_ranges(figure).horizontal.upper, 2);
}

TEST(AxisRanges, HoldHorizontalErrorBarsOnEitherKindOfAxis) {
  Figure figure = figure_of({10, 100, 200}, {1, 2, 3});
  figure.curves[0].x_error = {2, 300, nan};
  EXPECT_GT(plot_ranges(figure).horizontal.upper, 400);
  EXPECT_LT(plot_ranges(figure).horizontal.lower, -200);
  figure.log_x = true;  // a bar that reaches below zero sets no end there
  EXPECT_GE(plot_ranges(figure).horizontal.upper, 400);
  EXPECT_EQ(plot_ranges(figure).horizontal.lower, 5);
}

TEST(AxisRanges, AreScaledToWhatIsInsideAGivenHorizontalRange) {
  Figure figure = figure_of({0, 1, 2}, {0, 1, 1000});
  figure.x_range = {0, 1.5};
  EXPECT_EQ(plot_ranges(figure).horizontal.upper, 1.5);
  EXPECT_LT(plot_ranges(figure).vertical.upper, 2);
}

TEST(AxisRanges, AreNeverEmpty) {
  for (const bool logarithmic : {false, true})
    for (const auto& y :
         {std::vector<double>{nan, nan}, std::vector<double>{3, 3}, std::vector<double>{0, 0}}) {
      Figure figure = figure_of({1, 1}, y);
      figure.log_x = figure.log_y = logarithmic;
      const auto [horizontal, vertical] = plot_ranges(figure);
      EXPECT_LT(horizontal.lower, horizontal.upper);
      EXPECT_LT(vertical.lower, vertical.upper);
      EXPECT_TRUE(!logarithmic || vertical.lower > 0);
    }
}

TEST(LogarithmicTicks, NameOneTwoAndFiveOverFewDecadesAndPowersOfTenOverMany) {
  const std::string ticks = logarithmic_ticks({2, 50}), many = logarithmic_ticks({1e-12, 1e3}),
                    most = logarithmic_ticks({1e-200, 1e250});  // the quotient overflows
  for (const char* tick : {"'2' 2", "'5' 5", "'10' 10", "'20' 20", "'50' 50"})
    EXPECT_TRUE(holds(ticks, tick));
  EXPECT_TRUE(holds(many, "'10^{-12}'"));
  EXPECT_LE(std::count(many.begin(), many.end(), ','), 8);
  EXPECT_LE(std::count(most.begin(), most.end(), ','), 9) << most;
}

}  // namespace
}  // namespace slosh::reports::axes_test
