#include "verification/metrics/quantile_band.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/metrics/comparison.hpp"

namespace slosh::quantile_band_test {
namespace {

constexpr TimeWindow window{0, 10};

template <class Function>
TimeSeries sampled(const Function& value, double interval = 0.01) {
  TimeSeries series{"wall_pressure@P", "Pa", {}, {}};
  for (int i = 0; i * interval <= 10 + 1e-9; ++i) {
    series.time.push_back(i * interval);
    series.value.push_back(value(series.time.back()));
  }
  return series;
}

double median(double t) { return 10 * std::sin(t); }

const QuantileBand band{sampled([](double t) { return median(t) - 1; }),
                        sampled([](double t) { return median(t) + 2; })};

Comparison against_band(const TimeSeries& candidate) {
  PreparedSeries reference("reference", sampled(median), window, {});
  reference.add_band(band);
  return compare(PreparedSeries("candidate", candidate, window, {}), reference);
}

double outside(const TimeSeries& candidate, TimeWindow part = window) {
  return share_outside(against_band(candidate).margin.value(), part);
}

double excursion(const TimeSeries& candidate, TimeWindow part = window) {
  return largest_excursion(against_band(candidate).margin.value(), part);
}

TimeSeries moved(double by) {
  return sampled([by](double t) { return median(t) + by; });
}

TEST(QuantileBand, HoldsTheMedianAndAllUpToItsEdges) {
  for (const double by : {0.0, -0.99, 1.99}) {
    EXPECT_EQ(outside(moved(by)), 0) << by;
    EXPECT_EQ(excursion(moved(by)), 0) << by;
  }
}

TEST(QuantileBand, MeasuresTheDistanceToTheNearerEdge) {
  EXPECT_NEAR(excursion(moved(2.5)), 0.5, 1e-9);
  EXPECT_NEAR(excursion(moved(-4)), 3, 1e-9);
  EXPECT_EQ(outside(moved(2.5)), 1);
}

TEST(QuantileBand, CountsTheTimeOutsideAndNotTheSamples) {
  // It crosses the upper edge at 4 s and is outside for six tenths of the time, between samples
  // too.
  const auto ramp = [](double t) { return median(t) + 0.5 * t; };
  EXPECT_NEAR(outside(sampled(ramp)), 0.6, 1e-9);
  EXPECT_NEAR(outside(sampled(ramp, 0.03)), 0.6, 1e-3);
  EXPECT_NEAR(excursion(sampled(ramp)), 3, 1e-9);
}

TEST(QuantileBand, IsTakenOverAPartOfTheWindow) {
  const TimeSeries ramp = sampled([](double t) { return median(t) + 0.5 * t; });
  EXPECT_EQ(outside(ramp, {1, 3.995}), 0);
  EXPECT_NEAR(outside(ramp, {3.005, 5.005}), 1.005 / 2, 1e-9);
  EXPECT_NEAR(excursion(ramp, {3, 6.005}), 0.5 * 6.005 - 2, 1e-9);
  EXPECT_THROW(outside(ramp, {4, 11}), ComparisonError);
  EXPECT_THROW(outside(ramp, {4, 4}), ComparisonError);
}

TEST(QuantileBand, NeverHoldsANumberThatIsNone) {
  TimeSeries margin{"margin", "Pa", {0, 1, 2, 3}, {1, 1, not_a_number, 1}};
  EXPECT_TRUE(std::isnan(share_outside(margin, {0, 3})));
  EXPECT_TRUE(std::isnan(largest_excursion(margin, {0, 3})));
  EXPECT_EQ(share_outside(margin, {0, 1}), 0);
}

TEST(QuantileBand, IsOfAReferenceThatHasOne) {
  EXPECT_FALSE(compare(moved(1), sampled(median), window, {}).margin.has_value());
}

}  // namespace
}  // namespace slosh::quantile_band_test
