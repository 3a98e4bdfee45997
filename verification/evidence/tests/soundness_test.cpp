// Runs that have recorded of themselves that they are not sound, on the small surge of
// surge_results.hpp.
#include "verification/evidence/soundness.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "verification/evidence/tests/row_of_a_record.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::soundness_test {
namespace {

class Soundness : public ::testing::Test {
 protected:
  Soundness() { definition.gate.resize(1); }

  std::string doubt_of(const std::string& run) const {
    return soundness_doubt(definition, runs, {run});
  }
  GateOutcome judged() const { return assess(definition, runs).gate.at(0); }
  // A hundred samples, of which the first `count` are `peak`.
  void record(const std::string& name, double usual, double peak = 0, int count = 0) {
    TimeSeries series{name, "1", {}, {}};
    for (int i = 0; i < 100; ++i) {
      series.time.push_back(0.2 * i);
      series.value.push_back(i < count ? peak : usual);
    }
    runs.results.at("particles").series.push_back(series);
  }
  void forget() { runs = surge_runs(); }

  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
};

TEST_F(Soundness, IsDoubtedBeyondEachLimitAndOfNaN) {
  const std::pair<const char*, double> limits[] = {{"mach_number", 0.2},
                                                   {"density_error", 0.05},
                                                   {"packing_drift", 0.01},
                                                   {"tension_share", 0.5}};
  for (const auto& [name, limit] : limits) {
    forget();
    record(name, limit);
    EXPECT_EQ(doubt_of("particles"), "") << name;
    forget();
    record(name, 1.01 * limit);
    EXPECT_NE(doubt_of("particles"), "") << name;
    forget();
    record(name, 0, not_a_number, 1);
    EXPECT_NE(doubt_of("particles"), "") << name;
  }
  forget();
  record("mach_number", 0.42);
  record("density_error", 0.21);
  EXPECT_EQ(doubt_of("particles"),
            "particles is not sound: its Mach number but for 5 % of the time is 0.42, limit 0.2, "
            "its density error but for 5 % of the time is 0.21, limit 0.05");
  EXPECT_EQ(doubt_of("theory"), "");
}

TEST_F(Soundness, IsNotDoubtedOfAFewFastDropsAndShortImpacts) {
  record("mach_number", 0.1, 0.4, 5);
  record("density_error", 0.01, 0.2, 5);
  EXPECT_EQ(doubt_of("particles"), "");
  forget();
  record("mach_number", 0.1, 0.4, 6);
  EXPECT_NE(doubt_of("particles"), "");
}

// What exceeds its limit for 5 % of the run may last for all of a row's part; what spoilt the
// liquid before the part belongs to it, what comes later does not.
TEST_F(Soundness, IsThatOfTheTimeOfTheRowAndOfAllThatLedToIt) {
  record("mach_number", 0.1, 0.4, 5);
  const auto doubt_over = [&](double begin, double end) {
    definition.window_begin = begin;
    definition.window_end = end;
    return doubt_of("particles");
  };
  EXPECT_NE(doubt_over(0, 1), "");
  EXPECT_NE(doubt_over(1.1, 2), "");
  EXPECT_EQ(doubt_over(10, 20), "");
  forget();
  record("mach_number", 0.4, 0.1, 50);  // from 10 s on
  EXPECT_EQ(doubt_over(1, 9), "");
}

// The coarse run is named by the refinement alone.
TEST_F(Soundness, OfARunThatTheRowRestsOnKeepsItFromPassing) {
  OfARecord row(Metric::rms_error, "whole", "1", 0.5, 0.01);
  row.definition.inputs = {{Input::amplitude, 1e-6, "a guess"}};
  EXPECT_EQ(row.judged().verdict, Verdict::pass) << row.judged().message;
  row.runs.results.at("coarse_particles").diagnostics = {{"mach_number", 0.4}};
  const GateOutcome outcome = row.judged();
  EXPECT_TRUE(holds(outcome.message, "coarse_particles is not sound"));
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
}

TEST_F(Soundness, OfAMeshIsItsCourantNumber) {
  runs.results.at("fine_mesh").diagnostics = {{"max_courant_number", 1.2}};
  EXPECT_EQ(doubt_of("fine_mesh"),
            "fine_mesh is not sound: its largest Courant number is 1.2, limit 1");
}

TEST_F(Soundness, OfALiquidWithoutWeightHasNoLimitOfTension) {
  record("tension_share", 0.9);
  definition.gravity = 0;
  EXPECT_EQ(doubt_of("particles"), "");
}

TEST_F(Soundness, KeepsAValidationRowFromPassingAndIsToldBesideEveryRow) {
  EXPECT_EQ(judged().verdict, Verdict::pass);
  record("mach_number", 0.42);
  const GateOutcome outcome = judged();
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_TRUE(holds(outcome.message, "; doubtful: particles is not sound: its Mach number"));
  definition.gate[0].kind = RowKind::regression;
  const GateOutcome regression = judged();
  EXPECT_EQ(regression.verdict, Verdict::pass);
  EXPECT_TRUE(holds(regression.message, "doubtful"));
}

TEST_F(Soundness, IsToldOfARowOnWhatTheRunRecordsOfItselfAndKeepsItFromNothing) {
  definition.gate = {surge_row("whole", Metric::largest_magnitude, "1", 0.5)};
  definition.gate[0].reference.clear();
  definition.gate[0].quantity = "mach_number";
  record("mach_number", 0.42);
  const GateOutcome outcome = judged();
  EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
  EXPECT_TRUE(holds(outcome.remarks, "doubtful: particles is not sound"));
  EXPECT_TRUE(outcome.is_doubtful);
}

// What a run of Slosh records where c0 is twice the expected speed, and ten times.
TEST_F(Soundness, OfALiquidThatIsTooSoftKeepsItsRowFromPassing) {
  for (const double ratio : {2.0, 10.0}) {
    SphRun solver{"recommended", 0.05, 0.05};
    solver.numbers.sound_speed_ratio = ratio;
    const RunResult result = execute(sample_case(), sample_run(solver), {}, [](double, double) {});
    forget();
    for (const char* name : {"mach_number", "density_error", "packing_drift", "tension_share"})
      runs.results.at("particles").series.push_back(result.at(name));
    EXPECT_EQ(judged().verdict, ratio == 2 ? Verdict::inconclusive : Verdict::pass)
        << judged().message;
  }
}

TEST_F(Soundness, OfASurfaceOutsideOfTheTankKeepsItsRowFromPassing) {
  TimeSeries wave = elevation_of({});
  for (double& value : wave.value) value += 5;
  runs.results.at("particles") = result_of("particles", wave);
  const GateOutcome outcome = judged();
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
  EXPECT_TRUE(holds(outcome.message, "outside of the tank"));
  // Below the floor a gauge reads the floor, and there is nothing to compare.
  for (double& value : wave.value) value -= 8;
  runs.results.at("particles") = result_of("particles", wave);
  EXPECT_EQ(judged().verdict, Verdict::not_compared) << judged().message;
}

// As where a tank stands still for a while.
TEST_F(Soundness, OfATheoryIsNotThatOfASensor) {
  TimeSeries held = elevation_of({});
  for (double& value : held.value) value = std::max(value, -0.001);
  runs.results.at("theory") = result_of("theory", held);
  EXPECT_FALSE(holds(judged().message, "the reference stays"));
}

TEST_F(Soundness, IsNoMatterOfTheStart) {
  definition.gate = {surge_row("whole", Metric::initial_value, "m", 0.0035)};
  definition.gate[0].reference.clear();
  record("mach_number", 0.42);
  EXPECT_EQ(judged().verdict, Verdict::pass) << judged().message;
}

TEST_F(Soundness, OfACaseIsThatOfTheRunsThatItsRowsJudge) {
  EXPECT_EQ(doubtful_runs(definition, runs), "");
  for (const char* mesh : {"coarse_mesh", "fine_mesh"})
    runs.results.at(mesh).diagnostics = {{"max_courant_number", 3}};
  EXPECT_EQ(doubtful_runs(definition, runs), "");
  record("mach_number", 0.42);
  definition.gate[0].reference = "fine_mesh";
  EXPECT_EQ(
      doubtful_runs(definition, runs),
      "doubtful: small_surge: particles is not sound: its Mach number but for 5 % of the time "
      "is 0.42, limit 0.2; fine_mesh is not sound: its largest Courant number is 3, limit 1");
  definition.gate[0].kind = RowKind::regression;
  EXPECT_TRUE(holds(judged().message, "; fine_mesh is not sound"));
}

}  // namespace
}  // namespace slosh::soundness_test
