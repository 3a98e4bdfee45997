// The time over which rows are judged, on the small surge of surge_results.hpp, whose window is
// that from 1 to 20 s.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/evidence/case_evidence.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::judged_time_test {
namespace {

// The elevation of theory with a slam of 0.5 m at 0.5 s, before the window.
TimeSeries with_slam() {
  TimeSeries wave = elevation_of({});
  for (std::size_t i = 0; i < wave.time.size(); ++i)
    wave.value[i] += 0.5 * std::exp(-std::pow((wave.time[i] - 0.5) / 0.1, 2));
  return wave;
}

class JudgedTime : public ::testing::Test {
 protected:
  JudgedTime() { runs.results["particles"] = result_of("particles", with_slam()); }

  GateOutcome judged(const GateRow& row) {
    definition.gate = {row};
    return assess(definition, runs).gate.at(0);
  }
  static GateRow peak_row() {
    GateRow row = surge_row("whole", Metric::largest_magnitude, "m", 0.1);
    row.reference.clear();
    return row;
  }
  // The first natural frequency of the tank [Hz], sqrt(g k tanh(k h)) / (2 pi) with k = pi / L.
  static double first_frequency() {
    const double k = std::numbers::pi;
    return std::sqrt(9.81 * k * std::tanh(k * 0.35)) / (2 * std::numbers::pi);
  }
  static GateRow frequency_row(double lower, double upper) {
    GateRow row = surge_row("natural_1", Metric::frequency, "Hz", 1);
    row.reference.clear();
    row.limit.reset();
    row.between = {lower, upper};
    return row;
  }

  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
};

TEST_F(JudgedTime, OfAPeakIsTheWholeRun) {
  const GateOutcome outcome = judged(peak_row());
  EXPECT_EQ(outcome.verdict, Verdict::violated) << outcome.message;
  EXPECT_GT(outcome.value.value, 0.45);
  EXPECT_NE(outcome.message.find("; at 0.5"), std::string::npos) << outcome.message;
}

TEST_F(JudgedTime, OfAPartIsThePartAndTellsOfALargerPeakOutside) {
  GateRow row = peak_row();
  row.part = {1, 20};
  const GateOutcome later = judged(row);
  EXPECT_EQ(later.verdict, Verdict::pass) << later.message;
  EXPECT_NE(later.message.find("LARGER outside"), std::string::npos) << later.message;
  EXPECT_NE(row_name(row).find("from 1 to 20 s"), std::string::npos);
  row.part = {0, 1};
  EXPECT_EQ(judged(row).verdict, Verdict::violated);
}

// The peaks of repeats are compared, over less than a period of the natural mode.
TEST_F(JudgedTime, OfAPeakOfRepeatsMayBeTooShortForAMode) {
  RunDefinition repeat = run_named(definition, "particles");
  repeat.name = "particles_2";
  for (RunDefinition& run : definition.runs)
    if (run.name == "particles") run.ensemble = "particles";
  repeat.ensemble = "particles";
  definition.runs.push_back(repeat);
  runs.results["particles_2"] = result_of("particles_2", with_slam());
  runs.status["particles_2"] = runs.status.at("particles");
  GateRow row = peak_row();
  row.limit = 0.6;
  row.part = {0.2, 1};
  EXPECT_EQ(judged(row).verdict, Verdict::pass) << judged(row).message;
  row.limit = 0.4;
  EXPECT_EQ(judged(row).verdict, Verdict::violated);
}

TEST_F(JudgedTime, OfAComparisonIsTheWindowOrThePart) {
  GateRow row = surge_row("whole", Metric::normalised_rms, "1", 0.1);
  EXPECT_EQ(judged(row).verdict, Verdict::pass);
  row.part = {0, 20};
  const GateOutcome whole = judged(row);
  EXPECT_EQ(whole.verdict, Verdict::violated) << whole.message;
  row.part = {5, 20};
  EXPECT_EQ(judged(row).verdict, Verdict::pass);
}

TEST_F(JudgedTime, OfTheFrequencyOfAModeNeedsNoReference) {
  const double theory = first_frequency();
  const GateOutcome outcome = judged(frequency_row(0.99 * theory, 1.01 * theory));
  EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
  EXPECT_NEAR(outcome.value.value, theory, 1e-4 * theory);
  EXPECT_EQ(judged(frequency_row(1.01 * theory, 1.05 * theory)).verdict, Verdict::violated);
  GateRow part = frequency_row(0.99 * theory, 1.01 * theory);
  part.part = {8, 20};
  EXPECT_EQ(judged(part).verdict, Verdict::pass) << judged(part).message;
  TimeSeries slow = elevation_of({});
  for (double& t : slow.time) t *= 1.03;
  runs.results["particles"] = result_of("particles", slow);
  EXPECT_EQ(judged(part).verdict, Verdict::violated);
  slow.value[300] = not_a_number;
  runs.results["particles"] = result_of("particles", slow);
  EXPECT_EQ(judged(part).verdict, Verdict::not_compared);
}

}  // namespace
}  // namespace slosh::judged_time_test
