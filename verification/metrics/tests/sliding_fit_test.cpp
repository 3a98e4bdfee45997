#include "verification/metrics/sliding_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/tests/synthetic_series.hpp"

namespace slosh::sliding_fit_test {
namespace {

constexpr double forcing = two_pi / 1.25;  // [rad/s]
constexpr TimeWindow window{1, 21};
constexpr SlidingWindows sliding{3.75, 0.3125};
const std::vector<ToneRequest> forced{{"forced", forcing, false}};

TimeSeries wave() {
  return sampled([](double t) { return 0.02 * std::cos(forcing * t + 0.7); }, 0, 21);
}

TEST(SlidingFit, FollowsAnAmplitudeAndAPhaseThatDriftByKnownAmounts) {
  const auto ratio = [](double t) { return 1.1 - 0.01 * t; };
  const auto lag = [](double t) { return 0.05 + 0.01 * t; };  // [rad]
  const TimeSeries drifting = sampled(
      [&](double t) { return 0.02 * ratio(t) * std::cos(forcing * t + 0.7 - lag(t)); }, 0, 21);
  const auto fits = sliding_fit(drifting, wave(), window, sliding, forced);
  ASSERT_EQ(fits.size(), 53u);  // (20 - 3.75) / 0.3125 + 1
  EXPECT_NEAR(fits.front().middle, 2.875, 1e-12);
  EXPECT_NEAR(fits.back().middle, 19.125, 1e-9);
  for (const FittedWindow& fit : fits) {
    ASSERT_EQ(fit.modes.size(), 1u);
    // t cos(w t) contains sin(w t) / (2 w): either drift of 0.01 1/s contributes 0.001 at this w.
    EXPECT_NEAR(1 + fit.modes[0].amplitude_error.value, ratio(fit.middle), 2e-3);
    EXPECT_NEAR(fit.modes[0].phase_lag_degrees.value, 360 / two_pi * lag(fit.middle), 0.12);
  }
}

TEST(SlidingFit, OfEqualSeriesFindsNoLagAndNoError) {
  for (const FittedWindow& fit : sliding_fit(wave(), wave(), window, sliding, forced)) {
    EXPECT_NEAR(fit.modes[0].amplitude_error.value, 0, 1e-12);
    EXPECT_NEAR(fit.modes[0].phase_lag_degrees.value, 0, 1e-9);
  }
}

TEST(SlidingFit, ShowsAnotherFrequencyAsALagThatDrifts) {
  const double slower = 0.99 * forcing;
  const TimeSeries late =
      sampled([&](double t) { return 0.02 * std::cos(slower * t + 0.7); }, 0, 21);
  // The frequency is held even where the request asks to refine it.
  const auto fits = sliding_fit(late, wave(), window, sliding, {{"natural_1", forcing, true}});
  const double drift =
      fits.back().modes[0].phase_lag_degrees.value - fits.front().modes[0].phase_lag_degrees.value;
  EXPECT_NEAR(drift, 360 / two_pi * (forcing - slower) * (fits.back().middle - fits[0].middle),
              0.6);  // (forcing - slower) / (2 forcing) at either end
}

TEST(SlidingFit, KeepsATooShortWindowAndABadSeriesFromPassing) {
  EXPECT_THROW(sliding_fit(wave(), wave(), window, {20.1, 1}, forced), ComparisonError);
  EXPECT_EQ(sliding_fit(wave(), wave(), window, {20, 1}, forced).size(), 1u);
  EXPECT_THROW(sliding_fit(wave(), wave(), window, {1, 1}, forced), ComparisonError);
  TimeSeries broken = wave();
  broken.value[1500] = std::nan("");
  EXPECT_THROW(sliding_fit(broken, wave(), window, sliding, forced), ComparisonError);
}

TEST(ResolvedTones, AreThoseThatAWindowTellsFromTheOnesBefore) {
  const std::vector<ToneRequest> tones{
      {"forced", two_pi * 0.8, false}, {"near", two_pi * 0.85, true}, {"far", two_pi * 1.5, true}};
  const auto names = [&](double length) {
    std::string all;
    for (const ToneRequest& tone : resolved_tones(tones, length)) all += tone.name + " ";
    return all;
  };
  EXPECT_EQ(names(25), "forced near far ");
  EXPECT_EQ(names(3.75), "forced far ");
  EXPECT_EQ(names(1), "far ");
  EXPECT_EQ(names(0.5), "");
}

}  // namespace
}  // namespace slosh::sliding_fit_test
