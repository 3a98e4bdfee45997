#include "verification/case/metric_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace slosh::metric_table_test {
namespace {

using Modes = std::vector<std::string>;

const Modes fitted{"forced", "natural_1", "natural_2"};

TEST(MetricTable, HasEveryMetricOnceUnderANameOfItsOwn) {
  std::set<Metric> metrics;
  std::set<std::string> names, descriptions;
  for (const MetricEntry& entry : metric_table()) {
    metrics.insert(entry.metric);
    names.insert(entry.name);
    descriptions.insert(entry.description);
    EXPECT_EQ(metric_entry(std::string(entry.name)).metric, entry.metric);
    EXPECT_EQ(metric_entry(entry.metric).name, std::string(entry.name));
    EXPECT_STRNE(entry.widest.because, "") << entry.name;
    EXPECT_EQ(entry.bound.form == BoundForm::any, entry.bound.because == std::string())
        << entry.name;
  }
  EXPECT_EQ(descriptions.size(), metric_table().size());
  EXPECT_EQ(metrics.size(), metric_table().size());
  EXPECT_EQ(names.size(), metric_table().size());
  EXPECT_THROW(metric_entry(std::string("amplitude")), std::logic_error);
}

TEST(MetricTable, GivesTheUnitOfAMetricOrThatOfItsQuantity) {
  EXPECT_EQ(metric_unit(Metric::phase_lag, "Pa"), "deg");
  EXPECT_EQ(metric_unit(Metric::mean_offset, "Pa"), "Pa");
}

TEST(MetricTable, AGivenFrequencyIsNotJudgedOnItself) {
  const Modes natural{"natural_1", "natural_2"};
  for (const Metric metric : {Metric::frequency_error, Metric::decay_rate, Metric::decay_error})
    EXPECT_EQ(measured_modes(metric_entry(metric), fitted, false), natural) << metric_name(metric);
  EXPECT_EQ(measured_modes(metric_entry(Metric::frequency_error), {"forced", "tone_2"}, false),
            Modes{});
  EXPECT_EQ(measured_modes(metric_entry(Metric::phase_lag), fitted, false), fitted);
}

TEST(MetricTable, OnlyAFrontIsAligned) {
  const MetricEntry& lag = metric_entry(Metric::aligned_rms);
  EXPECT_EQ(measured_modes(lag, fitted, false), Modes{});
  EXPECT_EQ(measured_modes(lag, {}, true), Modes{"whole"});
}

TEST(MetricTable, OnlyAnOscillationHasALagAndASpectralPeak) {
  for (const Metric metric : {Metric::cross_correlation_lag, Metric::spectral_peak_error}) {
    EXPECT_EQ(measured_modes(metric_entry(metric), fitted, false), Modes{"whole"});
    EXPECT_EQ(measured_modes(metric_entry(metric), {}, true), Modes{}) << metric_name(metric);
  }
  EXPECT_EQ(measured_modes(metric_entry(Metric::mean_offset), {}, true), Modes{"whole"});
}

TEST(MetricTable, TakesTheForcedModeOrTheWholeWindowWhereALimitNamesNoMode) {
  EXPECT_EQ(default_mode(metric_entry(Metric::phase_lag)), "forced");
  EXPECT_EQ(default_mode(metric_entry(Metric::normalised_rms)), "whole");
  EXPECT_EQ(default_mode(metric_entry(Metric::frequency_error)), std::nullopt);
  for (const MetricEntry& entry : metric_table()) {
    const bool is_front = entry.measured_on == MeasuredOn::front;
    const Modes modes = measured_modes(entry, is_front ? Modes{} : fitted, is_front);
    const std::optional<std::string> mode = default_mode(entry);
    EXPECT_TRUE(!mode || std::find(modes.begin(), modes.end(), *mode) != modes.end()) << entry.name;
  }
}

TEST(MetricTable, NoLimitIsSoWideThatNothingViolatesIt) {
  const BoundScales scales{.window = 8, .impact_period = 2};
  for (const MetricEntry& entry : metric_table()) {
    const Rule<double> rule = limit_rule(entry, "1", scales);
    const double widest = widest_bound(entry, scales);
    EXPECT_TRUE(rule.holds(0.999 * widest)) << entry.name;
    for (const double wrong : {widest, 1e300, 0.0, -1.0})
      EXPECT_FALSE(rule.holds(wrong)) << entry.name << " " << wrong;
    EXPECT_NE(rule.expected.find(entry.widest.because), std::string::npos);
  }
  EXPECT_EQ(widest_bound(metric_entry(Metric::impact_arrival), scales), 0.5);
}

}  // namespace
}  // namespace slosh::metric_table_test
