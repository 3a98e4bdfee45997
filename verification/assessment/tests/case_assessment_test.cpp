// What a campaign makes of its runs' results, and that it turns red on every way in which they can
// be wrong.
#include "verification/assessment/case_assessment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "verification/series/sample_moments.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::case_assessment_test {
namespace {

constexpr double forcing_period = 2 * 3.14159265358979 / (0.3 * 4.94488);

std::set<Verdict> verdicts(const CaseAssessment& assessment) {
  std::set<Verdict> found;
  for (const GateOutcome& outcome : assessment.gate) found.insert(outcome.verdict);
  return found;
}

Verdict verdict_on(Metric metric, const CaseAssessment& assessment) {
  for (const GateOutcome& outcome : assessment.gate)
    if (outcome.row.metric == metric) return outcome.verdict;
  throw std::logic_error("no such row");
}

// Judged once, as the fits take most of the time of these tests.
const CaseAssessment& good() {
  static const CaseAssessment assessment = assess(surge_case(), surge_runs());
  return assessment;
}

// Judges theory and its candidate alone: the other pairs take three quarters of the time.
CaseAssessment assess_two(CaseRuns runs, CaseDefinition definition = surge_case()) {
  for (const char* other : {"theory_with_gas", "coarse_mesh", "fine_mesh"}) {
    std::erase_if(definition.runs, [&](const RunDefinition& run) { return run.name == other; });
    runs.results.erase(other);
    runs.status.erase(other);
  }
  return assess(definition, std::move(runs));
}

CaseAssessment assess_candidate(const TimeSeries& elevation) {
  return assess_two(surge_runs_with("particles", elevation));
}

TEST(CaseAssessment, PassesACandidateThatIsItsReferenceAndTakesTheWorstOfItsCases) {
  EXPECT_EQ(verdicts(good()), std::set{Verdict::pass});
  EXPECT_EQ(exit_status({good()}), exit_pass);
  const CaseAssessment high = assess_candidate(scaled(elevation_of({}), 1.1));
  EXPECT_EQ(verdict_on(Metric::phase_lag, high), Verdict::pass);
  EXPECT_NEAR(high.gate.front().value.value, 0.1, 1e-3);
  EXPECT_EQ(exit_status({good(), high}), exit_violated);
  EXPECT_EQ(exit_status({high, good()}), exit_violated);
}

TEST(CaseAssessment, RejectsOrDoesNotCompareWhatIsWrong) {
  using enum Verdict;
  const TimeSeries right = elevation_of({});
  TimeSeries late = right, broken = right, short_one = right, swapped = right, doubled = right;
  for (double& time : late.time) time += 0.05 * forcing_period;
  broken.value[250] = std::numeric_limits<double>::quiet_NaN();
  short_one.time.resize(450);  // 18 of 20 s
  short_one.value.resize(450);
  std::swap(swapped.time, swapped.value);
  doubled.value = doubled.time;
  const struct {
    CaseRuns runs;
    Metric metric;
    Verdict verdict;
    int status = exit_violated;
  } wrong[] = {
      {surge_runs_with("particles", scaled(right, 1.1)), Metric::amplitude_error, violated},
      {surge_runs_with("particles", scaled(right, 1000)), Metric::amplitude_error, violated},
      {surge_runs_with("particles", late), Metric::phase_lag, violated},
      {surge_runs_with("theory", elevation_of({.amplitude = -0.02})), Metric::phase_lag, violated},
      {surge_runs_with("particles", elevation_of({.gravity = 9.0})), Metric::frequency_error,
       violated},
      {surge_runs_with("particles", broken), Metric::phase_lag, not_compared, exit_not_compared},
      {surge_runs_with("particles", short_one), Metric::phase_lag, not_compared, exit_not_compared},
      {surge_runs_with("particles", swapped), Metric::phase_lag, not_compared, exit_not_compared},
      {surge_runs_without("theory", RunState::missing, "no such file"), Metric::phase_lag,
       not_compared, exit_not_compared},
      {surge_runs_without("coarse_mesh", RunState::failed, "no row names it"), Metric::phase_lag,
       pass, exit_solver_failed},
      {surge_runs_without("coarse_mesh", RunState::missing, "no such file"), Metric::phase_lag,
       pass, exit_not_compared},
      {surge_runs_without("coarse_mesh", RunState::not_supplied, "x.csv"), Metric::phase_lag, pass,
       exit_pass},
      {surge_runs_without("theory", RunState::not_supplied, "x.csv"), Metric::phase_lag,
       not_supplied, exit_not_compared},
      {surge_runs_without("particles", RunState::not_selected, ""), Metric::phase_lag, not_selected,
       exit_not_compared}};
  int line = 0;
  for (const auto& [runs, metric, verdict, status] : wrong) {
    const bool of_two = runs.status.at("coarse_mesh").state == RunState::finished;
    const CaseAssessment assessment = of_two ? assess_two(runs) : assess(surge_case(), runs);
    ++line;
    EXPECT_EQ(verdict_on(metric, assessment), verdict) << line;
    if (verdict != violated) {
      EXPECT_EQ(verdicts(assessment), std::set{verdict}) << line;
    }
    EXPECT_EQ(exit_status({assessment}), status) << line;
    if (verdict == not_supplied) {
      EXPECT_EQ(exit_status({assessment, good()}), exit_pass);
    }
    for (const GateOutcome& outcome : assessment.gate) {
      if (runs.status.at("theory").state == RunState::missing) {
        EXPECT_TRUE(holds(outcome.message, "no such file"));
      }
      if (outcome.verdict == violated && outcome.row.metric == Metric::phase_lag &&
          runs.results.at("particles").series[0].time[0] > 0) {
        // A twentieth of 360 degrees, late; the modes that are not fitted leave a quarter of one.
        EXPECT_NEAR(outcome.value.value, 18, 0.5);
      }
    }
  }
  // A ramp holds no tone but round-off: not compared, or compared and rejected.
  EXPECT_NE(exit_status({assess_candidate(doubled)}), exit_pass);
}

TEST(CaseAssessment, AsksForTheUnitOrTheSignOfACandidateThatIsAThousandfoldOrTurnedOver) {
  const auto remarks = [](double factor) {
    return assess_candidate(scaled(elevation_of({}), factor)).gate.front().remarks;
  };
  EXPECT_NE(remarks(1000).find("; unit? the candidate's swing is"), std::string::npos);
  EXPECT_EQ(remarks(0.001), "; unit? the candidate's swing is 0.001 times the reference's");
  EXPECT_TRUE(remarks(-1).starts_with("; sign? the candidate is the reference turned over"));
  EXPECT_EQ(remarks(2), "");
}

TEST(CaseAssessment, AsksForNoUnitOfSpikesADriftOrNoiseOnStillWater) {
  const TimeSeries wave = elevation_of({});
  TimeSeries spiked = wave, drifting = wave;
  for (std::size_t i = 0; i < wave.value.size(); ++i) {
    if (i % 50 == 7) spiked.value[i] += 5000 * rms(wave.value);
    drifting.value[i] += 60 * rms(wave.value) * wave.time[i];
  }
  const TimeSeries noise = with_noise(scaled(wave, 1e-9), 1e-3 * rms(wave.value), 0, 1);
  for (const TimeSeries& series : {spiked, drifting, noise})
    EXPECT_EQ(assess_candidate(series).gate.front().remarks.find("unit?"), std::string::npos);
}

TEST(CaseAssessment, ComparesNothingWithAReferenceOutOfItsRangeOrOfNone) {
  CaseRuns runs = surge_runs();
  for (const double elevation : {0.11, std::numeric_limits<double>::quiet_NaN()}) {
    runs.results.at("theory").diagnostics["highest_elevation_over_depth"] = elevation;
    const CaseAssessment assessment = assess_two(runs);
    EXPECT_EQ(assessment.runs.status.at("theory").state, RunState::out_of_range);
    EXPECT_EQ(verdicts(assessment), std::set{Verdict::not_compared});
    EXPECT_EQ(exit_status({assessment}), exit_not_compared);
  }
}

TEST(CaseAssessment, ComparesAForceWhereBothRunsLeftOne) {
  CaseRuns runs = surge_runs();
  TimeSeries force = elevation_of({});
  force.name = "force_x";
  force.unit = "N/m";
  for (const char* run : {"particles", "fine_mesh"}) runs.results.at(run).series.push_back(force);
  CaseDefinition definition = surge_case();
  GateRow row = surge_row("whole", Metric::mean_offset, "N/m", 0.1);
  row.quantity = "force_x";
  row.reference = "fine_mesh";
  row.kind = RowKind::regression;  // of a mesh that nobody refined
  definition.gate = {row};
  const CaseAssessment assessment = assess(definition, runs);
  EXPECT_EQ(verdicts(assessment), std::set{Verdict::pass}) << assessment.gate[0].message;
  EXPECT_TRUE(assessment.not_comparable.empty());
  int forces = 0;
  for (const Comparison& one : assessment.comparisons) forces += one.quantity == "force_x";
  EXPECT_EQ(forces, 1);
}

TEST(CaseAssessment, TellsOfAWallPressureThatARunDoesNotHave) {
  CaseDefinition definition = surge_case();
  definition.pressure_gauges = {{"b", Wall::left, 0.1}};
  const CaseAssessment assessment = assess(definition, surge_runs());
  ASSERT_FALSE(assessment.not_comparable.empty());
  EXPECT_NE(assessment.not_comparable[0].find("has no series wall_pressure@b"), std::string::npos);
}

TEST(CaseAssessment, PassesNothingWithoutCasesOrRowsNorAnUngatedCaseOfWhichNothingIsCompared) {
  EXPECT_EQ(exit_status(std::vector<CaseAssessment>{}), exit_not_compared);
  CaseDefinition ungated = surge_case();
  ungated.gate.clear();
  const CaseAssessment compared = assess(ungated, surge_runs());
  EXPECT_EQ(exit_status({compared}), exit_not_compared);
  EXPECT_EQ(exit_status({good(), compared}), exit_pass);
  CaseRuns broken = surge_runs();
  for (auto& [run, result] : broken.results) result.series[0].value[250] = std::nan("");
  const CaseAssessment nothing = assess(ungated, broken);
  ASSERT_FALSE(nothing.not_comparable.empty());
  EXPECT_TRUE(holds(nothing.not_comparable[0], "particles against theory: "));
  EXPECT_EQ(exit_status({good(), nothing}), exit_not_compared);
}

// Of a case without a reference.
class OwnSeriesAssessment : public ::testing::Test {
 protected:
  OwnSeriesAssessment() {
    row.reference.clear();
    row.quantity = "volume_drift";
    definition.gate = {row};
    definition.runs = {definition.runs.at(2)};  // there is no reference
  }
  static TimeSeries drift(double scale) {
    TimeSeries series = elevation_of({});
    series.name = "volume_drift";
    series.unit = "1";
    for (double& value : series.value) value = 0.01 * scale;
    return series;
  }
  CaseAssessment assess_drift(const TimeSeries& series) const {
    CaseRuns runs;
    runs.results["particles"] = surge_runs().results["particles"];
    runs.results["particles"].series.push_back(series);
    runs.status["particles"] = {RunState::finished, ""};
    return assess(definition, runs);
  }
  GateRow row = surge_row("whole", Metric::largest_magnitude, "1", 0.01);
  CaseDefinition definition = surge_case();
};

TEST_F(OwnSeriesAssessment, PassesWithinTheLimitAndNotScaledTruncatedPoisonedOrMissingData) {
  TimeSeries truncated = drift(1), poisoned = drift(1), misnamed = drift(1);
  truncated.time.resize(450);  // 18 of 20 s
  truncated.value.resize(450);
  poisoned.value[250] = std::nan("");
  misnamed.name = "volume";
  for (const auto& [series, verdict, status] :
       {std::tuple{drift(1), Verdict::pass, exit_pass},
        {drift(0), Verdict::pass, exit_pass},
        {drift(1.1), Verdict::violated, exit_violated},
        {truncated, Verdict::not_compared, exit_not_compared},
        {poisoned, Verdict::not_compared, exit_not_compared},
        {misnamed, Verdict::not_compared, exit_not_compared}}) {
    const CaseAssessment assessment = assess_drift(series);
    EXPECT_EQ(verdicts(assessment), std::set{verdict});
    EXPECT_EQ(exit_status({assessment}), status);
  }
}

std::vector<std::string> compared(const CaseAssessment& assessment) {
  std::vector<std::string> pairs;
  for (const Comparison& one : assessment.comparisons)
    pairs.push_back(one.candidate + " against " + one.reference);
  return pairs;
}

TEST(Comparisons, SetParticlesAgainstTheoryAndTheFinestMeshThatStandsAndMeshesAgainstTwoLayers) {
  using Pairs = std::vector<std::string>;
  EXPECT_EQ(compared(good()),
            (Pairs{"particles against theory", "particles against fine_mesh",
                   "coarse_mesh against theory_with_gas", "fine_mesh against theory_with_gas"}));
  EXPECT_EQ(
      compared(assess(surge_case(), surge_runs_without("fine_mesh", RunState::failed, "diverged"))),
      (Pairs{"particles against theory", "particles against coarse_mesh",
             "coarse_mesh against theory_with_gas"}));
  TimeSeries broken = elevation_of({});
  broken.value[250] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(compared(assess(surge_case(), surge_runs_with("coarse_mesh", broken))),
            (Pairs{"particles against theory", "particles against fine_mesh",
                   "fine_mesh against theory_with_gas"}));
  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
  definition.runs.erase(definition.runs.begin() + 1);
  runs.results.erase("theory_with_gas");
  runs.status.erase("theory_with_gas");
  EXPECT_EQ(compared(assess(definition, runs)).at(2), "coarse_mesh against theory");
}

// As SPH, on the quantities that it declares alone, and never as a reference.
TEST(Comparisons, SetAnExternalProgramAgainstOneLayerTheoryAndTheFinestMesh) {
  CaseDefinition definition = surge_case();
  definition.gauges.push_back({"left", 0.05});
  ExternalRun external;
  external.command = {"solve"};
  definition.runs.push_back(sample_run(external));
  definition.runs.back().name = "mine";
  CaseRuns runs = surge_runs_without("particles", RunState::not_selected, "");
  runs.results["mine"] = result_of("mine", scaled(elevation_of({}), 1.01));
  runs.status["mine"] = {RunState::finished, ""};
  const CaseAssessment assessment = assess(definition, std::move(runs));
  std::vector<std::string> references;
  for (const Comparison& comparison : assessment.comparisons) {
    if (comparison.candidate == "mine") references.push_back(comparison.reference);
    EXPECT_NE(comparison.reference, "mine");
  }
  EXPECT_EQ(references, (std::vector<std::string>{"theory", "fine_mesh"}));
  for (const std::string& why : assessment.not_comparable)
    EXPECT_FALSE(why.starts_with("mine against")) << why;
}

TEST(FittedModes, AreTheForcingAndTheFirstModesThatSurgeExcitesInTheTank) {
  CaseDefinition definition = surge_case();
  definition.natural_modes = 3;
  const auto modes = fitted_modes(definition);
  const std::pair<const char*, double> expected[] = {{"forced", 1.483464},
                                                     {"natural_1", 4.96646},
                                                     {"natural_3", 9.60235},
                                                     {"natural_5", 12.41330}};
  ASSERT_EQ(modes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(modes[i].name, expected[i].first);
    EXPECT_NEAR(modes[i].angular_frequency, expected[i].second, i == 0 ? 1e-9 : 1e-5);
    EXPECT_EQ(modes[i].refine, i > 0);
  }
  for (const auto& [length, depth, frequency] :
       {std::tuple{0.9, 0.093, 3.27746}, {0.92, 0.465, 5.55095}}) {
    definition.tank.length = length;
    definition.liquid.fill_depth = depth;
    EXPECT_NEAR(fitted_modes(definition)[1].angular_frequency, frequency, 1e-5);
  }
  definition = surge_case();
  definition.motion.surge = TableMotion{};  // has no frequency
  ASSERT_EQ(fitted_modes(definition).size(), 1u);
  EXPECT_EQ(fitted_modes(definition)[0].name, "natural_1");
}

TEST(CaseAssessment, DoubtsAModeThatPassesWhereTheRestOfTheSeriesDeparts) {
  CaseDefinition definition = surge_case();
  definition.gate.resize(1);  // the amplitude of the forced wave
  CaseRuns runs = surge_runs();
  TimeSeries other_start = elevation_of({});
  for (std::size_t i = 0; i < other_start.time.size(); ++i)
    other_start.value[i] += 0.01 * std::sin(4.94488 * other_start.time[i]);
  runs.results["particles"] = result_of("particles", other_start);
  const CaseAssessment assessment = assess_two(runs, definition);
  EXPECT_EQ(assessment.gate[0].verdict, Verdict::pass) << assessment.gate[0].message;
  EXPECT_TRUE(assessment.gate[0].is_doubtful);
  ASSERT_EQ(assessment.doubts.size(), 1u);
  EXPECT_TRUE(
      assessment.doubts[0].starts_with("doubtful: small_surge: particles departs from theory by "))
      << assessment.doubts[0];
  definition.gate.push_back(surge_row("whole", Metric::rms_error, "1", 0.9));
  EXPECT_EQ(assess_two(runs, definition).doubts.size(), 1u) << "that row sees its size alone";
  definition.gate[1] = surge_row("whole", Metric::normalised_rms, "1", 0.2);
  EXPECT_EQ(assess_two(runs, definition).doubts, std::vector<std::string>{}) << "that row fails";
  EXPECT_EQ(good().doubts, std::vector<std::string>{});
}

TEST(CaseAssessment, DoubtsALoadWithoutAReferenceBeyondALimitOfTheModels) {
  CaseDefinition definition = surge_case();
  GateRow row = surge_row("whole", Metric::largest_magnitude, "m", 0.1);
  row.reference.clear();
  definition.gate = {row};
  EXPECT_EQ(assess_two(surge_runs(), definition).doubts, std::vector<std::string>{});
  definition.gas.density = 870;
  const CaseAssessment under_oil = assess_two(surge_runs(), definition);
  ASSERT_EQ(under_oil.doubts.size(), 1u);
  EXPECT_TRUE(under_oil.doubts[0].starts_with(
      "doubtful: small_surge: beyond the limit of the models: the gas above the liquid"))
      << under_oil.doubts[0];
  EXPECT_TRUE(under_oil.gate[0].message.ends_with(
      "; doubtful: beyond a limit of the models, and without a reference"))
      << under_oil.gate[0].message;
  EXPECT_TRUE(under_oil.gate[0].is_doubtful);
}

TEST(CaseAssessment, TellsWhereAFrequencyIsMeasuredAndWhatLinearTheoryHas) {
  CaseDefinition definition = surge_case();
  GateRow row = surge_row("natural_1", Metric::frequency, "Hz", 0);
  row.reference.clear();
  row.limit.reset();
  row.between = {0.785, 0.795};
  definition.gate = {row};
  const std::string message = assess_two(surge_runs(), definition).gate.at(0).message;
  EXPECT_NE(message.find(" Hz within 0.785 Hz to 0.795 Hz; over 1 to 20 s; linear theory has "
                         "0.7904 Hz"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace slosh::case_assessment_test
