#include "verification/metrics/quantile_band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/metrics/comparison.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::quantile_band_test {
namespace {

constexpr TimeWindow window{0, 10};

double median(double t) { return 10 * std::sin(t); }

// The median and what is added to it.
TimeSeries beside(const std::function<double(double)>& further, double interval = 0.01) {
  return sampled([&](double t) { return median(t) + further(t); }, 0, 10, interval);
}

TimeSeries moved(double by) {
  return beside([by](double) { return by; });
}

const QuantileBand band{moved(-1), moved(2)};

Comparison against_band(const TimeSeries& candidate) {
  PreparedSeries reference("reference", moved(0), window, {});
  reference.add_band(band);
  return compare(PreparedSeries("candidate", candidate, window, {}), reference);
}

double outside(const TimeSeries& candidate, TimeWindow part = window) {
  return share_outside(against_band(candidate).margin.value(), part);
}

TEST(QuantileBand, HoldsTheMedianAndAllUpToItsEdgesOfAReferenceThatHasOne) {
  for (const double by : {0.0, -0.99, 1.99}) EXPECT_EQ(outside(moved(by)), 0) << by;
  EXPECT_EQ(outside(moved(2.5)), 1);
  EXPECT_FALSE(compare(moved(1), moved(0), window, {}).margin.has_value());
}

double ramp(double t) { return 0.5 * t; }

TEST(QuantileBand, CountsTheTimeOutsideAndNotTheSamples) {
  // It crosses the upper edge at 4 s and is outside for six tenths of the time, between samples
  // too.
  EXPECT_NEAR(outside(beside(ramp)), 0.6, 1e-9);
  EXPECT_NEAR(outside(beside(ramp, 0.03)), 0.6, 1e-3);
}

// A band about straight lines, sampled once a second.
TimeSeries margin_of(const std::vector<double>& candidate, const std::vector<double>& lower,
                     const std::vector<double>& upper) {
  std::vector<double> time;
  for (std::size_t i = 0; i < candidate.size(); ++i) time.push_back(static_cast<double>(i));
  return band_margin(time, candidate, {{"lower", "Pa", time, lower}, {"upper", "Pa", time, upper}});
}

TEST(QuantileBand, HoldsAFrontThatCrossesItBetweenTwoSamplesForThePartOfThatTimeInside) {
  // The front rises from -1 to 3 and is within 0 and 1 from 0.25 to 0.5 s.
  const TimeSeries rising = margin_of({-1, 3, 3}, {0, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(share_outside(rising, {0, 1}), 0.75, 1e-12);
  EXPECT_NEAR(share_outside(rising, {0, 2}), 1.75 / 2, 1e-12);
  EXPECT_NEAR(share_outside(rising, {0.25, 0.5}), 0, 1e-12);
  EXPECT_NEAR(share_outside(rising, {0, 0.4}), 0.25 / 0.4, 1e-12);
  EXPECT_NEAR(share_outside(margin_of({3, -1}, {0, 0}, {1, 1}), {0, 1}), 0.75, 1e-12);
  // The edges move too: the front meets the lower one at 0.25 s and the upper one at 0.6 s.
  EXPECT_NEAR(share_outside(margin_of({-1, 4}, {0, 1}, {2, 2}), {0, 1}), 0.65, 1e-12);
  // Of 10 s the candidate is inside for three tenths of one interval.
  const TimeSeries jump = beside([](double t) { return t < 5 ? -5 : 5; });
  EXPECT_NEAR(outside(jump), 1 - 0.3 * 0.01 / 10, 1e-9);
  // The candidate falls from just below the upper edge and crosses the lower one at 9 / 19 s.
  const TimeSeries falling = margin_of({0.9, -1}, {0, 0}, {1, 1});
  EXPECT_NEAR(share_outside(falling, {0, 1}), 10.0 / 19, 1e-12);
}

TEST(QuantileBand, CoversAWindowThatEndsWithinOneIntervalThoughTheMarginHasCorners) {
  const TimeSeries margin = margin_of({-1, 3, 3, 3}, {0, 0, 0, 0}, {1, 1, 1, 1});
  EXPECT_NEAR(share_outside(margin, {0, 3.99}), 2.75 / 3, 1e-12);
  EXPECT_THROW(share_outside(margin, {0, 4.01}), ComparisonError);
}

TEST(QuantileBand, IsTakenOverAPartOfTheWindow) {
  EXPECT_EQ(outside(beside(ramp), {1, 3.995}), 0);
  EXPECT_NEAR(outside(beside(ramp), {3.005, 5.005}), 1.005 / 2, 1e-9);
  EXPECT_THROW(outside(beside(ramp), {4, 11}), ComparisonError);
  EXPECT_THROW(outside(beside(ramp), {4, 4}), ComparisonError);
}

TEST(QuantileBand, NeverHoldsANumberThatIsNone) {
  TimeSeries margin{"margin", "Pa", {0, 1, 2, 3}, {1, 1, not_a_number, 1}};
  EXPECT_TRUE(std::isnan(share_outside(margin, {0, 3})));
  EXPECT_EQ(share_outside(margin, {0, 1}), 0);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double none : {not_a_number, infinite, -infinite})
    EXPECT_TRUE(std::isnan(share_outside(margin_of({-1, none, 3}, {0, 0, 0}, {1, 1, 1}), {0, 2})))
        << none;
}

}  // namespace
}  // namespace slosh::quantile_band_test
