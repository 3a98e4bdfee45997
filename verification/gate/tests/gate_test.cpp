#include "verification/gate/gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "verification/gate/measured_value.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh::gate_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

GateRow row_of(Metric metric, const std::string& mode, const std::string& unit, double limit) {
  GateRow row{};
  row.candidate = "sph";
  row.reference = "linear";
  row.quantity = "elevation@right";
  row.metric = metric;
  row.mode = mode;
  row.unit = unit;
  row.limit = limit;
  return row;
}

const GateRow amplitude_row = row_of(Metric::amplitude_error, "forced", "1", 0.05);

// Rows that compare must not ask for a run's own series.
TimeSeries no_series(const std::string& run, const std::string&) {
  throw std::logic_error("the row asked for a series of " + run);
}

std::map<std::string, RunStatus> all_finished() {
  return {{"sph", {RunState::finished, ""}},
          {"sph_coarse", {RunState::finished, ""}},
          {"linear", {RunState::finished, ""}}};
}

std::map<std::string, RunStatus> with(const std::string& run, RunState state,
                                      const std::string& message) {
  auto runs = all_finished();
  runs[run] = {state, message};
  return runs;
}

Comparison comparison_of(double amplitude_error) {
  Comparison comparison{};
  comparison.unit = "m";
  ModeComparison forced{};
  forced.mode = "forced";
  forced.amplitude_error = {amplitude_error, 0.001};
  forced.phase_lag = {0.01, 0};  // [s]: no row is in seconds
  forced.phase_lag_degrees = {1.5, 0.1};
  comparison.modes.push_back(forced);
  ModeComparison natural{};
  natural.mode = "natural_1";
  natural.frequency_error = {-0.002, 0.0001};
  natural.decay_rate = {0.02, 0.001};
  natural.reference.decay_rate = {0.016, 0.001};
  natural.decay_error = {0.25, 0.08};
  comparison.modes.push_back(natural);
  for (ModeComparison& mode : comparison.modes)
    mode.candidate.resolved = mode.reference.resolved = true;
  comparison.normalised_rms = {0.1, 0};
  comparison.alignment = {-0.003, 0.05};
  comparison.candidate_wave = {.mean = 0.003, .deviation = 3};
  comparison.reference_wave = {.mean = 0.001, .deviation = 2};
  comparison.candidate_peaks = {{0.9, 1}};
  comparison.reference_peaks = {{1, 1}};
  return comparison;
}

GateOutcome judge(const GateRow& row, const Comparison& comparison) {
  return evaluate(
      row, all_finished(),
      {[&](const auto&, const auto&, const auto&) -> const Comparison& { return comparison; },
       no_series});
}

GateOutcome judge(const GateRow& row, const std::map<std::string, RunStatus>& runs) {
  const Comparison comparison = comparison_of(0.01);
  return evaluate(
      row, runs,
      {[&](const auto&, const auto&, const auto&) -> const Comparison& { return comparison; },
       no_series});
}

TEST(Gate, PassesAValueUpToItsLimitOnEitherSide) {
  GateRow row = row_of(Metric::normalised_rms, "whole", "1", 0.1);  // has no interval
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::pass);
  row.limit = 0.0999;
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::violated);
}

TEST(Gate, DoesNotPassOnWhatTheReferencesSamplesDoNotTell) {
  Comparison comparison = comparison_of(0);
  comparison.unseen = UnseenInterval{3, 3.5, 0.02};
  GateRow row = row_of(Metric::normalised_rms, "whole", "1", 0.2);
  const GateOutcome outcome = judge(row, comparison);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_NE(outcome.message.find("no sample between 3 and 3.5 s, where the candidate departs by up "
                                 "to 0.02 m"),
            std::string::npos)
      << outcome.message;
  comparison.unseen->in_candidate = true;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::inconclusive);
  EXPECT_NE(judge(row, comparison).message.find("the candidate has no sample between 3 and 3.5 s"),
            std::string::npos);
  row.limit = 0.05;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::violated);
  row.limit = 0.2;
  row.kind = RowKind::regression;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::pass);
  EXPECT_NE(judge(row, comparison).message.find("no sample"), std::string::npos);
  EXPECT_EQ(judge(amplitude_row, comparison).verdict, Verdict::pass);  // of each series' own fit
}

TEST(Gate, DoesNotPassOnDoubtfulReadings) {
  Comparison comparison = comparison_of(0);
  comparison.doubts = {"the values of the candidate lie 0.01 m apart"};
  GateRow row = amplitude_row;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::inconclusive);
  EXPECT_NE(judge(row, comparison).message.find("; doubtful: the values of the candidate"),
            std::string::npos);
  row.kind = RowKind::regression;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::pass);
}

TEST(Gate, TellsTheCoverageOfTheWindowAndRefusesLessThanHalf) {
  Comparison comparison = comparison_of(0);
  comparison.covered = 0.7;
  EXPECT_EQ(judge(amplitude_row, comparison).verdict, Verdict::pass);
  EXPECT_NE(judge(amplitude_row, comparison).message.find("; over 70 % of the window"),
            std::string::npos);
  comparison.covered = 0.31;
  GateRow row = amplitude_row;
  row.kind = RowKind::regression;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::not_compared);
  EXPECT_NE(judge(row, comparison)
                .message.find("the samples cover 31 % of the window; expected "
                              "half of it or more"),
            std::string::npos);
}

TEST(Gate, MeasuresAgainstAConstantReferenceWhatNeedsNoVariation) {
  Comparison comparison = comparison_of(0);
  comparison.reference_is_constant = true;
  comparison.modes.clear();
  EXPECT_EQ(judge(row_of(Metric::mean_offset, "whole", "m", 0.01), comparison).verdict,
            Verdict::pass);
  EXPECT_EQ(judge(row_of(Metric::mean_offset, "whole", "m", 0.001), comparison).verdict,
            Verdict::violated);
  for (const GateRow& row : {row_of(Metric::normalised_rms, "whole", "1", 0.5),
                             row_of(Metric::rms_error, "whole", "1", 0.9), amplitude_row}) {
    EXPECT_EQ(judge(row, comparison).verdict, Verdict::not_compared);
    EXPECT_NE(judge(row, comparison).message.find("constant"), std::string::npos);
  }
}

TEST(Gate, IsInconclusiveWhereTheIntervalReachesAcrossTheBound) {  // each +- 0.001
  EXPECT_EQ(judge(amplitude_row, comparison_of(0.0489)).verdict, Verdict::pass);
  EXPECT_EQ(judge(amplitude_row, comparison_of(-0.0489)).verdict, Verdict::pass);
  for (const double value : {0.0491, 0.05, 0.0509, -0.0491, -0.0509})
    EXPECT_EQ(judge(amplitude_row, comparison_of(value)).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge(amplitude_row, comparison_of(0.0511)).verdict, Verdict::violated);
  EXPECT_EQ(judge(amplitude_row, comparison_of(-0.0511)).verdict, Verdict::violated);
  EXPECT_EQ(judge(amplitude_row, comparison_of(0.05)).message,
            "5.00 ± 0.10 % cannot be distinguished from 5 %");
}

TEST(Gate, CountsWhatElseIsUncertainBesideTheInterval) {
  const Comparison comparison = comparison_of(0.04);
  const FindComparison find = [&](const auto&, const auto&, const auto&) -> const Comparison& {
    return comparison;
  };
  const auto with_reference = [&](double half_width) {
    const FindUncertainty uncertainty = [=](const GateRow&) {
      return UncertaintyContributions{.reference = half_width};
    };
    return evaluate(amplitude_row, all_finished(), {find, no_series, {}, uncertainty});
  };
  EXPECT_EQ(with_reference(0.005).verdict, Verdict::pass);
  const GateOutcome unsure = with_reference(0.02);
  EXPECT_EQ(unsure.verdict, Verdict::inconclusive);
  EXPECT_NEAR(unsure.judgement.value().uncertainty, std::hypot(0.02, 0.001), 1e-15);
  EXPECT_NEAR(unsure.judgement.value().conclusive_uncertainty, 0.01, 1e-15);
  EXPECT_EQ(with_reference(nan).verdict, Verdict::inconclusive);
}

GateOutcome judge_with(const GateRow& row, double value, const UncertaintyContributions& found) {
  const Comparison comparison = comparison_of(value);
  const FindComparison find = [&](const auto&, const auto&, const auto&) -> const Comparison& {
    return comparison;
  };
  return evaluate(row, all_finished(),
                  {find, no_series, {}, [&](const GateRow&) { return found; }});
}

TEST(Gate, DoesNotPassAValidationRowWhoseNumericalOrReferencesUncertaintyIsUnknown) {
  const Contribution unknown = Contribution::unknown("nobody refined the mesh");
  for (const UncertaintyContributions& found :
       {UncertaintyContributions{.reference = unknown},
        UncertaintyContributions{.discretisation = unknown}}) {
    const GateOutcome outcome = judge_with(amplitude_row, 0.01, found);
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
    EXPECT_EQ(outcome.message, "1.00 ± 0.10 % ≤ 5 %; not included: nobody refined the mesh");
    EXPECT_EQ(judge_with(amplitude_row, 0.08, found).verdict, Verdict::violated);
    GateRow regression = amplitude_row;
    regression.kind = RowKind::regression;
    EXPECT_EQ(judge_with(regression, 0.01, found).verdict, Verdict::pass);
    EXPECT_TRUE(judge_with(regression, 0.01, found).message.ends_with(" (regression)"));
    GateRow improvement = amplitude_row;
    improvement.limit.reset();
    improvement.improves_on = "sph_coarse";
    EXPECT_NE(judge_with(improvement, 0.01, found).verdict, Verdict::pass);
  }
  EXPECT_EQ(judge_with(amplitude_row, 0.01, {}).verdict, Verdict::pass);
}

TEST(Gate, PassesAValidationRowWhoseInputsAreUnknownAndKeepsThat) {
  const GateOutcome outcome =
      judge_with(amplitude_row, 0.01, {.input = Contribution::unknown("the paper is silent")});
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_FALSE(outcome.judgement.value().contributions.input.half_width.has_value());
}

TEST(Gate, SaysTheValueAndItsLimitInTheRowsUnit) {
  EXPECT_EQ(judge(amplitude_row, comparison_of(0.008)).message, "0.80 ± 0.10 % ≤ 5 %");
  EXPECT_EQ(judge(amplitude_row, comparison_of(-0.08)).message, "|-8.00 ± 0.10 %| is not ≤ 5 %");
  EXPECT_EQ(judge(row_of(Metric::phase_lag, "forced", "deg", 2), comparison_of(0)).message,
            "1.50 ± 0.10 deg ≤ 2 deg");
  EXPECT_EQ(judge(row_of(Metric::mean_offset, "whole", "m", 0.003), comparison_of(0)).message,
            "0.002 m ≤ 0.003 m");
}

TEST(Gate, TakesEachMetricFromItsPlace) {
  const Comparison comparison = comparison_of(0.01);
  const auto value = [&](Metric metric, const char* mode, const char* unit) {
    return judge(row_of(metric, mode, unit, 1e9), comparison).value.value;
  };
  EXPECT_EQ(value(Metric::amplitude_error, "forced", "1"), 0.01);
  EXPECT_EQ(value(Metric::phase_lag, "forced", "deg"), 1.5);
  EXPECT_EQ(value(Metric::frequency_error, "natural_1", "1"), -0.002);
  EXPECT_EQ(value(Metric::decay_rate, "natural_1", "1/s"), 0.02);
  EXPECT_EQ(value(Metric::decay_error, "natural_1", "1"), 0.25);
  EXPECT_EQ(value(Metric::normalised_rms, "whole", "1"), 0.1);
  EXPECT_EQ(value(Metric::aligned_rms, "whole", "1"), 0.05);
  EXPECT_DOUBLE_EQ(value(Metric::spectral_peak_error, "whole", "1"), -0.1);
  EXPECT_DOUBLE_EQ(value(Metric::rms_error, "whole", "1"), 0.5);
  EXPECT_DOUBLE_EQ(value(Metric::mean_offset, "whole", "m"), 0.002);
}

TEST(Gate, CountsEachOfTwoPeaksOfNearlyTheSamePower) {
  Comparison comparison = comparison_of(0.01);
  comparison.reference_peaks = {{1, 2}, {2, 1.9}, {4, 1.7}};
  comparison.candidate_peaks = {{1, 2}};
  const GateRow row = row_of(Metric::spectral_peak_error, "whole", "1", 0.4);
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge(row, comparison).value.half_width, 0.5);
  comparison.reference_peaks.erase(comparison.reference_peaks.begin() + 1);
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::pass);
}

TEST(Gate, HasAValueForEveryMetricOfTheTable) {
  Comparison comparison = comparison_of(0.01);
  comparison.window = {0, 1};
  comparison.margin = TimeSeries{"margin", "m", {0, 1}, {1, -1}};
  TimeSeries series{"elevation@right", "m", {}, {}};
  for (int i = 0; i <= 1000; ++i) {
    series.time.push_back(0.01 * i);
    series.value.push_back(0.1 * std::sin(0.05 * i));
  }
  const FindSeries own = [&](const auto&, const auto&) { return series; };
  const GateEvidence evidence{
      .comparison = [&](const auto&, const auto&, const auto&) -> const Comparison& {
        return comparison;
      },
      .series = own,
      .impacts = [](const auto&, const GateRow&) { return 0.1; },
      .cost = [](const GateRow&) { return CostAtError{Reach::between, 15, 0.1, 0.8, {}, {}}; },
      .history = own,
      .fields = [](const GateRow&) { return 0.1; },
      .repeats =
          [](const auto&, const GateRow&) {
            return Estimate{0.1, 0};
          }};
  for (const MetricEntry& metric : metric_table()) {
    const std::string quantity_unit = is_of_impacts(metric.metric) ? "Pa" : "m";
    const std::vector<std::string> modes =
        measured_modes(metric, {"forced", "natural_1"}, metric.measured_on == MeasuredOn::front);
    const GateRow row = row_of(metric.metric, modes.empty() ? "impact_1" : modes.front(),
                               metric_unit(metric.metric, quantity_unit), 1);
    EXPECT_TRUE(std::isfinite(measured(row, evidence).value)) << metric.name;
  }
}

TEST(Gate, DoesNotCompareAModeThatIsNotResolved) {
  Comparison lost = comparison_of(0.01), lost_reference = lost;
  lost.modes[0].candidate.resolved = false;
  lost_reference.modes[0].reference.resolved = false;
  EXPECT_EQ(judge(amplitude_row, lost).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(amplitude_row, lost).message,
            "the candidate's mode forced cannot be resolved; expected a longer window, or "
            "natural_modes = 0");
  EXPECT_EQ(judge(amplitude_row, lost_reference).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(row_of(Metric::normalised_rms, "whole", "1", 0.2), lost).verdict, Verdict::pass);
  Comparison beating = comparison_of(0.01);
  beating.modes[0].beside = 2 * std::numbers::pi * 0.25;
  EXPECT_EQ(judge(amplitude_row, beating).verdict, Verdict::not_compared);
  EXPECT_NE(
      judge(amplitude_row, beating)
          .message.find("cannot separate the mode forced from a component at 0.25 Hz; expected a "
                        "longer window, or natural_modes = 0"),
      std::string::npos);
}

TEST(Gate, DoesNotPassABoundThatACandidateOfNothingMeets) {
  Comparison comparison = comparison_of(0);
  comparison.largest_departure = 0.01;
  EXPECT_EQ(judge(row_of(Metric::mean_offset, "whole", "m", 0.0099), comparison).verdict,
            Verdict::pass);
  const GateOutcome wide = judge(row_of(Metric::mean_offset, "whole", "m", 0.0101), comparison);
  EXPECT_EQ(wide.verdict, Verdict::inconclusive);
  EXPECT_NE(wide.message.find("the bounds hold 0.01 m, the reference's largest departure"),
            std::string::npos)
      << wide.message;
  comparison.window = {0, 1};
  comparison.margin = TimeSeries{"margin", "m", {0, 1}, {1, 1}};
  for (const bool is_held : {true, false}) {
    const double nothing = is_held ? 1 : -1;
    comparison.margin_of_nothing = TimeSeries{"margin", "m", {0, 1}, {nothing, nothing}};
    EXPECT_EQ(judge(row_of(Metric::outside_band, "whole", "1", 0.2), comparison).verdict,
              is_held ? Verdict::inconclusive : Verdict::pass);
  }
}

TEST(Gate, DoubtsStepsOfMoreThanATenthOfTheBounds) {
  Comparison comparison = comparison_of(0);
  SensorLimits limits;
  limits.range = 4;
  limits.step = 0.04;
  comparison.in_steps = {{"candidate", "m", limits}};
  const auto verdict = [&](const GateRow& row) { return judge(row, comparison).verdict; };
  EXPECT_EQ(verdict(row_of(Metric::mean_offset, "whole", "m", 0.41)), Verdict::pass);
  EXPECT_EQ(verdict(row_of(Metric::mean_offset, "whole", "m", 0.39)), Verdict::inconclusive);
  EXPECT_EQ(verdict(row_of(Metric::amplitude_error, "forced", "1", 0.21)), Verdict::pass);
  EXPECT_EQ(verdict(row_of(Metric::amplitude_error, "forced", "1", 0.19)), Verdict::inconclusive);
  EXPECT_EQ(verdict(row_of(Metric::phase_lag, "forced", "deg", 12)), Verdict::pass);
  EXPECT_EQ(verdict(row_of(Metric::phase_lag, "forced", "deg", 11)), Verdict::inconclusive);
}

TEST(Gate, TakesNoDecayErrorAgainstAReferenceWhoseDecayIsWithinItsInterval) {
  const GateRow row = row_of(Metric::decay_error, "natural_1", "1", 0.4);
  Comparison comparison = comparison_of(0);
  EXPECT_EQ(judge(row, comparison).message, "25 ± 8 % ≤ 40 %");
  for (const Estimate decay : {Estimate{1e-4, 1e-3}, Estimate{-0.01, 1e-3}, Estimate{nan, 1e-3}}) {
    comparison.modes[1].reference.decay_rate = decay;
    EXPECT_EQ(judge(row, comparison).verdict, Verdict::not_compared) << decay.value;
  }
  comparison = comparison_of(0);
  comparison.modes[1].decay_error.value = nan;
  EXPECT_EQ(judge(row, comparison).verdict, Verdict::violated);
}

TEST(Gate, HoldsAValueBetweenItsBounds) {
  GateRow row = row_of(Metric::decay_rate, "natural_1", "1/s", 0);
  row.limit.reset();
  row.between = {0.01, 0.03};
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::pass);
  EXPECT_EQ(judge(row, comparison_of(0)).message,
            "0.0200 ± 0.0010 1/s within 0.01 1/s to 0.03 1/s");
  row.between = {0.0215, 0.03};
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::violated);
  row.between = {0.01, 0.0185};
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::violated);
  row.between = {0.0195, 0.03};
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::inconclusive);
  row.between = {0.022, 0.03};
  EXPECT_EQ(judge(row, comparison_of(0)).verdict, Verdict::violated);
}

class GateOnImprovement : public ::testing::Test {
 protected:
  GateOnImprovement() {
    row.limit.reset();
    row.improves_on = "sph_coarse";
  }
  Verdict verdict(double fine_error, double coarse_error) const {
    return outcome(fine_error, coarse_error, {}).verdict;
  }
  GateOutcome outcome(double fine_error, double coarse_error,
                      const UncertaintyContributions& contributions) const {
    const Comparison fine = comparison_of(fine_error), coarse = comparison_of(coarse_error);
    const FindComparison find = [&](const std::string& run, const std::string& reference,
                                    const std::string&) -> const Comparison& {
      EXPECT_EQ(reference, "linear");
      return run == "sph" ? fine : coarse;
    };
    return evaluate(row, all_finished(),
                    {find, no_series, {}, [&](const GateRow&) { return contributions; }});
  }

  GateRow row = amplitude_row;
};

TEST_F(GateOnImprovement, ComparesMagnitudes) {
  EXPECT_EQ(verdict(0.01, -0.02), Verdict::pass);
  EXPECT_EQ(verdict(-0.02, 0.01), Verdict::violated);
}

TEST_F(GateOnImprovement, NeedsMoreThanBothIntervalsUnlessItReachesZero) {
  EXPECT_EQ(verdict(0.0100, 0.0113), Verdict::inconclusive);  // each +- 0.001
  EXPECT_EQ(verdict(0.01, 0.01), Verdict::inconclusive);
  EXPECT_EQ(verdict(0.0113, 0.0100), Verdict::inconclusive);
  EXPECT_EQ(verdict(0.0115, 0.0100), Verdict::violated);
  EXPECT_EQ(verdict(0.0100, 0.0115), Verdict::pass);
  EXPECT_EQ(verdict(0.0008, 0.0011), Verdict::pass);
  EXPECT_EQ(verdict(0.0008, 0.0009), Verdict::inconclusive);
}

// Whatever stands still has -1.
TEST_F(GateOnImprovement, MustBeBetterThanNothing) {
  EXPECT_EQ(verdict(-0.9, 1.3), Verdict::pass);
  EXPECT_EQ(verdict(-1, 1.3), Verdict::inconclusive);
  EXPECT_EQ(verdict(-0.9995, -1.3), Verdict::inconclusive);  // +- 0.001
  EXPECT_EQ(verdict(1.2, 1.3), Verdict::inconclusive);
  EXPECT_NE(outcome(-1 + 1e-9, 1.3, {}).verdict, Verdict::pass);
  EXPECT_NE(outcome(-1, 1.3, {}).message.find("a candidate of nothing is as good"),
            std::string::npos);
}

TEST_F(GateOnImprovement, DoesNotPassWhereTheOtherRunsUncertaintyIsUnknown) {
  const FindComparison find = [&](const std::string& run, const auto&,
                                  const auto&) -> const Comparison& {
    static const Comparison fine = comparison_of(0.01), coarse = comparison_of(0.1);
    return run == "sph" ? fine : coarse;
  };
  for (const std::string unknown_of : {"sph", "sph_coarse"}) {
    const GateOutcome found = evaluate(
        row, all_finished(), {find, no_series, {}, [&](const GateRow& of) {
                                UncertaintyContributions all;
                                if (of.candidate == unknown_of)
                                  all.discretisation =
                                      Contribution::unknown("nobody refined " + unknown_of);
                                return all;
                              }});
    EXPECT_EQ(found.verdict, Verdict::inconclusive) << unknown_of;
    EXPECT_NE(found.message.find("; not included: nobody refined " + unknown_of), std::string::npos)
        << found.message;
  }
}

// A reference that is off by d gives errors that are off by d. The two are as good as one another
// where d is the mean of both errors; of distances at half of their difference, at the worst.
TEST_F(GateOnImprovement, MustExceedWhatTheReferencesUncertaintyExplains) {
  const auto with = [&](double fine, double coarse, double reference) {
    return outcome(fine, coarse, {.reference = reference}).verdict;
  };
  EXPECT_EQ(with(0.0136, 0.0899, 0.0517), Verdict::pass);
  EXPECT_EQ(with(0.0136, 0.0899, 0.0518), Verdict::inconclusive);
  EXPECT_EQ(with(-0.0136, 0.0899, 0.0381), Verdict::pass);
  EXPECT_EQ(with(-0.0136, 0.0899, 0.0382), Verdict::inconclusive);
  EXPECT_EQ(with(0.0899, 0.0136, 0.0517), Verdict::violated);
  EXPECT_EQ(with(0.0899, 0.0136, 0.0518), Verdict::inconclusive);
  EXPECT_EQ(with(0.0008, 0.0899, 0.05), Verdict::inconclusive) << "its interval holds zero";
  EXPECT_EQ(with(0.0136, 0.0899, nan), Verdict::inconclusive);
  EXPECT_EQ(with(nan, 0.0899, 0.05), Verdict::violated);
  EXPECT_EQ(outcome(0.0136, 0.0899, {.input = 0.06}).verdict, Verdict::inconclusive);
  EXPECT_EQ(outcome(0.0136, 0.0899, {.time_series = 0.09}).verdict, Verdict::inconclusive);
  const std::string message = outcome(0.0136, 0.0899, {.reference = 0.06}).message;
  EXPECT_NE(message.find("is not clearly < |8.99 ± 0.10 %| of sph_coarse; the reference and the "
                         "inputs may be off by 6 %, and both are as good at 5.17 %"),
            std::string::npos)
      << message;
}

TEST(Gate, AnImprovementInADistanceMustExceedTwiceTheReferencesUncertainty) {
  GateRow row = row_of(Metric::normalised_rms, "whole", "1", 0);
  row.limit.reset();
  row.improves_on = "sph_coarse";
  Comparison fine = comparison_of(0), coarse = comparison_of(0);
  fine.normalised_rms.value = 0.05;  // coarse: 0.1
  const FindComparison find = [&](const std::string& run, const auto&,
                                  const auto&) -> const Comparison& {
    return run == "sph" ? fine : coarse;
  };
  for (const double reference : {0.0249, 0.0251})
    EXPECT_EQ(
        evaluate(row, all_finished(),
                 {find,
                  no_series,
                  {},
                  [=](const GateRow&) { return UncertaintyContributions{.reference = reference}; }})
            .verdict,
        reference < 0.025 ? Verdict::pass : Verdict::inconclusive);
}

TEST_F(GateOnImprovement, NeverPassesNaN) {
  EXPECT_EQ(verdict(nan, 0.01), Verdict::violated);
  EXPECT_EQ(verdict(0.01, nan), Verdict::violated);
}

TEST_F(GateOnImprovement, NeedsTheOtherRunToo) {
  EXPECT_EQ(judge(row, with("sph_coarse", RunState::failed, "")).verdict, Verdict::solver_failed);
  EXPECT_EQ(judge(row, with("sph_coarse", RunState::not_selected, "")).verdict,
            Verdict::not_selected);
}

TEST(Gate, NeverPassesNaNOrInfinity) {
  EXPECT_EQ(judge(amplitude_row, comparison_of(nan)).verdict, Verdict::violated);
  EXPECT_EQ(judge(amplitude_row, comparison_of(std::numeric_limits<double>::infinity())).verdict,
            Verdict::violated);
  GateRow between = amplitude_row;
  between.limit.reset();
  between.between = {-1, 1};
  EXPECT_EQ(judge(between, comparison_of(nan)).verdict, Verdict::violated);
  GateRow no_limit = amplitude_row;
  no_limit.limit = nan;
  EXPECT_EQ(judge(no_limit, comparison_of(0)).verdict, Verdict::violated);
}

TEST(Gate, ReportsAFailedSolverAndLeavesItsMessageToTheRun) {
  const GateOutcome outcome =
      judge(amplitude_row, with("sph", RunState::failed, "density out of range at 1.2 s"));
  EXPECT_EQ(outcome.verdict, Verdict::solver_failed);
  EXPECT_TRUE(std::isnan(outcome.value.value));
  EXPECT_EQ(outcome.message, "the candidate sph failed");
}

TEST(Gate, DoesNotCompareWithAReferenceOutsideItsRange) {
  const GateOutcome outcome =
      judge(amplitude_row, with("linear", RunState::out_of_range, "0.3 > 0.1 depths"));
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_EQ(outcome.message,
            "the reference linear is outside its declared range: 0.3 > 0.1 depths");
}

TEST(Gate, DoesNotCompareWithoutARunAndSaysWhich) {
  auto runs = all_finished();
  runs.erase("linear");
  const GateOutcome outcome = judge(amplitude_row, runs);
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_EQ(outcome.message, "the reference linear is missing");
}

TEST(Gate, SkipsARowOfARunThatIsNotSelectedWhateverBecameOfTheOther) {
  auto runs = with("sph", RunState::not_selected, "");
  EXPECT_EQ(judge(amplitude_row, runs).verdict, Verdict::not_selected);
  runs["linear"] = {RunState::failed, ""};
  EXPECT_EQ(judge(amplitude_row, runs).verdict, Verdict::not_selected);
}

TEST(Gate, NeitherPassesNorFailsARowWhoseRecordIsNotSupplied) {
  auto runs = with("linear", RunState::not_supplied, "expected a.csv");
  const GateOutcome outcome = judge(amplitude_row, runs);
  EXPECT_EQ(outcome.verdict, Verdict::not_supplied);
  EXPECT_EQ(outcome.message, "the reference linear is not supplied: expected a.csv");
  EXPECT_TRUE(std::isnan(outcome.value.value));
  runs["sph"] = {RunState::failed, ""};
  EXPECT_EQ(judge(amplitude_row, runs).verdict, Verdict::not_supplied);
  runs["sph"] = {RunState::not_selected, ""};
  EXPECT_EQ(judge(amplitude_row, runs).verdict, Verdict::not_selected);
}

TEST(Gate, DoesNotCompareAModeThatWasNotFitted) {
  const GateOutcome outcome =
      judge(row_of(Metric::frequency_error, "natural_2", "1", 0.1), comparison_of(0));
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_EQ(outcome.message, "the mode natural_2 was not fitted");
}

TEST(Gate, DoesNotCompareALimitInAnotherUnit) {
  EXPECT_EQ(judge(row_of(Metric::mean_offset, "whole", "Pa", 100), comparison_of(0)).verdict,
            Verdict::not_compared);
  EXPECT_EQ(judge(row_of(Metric::phase_lag, "forced", "s", 100), comparison_of(0)).verdict,
            Verdict::not_compared);
}

// Through the real comparison: a candidate poisoned in each of these ways must turn the row red.
class GateOnSeries : public ::testing::Test {
 protected:
  static constexpr double frequency = 1.5;  // [rad/s]
  static constexpr double duration = 20;    // [s]

  static TimeSeries wave(double amplitude, double delay) {
    TimeSeries series{"elevation@right", "m", {}, {}};
    for (int i = 0; i <= 2000; ++i) {
      const double t = 0.01 * i;
      series.time.push_back(t);
      series.value.push_back(amplitude * std::sin(frequency * (t - delay)));
    }
    return series;
  }

  static GateOutcome judge_series(const GateRow& row, const TimeSeries& candidate) {
    Comparison comparison;
    return evaluate(row, all_finished(),
                    {[&](const auto&, const auto&, const auto&) -> const Comparison& {
                       comparison = compare(candidate, wave(0.01, 0), {0, duration},
                                            {{"forced", frequency, false}});
                       return comparison;
                     },
                     no_series});
  }

  const GateRow lag_row = row_of(Metric::phase_lag, "forced", "deg", 1);
  const GateRow rms_row = row_of(Metric::normalised_rms, "whole", "1", 0.02);
};

TEST_F(GateOnSeries, PassesATrueCandidate) {
  for (const GateRow& row : {amplitude_row, lag_row, rms_row}) {
    EXPECT_EQ(judge_series(row, wave(0.0101, 0.001)).verdict, Verdict::pass);
  }
}

TEST_F(GateOnSeries, IsViolatedByAScaledCandidate) {
  EXPECT_EQ(judge_series(amplitude_row, wave(0.0106, 0)).verdict, Verdict::violated);
  EXPECT_EQ(judge_series(rms_row, wave(0.0106, 0)).verdict, Verdict::violated);
  EXPECT_EQ(judge_series(amplitude_row, wave(0.0094, 0)).verdict, Verdict::violated);
}

TEST_F(GateOnSeries, IsViolatedByAShiftedCandidate) {
  const double two_degrees = 2 * std::numbers::pi / 180 / frequency;
  EXPECT_EQ(judge_series(lag_row, wave(0.01, two_degrees)).verdict, Verdict::violated);
  EXPECT_EQ(judge_series(lag_row, wave(0.01, -two_degrees)).verdict, Verdict::violated);
  EXPECT_EQ(judge_series(rms_row, wave(0.01, two_degrees)).verdict, Verdict::violated);
}

TEST_F(GateOnSeries, DoesNotCompareATruncatedCandidateNorOneWithNaN) {
  TimeSeries truncated = wave(0.01, 0);
  truncated.time.resize(1500);
  truncated.value.resize(1500);
  TimeSeries poisoned = wave(0.01, 0);
  poisoned.value[1000] = nan;
  for (const GateRow& row : {amplitude_row, lag_row, rms_row}) {
    EXPECT_EQ(judge_series(row, truncated).verdict, Verdict::not_compared);
    EXPECT_EQ(judge_series(row, poisoned).verdict, Verdict::not_compared);
  }
}

// "sph" and "linear" stand for ensembles; the amplitude error of each pair is told, each with a
// half width of its own that must not count.
class GateOnEnsemble : public ::testing::Test {
 protected:
  using Pair = std::pair<std::string, std::string>;

  GateOutcome judged(const std::map<Pair, double>& errors,
                     const std::map<std::string, RunStatus>& runs) {
    for (const auto& [pair, error] : errors) comparisons[pair] = comparison_of(error);
    return evaluate(row, runs, evidence());
  }
  GateEvidence evidence() {
    const FindComparison find = [this](const std::string& run, const std::string& reference,
                                       const std::string&) -> const Comparison& {
      return comparisons.at({run, reference});
    };
    const FindEnsemble ensemble = [this](const std::string& run) {
      return run == "sph" ? EnsembleOfRun{candidates} : EnsembleOfRun{references, exact};
    };
    return {find, no_series, {}, {}, {}, ensemble};
  }
  std::map<std::string, RunStatus> finished() const {
    std::map<std::string, RunStatus> runs;
    for (const auto& names : {candidates, references})
      for (const std::string& run : names) runs[run] = {RunState::finished, ""};
    return runs;
  }

  std::vector<std::string> candidates{"sph", "sph_2", "sph_3"}, references{"linear"};
  bool exact = true;
  std::map<Pair, Comparison> comparisons;
  GateRow row = amplitude_row;  // 5 %
  const std::map<Pair, double> scattered{
      {{"sph", "linear"}, 0.01}, {{"sph_2", "linear"}, 0.02}, {{"sph_3", "linear"}, 0.06}};
};

TEST_F(GateOnEnsemble, JudgesTheMeanByTheSpreadOfTheRepeatsAlone) {
  const GateOutcome outcome = judged(scattered, finished());
  EXPECT_NEAR(outcome.value.value, 0.03, 1e-12);
  EXPECT_NEAR(outcome.value.half_width, 4.30265 * std::sqrt(7e-4 / 3), 1e-6);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_EQ(outcome.message,
            "3.0 ± 6.6 % cannot be distinguished from 5 %; mean over 3 x 1 repeats");
  row.limit = 0.1;
  EXPECT_EQ(judged(scattered, finished()).verdict, Verdict::pass);
  row.limit = 0.005;
  const std::map<Pair, double> alike{
      {{"sph", "linear"}, 0.03}, {{"sph_2", "linear"}, 0.0301}, {{"sph_3", "linear"}, 0.0299}};
  EXPECT_EQ(judged(alike, finished()).verdict, Verdict::violated);
}

TEST_F(GateOnEnsemble, CountsTheSpreadOfASingleRunOnTheOtherSide) {
  exact = false;
  EXPECT_NEAR(judged(scattered, finished()).value.half_width,
              std::hypot(4.30265 * std::sqrt(7e-4 * 4 / 3), 0.001), 1e-6);
}

TEST_F(GateOnEnsemble, TakesTheMeanOverAllPairs) {
  candidates = {"sph", "sph_2"};
  references = {"linear", "linear_2"};
  const GateOutcome outcome = judged({{{"sph", "linear"}, 0.01},
                                      {{"sph", "linear_2"}, 0.03},
                                      {{"sph_2", "linear"}, 0.02},
                                      {{"sph_2", "linear_2"}, 0.04}},
                                     finished());
  EXPECT_NEAR(outcome.value.value, 0.025, 1e-12);
  EXPECT_NE(outcome.message.find("; mean over 2 x 2 repeats"), std::string::npos);
}

TEST_F(GateOnEnsemble, IsNotJudgedOnFewerThanAllMembers) {
  auto runs = finished();
  runs["sph_3"] = {RunState::missing, "it was not run"};
  EXPECT_EQ(judged(scattered, runs).verdict, Verdict::not_compared);
  EXPECT_EQ(judged(scattered, runs).message, "the candidate sph_3 has no result: it was not run");
  runs["sph_3"] = {RunState::failed, "a particle left the tank"};
  EXPECT_EQ(judged(scattered, runs).verdict, Verdict::solver_failed);
  runs.erase("sph_3");
  EXPECT_EQ(judged(scattered, runs).verdict, Verdict::not_compared);
}

TEST_F(GateOnEnsemble, IsViolatedByAMemberThatIsNoNumber) {
  auto errors = scattered;
  errors[{"sph_2", "linear"}] = nan;
  EXPECT_EQ(judged(errors, finished()).verdict, Verdict::violated);
}

TEST_F(GateOnEnsemble, FindsALagOfHalfATurnWhereverItIsWrapped) {
  row = row_of(Metric::phase_lag, "forced", "deg", 20);
  const std::map<Pair, double> none{
      {{"sph", "linear"}, 0}, {{"sph_2", "linear"}, 0}, {{"sph_3", "linear"}, 0}};
  judged(none, finished());
  comparisons[{"sph", "linear"}].modes[0].phase_lag_degrees.value = 178;
  comparisons[{"sph_2", "linear"}].modes[0].phase_lag_degrees.value = -179;
  comparisons[{"sph_3", "linear"}].modes[0].phase_lag_degrees.value = 179;
  const GateOutcome outcome = evaluate(row, finished(), evidence());
  EXPECT_NEAR(outcome.value.value, 179.333, 1e-3);
  EXPECT_EQ(outcome.verdict, Verdict::violated);
}

class GateOnOwnSeries : public ::testing::Test {
 protected:
  static constexpr double duration = 10;  // [s]

  GateOnOwnSeries() {
    row.reference.clear();
    row.quantity = "wall_gap";
  }

  // Between -0.5 and 0.5, largest at the end.
  static TimeSeries gap(double scale = 1) {
    TimeSeries series{"wall_gap", "1", {}, {}};
    for (int i = 0; i <= 1000; ++i) {
      series.time.push_back(0.01 * i);
      series.value.push_back(scale * (i % 2 == 0 ? -1 : 1) * 0.5 * i / 1000);
    }
    return series;
  }

  GateOutcome judge_series(const TimeSeries& series) const {
    return evaluate(row, {{"sph", {RunState::finished, ""}}},
                    {[](const auto&, const auto&, const auto&) -> const Comparison& {
                       throw std::logic_error("there is no reference to compare with");
                     },
                     [&](const std::string& run, const std::string& quantity) {
                       EXPECT_EQ(run, "sph");
                       EXPECT_EQ(quantity, series.name);
                       return cut_to_window(series, {0, duration});
                     },
                     {},
                     {},
                     {},
                     {},
                     {},
                     {},
                     {},
                     {},
                     0.01});
  }
  GateRow row = row_of(Metric::largest_magnitude, "whole", "1", 0.5);
};

TEST_F(GateOnOwnSeries, PassesUpToItsLimitOnEitherSide) {
  EXPECT_EQ(judge_series(gap()).verdict, Verdict::pass);
  EXPECT_EQ(judge_series(gap(-1)).verdict, Verdict::pass);
  EXPECT_EQ(judge_series(gap()).value.value, 0.5);
  EXPECT_EQ(judge_series(gap()).message, "50 % ≤ 50 %; at 10 s of 0 to 10 s");
}

TEST_F(GateOnOwnSeries, IsViolatedByAScaledSeries) {
  EXPECT_EQ(judge_series(gap(1.01)).verdict, Verdict::violated);
  EXPECT_EQ(judge_series(gap(-1.01)).verdict, Verdict::violated);
}

TEST_F(GateOnOwnSeries, DoesNotJudgeATruncatedSeriesNorOneWithNaNOrInfinity) {
  TimeSeries truncated = gap(), poisoned = gap(), infinite = gap(), empty = gap();
  truncated.time.resize(900);
  truncated.value.resize(900);
  poisoned.value[500] = nan;
  infinite.value[0] = std::numeric_limits<double>::infinity();
  empty.time.clear();
  empty.value.clear();
  for (const TimeSeries& series : {truncated, poisoned, infinite, empty})
    EXPECT_EQ(judge_series(series).verdict, Verdict::not_compared);
}

TEST_F(GateOnOwnSeries, NeverPassesNaNNorNothingWhateverItIsHanded) {
  TimeSeries poisoned = gap(), empty = gap();
  poisoned.value[500] = nan;
  empty.value.clear();
  for (const TimeSeries& series : {poisoned, empty}) {
    const GateOutcome outcome = evaluate(row, {{"sph", {RunState::finished, ""}}},
                                         {{}, [&](const auto&, const auto&) { return series; }});
    EXPECT_EQ(outcome.verdict, Verdict::violated);
  }
}

TEST_F(GateOnOwnSeries, DoesNotJudgeALimitInAnotherUnit) {
  row.unit = "m";
  EXPECT_EQ(judge_series(gap()).verdict, Verdict::not_compared);
  EXPECT_EQ(judge_series(gap()).message, "largest_magnitude is in 1, the row's limit in m");
}

TEST_F(GateOnOwnSeries, DoesNotPassWithAHoleAndSaysWhatTheSamplesCover) {
  const auto without = [](std::size_t begin, std::size_t end) {
    TimeSeries series = gap();
    const auto cut = [&](std::vector<double>& of) {
      of.erase(of.begin() + static_cast<std::ptrdiff_t>(begin),
               of.begin() + static_cast<std::ptrdiff_t>(end));
    };
    cut(series.time);
    cut(series.value);
    return series;
  };
  const std::size_t count = gap().time.size();
  const GateOutcome few = judge_series(without(count / 2, count / 2 + 12));
  EXPECT_EQ(few.verdict, Verdict::inconclusive) << few.message;
  EXPECT_NE(few.message.find("the candidate has no sample between"), std::string::npos);
  const GateOutcome many = judge_series(without(count / 2, 8 * count / 10));
  EXPECT_EQ(many.verdict, Verdict::inconclusive) << many.message;
  EXPECT_NE(many.message.find("% of the window, which the samples cover"), std::string::npos)
      << many.message;
  EXPECT_EQ(judge_series(without(count / 5, 9 * count / 10)).verdict, Verdict::not_compared);
}

// A wave that is thinned to every third sample and has none above half of its crests, six medians
// long.
TEST_F(GateOnOwnSeries, DoesNotPassWithAHoleAtEveryCrest) {
  row.quantity = "elevation@right";
  row.unit = "m";
  TimeSeries kept{row.quantity, row.unit, {0}, {0}};
  for (int i = 3; i <= 1000; i += 3)
    if (const double value = 0.75 * std::sin(0.055 * i); std::abs(value) < 0.375 || i == 999) {
      kept.time.push_back(0.01 * i);
      kept.value.push_back(i == 999 ? 0.3 : value);
    }
  const GateOutcome outcome = judge_series(kept);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
  EXPECT_NE(outcome.message.find("the candidate has no sample between"), std::string::npos);
}

// The crest is as high as the trough is left.
TEST_F(GateOnOwnSeries, DoesNotPassWithATroughThatIsCutOff) {
  row.quantity = "elevation@right";
  row.unit = "m";
  const auto wave = [&](double cut) {
    TimeSeries series{row.quantity, row.unit, {}, {}};
    for (int i = 0; i <= 1000; ++i) {
      const double s = std::sin(0.03 * i + 0.2);
      series.time.push_back(0.01 * i);
      series.value.push_back(std::max(s < 0 ? 1.3 * s : 0.45 * s, cut));
    }
    return series;
  };
  const GateOutcome outcome = judge_series(wave(-0.46));
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
  EXPECT_NE(outcome.message.find("stays at its lowest value"), std::string::npos);
  row.limit = 1.4;
  EXPECT_EQ(judge_series(wave(-2)).verdict, Verdict::pass);
}

// What is smoothed, and what the sensor has read.
TEST_F(GateOnOwnSeries, DoesNotPassFilteredPressuresWhoseReadingsAreCutOff) {
  row.quantity = "wall_pressure@P/filtered";
  row.unit = "Pa";
  row.limit = 1000;
  const auto pressure = [&](double cut) {
    TimeSeries series{row.quantity, row.unit, {}, {}};
    for (int i = 0; i <= 1000; ++i) {
      series.time.push_back(0.01 * i);
      series.value.push_back(std::min(cut, 700 + 300 * std::sin(0.03 * i + 0.2)));
    }
    return series;
  };
  const TimeSeries smoothed = pressure(2000);
  for (const double cut : {850.0, 2000.0}) {
    GateEvidence evidence;
    evidence.series = [&](const auto&, const auto&) { return smoothed; };
    evidence.readings = [&](const auto&, const auto&) { return pressure(cut); };
    evidence.sample_interval = 0.01;
    const GateOutcome outcome = evaluate(row, {{"sph", {RunState::finished, ""}}}, evidence);
    EXPECT_EQ(outcome.verdict, cut < 1000 ? Verdict::inconclusive : Verdict::pass)
        << outcome.message;
  }
}

TEST_F(GateOnOwnSeries, FailsWithItsSolver) {
  const GateOutcome outcome =
      evaluate(row, {{"sph", {RunState::failed, "a particle left the tank"}}}, {});
  EXPECT_EQ(outcome.verdict, Verdict::solver_failed);
}

TEST_F(GateOnOwnSeries, JudgesTheNoiseInASeriesInAShareOfItsDeviation) {
  row = row_of(Metric::noise_share, "whole", "1", 0.05);
  row.quantity = "wall_gap";
  EXPECT_EQ(judge_series(gap()).verdict, Verdict::violated);  // its sign turns at each sample
  TimeSeries smooth = gap();
  smooth.unit = "m";
  for (std::size_t i = 0; i < smooth.time.size(); ++i) smooth.value[i] = std::sin(smooth.time[i]);
  EXPECT_EQ(judge_series(smooth).verdict, Verdict::pass);
}

// At 6.7 samples a period the crest may lie 10 % above the highest, at 40 samples 0.3 %.
TEST_F(GateOnOwnSeries, DoubtsALargestValueThatTheSamplesMayMiss) {
  row = row_of(Metric::largest_magnitude, "whole", "1", 0);
  row.reference.clear();
  row.quantity = "wall_gap";
  for (const double interval : {0.3, 0.05}) {
    TimeSeries wave{"wall_gap", "1", {}, {}};
    for (int i = 0; i * interval < 10; ++i) {
      wave.time.push_back(i * interval);
      wave.value.push_back(0.65 * std::sin(std::numbers::pi * (i + 0.5) * interval));
    }
    row.limit = 1.02 * *std::max_element(wave.value.begin(), wave.value.end());
    EXPECT_EQ(judge_series(wave).verdict, interval < 0.1 ? Verdict::pass : Verdict::inconclusive);
    row.limit = 0.8;
    EXPECT_EQ(judge_series(wave).verdict, Verdict::pass);
  }
}

// An error that is reached by less than the reference may be off is not known to be reached.
TEST(Gate, DoubtsACostWhoseErrorTheReferenceDoesNotTell) {
  GateRow row = row_of(Metric::cost_to_reach, "whole", "s", 30);
  row.error = 0.12;
  const Comparison comparison = comparison_of(0);  // of a normalised rms of 10 %
  const FindComparison find = [&](const auto&, const auto&, const auto&) -> const Comparison& {
    return comparison;
  };
  for (const auto& [reference, verdict] :
       {std::pair{Contribution(0.019), Verdict::pass},
        {Contribution(0.021), Verdict::inconclusive},
        {Contribution::unknown("the record declares none"), Verdict::inconclusive}}) {
    GateEvidence evidence{find, no_series, {}, [&reference = reference](const GateRow& of) {
                            UncertaintyContributions all;
                            if (of.metric == Metric::normalised_rms) all.reference = reference;
                            return all;
                          }};
    evidence.cost = [](const GateRow&) {
      return CostAtError{Reach::between, 5, 0, 0, {"sph_coarse", "sph"}, {}};
    };
    EXPECT_EQ(evaluate(row, all_finished(), evidence).verdict, verdict) << reference.basis;
  }
}

// A load of 30 N/m that swings with a period of 4 s, judged from 5 s on, and a slam before that.
class GateOnALoad : public ::testing::Test {
 protected:
  GateOnALoad() { row.quantity = "force_x"; }

  static TimeSeries load(double slam) {
    TimeSeries series{"force_x", "N/m", {}, {}};
    for (int i = 0; i <= 1000; ++i) {
      const double t = 0.01 * i;
      series.time.push_back(t);
      series.value.push_back(30 * std::sin(std::numbers::pi / 2 * t) +
                             slam * std::exp(-std::pow((t - 1.2) / 0.02, 2)));
    }
    return series;
  }
  GateOutcome judge(const TimeSeries& whole, TimeWindow over) const {
    GateEvidence evidence;
    evidence.series = [&](const auto&, const auto&) { return cut_to_window(whole, over); };
    evidence.history = [&](const auto&, const auto&) { return whole; };
    evidence.sample_interval = 0.01;
    evidence.judged = over;
    evidence.rests = [&](const auto&) { return rests; };
    evidence.ensemble = [&](const auto& run) { return EnsembleOfRun{{run}, false, may_repeat}; };
    return evaluate(row, {{"sph", {RunState::finished, ""}}}, evidence);
  }

  GateRow row = row_of(Metric::largest_magnitude, "whole", "N/m", 60);
  bool may_repeat = false;
  std::vector<double> rests;
};

TEST_F(GateOnALoad, TellsWhenThePeakIsAndThatALargerOneLiesOutsideOfItsTime) {
  const GateOutcome whole = judge(load(90), {0, 10});
  EXPECT_EQ(whole.verdict, Verdict::violated);
  EXPECT_NE(whole.message.find("; at 1.2 s of 0 to 10 s"), std::string::npos) << whole.message;
  const GateOutcome later = judge(load(90), {5, 10});
  EXPECT_EQ(later.value.value, 30);
  EXPECT_EQ(later.verdict, Verdict::pass);
  EXPECT_NE(later.remarks.find("; LARGER outside of that time: 119 N/m at 1.2 s"),
            std::string::npos)
      << later.remarks;
  EXPECT_EQ(judge(load(0), {5, 10}).message.find("LARGER"), std::string::npos);
}

// An impact of 15 ms on samples of 10 ms: its top may lie between them.
TEST_F(GateOnALoad, DoubtsAPeakThatLastsForASample) {
  row.limit = 160;
  EXPECT_EQ(judge(load(120), {0, 10}).verdict, Verdict::pass);
  TimeSeries sharp = load(0);
  sharp.value[120] += 120;
  const GateOutcome outcome = judge(sharp, {0, 10});
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_NE(outcome.message.find("lasts for about a sample"), std::string::npos);
}

// Crests that are cut off at 10 N/m are none of the peak, which is a trough of -30 N/m.
TEST_F(GateOnALoad, DoubtsAFlatOnlyWhereThePeakMayBeCutOff) {
  TimeSeries flat = load(0);
  for (double& value : flat.value) value = std::min(value, 10.0);
  EXPECT_EQ(judge(flat, {0, 10}).verdict, Verdict::pass) << judge(flat, {0, 10}).message;
  for (double& value : flat.value) value = std::clamp(value, -9.0, 10.0);
  row.limit = 11;
  EXPECT_EQ(judge(flat, {0, 10}).verdict, Verdict::inconclusive);
  row.limit = 160;
  EXPECT_EQ(judge(flat, {0, 10}).verdict, Verdict::pass);
}

TEST_F(GateOnALoad, DoubtsNoFlatAtWhichTheQuantityRests) {
  row = row_of(Metric::noise_share, "whole", "1", 0.05);
  row.quantity = "elevation@right";
  TimeSeries at_roof = load(0);
  for (double& value : at_roof.value) value = std::min(value, 10.0);
  EXPECT_EQ(judge(at_roof, {0, 10}).verdict, Verdict::inconclusive);
  rests = {10};
  EXPECT_EQ(judge(at_roof, {0, 10}).verdict, Verdict::pass) << judge(at_roof, {0, 10}).message;
}

// The gauge fails from 4.06 s on, and four samples of the part are left.
TEST_F(GateOnALoad, DoubtsAPartAtWhoseEdgeSamplesAreMissing) {
  TimeSeries failing = load(0);
  const auto remove = [](std::vector<double>& of) { of.erase(of.begin() + 407, of.begin() + 600); };
  remove(failing.time);
  remove(failing.value);
  const GateOutcome outcome = judge(failing, {4, 5.5});
  EXPECT_NE(outcome.verdict, Verdict::pass) << outcome.message;
  EXPECT_EQ(judge(failing, {6, 10}).verdict, Verdict::pass);
}

TEST_F(GateOnALoad, SaysSingleRunWhereNoRunRepeatsIt) {
  EXPECT_NE(judge(load(20), {0, 10}).message.find("; single run: how its peaks scatter is not"),
            std::string::npos);
  may_repeat = true;
  const char* says = "; single run: `repeats` of sph tell how its peaks scatter";
  EXPECT_NE(judge(load(20), {0, 10}).message.find(says), std::string::npos);
  row.quantity = "mach_number";
  EXPECT_EQ(judge(load(20), {0, 10}).message.find("single run"), std::string::npos);
}

TEST_F(GateOnALoad, DoesNotPassOnARunThatIsNotSound) {
  GateEvidence evidence;
  const TimeSeries whole = load(0);
  evidence.series = [&](const auto&, const auto&) { return whole; };
  evidence.doubts_of_runs = [](const GateRow&) { return RowDoubts{"; doubtful: sph", true}; };
  const auto judged = [&] {
    return evaluate(row, {{"sph", {RunState::finished, ""}}}, evidence).verdict;
  };
  EXPECT_EQ(judged(), Verdict::inconclusive);
  row.limit = 10;
  EXPECT_EQ(judged(), Verdict::violated);
  row.limit = 60;
  row.kind = RowKind::regression;
  EXPECT_EQ(judged(), Verdict::pass);
}

// Liquid that starts 1e-5 m above its still level, recorded from 0 s and judged from 5 s on.
class GateOnTheStart : public ::testing::Test {
 protected:
  static TimeSeries recorded() {
    TimeSeries series{"elevation@right", "m", {}, {}};
    for (int i = 0; i <= 1000; ++i) {
      series.time.push_back(0.01 * i);
      series.value.push_back(1e-5 + 0.3 * std::sin(0.01 * i) * (i > 0));
    }
    return series;
  }
  GateOutcome judge(const TimeSeries& whole) const {
    const FindSeries window = [&](const std::string&, const std::string&) {
      return cut_to_window(whole, {5, 10});
    };
    const FindHistory history = [&](const std::string&, const std::string&) { return whole; };
    return evaluate(row, {{"sph", {RunState::finished, ""}}},
                    {{}, window, {}, {}, {}, {}, history, {}, {}, {}, 0.01});
  }

  GateRow row = row_of(Metric::initial_value, "whole", "m", 0.0035);
};

TEST_F(GateOnTheStart, SeesADatumThatIsOffAndNothingOfTheWave) {
  const GateOutcome outcome = judge(recorded());
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_EQ(outcome.value.value, 1e-5);
  for (const double offset : {0.007, -0.007, 0.35}) {
    TimeSeries shifted = recorded();
    for (double& value : shifted.value) value += offset;
    EXPECT_EQ(judge(shifted).verdict, Verdict::violated) << offset;
  }
}

TEST_F(GateOnTheStart, DoesNotJudgeASeriesWithoutIts) {
  TimeSeries late = recorded(), truncated = recorded(), poisoned = recorded(), scaled = recorded();
  late.time.erase(late.time.begin(), late.time.begin() + 2);
  late.value.erase(late.value.begin(), late.value.begin() + 2);
  truncated.time.resize(700);
  truncated.value.resize(700);
  poisoned.value[700] = nan;
  for (const TimeSeries& series : {late, truncated, poisoned})
    EXPECT_EQ(judge(series).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(late).message,
            "the sample of elevation@right nearest to the start is at 0.02 s; expected one within "
            "0.01 s of 0 s, where initial_value is measured");
  for (double& value : scaled.value) value *= 1000;
  EXPECT_EQ(judge(scaled).verdict, Verdict::violated);
  TimeSeries early = recorded(), later = recorded();
  for (double& value : early.value) value += 1;
  early.time[0] = -5;
  early.value[0] = 0;
  EXPECT_EQ(judge(early).verdict, Verdict::violated) << "of 0.01 s";
  for (auto* column : {&later.time, &later.value})
    column->erase(column->begin(), column->begin() + 100);
  later.time[0] = 0.49;
  later.value[0] = 0;
  EXPECT_EQ(judge(later).verdict, Verdict::not_compared);
  poisoned = recorded();
  poisoned.value[0] = nan;
  EXPECT_NE(judge(poisoned).verdict, Verdict::pass);
}

class GateOnCost : public ::testing::Test {
 protected:
  GateOnCost() { row.error = 0.1; }

  GateOutcome judge(const CostAtError& found) const {
    return judge_by([&](const GateRow&) { return found; });
  }
  GateOutcome judge_by(const MeasureCost& cost) const {
    return evaluate(row, all_finished(), {{}, no_series, {}, {}, cost});
  }
  static CostAtError costs(double value, double spread) {
    return {Reach::between, value, spread, 0.8, {}, {}};
  }

  GateRow row = row_of(Metric::cost_to_reach, "whole", "s", 20);
};

TEST_F(GateOnCost, PassesACostBelowItsLimitAndFailsOneThatIsScaledAboveIt) {
  const GateOutcome cheap = judge(costs(15, 0.1));
  EXPECT_EQ(cheap.verdict, Verdict::pass);
  EXPECT_EQ(cheap.message, "15.0 ± 1.6 s ≤ 20 s");  // 15 (e^0.1 - 1)
  EXPECT_EQ(judge(costs(18.5, 0.1)).verdict, Verdict::inconclusive);
  const GateOutcome dear = judge(costs(1.5 * 15, 0.1));
  EXPECT_EQ(dear.verdict, Verdict::violated);
  EXPECT_EQ(dear.message, "22.5 ± 2.4 s is not ≤ 20 s");
}

TEST_F(GateOnCost, FailsAnErrorThatIsNeverReachedAndSaysHowFarItGot) {
  CostAtError found{Reach::not_at_all, nan, nan, nan, {}, {}};
  found.most_exact = WorkPoint{"sph", 1, {85, 1}, {0.057, 0}};
  row.error = 0.05;
  const GateOutcome outcome = judge(found);
  EXPECT_EQ(outcome.verdict, Verdict::violated);
  EXPECT_TRUE(std::isnan(outcome.value.value));
  EXPECT_EQ(outcome.message, "not reached (5.7 % at 85 s) is not ≤ 20 s");
  found.most_exact.reset();
  EXPECT_EQ(judge(found).verdict, Verdict::violated);
}

TEST_F(GateOnCost, PassesNoCostThatIsNoNumberOrWhoseSpreadIsNone) {
  EXPECT_EQ(judge(costs(nan, 0.1)).verdict, Verdict::violated);
  EXPECT_EQ(judge(costs(1, nan)).verdict, Verdict::inconclusive);
}

TEST_F(GateOnCost, IsNotComparedWithoutTimingsAndLeftOutWithItsRuns) {
  const GateOutcome untimed =
      judge_by([](const GateRow&) -> CostAtError { throw ComparisonError("not timed"); });
  EXPECT_EQ(untimed.verdict, Verdict::not_compared);
  EXPECT_EQ(untimed.message, "not timed");
  const GateOutcome left_out =
      judge_by([](const GateRow&) -> CostAtError { throw NotSelectedError("finer runs"); });
  EXPECT_EQ(left_out.verdict, Verdict::not_selected);
}

TEST_F(GateOnCost, IsNamedByItsError) {
  EXPECT_EQ(row_name(row), "sph against linear, whole cost_to_reach 10 % of elevation@right");
  row.unit = "h";
  EXPECT_EQ(judge(costs(1, 0)).verdict, Verdict::not_compared);
}

GateOutcome outcome_of(Verdict verdict) { return {amplitude_row, verdict, {nan, nan}, ""}; }

TEST(GateExitStatus, IsThatOfTheWorstOutcome) {
  const auto pass = outcome_of(Verdict::pass), violated = outcome_of(Verdict::violated),
             failed = outcome_of(Verdict::solver_failed),
             missing = outcome_of(Verdict::not_compared),
             skipped = outcome_of(Verdict::not_selected),
             not_there = outcome_of(Verdict::not_supplied);
  EXPECT_EQ(exit_status({pass, pass}), 0);
  EXPECT_EQ(exit_status({pass, skipped}), 0);
  EXPECT_EQ(exit_status({pass, not_there}), 0);
  EXPECT_EQ(exit_status({violated, not_there}), 1);
  EXPECT_EQ(exit_status({pass, missing}), 4);
  EXPECT_EQ(exit_status({pass, missing, violated}), 1);
  EXPECT_EQ(exit_status({missing, violated, failed}), 3);
}

TEST(GateExitStatus, IsNotComparedWhereNoRowWasEvaluated) {
  EXPECT_EQ(exit_status({}), 4);
  EXPECT_EQ(exit_status({outcome_of(Verdict::not_selected), outcome_of(Verdict::not_selected)}), 4);
  EXPECT_EQ(exit_status({outcome_of(Verdict::not_supplied)}), 4);
}

TEST(GateMetrics, HaveNamesAndUnits) {
  EXPECT_EQ(metric_name(Metric::phase_lag), "phase_lag");
  EXPECT_EQ(metric_unit(Metric::phase_lag, "m"), "deg");
  EXPECT_EQ(metric_unit(Metric::mean_offset, "m"), "m");
  EXPECT_EQ(metric_unit(Metric::aligned_rms, "m"), "1");
  EXPECT_EQ(metric_unit(Metric::decay_rate, "m"), "1/s");
  EXPECT_EQ(metric_unit(Metric::decay_error, "m"), "1");
}

}  // namespace
}  // namespace slosh::gate_test
