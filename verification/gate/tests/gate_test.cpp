#include "verification/gate/gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "verification/gate/measured_value.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::gate_test {
namespace {

using enum Verdict;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

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

GateRow rms_row(double limit) { return row_of(Metric::normalised_rms, "whole", "1", limit); }
GateRow mean_row(double limit) { return row_of(Metric::mean_offset, "whole", "m", limit); }

GateRow between(GateRow row, double lower, double upper) {
  row.limit.reset();
  row.between = {lower, upper};
  return row;
}

GateRow improving(GateRow row) {
  row.limit.reset();
  row.improves_on = "sph_coarse";
  return row;
}

GateRow regression(GateRow row) {
  row.kind = RowKind::regression;
  return row;
}

// Whether the verdict is this one and the message says that.
::testing::AssertionResult is(const GateOutcome& outcome, Verdict verdict,
                              const std::string& says = "") {
  return ::testing::AssertionResult(outcome.verdict == verdict &&
                                    outcome.message.find(says) != std::string::npos)
         << verdict_name(outcome.verdict) << ": " << outcome.message;
}

using Runs = std::map<std::string, RunStatus>;

Runs all_finished() {
  return {{"sph", {RunState::finished, ""}},
          {"sph_coarse", {RunState::finished, ""}},
          {"linear", {RunState::finished, ""}}};
}

Runs with(const std::string& run, RunState state, const std::string& message = "") {
  Runs runs = all_finished();
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

// Rows that compare must not ask for a run's own series.
GateEvidence comparing(const FindComparison& find, const FindUncertainty& uncertainty = {}) {
  return {find,
          [](const std::string& run, const auto&) -> TimeSeries {
            throw std::logic_error("the row asked for a series of " + run);
          },
          {},
          uncertainty};
}

FindComparison always(const Comparison& comparison) {
  return [&](const auto&, const auto&, const auto&) -> const Comparison& { return comparison; };
}

GateOutcome judge(const GateRow& row, const Comparison& comparison,
                  const UncertaintyContributions& found = {}) {
  return evaluate(row, all_finished(),
                  comparing(always(comparison), [&](const GateRow&) { return found; }));
}

GateOutcome judge(const GateRow& row, const Runs& runs) {
  const Comparison comparison = comparison_of(0.01);
  return evaluate(row, runs, comparing(always(comparison)));
}

TEST(Gate, DoesNotPassOnWhatTheSamplesDoNotTell) {
  Comparison comparison = comparison_of(0);
  comparison.unseen = UnseenInterval{3, 3.5, 0.02};
  EXPECT_TRUE(is(judge(rms_row(0.2), comparison), inconclusive,
                 "no sample between 3 and 3.5 s, where the candidate departs by up to 0.02 m"));
  comparison.unseen->in_candidate = true;
  EXPECT_TRUE(is(judge(rms_row(0.2), comparison), inconclusive,
                 "the candidate has no sample between 3 and 3.5 s"));
  EXPECT_TRUE(is(judge(rms_row(0.05), comparison), violated));
  EXPECT_TRUE(is(judge(regression(rms_row(0.2)), comparison), pass, "no sample"));
  EXPECT_TRUE(is(judge(amplitude_row, comparison), pass));  // of each series' own fit
  Comparison doubtful = comparison_of(0);
  doubtful.doubts = {"the values of the candidate lie 0.01 m apart"};
  EXPECT_TRUE(
      is(judge(amplitude_row, doubtful), inconclusive, "; doubtful: the values of the candidate"));
  EXPECT_TRUE(is(judge(regression(amplitude_row), doubtful), pass));
  Comparison covered = comparison_of(0);
  covered.covered = 0.7;
  EXPECT_TRUE(is(judge(amplitude_row, covered), pass, "; over 70 % of the window"));
  covered.covered = 0.31;
  EXPECT_TRUE(is(judge(regression(amplitude_row), covered), not_compared,
                 "the samples cover 31 % of the window; expected half of it or more"));
}

TEST(Gate, MeasuresAgainstAConstantReferenceWhatNeedsNoVariation) {
  Comparison comparison = comparison_of(0);
  comparison.reference_is_constant = true;
  comparison.modes.clear();
  EXPECT_TRUE(is(judge(mean_row(0.01), comparison), pass));
  EXPECT_TRUE(is(judge(mean_row(0.001), comparison), violated));
  for (const GateRow& row :
       {rms_row(0.5), row_of(Metric::rms_error, "whole", "1", 0.9), amplitude_row})
    EXPECT_TRUE(is(judge(row, comparison), not_compared, "constant"));
}

// Each with the interval of its metric: +- 0.001 of the amplitude and of the decay, +- 0.1 deg of
// the lag, none of the others.
TEST(Gate, PassesWhereTheIntervalIsWithinTheBoundsAndIsInconclusiveWhereItReachesAcross) {
  const GateRow decay = row_of(Metric::decay_rate, "natural_1", "1/s", 0);
  const struct {
    GateRow row;
    double value;  // of the amplitude error
    Verdict verdict;
    const char* says = "";
  } judged[] = {
      {rms_row(0.1), 0, pass},
      {rms_row(0.0999), 0, violated},
      {amplitude_row, 0.0489, pass},
      {amplitude_row, -0.0489, pass},
      {amplitude_row, 0.0491, inconclusive},
      {amplitude_row, 0.05, inconclusive, "5.00 ± 0.10 % cannot be distinguished from 5 %"},
      {amplitude_row, 0.0509, inconclusive},
      {amplitude_row, -0.0491, inconclusive},
      {amplitude_row, -0.0509, inconclusive},
      {amplitude_row, 0.0511, violated},
      {amplitude_row, -0.0511, violated},
      {amplitude_row, 0.008, pass, "0.80 ± 0.10 % ≤ 5 %"},
      {amplitude_row, -0.08, violated, "|-8.00 ± 0.10 %| is not ≤ 5 %"},
      {row_of(Metric::phase_lag, "forced", "deg", 2), 0, pass, "1.50 ± 0.10 deg ≤ 2 deg"},
      {mean_row(0.003), 0, pass, "0.002 m ≤ 0.003 m"},
      {between(decay, 0.01, 0.03), 0, pass, "0.0200 ± 0.0010 1/s within 0.01 1/s to 0.03 1/s"},
      {between(decay, 0.0195, 0.03), 0, inconclusive},
      {between(decay, 0.0215, 0.03), 0, violated},
      {between(decay, 0.01, 0.0185), 0, violated},
      {row_of(Metric::amplitude_error, "forced", "1", 0.99), -0.98, inconclusive,
       "; doubtful: a candidate that does not move has -1"},
      {between(amplitude_row, -0.99, 0.05), -0.98, inconclusive, "does not move"},
      {between(amplitude_row, -0.99, 0.05), -0.9, pass},
      {row_of(Metric::phase_lag, "forced", "deg", 170), 0, pass, "1.50 ± 0.10 deg ≤ 170 deg"},
      {amplitude_row, nan, violated},
      {amplitude_row, infinity, violated},
      {between(amplitude_row, -1, 1), nan, violated},
      {row_of(Metric::amplitude_error, "forced", "1", nan), 0, violated},
      {row_of(Metric::frequency_error, "natural_2", "1", 0.1), 0, not_compared,
       "the mode natural_2 was not fitted"},
      {row_of(Metric::mean_offset, "whole", "Pa", 100), 0, not_compared},
      {row_of(Metric::phase_lag, "forced", "s", 100), 0, not_compared}};
  for (const auto& [row, value, verdict, says] : judged)
    EXPECT_TRUE(is(judge(row, comparison_of(value)), verdict, says)) << value;
}

TEST(Gate, CountsWhatElseIsUncertainBesideTheInterval) {
  const auto with_reference = [](double half_width) {
    return judge(amplitude_row, comparison_of(0.04), {.reference = half_width});
  };
  EXPECT_TRUE(is(with_reference(0.005), pass));
  const GateOutcome unsure = with_reference(0.02);
  EXPECT_TRUE(is(unsure, inconclusive));
  EXPECT_NEAR(unsure.judgement.value().uncertainty, std::hypot(0.02, 0.001), 1e-15);
  EXPECT_NEAR(unsure.judgement.value().conclusive_uncertainty, 0.01, 1e-15);
  EXPECT_TRUE(is(with_reference(nan), inconclusive));
}

TEST(Gate, DoesNotPassAValidationRowWhoseNumericalOrReferencesUncertaintyIsUnknown) {
  const Contribution unknown = Contribution::unknown("nobody refined the mesh");
  const Comparison small = comparison_of(0.01);
  for (const UncertaintyContributions& found :
       {UncertaintyContributions{.reference = unknown},
        UncertaintyContributions{.discretisation = unknown}}) {
    EXPECT_TRUE(is(judge(amplitude_row, small, found), inconclusive,
                   "1.00 ± 0.10 % ≤ 5 %; not included: nobody refined the mesh"));
    EXPECT_TRUE(is(judge(amplitude_row, comparison_of(0.08), found), violated));
    const GateOutcome watched = judge(regression(amplitude_row), small, found);
    EXPECT_TRUE(is(watched, pass));
    EXPECT_TRUE(watched.message.ends_with(" (regression)"));
    EXPECT_FALSE(is(judge(improving(amplitude_row), small, found), pass));
  }
  const GateOutcome outcome =
      judge(amplitude_row, small, {.input = Contribution::unknown("the paper is silent")});
  EXPECT_TRUE(is(outcome, pass)) << "inputs may be unknown, and that is kept";
  EXPECT_FALSE(outcome.judgement.value().contributions.input.half_width.has_value());
}

TEST(Gate, TakesEachMetricFromItsPlace) {
  const Comparison comparison = comparison_of(0.01);
  const struct {
    Metric metric;
    const char *mode, *unit;
    double value;
  } places[] = {{Metric::amplitude_error, "forced", "1", 0.01},
                {Metric::phase_lag, "forced", "deg", 1.5},
                {Metric::frequency_error, "natural_1", "1", -0.002},
                {Metric::decay_rate, "natural_1", "1/s", 0.02},
                {Metric::decay_error, "natural_1", "1", 0.25},
                {Metric::normalised_rms, "whole", "1", 0.1},
                {Metric::aligned_rms, "whole", "1", 0.05},
                {Metric::spectral_peak_error, "whole", "1", -0.1},
                {Metric::rms_error, "whole", "1", 0.5},
                {Metric::mean_offset, "whole", "m", 0.002}};
  for (const auto& [metric, mode, unit, value] : places) {
    EXPECT_DOUBLE_EQ(judge(row_of(metric, mode, unit, 1e9), comparison).value.value, value);
    EXPECT_EQ(metric_unit(metric, "m"), unit);
  }
  EXPECT_EQ(metric_name(Metric::phase_lag), "phase_lag");
}

TEST(Gate, CountsEachOfTwoPeaksOfNearlyTheSamePower) {
  Comparison comparison = comparison_of(0.01);
  comparison.reference_peaks = {{1, 2}, {2, 1.9}, {4, 1.7}};
  comparison.candidate_peaks = {{1, 2}};
  const GateRow row = row_of(Metric::spectral_peak_error, "whole", "1", 0.4);
  EXPECT_TRUE(is(judge(row, comparison), inconclusive));
  EXPECT_EQ(judge(row, comparison).value.half_width, 0.5);
  comparison.reference_peaks.erase(comparison.reference_peaks.begin() + 1);
  EXPECT_TRUE(is(judge(row, comparison), pass));
}

TEST(Gate, HasAValueForEveryMetricOfTheTable) {
  Comparison comparison = comparison_of(0.01);
  comparison.window = {0, 1};
  comparison.margin = TimeSeries{"margin", "m", {0, 1}, {1, -1}};
  const TimeSeries series = sampled([](double t) { return 0.1 * std::sin(5 * t); }, 0, 10);
  const FindSeries own = [&](const auto&, const auto&) { return series; };
  const GateEvidence evidence{
      .comparison = always(comparison),
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
  Comparison lost = comparison_of(0.01), lost_reference = lost, beating = lost;
  lost.modes[0].candidate.resolved = false;
  lost_reference.modes[0].reference.resolved = false;
  beating.modes[0].beside = 2 * std::numbers::pi * 0.25;
  const std::string expected = "; expected a longer window, or natural_modes = 0";
  EXPECT_TRUE(is(judge(amplitude_row, lost), not_compared,
                 "the candidate's mode forced cannot be resolved" + expected));
  EXPECT_TRUE(is(judge(amplitude_row, lost_reference), not_compared));
  EXPECT_TRUE(is(judge(rms_row(0.2), lost), pass));
  EXPECT_TRUE(is(judge(amplitude_row, beating), not_compared,
                 "cannot separate the mode forced from a component at 0.25 Hz" + expected));
}

TEST(Gate, DoesNotPassABoundThatACandidateOfNothingMeets) {
  Comparison comparison = comparison_of(0);
  comparison.largest_departure = 0.01;
  EXPECT_TRUE(is(judge(mean_row(0.0099), comparison), pass));
  EXPECT_TRUE(is(judge(mean_row(0.0101), comparison), inconclusive,
                 "the bounds hold 0.01 m, the reference's largest departure"));
  comparison.window = {0, 1};
  comparison.margin = TimeSeries{"margin", "m", {0, 1}, {1, 1}};
  for (const bool is_held : {true, false}) {
    const double nothing = is_held ? 1 : -1;
    comparison.margin_of_nothing = TimeSeries{"margin", "m", {0, 1}, {nothing, nothing}};
    EXPECT_TRUE(is(judge(row_of(Metric::outside_band, "whole", "1", 0.2), comparison),
                   is_held ? inconclusive : pass));
  }
}

TEST(Gate, DoubtsStepsOfMoreThanATenthOfTheBounds) {
  Comparison comparison = comparison_of(0);
  SensorLimits limits;
  limits.range = 4;
  limits.step = 0.04;
  comparison.in_steps = {{"candidate", "m", limits}};
  for (const auto& [passes, doubtful] : {std::pair{mean_row(0.41), mean_row(0.39)},
                                         {row_of(Metric::amplitude_error, "forced", "1", 0.21),
                                          row_of(Metric::amplitude_error, "forced", "1", 0.19)},
                                         {row_of(Metric::phase_lag, "forced", "deg", 12),
                                          row_of(Metric::phase_lag, "forced", "deg", 11)}}) {
    EXPECT_TRUE(is(judge(passes, comparison), pass));
    EXPECT_TRUE(is(judge(doubtful, comparison), inconclusive));
  }
}

TEST(Gate, TakesNoDecayErrorAgainstAReferenceWhoseDecayIsWithinItsInterval) {
  const GateRow row = row_of(Metric::decay_error, "natural_1", "1", 0.4);
  Comparison comparison = comparison_of(0);
  EXPECT_TRUE(is(judge(row, comparison), pass, "25 ± 8 % ≤ 40 %"));
  for (const Estimate decay : {Estimate{1e-4, 1e-3}, Estimate{-0.01, 1e-3}, Estimate{nan, 1e-3}}) {
    comparison.modes[1].reference.decay_rate = decay;
    EXPECT_TRUE(is(judge(row, comparison), not_compared)) << decay.value;
  }
  comparison = comparison_of(0);
  comparison.modes[1].decay_error.value = nan;
  EXPECT_TRUE(is(judge(row, comparison), violated));
}

class GateOnImprovement : public ::testing::Test {
 protected:
  GateOutcome outcome(double fine_error, double coarse_error,
                      const UncertaintyContributions& contributions = {}) const {
    return outcome_by(fine_error, coarse_error, [&](const GateRow&) { return contributions; });
  }
  GateOutcome outcome_by(double fine_error, double coarse_error,
                         const FindUncertainty& uncertainty) const {
    Comparison fine = comparison_of(fine_error), coarse = comparison_of(coarse_error);
    fine.normalised_rms.value = 0.05;  // coarse: 0.1
    const FindComparison find = [&](const std::string& run, const std::string& reference,
                                    const std::string&) -> const Comparison& {
      EXPECT_EQ(reference, "linear");
      return run == "sph" ? fine : coarse;
    };
    return evaluate(row, all_finished(), comparing(find, uncertainty));
  }

  GateRow row = improving(amplitude_row);
};

// Each +- 0.001; whatever stands still has -1.
TEST_F(GateOnImprovement, NeedsMoreThanBothIntervalsOrToReachZeroAndToBeBetterThanNothing) {
  const struct {
    double fine, coarse;
    Verdict verdict;
    const char* says = "";
  } judged[] = {{0.01, -0.02, pass},
                {-0.02, 0.01, violated},
                {0.0100, 0.0113, inconclusive},
                {0.01, 0.01, inconclusive},
                {0.0113, 0.0100, inconclusive},
                {0.0115, 0.0100, violated},
                {0.0100, 0.0115, pass},
                {0.0008, 0.0011, pass},
                {0.0008, 0.0009, inconclusive},
                {-0.9, 1.3, pass},
                {-1, 1.3, inconclusive, "a candidate of nothing is as good"},
                {-1 + 1e-9, 1.3, inconclusive},
                {-0.9995, -1.3, inconclusive},
                {1.2, 1.3, inconclusive},
                {nan, 0.01, violated},
                {0.01, nan, violated}};
  for (const auto& [fine, coarse, verdict, says] : judged)
    EXPECT_TRUE(is(outcome(fine, coarse), verdict, says)) << fine << " and " << coarse;
}

TEST_F(GateOnImprovement, DoesNotPassWhereTheOtherRunsUncertaintyIsUnknown) {
  for (const std::string unknown_of : {"sph", "sph_coarse"})
    EXPECT_TRUE(is(outcome_by(0.01, 0.1,
                              [&](const GateRow& of) {
                                UncertaintyContributions all;
                                if (of.candidate == unknown_of)
                                  all.discretisation =
                                      Contribution::unknown("nobody refined " + unknown_of);
                                return all;
                              }),
                   inconclusive, "; not included: nobody refined " + unknown_of));
}

// A reference that is off by d gives errors that are off by d. The two are as good as one another
// where d is the mean of both errors; of distances at half of their difference, at the worst.
TEST_F(GateOnImprovement, MustExceedWhatTheReferencesUncertaintyExplains) {
  const struct {
    double fine, coarse, reference;
    Verdict verdict;
  } judged[] = {{0.0136, 0.0899, 0.0517, pass},       {0.0136, 0.0899, 0.0518, inconclusive},
                {-0.0136, 0.0899, 0.0381, pass},      {-0.0136, 0.0899, 0.0382, inconclusive},
                {0.0899, 0.0136, 0.0517, violated},   {0.0899, 0.0136, 0.0518, inconclusive},
                {0.0008, 0.0899, 0.05, inconclusive},  // its interval holds zero
                {0.0136, 0.0899, nan, inconclusive},  {nan, 0.0899, 0.05, violated}};
  for (const auto& [fine, coarse, reference, verdict] : judged)
    EXPECT_TRUE(is(outcome(fine, coarse, {.reference = reference}), verdict)) << reference;
  EXPECT_TRUE(is(outcome(0.0136, 0.0899, {.input = 0.06}), inconclusive));
  EXPECT_TRUE(is(outcome(0.0136, 0.0899, {.time_series = 0.09}), inconclusive));
  EXPECT_TRUE(is(outcome(0.0136, 0.0899, {.reference = 0.06}), inconclusive,
                 "is not clearly < |8.99 ± 0.10 %| of sph_coarse; the reference and the "
                 "inputs may be off by 6 %, and both are as good at 5.17 %"));
  row = improving(rms_row(0));
  EXPECT_TRUE(is(outcome(0, 0, {.reference = 0.0249}), pass));
  EXPECT_TRUE(is(outcome(0, 0, {.reference = 0.0251}), inconclusive));
}

TEST(Gate, TellsWhichRunItLacksAndTheMostImportantReason) {
  const GateRow better = improving(amplitude_row);
  Runs without = all_finished(), left_out = with("sph", RunState::not_selected), not_there;
  without.erase("linear");
  left_out["linear"] = {RunState::failed, ""};
  not_there = with("linear", RunState::not_supplied, "expected a.csv");
  not_there["sph"] = {RunState::failed, ""};
  Runs neither = not_there;
  neither["sph"] = {RunState::not_selected, ""};
  const struct {
    GateRow row;
    Runs runs;
    Verdict verdict;
    const char* says = "";
  } judged[] = {
      {amplitude_row, with("sph", RunState::failed, "density out of range at 1.2 s"), solver_failed,
       "the candidate sph failed"},
      {amplitude_row, with("linear", RunState::out_of_range, "0.3 > 0.1 depths"), not_compared,
       "the reference linear is outside its declared range: 0.3 > 0.1 depths"},
      {amplitude_row, without, not_compared, "the reference linear is missing"},
      {amplitude_row, with("sph", RunState::not_selected), not_selected},
      {amplitude_row, left_out, not_selected},
      {amplitude_row, with("linear", RunState::not_supplied, "expected a.csv"), not_supplied,
       "the reference linear is not supplied: expected a.csv"},
      {amplitude_row, not_there, not_supplied},
      {amplitude_row, neither, not_selected},
      {better, with("sph_coarse", RunState::failed), solver_failed},
      {better, with("sph_coarse", RunState::not_selected), not_selected}};
  for (const auto& [row, runs, verdict, says] : judged) {
    const GateOutcome outcome = judge(row, runs);
    EXPECT_TRUE(is(outcome, verdict, says));
    EXPECT_TRUE(std::isnan(outcome.value.value));
  }
  EXPECT_EQ(judge(judged[0].row, judged[0].runs).message, judged[0].says)
      << "the run itself tells why";
}

// Through the real comparison: a candidate poisoned in each of these ways must turn the row red.
class GateOnSeries : public ::testing::Test {
 protected:
  static constexpr double frequency = 1.5;  // [rad/s]

  static TimeSeries wave(double amplitude, double delay, double end = 20) {
    return sampled([=](double t) { return amplitude * std::sin(frequency * (t - delay)); }, 0, end);
  }

  static GateOutcome judge_series(const GateRow& row, const TimeSeries& candidate) {
    Comparison comparison;
    return evaluate(
        row, all_finished(),
        comparing([&](const auto&, const auto&, const auto&) -> const Comparison& {
          comparison = compare(candidate, wave(0.01, 0), {0, 20}, {{"forced", frequency, false}});
          return comparison;
        }));
  }

  const GateRow lag = row_of(Metric::phase_lag, "forced", "deg", 1), rms = rms_row(0.02);
};

TEST_F(GateOnSeries, PassesATrueCandidateAndIsViolatedByAScaledOrShiftedOne) {
  for (const GateRow& row : {amplitude_row, lag, rms})
    EXPECT_TRUE(is(judge_series(row, wave(0.0101, 0.001)), pass));
  for (const GateRow& row : {amplitude_row, rms})
    EXPECT_TRUE(is(judge_series(row, wave(0.0106, 0)), violated));
  EXPECT_TRUE(is(judge_series(amplitude_row, wave(0.0094, 0)), violated));
  const double two_degrees = 2 * std::numbers::pi / 180 / frequency;
  for (const GateRow& row : {lag, rms})
    EXPECT_TRUE(is(judge_series(row, wave(0.01, two_degrees)), violated));
  EXPECT_TRUE(is(judge_series(lag, wave(0.01, -two_degrees)), violated));
}

TEST_F(GateOnSeries, DoesNotCompareATruncatedCandidateNorOneWithNaN) {
  TimeSeries poisoned = wave(0.01, 0);
  poisoned.value[1000] = nan;
  for (const GateRow& row : {amplitude_row, lag, rms})
    for (const TimeSeries& spoilt : {poisoned, wave(0.01, 0, 15)})
      EXPECT_TRUE(is(judge_series(row, spoilt), not_compared));
}

// "sph" and "linear" stand for ensembles; the amplitude error of each pair is told, each with a
// half width of its own that must not count.
class GateOnEnsemble : public ::testing::Test {
 protected:
  using Pair = std::pair<std::string, std::string>;

  GateOutcome judged(const std::map<Pair, double>& errors) { return judged(errors, finished()); }
  GateOutcome judged(const std::map<Pair, double>& errors, const Runs& runs) {
    for (const auto& [pair, error] : errors) comparisons[pair] = comparison_of(error);
    return judged(runs);
  }
  GateOutcome judged(const Runs& runs) const {
    GateEvidence evidence = comparing([this](const std::string& run, const std::string& reference,
                                             const std::string&) -> const Comparison& {
      return comparisons.at({run, reference});
    });
    evidence.ensemble = [this](const std::string& run) {
      return run == "sph" ? EnsembleOfRun{candidates} : EnsembleOfRun{references, exact};
    };
    return evaluate(row, runs, evidence);
  }
  Runs finished() const {
    Runs runs;
    for (const auto& names : {candidates, references})
      for (const std::string& run : names) runs[run] = {RunState::finished, ""};
    return runs;
  }
  static std::map<Pair, double> three(double a, double b, double c) {
    return {{{"sph", "linear"}, a}, {{"sph_2", "linear"}, b}, {{"sph_3", "linear"}, c}};
  }

  std::vector<std::string> candidates{"sph", "sph_2", "sph_3"}, references{"linear"};
  bool exact = true;
  std::map<Pair, Comparison> comparisons;
  GateRow row = amplitude_row;  // 5 %
  const std::map<Pair, double> scattered = three(0.01, 0.02, 0.06);
};

TEST_F(GateOnEnsemble, JudgesTheMeanByTheSpreadOfTheRepeatsAlone) {
  const GateOutcome outcome = judged(scattered);
  EXPECT_NEAR(outcome.value.value, 0.03, 1e-12);
  EXPECT_NEAR(outcome.value.half_width, 4.30265 * std::sqrt(7e-4 / 3), 1e-6);
  EXPECT_TRUE(is(outcome, inconclusive,
                 "3.0 ± 6.6 % cannot be distinguished from 5 %; mean over 3 x 1 repeats"));
  row.limit = 0.1;
  EXPECT_TRUE(is(judged(scattered), pass));
  EXPECT_TRUE(is(judged(three(0.01, nan, 0.06)), violated));
  row.limit = 0.005;
  EXPECT_TRUE(is(judged(three(0.03, 0.0301, 0.0299)), violated));
  exact = false;  // the spread of a single run on the other side
  EXPECT_NEAR(judged(scattered).value.half_width,
              std::hypot(4.30265 * std::sqrt(7e-4 * 4 / 3), 0.001), 1e-6);
}

TEST_F(GateOnEnsemble, TakesTheMeanOverAllPairs) {
  candidates = {"sph", "sph_2"};
  references = {"linear", "linear_2"};
  const GateOutcome outcome = judged({{{"sph", "linear"}, 0.01},
                                      {{"sph", "linear_2"}, 0.03},
                                      {{"sph_2", "linear"}, 0.02},
                                      {{"sph_2", "linear_2"}, 0.04}});
  EXPECT_NEAR(outcome.value.value, 0.025, 1e-12);
  EXPECT_TRUE(holds(outcome.message, "; mean over 2 x 2 repeats"));
}

TEST_F(GateOnEnsemble, IsNotJudgedOnFewerThanAllMembers) {
  Runs runs = finished();
  runs["sph_3"] = {RunState::missing, "it was not run"};
  EXPECT_TRUE(is(judged(scattered, runs), not_compared,
                 "the candidate sph_3 has no result: it was not run"));
  runs["sph_3"] = {RunState::failed, "a particle left the tank"};
  EXPECT_TRUE(is(judged(scattered, runs), solver_failed));
  runs.erase("sph_3");
  EXPECT_TRUE(is(judged(scattered, runs), not_compared));
}

TEST_F(GateOnEnsemble, FindsALagOfHalfATurnWhereverItIsWrapped) {
  row = row_of(Metric::phase_lag, "forced", "deg", 20);
  judged(three(0, 0, 0));
  for (const auto& [run, lag] : {std::pair{"sph", 178}, {"sph_2", -179}, {"sph_3", 179}})
    comparisons[{run, "linear"}].modes[0].phase_lag_degrees.value = lag;
  const GateOutcome outcome = judged(finished());
  EXPECT_NEAR(outcome.value.value, 179.333, 1e-3);
  EXPECT_TRUE(is(outcome, violated));
}

// Judges a row on the candidate's own series, sampled every 0.01 s, over a part of its time.
GateOutcome judge_own(const GateRow& row, const TimeSeries& whole, TimeWindow over = {0, 10},
                      GateEvidence evidence = {}) {
  evidence.series = [&](const std::string& run, const std::string& quantity) {
    EXPECT_EQ(run, "sph");
    EXPECT_EQ(quantity, whole.name);
    return cut_to_window(whole, over);
  };
  evidence.history = [&](const auto&, const auto&) { return whole; };
  evidence.sample_interval = 0.01;
  evidence.judged = over;
  return evaluate(row, {{"sph", {RunState::finished, ""}}}, evidence);
}

GateRow own_row(Metric metric, const std::string& quantity, const std::string& unit, double limit) {
  GateRow row = row_of(metric, "whole", unit, limit);
  row.reference.clear();
  row.quantity = quantity;
  return row;
}

TimeSeries series_of(const GateRow& row, const std::function<double(double)>& value,
                     double interval = 0.01) {
  TimeSeries series = sampled(value, 0, 10, interval);
  series.name = row.quantity;
  series.unit = row.unit;
  return series;
}

TimeSeries without(TimeSeries series, std::ptrdiff_t begin, std::ptrdiff_t end) {
  for (std::vector<double>* of : {&series.time, &series.value})
    of->erase(of->begin() + begin, of->begin() + end);
  return series;
}

class GateOnOwnSeries : public ::testing::Test {
 protected:
  // Between -0.5 and 0.5, largest at the end.
  TimeSeries gap(double scale = 1) const {
    TimeSeries series = series_of(row, [&](double t) { return scale * 0.05 * t; });
    for (std::size_t i = 0; i < series.value.size(); i += 2) series.value[i] *= -1;
    return series;
  }

  GateRow row = own_row(Metric::largest_magnitude, "wall_gap", "1", 0.5);
};

TEST_F(GateOnOwnSeries, PassesUpToItsLimitOnEitherSideAndNeverNaN) {
  EXPECT_TRUE(is(judge_own(row, gap()), pass, "50 % ≤ 50 %; at 10 s of 0 to 10 s"));
  EXPECT_TRUE(is(judge_own(row, gap(-1)), pass));
  EXPECT_EQ(judge_own(row, gap()).value.value, 0.5);
  EXPECT_TRUE(is(judge_own(row, gap(1.01)), violated));
  EXPECT_TRUE(is(judge_own(row, gap(-1.01)), violated));
  TimeSeries poisoned = gap(), infinite = gap(), empty = without(gap(), 0, 1001);
  poisoned.value[500] = nan;
  infinite.value[0] = infinity;
  for (const TimeSeries& series : {without(gap(), 900, 1001), poisoned, infinite, empty})
    EXPECT_TRUE(is(judge_own(row, series), not_compared));
  for (const TimeSeries& handed : {poisoned, empty})  // whoever does not cut it to the window
    EXPECT_TRUE(is(evaluate(row, {{"sph", {RunState::finished, ""}}},
                            {{}, [&](const auto&, const auto&) { return handed; }}),
                   violated));
  EXPECT_TRUE(is(evaluate(row, {{"sph", {RunState::failed, "a particle left the tank"}}}, {}),
                 solver_failed));
  const TimeSeries in_one = gap();
  row.unit = "m";
  EXPECT_TRUE(
      is(judge_own(row, in_one), not_compared, "largest_magnitude is in 1, the row's limit in m"));
}

TEST_F(GateOnOwnSeries, DoesNotPassWithAHoleAndSaysWhatTheSamplesCover) {
  EXPECT_TRUE(is(judge_own(row, without(gap(), 500, 512)), inconclusive,
                 "the candidate has no sample between"));
  EXPECT_TRUE(is(judge_own(row, without(gap(), 500, 800)), inconclusive,
                 "% of the window, which the samples cover"));
  EXPECT_TRUE(is(judge_own(row, without(gap(), 200, 900)), not_compared));
}

// A wave that is thinned to every third sample and has none above half of its crests, six medians
// long.
TEST_F(GateOnOwnSeries, DoesNotPassWithAHoleAtEveryCrest) {
  row = own_row(Metric::largest_magnitude, "elevation@right", "m", 0.5);
  TimeSeries kept{row.quantity, row.unit, {0}, {0}};
  for (int i = 3; i <= 1000; i += 3)
    if (const double value = 0.75 * std::sin(0.055 * i); std::abs(value) < 0.375 || i == 999) {
      kept.time.push_back(0.01 * i);
      kept.value.push_back(i == 999 ? 0.3 : value);
    }
  EXPECT_TRUE(is(judge_own(row, kept), inconclusive, "the candidate has no sample between"));
}

// The crest is as high as the trough is left.
TEST_F(GateOnOwnSeries, DoesNotPassWithATroughThatIsCutOff) {
  row = own_row(Metric::largest_magnitude, "elevation@right", "m", 0.5);
  const auto wave = [&](double cut) {
    return series_of(row, [=](double t) {
      const double s = std::sin(3 * t + 0.2);
      return std::max(s < 0 ? 1.3 * s : 0.45 * s, cut);
    });
  };
  EXPECT_TRUE(is(judge_own(row, wave(-0.46)), inconclusive, "stays at its lowest value"));
  row.limit = 1.4;
  EXPECT_TRUE(is(judge_own(row, wave(-2)), pass));
}

// What is smoothed, and what the sensor has read.
TEST_F(GateOnOwnSeries, DoesNotPassFilteredPressuresWhoseReadingsAreCutOff) {
  row = own_row(Metric::largest_magnitude, "wall_pressure@P/filtered", "Pa", 1000);
  const auto pressure = [&](double cut) {
    return series_of(row,
                     [=](double t) { return std::min(cut, 700 + 300 * std::sin(3 * t + 0.2)); });
  };
  for (const double cut : {850.0, 2000.0}) {
    GateEvidence evidence;
    evidence.readings = [&](const auto&, const auto&) { return pressure(cut); };
    EXPECT_TRUE(
        is(judge_own(row, pressure(2000), {0, 10}, evidence), cut < 1000 ? inconclusive : pass));
  }
}

TEST_F(GateOnOwnSeries, JudgesTheNoiseInASeriesInAShareOfItsDeviation) {
  row = own_row(Metric::noise_share, "wall_gap", "1", 0.05);
  EXPECT_TRUE(is(judge_own(row, gap()), violated));  // its sign turns at each sample
  TimeSeries smooth = series_of(row, [](double t) { return std::sin(t); });
  smooth.unit = "m";
  EXPECT_TRUE(is(judge_own(row, smooth), pass));
}

// At 6.7 samples a period the crest may lie 10 % above the highest, at 40 samples 0.3 %.
TEST_F(GateOnOwnSeries, DoubtsALargestValueThatTheSamplesMayMiss) {
  for (const double interval : {0.3, 0.05}) {
    TimeSeries wave{"wall_gap", "1", {}, {}};
    for (int i = 0; i * interval < 10; ++i) {
      wave.time.push_back(i * interval);
      wave.value.push_back(0.65 * std::sin(std::numbers::pi * (i + 0.5) * interval));
    }
    row.limit = 1.02 * *std::max_element(wave.value.begin(), wave.value.end());
    EXPECT_TRUE(is(judge_own(row, wave), interval < 0.1 ? pass : inconclusive));
    row.limit = 0.8;
    EXPECT_TRUE(is(judge_own(row, wave), pass));
  }
}

// A load of 30 N/m that swings with a period of 4 s, judged from 5 s on, and a slam before that.
class GateOnALoad : public ::testing::Test {
 protected:
  TimeSeries load(double slam) const {
    return series_of(row, [=](double t) {
      return 30 * std::sin(std::numbers::pi / 2 * t) +
             slam * std::exp(-std::pow((t - 1.2) / 0.02, 2));
    });
  }
  GateOutcome judge(const TimeSeries& whole, TimeWindow over = {0, 10}) const {
    GateEvidence evidence;
    evidence.rests = [&](const auto&) { return rests; };
    evidence.ensemble = [&](const auto& run) { return EnsembleOfRun{{run}, false, may_repeat}; };
    evidence.doubts_of_runs = [&](const GateRow&) { return doubts; };
    return judge_own(row, whole, over, evidence);
  }

  GateRow row = own_row(Metric::largest_magnitude, "force_x", "N/m", 60);
  bool may_repeat = false;
  std::vector<double> rests;
  RowDoubts doubts;
};

TEST_F(GateOnALoad, TellsWhenThePeakIsAndThatALargerOneLiesOutsideOfItsTime) {
  EXPECT_TRUE(is(judge(load(90)), violated, "; at 1.2 s of 0 to 10 s"));
  const GateOutcome later = judge(load(90), {5, 10});
  EXPECT_EQ(later.value.value, 30);
  EXPECT_TRUE(is(later, pass));
  EXPECT_TRUE(holds(later.remarks, "; LARGER outside of that time: 119 N/m at 1.2 s"));
  EXPECT_FALSE(holds(judge(load(0), {5, 10}).message, "LARGER"));
}

// An impact of 15 ms on samples of 10 ms: its top may lie between them.
TEST_F(GateOnALoad, DoubtsAPeakThatLastsForASample) {
  row.limit = 160;
  EXPECT_TRUE(is(judge(load(120)), pass));
  TimeSeries sharp = load(0);
  sharp.value[120] += 120;
  EXPECT_TRUE(is(judge(sharp), inconclusive, "lasts for about a sample"));
}

// Crests that are cut off at 10 N/m are none of the peak, which is a trough of -30 N/m.
TEST_F(GateOnALoad, DoubtsAFlatOnlyWhereThePeakMayBeCutOffAndTheQuantityDoesNotRest) {
  TimeSeries flat = load(0);
  for (double& value : flat.value) value = std::min(value, 10.0);
  const TimeSeries at_roof = flat;
  EXPECT_TRUE(is(judge(flat), pass));
  for (double& value : flat.value) value = std::clamp(value, -9.0, 10.0);
  row.limit = 11;
  EXPECT_TRUE(is(judge(flat), inconclusive));
  row.limit = 160;
  EXPECT_TRUE(is(judge(flat), pass));
  row = own_row(Metric::noise_share, "force_x", "1", 0.05);
  EXPECT_TRUE(is(judge(at_roof), inconclusive));
  rests = {10};
  EXPECT_TRUE(is(judge(at_roof), pass));
}

// The gauge fails from 4.06 s on, and four samples of the part are left.
TEST_F(GateOnALoad, DoubtsAPartAtWhoseEdgeSamplesAreMissing) {
  const TimeSeries failing = without(load(0), 407, 600);
  EXPECT_FALSE(is(judge(failing, {4, 5.5}), pass));
  EXPECT_TRUE(is(judge(failing, {6, 10}), pass));
}

TEST_F(GateOnALoad, SaysSingleRunWhereNoRunRepeatsIt) {
  EXPECT_TRUE(holds(judge(load(20)).message, "; single run: how its peaks scatter is not"));
  may_repeat = true;
  EXPECT_TRUE(
      holds(judge(load(20)).message, "; single run: `repeats` of sph tell how its peaks scatter"));
  row.quantity = "mach_number";
  EXPECT_FALSE(holds(judge(load(20)).message, "single run"));
}

TEST_F(GateOnALoad, DoesNotPassOnARunThatIsNotSound) {
  doubts = {"; doubtful: sph", true};
  EXPECT_TRUE(is(judge(load(0)), inconclusive));
  row.limit = 10;
  EXPECT_TRUE(is(judge(load(0)), violated));
  row.limit = 60;
  row.kind = RowKind::regression;
  EXPECT_TRUE(is(judge(load(0)), pass));
}

// Liquid that starts 1e-5 m above its still level, recorded from 0 s and judged from 5 s on.
class GateOnTheStart : public ::testing::Test {
 protected:
  TimeSeries recorded(double scale = 1, double offset = 0) const {
    return series_of(
        row, [=](double t) { return offset + scale * (1e-5 + 0.3 * std::sin(t) * (t > 0)); });
  }
  GateOutcome judge(const TimeSeries& whole) const { return judge_own(row, whole, {5, 10}); }

  GateRow row = own_row(Metric::initial_value, "elevation@right", "m", 0.0035);
};

TEST_F(GateOnTheStart, SeesADatumThatIsOffAndNothingOfTheWave) {
  const GateOutcome outcome = judge(recorded());
  EXPECT_TRUE(is(outcome, pass));
  EXPECT_EQ(outcome.value.value, 1e-5);
  for (const double offset : {0.007, -0.007, 0.35})
    EXPECT_TRUE(is(judge(recorded(1, offset)), violated)) << offset;
  EXPECT_TRUE(is(judge(recorded(1000)), violated));
}

TEST_F(GateOnTheStart, DoesNotJudgeASeriesWithoutIts) {
  TimeSeries poisoned = recorded(), unknown = recorded(), early = recorded(1, 1),
             later = without(recorded(), 0, 100);
  poisoned.value[700] = nan;
  unknown.value[0] = nan;
  early.time[0] = -5;
  later.time[0] = 0.49;
  early.value[0] = later.value[0] = 0;
  EXPECT_TRUE(is(judge(without(recorded(), 0, 2)), not_compared,
                 "the sample of elevation@right nearest to the start is at 0.02 s; expected one "
                 "within 0.01 s of 0 s, where initial_value is measured"));
  for (const TimeSeries& series : {without(recorded(), 700, 1001), poisoned, later})
    EXPECT_TRUE(is(judge(series), not_compared));
  EXPECT_TRUE(is(judge(early), violated)) << "of 0.01 s";
  EXPECT_FALSE(is(judge(unknown), pass));
}

class GateOnCost : public ::testing::Test {
 protected:
  GateOnCost() { row.error = 0.1; }

  GateOutcome judge(const CostAtError& found) const {
    return judge_by([&](const GateRow&) { return found; });
  }
  GateOutcome judge_by(const MeasureCost& cost) const {
    GateEvidence evidence = comparing({});
    evidence.cost = cost;
    return evaluate(row, all_finished(), evidence);
  }
  static CostAtError costs(double value, double spread) {
    return {Reach::between, value, spread, 0.8, {}, {}};
  }

  GateRow row = row_of(Metric::cost_to_reach, "whole", "s", 20);
};

TEST_F(GateOnCost, PassesACostBelowItsLimitAndFailsOneThatIsScaledAboveItOrIsNone) {
  EXPECT_TRUE(is(judge(costs(15, 0.1)), pass, "15.0 ± 1.6 s ≤ 20 s"));  // 15 (e^0.1 - 1)
  EXPECT_TRUE(is(judge(costs(18.5, 0.1)), inconclusive));
  EXPECT_TRUE(is(judge(costs(1.5 * 15, 0.1)), violated, "22.5 ± 2.4 s is not ≤ 20 s"));
  EXPECT_TRUE(is(judge(costs(nan, 0.1)), violated));
  EXPECT_TRUE(is(judge(costs(1, nan)), inconclusive));
  row.unit = "h";
  EXPECT_TRUE(is(judge(costs(1, 0)), not_compared));
}

TEST_F(GateOnCost, FailsAnErrorThatIsNeverReachedAndSaysHowFarItGot) {
  CostAtError found{Reach::not_at_all, nan, nan, nan, {}, {}};
  found.most_exact = WorkPoint{"sph", 1, {85, 1}, {0.057, 0}};
  row.error = 0.05;
  EXPECT_TRUE(is(judge(found), violated, "not reached (5.7 % at 85 s) is not ≤ 20 s"));
  EXPECT_TRUE(std::isnan(judge(found).value.value));
  found.most_exact.reset();
  EXPECT_TRUE(is(judge(found), violated));
}

TEST_F(GateOnCost, IsNotComparedWithoutTimingsAndLeftOutWithItsRuns) {
  EXPECT_TRUE(
      is(judge_by([](const GateRow&) -> CostAtError { throw ComparisonError("not timed"); }),
         not_compared, "not timed"));
  EXPECT_TRUE(
      is(judge_by([](const GateRow&) -> CostAtError { throw NotSelectedError("finer runs"); }),
         not_selected));
  EXPECT_EQ(row_name(row), "sph against linear, whole cost_to_reach 10 % of elevation@right");
}

// An error that is reached by less than the reference may be off is not known to be reached.
TEST_F(GateOnCost, DoubtsAnErrorThatTheReferenceDoesNotTell) {
  row.error = 0.12;
  row.limit = 30;
  const Comparison comparison = comparison_of(0);  // of a normalised rms of 10 %
  for (const auto& [reference, verdict] :
       {std::pair{Contribution(0.019), pass},
        {Contribution(0.021), inconclusive},
        {Contribution::unknown("the record declares none"), inconclusive}}) {
    GateEvidence evidence =
        comparing(always(comparison), [&reference = reference](const GateRow& of) {
          UncertaintyContributions all;
          if (of.metric == Metric::normalised_rms) all.reference = reference;
          return all;
        });
    evidence.cost = [](const GateRow&) {
      return CostAtError{Reach::between, 5, 0, 0, {"sph_coarse", "sph"}, {}};
    };
    EXPECT_TRUE(is(evaluate(row, all_finished(), evidence), verdict)) << reference.basis;
  }
}

TEST(GateExitStatus, IsThatOfTheWorstOutcome) {
  const std::pair<std::vector<Verdict>, int> statuses[] = {
      {{pass, pass}, 0},
      {{pass, not_selected}, 0},
      {{pass, not_supplied}, 0},
      {{violated, not_supplied}, 1},
      {{pass, not_compared}, 4},
      {{pass, not_compared, violated}, 1},
      {{not_compared, violated, solver_failed}, 3},
      {{}, 4},
      {{not_selected, not_selected}, 4},
      {{not_supplied}, 4}};
  for (const auto& [verdicts, status] : statuses) {
    std::vector<GateOutcome> outcomes;
    for (const Verdict verdict : verdicts) outcomes.push_back({amplitude_row, verdict, {}, ""});
    EXPECT_EQ(exit_status(outcomes), status);
  }
}

}  // namespace
}  // namespace slosh::gate_test
