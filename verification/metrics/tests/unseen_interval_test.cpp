#include "verification/metrics/unseen_interval.hpp"

#include <gtest/gtest.h>

#include "verification/metrics/comparison.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::unseen_interval_test {
namespace {

constexpr TimeWindow window{0, 20};

double pressure(double t) { return 3000 + 500 * std::sin(4 * t); }  // [Pa]

TimeSeries without(TimeSeries series, double begin, double end) {
  TimeSeries left{series.name, series.unit, {}, {}};
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (series.time[i] > begin && series.time[i] < end) continue;
    left.time.push_back(series.time[i]);
    left.value.push_back(series.value[i]);
  }
  return left;
}

TimeSeries with_impact_at(double time) {
  return sampled(
      [time](double t) { return pressure(t) + 5000 * std::exp(-std::pow((t - time) / 0.004, 2)); },
      0, 20, 0.001);
}

std::optional<UnseenInterval> unseen(const TimeSeries& candidate, const TimeSeries& reference) {
  return unseen_interval(candidate, common_samples(candidate, reference));
}

TEST(UnseenInterval, TellsAPeakBetweenTheSamplesOfAReferenceAndWhatADropoutMayHide) {
  const auto fine = sampled(pressure, 0, 20, 0.001);
  const struct {
    TimeSeries candidate, reference;
    double begin, end, departure, tolerance;
  } told[] = {{with_impact_at(10.05), sampled(pressure, 0, 20, 0.1), 10, 10.1, 5000, 10},
              {with_impact_at(9.2), without(fine, 9, 9.5), 9, 9.5, 5000, 200},
              {fine, without(fine, 9, 9.1), 9, 9.1, 0, 5}};
  for (const auto& [candidate, reference, begin, end, departure, tolerance] : told) {
    const auto found = compare(candidate, reference, window, {}).unseen;
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->begin, begin, 1e-9);
    EXPECT_NEAR(found->end, end, 1e-9);
    EXPECT_NEAR(found->departure, departure, tolerance);
  }
}

TEST(UnseenInterval, TellsPowerBeyondTheNyquistFrequencyOfTheReference) {
  const auto ringing =
      sampled([](double t) { return pressure(t) + 100 * std::sin(two_pi * 37 * t); }, 0, 20, 0.001);
  EXPECT_TRUE(unseen(ringing, sampled(pressure, 0, 20, 0.05)));
  EXPECT_FALSE(unseen(ringing, sampled(pressure, 0, 20, 0.001)));
}

TEST(UnseenInterval, IsNotThereWhereTheReferenceResolvesTheCandidate) {
  const auto impact = with_impact_at(10.05);
  EXPECT_FALSE(unseen(impact, impact));
  EXPECT_FALSE(unseen(impact, sampled(pressure, 0, 20, 0.0005)));
  EXPECT_FALSE(unseen(sampled(pressure, 0, 20, 0.001), sampled(pressure, 0, 20, 0.1)));
  EXPECT_FALSE(unseen(sampled(pressure, 0, 20, 0.1), sampled(pressure, 0, 20, 0.001)));
  EXPECT_FALSE(unseen(with_noise(impact, 100, 0, 1), with_noise(impact, 100, 0, 2)));
}

// Of a candidate that prints finer than the reference, the largest of many samples of its noise.
TEST(UnseenInterval, IsNotThatOfTheCandidatesNoise) {
  const auto reference = sampled(pressure, 0, 20, 0.02);
  for (const double interval : {0.0002, 0.001, 0.01})
    for (const double noise : {5.0, 10.0, 20.0}) {
      const auto noisy = with_noise(sampled(pressure, 0, 20, interval), noise, 0, 3);
      EXPECT_FALSE(unseen(noisy, reference)) << interval << " " << noise;
    }
  EXPECT_TRUE(unseen(with_noise(with_impact_at(10.05), 10, 0, 1), sampled(pressure, 0, 20, 0.1)));
}

// A digitised curve of few points is compared where it has them, with nothing made up between.
TEST(SamplesOfBoth, AreTheReferencesWhereThatDoesNotResolveItself) {
  const auto sparse = sampled(pressure, 0, 20, 0.5), fine = sampled(pressure, 0, 20, 0.001);
  EXPECT_EQ(samples_of_both(fine, common_samples(fine, sparse)).time, sparse.time);
  const auto well = sampled(pressure, 0, 20, 0.03);
  const CommonSamples both = samples_of_both(fine, common_samples(fine, well));
  EXPECT_GE(both.time.size(), fine.time.size() - 10);
  for (std::size_t i = 0; i < both.time.size(); ++i)
    EXPECT_NEAR(both.reference[i], pressure(both.time[i]), 0.5);
}

// What a record lost is no error of the candidate: no curve is made up in a dropout.
TEST(SamplesOfBoth, AreNotInsideADropoutOfTheReference) {
  const auto fine = sampled(pressure, 0, 20, 0.001);
  for (const double end : {9.0195, 9.5005, 10.1005, 10.1015}) {
    const auto dropped = without(sampled(pressure, 0, 20, 0.002), 9.0005, end);
    for (const double time : samples_of_both(fine, common_samples(fine, dropped)).time)
      EXPECT_FALSE(time > 9.0005 && time < end) << time;
    const Comparison same = compare(fine, dropped, window, {});
    EXPECT_LT(same.normalised_rms.value, 1e-4) << end;
    EXPECT_LT(same.maximum_residual, 1) << end;
  }
}

// What a candidate lost is judged by no curve that is made up across it, and told.
TEST(UnseenInterval, TellsADropoutOfTheCandidateAndLeavesItOut) {
  const auto reference = sampled(pressure, 0, 20, 0.002);
  for (const double end : {9.5005, 10.1005, 10.8}) {
    const auto dropped = without(sampled(pressure, 0, 20, 0.001), 9.0005, end);
    const Comparison same = compare(dropped, reference, window, {});
    ASSERT_TRUE(same.unseen) << end;
    EXPECT_TRUE(same.unseen->in_candidate);
    EXPECT_NEAR(same.unseen->begin, 9.0, 1e-9);
    EXPECT_NEAR(same.unseen->end, end, 1e-3);
    EXPECT_GT(same.unseen->departure, 10);
    EXPECT_LT(same.normalised_rms.value, 1e-4) << end;
    EXPECT_LT(same.maximum_residual, 1) << end;
    EXPECT_NEAR(same.candidate_wave.mean, same.reference_wave.mean, 0.1) << end;
  }
}

TEST(UnseenInterval, TellsADropoutOfTheCandidateAtTheEndOfTheWindowAndInASparseReference) {
  const auto dropped = without(sampled(pressure, -2, 22, 0.001), -1, 1.5);
  const Comparison begin = compare(dropped, sampled(pressure, 0, 20, 0.01), window, {});
  ASSERT_TRUE(begin.unseen);
  EXPECT_NEAR(begin.unseen->end, 1.5, 1e-9);
  EXPECT_LT(begin.normalised_rms.value, 1e-4);
  const Comparison sparse = compare(dropped, sampled(pressure, 0.6, 19.9, 0.7), {0.6, 19.2}, {});
  ASSERT_TRUE(sparse.unseen);
  EXPECT_LT(sparse.normalised_rms.value, 1e-4);
  const auto ends = without(sampled(pressure, 0, 20, 0.001), 0.5, 19.6);
  EXPECT_THROW(compare(ends, sampled(pressure, 0.6, 17, 4), window, {}), ComparisonError);
}

// The rest is judged as before, and a candidate of few samples is judged by its curve.
TEST(UnseenInterval, OfTheCandidateHidesNoErrorElsewhere) {
  const auto reference = sampled(pressure, 0, 20, 0.002);
  const auto scaled = without(
      sampled([](double t) { return 3000 + 1.1 * (pressure(t) - 3000); }, 0, 20, 0.001), 9, 10);
  EXPECT_NEAR(compare(scaled, reference, window, {}).normalised_rms.value, 0.1, 0.005);
  const auto few = without(sampled(pressure, 0, 20, 0.1), 9.05, 9.85);
  EXPECT_FALSE(unseen(few, reference));
  EXPECT_GT(compare(few, reference, window, {}).maximum_residual, 50);
}

// 8.57 - 8.54 is more than 0.03 by the rounding of both.
TEST(LongestGap, OfTwoLostSamplesIsNotLongerThanThreeIntervalsByRounding) {
  for (const double lost : {2.0, 4.0, 5.0, 7.0, 8.54}) {
    TimeSeries series{"p", "m", {}, {}};
    for (int i = 0; i <= 1000; ++i)
      if (const double time = i / 100.0; time < lost + 0.005 || time > lost + 0.025) {
        series.time.push_back(time);
        series.value.push_back(std::sin(3 * time));
      }
    EXPECT_FALSE(longest_gap(series, window, 0.01)) << lost;
    std::erase_if(series.time, [&](double time) { return std::abs(time - lost - 0.03) < 0.005; });
    EXPECT_TRUE(longest_gap(series, window, 0.01)) << lost;
  }
}

TEST(CoveredShare, LeavesOutGapsHolesAtTheEdgesAndWhatIsBeyondTheSeries) {
  const auto whole = sampled(pressure, -1, 21, 0.01);
  const TimeWindow all{0, 20};
  EXPECT_EQ(covered_share(whole, all), 1);
  EXPECT_EQ(covered_share(sampled(pressure, 0, 19.99, 0.01), all), 1);
  EXPECT_NEAR(covered_share(without(whole, 2, 18), all), 0.2, 0.002);
  EXPECT_NEAR(covered_share(without(whole, -0.5, 5), all), 0.75, 0.002) << "at the begin";
  EXPECT_NEAR(covered_share(without(whole, 13, 20.5), all), 0.65, 0.002) << "at the end";
  EXPECT_NEAR(covered_share(sampled(pressure, 0, 6, 0.01), all), 0.3, 0.002);
  TimeSeries bursts = whole;
  for (int i = 0; i < 4; ++i) bursts = without(bursts, 5 * i + 0.5, 5 * i + 4.9);
  EXPECT_NEAR(covered_share(bursts, all), 0.12, 0.01);
  EXPECT_EQ(covered_share(sampled(pressure, 0, 20, 2.5), all), 1) << "few, but no gap";
}

}  // namespace
}  // namespace slosh::unseen_interval_test
