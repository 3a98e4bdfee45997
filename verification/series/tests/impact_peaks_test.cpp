#include "verification/series/impact_peaks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "verification/tests/messages.hpp"
#include "verification/tests/published_records.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::impact_peaks_test {
namespace {

constexpr double period = 1.636;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

struct Impact {
  double time, height;  // [s], [Pa]
};

// The impacts rise within 10 ms and decay within some 50 ms, on a plateau that decays slowly.
TimeSeries pressure_of(const std::vector<Impact>& impacts, double end = 9) {
  const auto pressure = [&](double t) {
    double sum = 0;
    for (const auto& [time, height] : impacts) {
      const double s = t - time;
      if (s < -0.01) continue;
      sum += s < 0 ? height * (1 + s / 0.01)
                   : (height - 670) * std::exp(-s / 0.05) + 670 * std::exp(-s / 0.5);
    }
    return sum;
  };
  return sampled(pressure, 0, end, 0.001);
}

TEST(ImpactWindows, FollowOneAnotherByAPeriodOrLieAboutTheExpectedTimes) {
  const auto following = impact_windows(1.6, period, 3);
  ASSERT_EQ(following.size(), 3U);
  EXPECT_DOUBLE_EQ(following[0].begin, 1.6);
  EXPECT_DOUBLE_EQ(following[0].end, 3.236);
  EXPECT_DOUBLE_EQ(following[2].begin, 4.872);
  EXPECT_DOUBLE_EQ(following[2].end, 6.508);
  const auto about = impact_windows({2.375, 4.073}, period);
  ASSERT_EQ(about.size(), 2U);
  EXPECT_DOUBLE_EQ(about[1].begin, 4.073 - 0.409);
  EXPECT_DOUBLE_EQ(about[1].end, 4.073 + 0.409);
}

TEST(ImpactThreshold, IsAQuarterOfTheLowestPublishedMeanPeak) {
  EXPECT_DOUBLE_EQ(impact_threshold({3710, 4816, 4691, 4643}), 927.5);
  EXPECT_THROW(impact_threshold({}), ComparisonError);
}

TEST(ImpactPeaks, AreTheHighestOfEachWindow) {
  const TimeSeries pressure =
      pressure_of({{2.375, 3710}, {4.073, 4816}, {4.2, 2000}, {5.718, 4691}, {7.303, 4643}});
  for (const auto& windows :
       {impact_windows(1.6, period, 4), impact_windows({2.4, 4.0, 5.7, 7.3}, period)}) {
    const auto peaks = impact_peaks(pressure, windows, 910);
    ASSERT_EQ(peaks.size(), 4U);
    const std::vector<double> times{2.375, 4.073, 5.718, 7.303};
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(peaks[i]) << i;
      EXPECT_NEAR(peaks[i]->time, times[i], 1e-9);
    }
    EXPECT_NEAR(peaks[0]->pressure, 3710, 1e-9);
    EXPECT_NEAR(peaks[1]->pressure, 4816 + 670 * std::exp(-1.698 / 0.5), 1);
  }
}

TEST(ImpactPeaks, ReportAnImpactThatDoesNotComeAsAbsent) {
  const auto peaks = impact_peaks(pressure_of({{2.375, 3710}, {4.073, 800}, {5.718, 4691}}),
                                  impact_windows(1.6, period, 4), 910);
  EXPECT_TRUE(peaks.at(0));
  EXPECT_FALSE(peaks.at(1));  // a peak below the threshold
  EXPECT_TRUE(peaks.at(2));
  EXPECT_FALSE(peaks.at(3));  // no peak: the rest of the third one's plateau
}

TEST(ImpactPeaks, AreNotWhatAWindowsEdgeCutsOff) {
  const TimeSeries pressure = pressure_of({{2.375, 3710}});
  EXPECT_FALSE(impact_peaks(pressure, {{2.38, 4}}, 910).at(0));   // the fall
  EXPECT_FALSE(impact_peaks(pressure, {{1, 2.374}}, 910).at(0));  // the rise
  EXPECT_TRUE(impact_peaks(pressure, {{1, 2.376}}, 910).at(0));
  // A record that ends during the rise or begins during the fall has no peak either.
  EXPECT_FALSE(impact_peaks(pressure_of({{2.375, 3710}}, 2.37), {{1, 2.37}}, 910).at(0));
}

TEST(ImpactPeaks, BelongToOneWindowOnly) {
  const auto peaks = impact_peaks(pressure_of({{2.375, 3710}}), {{1, 2.375}, {2.375, 4}}, 910);
  EXPECT_FALSE(peaks.at(0));
  EXPECT_TRUE(peaks.at(1));
}

TEST(ImpactPeaks, OfASaturatedSensorBeginWithTheFirstOfTheEqualSamples) {
  TimeSeries pressure = pressure_of({{2.375, 3710}});
  for (double& value : pressure.value) value = std::min(value, 2000.0);
  const auto peaks = impact_peaks(pressure, {{1, 4}}, 910);
  ASSERT_TRUE(peaks.at(0));
  EXPECT_EQ(peaks[0]->pressure, 2000);
  EXPECT_NEAR(peaks[0]->time, 2.371, 1e-9);
  // A step during the rise is no peak.
  EXPECT_FALSE(
      impact_peaks(sampled([](double t) { return 1000 * std::floor(t); }, 0, 5), {{1, 4}}, 910)
          .at(0));
}

std::string complaint(const TimeSeries& pressure, const std::vector<TimeWindow>& windows,
                      double threshold) {
  return message_of<ComparisonError>([&] { impact_peaks(pressure, windows, threshold); });
}

TEST(ImpactPeaks, RefuseWhatTheyCannotSearch) {
  const TimeSeries pressure = pressure_of({{2.375, 3710}});
  const auto windows = impact_windows(1.6, period, 4);
  EXPECT_EQ(complaint(pressure, windows, 910), "");
  EXPECT_TRUE(holds(complaint(pressure_of({{2.375, 3710}}, 5), windows, 910), "covers 0 s to 5 s"));
  TimeSeries with_nan = pressure;
  with_nan.value[2375] = nan_value;
  EXPECT_TRUE(holds(complaint(with_nan, windows, 910), "sample 2375 is not finite"));
  for (const double threshold : {0.0, -1.0, nan_value})
    EXPECT_TRUE(holds(complaint(pressure, windows, threshold), "threshold = "));
  EXPECT_TRUE(holds(complaint(pressure, {}, 910), "no windows"));
  EXPECT_TRUE(holds(complaint(pressure, {{1, 3}, {2.5, 4}}, 910),
                    "the window of impact 2 begins at 2.5 s; expected at or after the last one's "
                    "end, 3 s"));
}

TEST(PlateauMean, IsTheMeanOverTimeOfUnevenSamplesToo) {
  TimeSeries line{.name = "p", .unit = "Pa", .time = {0, 1, 1.5, 2, 4, 5}, .value = {}};
  for (const double t : line.time) line.value.push_back(100 + 10 * t);
  EXPECT_DOUBLE_EQ(plateau_mean(line, {1, 4}), 125);  // the samples' own mean is 121.25
  EXPECT_THROW(plateau_mean(line, {4, 7}), ComparisonError);
}

TimeSeries record_of(const std::filesystem::path& file) {
  TimeSeries pressure{.name = "sensor 1", .unit = "Pa", .time = {}, .value = {}};
  std::ifstream stream(file);
  std::string header;
  std::getline(stream, header);
  char comma = 0;
  for (double t = 0, p = 0; stream >> t >> comma >> p;) {
    pressure.time.push_back(t);
    pressure.value.push_back(p);
  }
  return pressure;
}

TEST(ImpactsOfSpheric10, ComeInTheRecordWhenPublished) {
  const std::string name = "spheric_test10/pressure_sensor1_lateral_water_1kHz.csv";
  const auto file = published_record(name);
  if (!file) GTEST_SKIP() << name << record_missing;
  const TimeSeries pressure = record_of(*file);
  const auto peaks = impact_peaks(pressure, impact_windows(1.6, period, 4),
                                  impact_threshold({3710, 4816, 4691, 4643}));
  const std::vector<double> published{2.375, 4.073, 5.718, 7.303};  // [s]
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(peaks[i]) << i;
    EXPECT_NEAR(peaks[i]->time, published[i], 0.001);
  }
  EXPECT_NEAR(plateau_mean(pressure, {2.45, 2.65}), 670, 1);
}

// As the cases spheric10_water and spheric10_oil state them.
TEST(ImpactsOfSpheric10, ArriveInTheRecordsOfBothLiquidsAsTheCasesState) {
  struct Published {
    std::string liquid;
    double share, period;
    std::vector<double> times, peaks, arrivals;
  };
  for (const Published& of : {Published{"water",
                                        0.1,
                                        1.6361,
                                        {2.375, 4.073, 5.718, 7.303},
                                        {3710, 4816, 4691, 4643},
                                        {2.3742, 4.0468, 5.6702, 7.3021}},
                              Published{"oil",
                                        0.5,
                                        1.5407,
                                        {2.432, 4.067, 5.631, 7.170},
                                        {686.5, 648.9, 544.4, 552.7},
                                        {2.4004, 4.0335, 5.5795, 7.1347}}}) {
    const auto file =
        published_record("spheric_test10/pressure_sensor1_lateral_" + of.liquid + "_1kHz.csv");
    if (!file) GTEST_SKIP() << of.liquid << record_missing;
    const TimeSeries pressure = record_of(*file);
    const auto windows = impact_windows(of.times, of.period);
    for (std::size_t n = 0; n < 4; ++n)
      EXPECT_NEAR(arrival_time(pressure, windows[n], of.share * of.peaks[n]).value(),
                  of.arrivals[n], 1e-4)
          << of.liquid << " impact " << n + 1;
  }
}

const TimeSeries rise{
    .name = "p", .unit = "Pa", .time = {0, 1, 1.5, 2, 4, 5}, .value = {0, 0, 10, 30, 10, 40}};

TEST(ArrivalTime, IsACrossingBetweenTheSamples) {
  EXPECT_DOUBLE_EQ(arrival_time(rise, {0, 5}, 5).value(), 1.25);
  EXPECT_DOUBLE_EQ(arrival_time(rise, {0, 5}, 20).value(), 1.75);
  EXPECT_FALSE(arrival_time(rise, {0, 5}, 41));
  EXPECT_FALSE(arrival_time(rise, {1, 5}, 50));
  EXPECT_FALSE(arrival_time({"p", "Pa", {0, 1, 2, 3}, {9, 8, 7, 6}}, {0, 3}, 5));
  EXPECT_THROW(arrival_time(rise, {0, 7}, 5), ComparisonError);
  EXPECT_THROW(arrival_time(rise, {0, 5}, 0), ComparisonError);
}

// A front of 3000 Pa at 2.4 s with the plateau of the lateral impact of water, and drops before it.
struct Drop {
  double time, duration, height;  // [s], [s], [Pa]
};

TimeSeries front_after(const std::vector<Drop>& drops, double plateau = 670) {
  return sampled(
      [=](double t) {
        double pressure = t < 2.4 ? 30 : plateau + (3000 - plateau) * std::exp(-(t - 2.4) / 0.004);
        for (const Drop& drop : drops)
          if (t >= drop.time && t < drop.time + drop.duration) pressure += drop.height;
        return pressure;
      },
      1.5, 3.5, 0.001);
}

const TimeWindow searched{2.0, 2.8};

TEST(ArrivalTime, IsNotThatOfADropOfSpray) {
  const double front = arrival_time(front_after({}), searched, 400).value();
  EXPECT_NEAR(front, 2.4, 0.001);
  for (const std::vector<Drop>& drops :
       {std::vector<Drop>{{2.13, 0.004, 2000}},
        {{2.37, 0.002, 900}},
        {{2.2, 0.008, 9000}},
        {{2.05, 0.001, 500}, {2.13, 0.003, 4000}, {2.3, 0.006, 1500}}})
    EXPECT_NEAR(arrival_time(front_after(drops), searched, 400).value(), front, 1e-9);
}

TEST(ArrivalTime, IsThatOfAFrontWithGapsAsInTheRecord) {
  // The fourth impact of the record falls to 42 Pa from 4 to 8 ms after its front.
  EXPECT_NEAR(arrival_time(front_after({{2.404, 0.004, -2000}, {2.42, 0.006, -700}}), searched, 400)
                  .value(),
              2.4, 0.001);
}

// As with boundary particles at 8 mm in the violent roll: 18 ms at the level, then a swell that
// holds it for longer.
TEST(ArrivalTime, IsThatOfAShortFrontBeforeTheSwellBehindIt) {
  const TimeSeries low = sampled(
      [](double t) {
        return t < 2.4 ? 0.0 : t < 2.418 ? 1700.0 : t < 2.55 ? -100.0 : 600.0;
      },
      1.5, 3.5, 0.001);
  EXPECT_NEAR(arrival_time(low, searched, 482).value(), 2.4, 0.001);
}

TEST(ArrivalTime, IsThatOfAPeakWithoutAPlateauToo) {
  for (const std::vector<Drop>& drops : {std::vector<Drop>{}, {{2.1, 0.002, 900}}})
    EXPECT_NEAR(arrival_time(front_after(drops, 0), searched, 400).value(), 2.4, 0.001);
}

TEST(ArrivalTime, OfASmoothRiseIsWhereItHasTheLevelWhateverItsNoise) {
  const auto rise_of_oil = [](double t) {
    return t < 2.365   ? -30
           : t < 2.435 ? 650 * (t - 2.365) / 0.07
                       : 440 + 210 * std::exp(-(t - 2.435) / 0.03);
  };
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const TimeSeries noisy = with_noise(sampled(rise_of_oil, 1.5, 3.5, 0.001), 20, 0, seed);
    EXPECT_NEAR(arrival_time(noisy, searched, 325).value(), 2.4, 0.006) << seed;
  }
}

TEST(RiseTime, IsTwiceTheTimeFromHalfThePeakToIt) {
  // From 2 at 1 s to 10 at 3 s: half the peak is crossed at 1.75 s.
  const TimeSeries triangle{"p", "Pa", {0, 1, 3, 4}, {6, 2, 10, 0}};
  EXPECT_DOUBLE_EQ(rise_time(triangle, {3, 10}).value(), 2.5);
  // The last crossing counts, and a straight rise from zero has its whole length.
  EXPECT_DOUBLE_EQ(rise_time({"p", "Pa", {0, 1, 2, 3, 4, 5}, {0, 8, 0, 5, 10, 0}}, {4, 10}).value(),
                   2);
  EXPECT_FALSE(rise_time({"p", "Pa", {0, 1, 2}, {6, 10, 0}}, {1, 10}));
}

TEST(Impulse, IsTheIntegralOverTheWindowWhereverItEnds) {
  EXPECT_DOUBLE_EQ(impulse(rise, {0, 5}), 2.5 + 10 + 40 + 25);
  EXPECT_DOUBLE_EQ(impulse(rise, {0.5, 4.5}), 2.5 + 10 + 40 + 0.5 * 17.5);
  EXPECT_DOUBLE_EQ(impulse(rise, {0.75, 4.25}), 2.5 + 10 + 40 + 0.25 * 13.75);
  EXPECT_THROW(impulse(rise, {0, 7}), ComparisonError);
}

}  // namespace
}  // namespace slosh::impact_peaks_test
