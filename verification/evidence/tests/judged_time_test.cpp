#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/distributions/holm_correction.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/messages.hpp"
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
  EXPECT_TRUE(holds(outcome.message, "; at 0.5"));
}

TEST_F(JudgedTime, OfAPartIsThePartAndTellsOfALargerPeakOutside) {
  GateRow row = peak_row();
  row.part = {1, 20};
  const GateOutcome later = judged(row);
  EXPECT_EQ(later.verdict, Verdict::pass) << later.message;
  EXPECT_TRUE(holds(later.message, "LARGER outside"));
  EXPECT_TRUE(holds(row_name(row), "from 1 to 20 s"));
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

// Rows on the impacts of ensembles, judged with all their evidence: medians whose intervals are no
// wider than the window that is searched, and p-values that are corrected together.

GateRow row_of(Metric metric, const std::string& mode) {
  GateRow row{};
  row.candidate = "fine";
  row.quantity = impact_pressure;
  row.mode = mode;
  row.metric = metric;
  row.unit = metric_unit(metric, "Pa");
  if (is_p_value(metric))
    row.between = {0.05, 1};
  else
    row.limit = metric == Metric::impact_arrival ? 0.02 : 0.15;
  row.reason = row.source = "a test";
  row.where = {"impacts.toml", 1};
  return row;
}

struct Ensembles {
  CaseAssessment made = no_runs_of(impact_case());

  Ensembles() {
    made.definition.impacts->arrivals = ArrivalsDefinition{0.1, {}, 0.001};
    for (std::size_t n = 0; n < 4; ++n)
      made.definition.impacts->arrivals->times.push_back(
          arrival_in(pressure_of({}), n, made.definition).value());
    made.definition.impacts->plateau_half_width = 10;
    made.definition.inputs = {};
  }
  void add(const std::string& name, double spacing, const std::vector<ImpactRun>& members) {
    for (std::size_t k = 0; k < members.size(); ++k) {
      const std::string member = k == 0 ? name : name + "_" + std::to_string(k + 1);
      add_run(made, member, SphRun{"recommended", spacing, spacing}, {pressure_of(members[k])});
      made.definition.runs.back().ensemble = name;
    }
  }
  GateOutcome judged(const GateRow& row) {
    made.definition.gate = {row};
    return assess(made.definition, made.runs).gate.at(0);
  }
};

std::vector<ImpactRun> late_by(const std::vector<double>& times) {
  std::vector<ImpactRun> members;
  for (const double late : times) members.push_back({.late = late});
  return members;
}

TEST(ImpactRows, OfAnEnsembleAreMediansThatOneEarlyMemberDoesNotMove) {
  Ensembles ensembles;
  ensembles.add("fine", 0.004,
                late_by({0.001, 0.002, 0, -0.001, 0.001, 0.003, -0.002, 0, -0.27, 0.001}));
  ensembles.add("coarse", 0.008,
                late_by({0.0015, 0.002, 0.001, 0.002, 0.001, 0.002, 0.001, 0.003}));
  ensembles.made.definition.refinements = {
      {"spacing", RefinedNumber::particle_spacing, {"coarse", "fine"}}};
  for (const char* mode : {"impact_2", "impact_4"}) {
    const GateOutcome outcome = ensembles.judged(row_of(Metric::impact_arrival, mode));
    EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
    EXPECT_NEAR(outcome.value.value, 0.0005, 1e-3);
    EXPECT_LT(outcome.value.half_width, 0.005);
    EXPECT_TRUE(holds(outcome.message, "; median of 10 repeats"));
  }
}

TEST(ImpactRows, OnArrivalsAreNeverLessCertainThanTheWindowThatIsSearched) {
  Ensembles ensembles;
  ensembles.add("fine", 0.002, late_by({-0.03, -0.03, -0.27}));
  ensembles.add("coarse", 0.004, late_by({0.01, 0.02, 0.3}));
  ensembles.made.definition.refinements = {
      {"spacing", RefinedNumber::particle_spacing, {"coarse", "fine"}}};
  const double searched = ensembles.made.definition.impacts->period / 4;
  const GateOutcome outcome = ensembles.judged(row_of(Metric::impact_arrival, "impact_3"));
  const ThreeWayOutcome& judged = outcome.judgement.value();
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_LE(outcome.value.half_width, searched);
  EXPECT_LE(judged.contributions.discretisation.known(), searched);
  EXPECT_LE(judged.contributions.time_series.known(), searched);
  EXPECT_LE(judged.uncertainty, searched);
  EXPECT_GT(judged.uncertainty, 0.9 * searched);
  EXPECT_TRUE(outcome.message.ends_with("; U is limited to what is searched to either side"))
      << outcome.message;
}

TEST(ImpactRows, OfAnEnsembleAreViolatedByWhatIsWrongWithAllMembers) {
  const std::vector<double> times{0, 0.001, 0.002, -0.001, 0.001, 0, 0.002};
  const auto judged = [&](Metric metric, const char* mode, double late, double scale, int impacts) {
    Ensembles ensembles;
    std::vector<ImpactRun> fine, coarse;
    for (const double time : times) {
      fine.push_back({.late = late + time, .scale = scale + time, .impacts = impacts});
      coarse.push_back(fine.back());
      coarse.back().late += 1e-4;
    }
    ensembles.add("fine", 0.002, fine);
    ensembles.add("coarse", 0.004, coarse);
    ensembles.made.definition.refinements = {
        {"spacing", RefinedNumber::particle_spacing, {"coarse", "fine"}}};
    return ensembles.judged(row_of(metric, mode)).verdict;
  };
  EXPECT_EQ(judged(Metric::impact_arrival, "impact_3", 0, 1, 4), Verdict::pass);
  EXPECT_EQ(judged(Metric::impact_arrival, "impact_3", 0.05, 1, 4), Verdict::violated);
  EXPECT_EQ(judged(Metric::impact_arrival, "impact_3", -0.05, 1, 4), Verdict::violated);
  EXPECT_EQ(judged(Metric::impact_arrival, "impact_3", 0, 1, 2), Verdict::violated);
  EXPECT_EQ(judged(Metric::plateau_error, "whole", 0, 1, 4), Verdict::pass);
  EXPECT_EQ(judged(Metric::plateau_error, "whole", 0, 1.3, 4), Verdict::violated);
}

// The ends of an input are single runs, and one of them stands for the whole ensemble.
TEST(ImpactRows, OfAnEnsembleCountWhatItsInputsDoToARun) {
  Ensembles ensembles;
  ensembles.add("fine", 0.002, late_by({0, 0.001, -0.001}));
  ensembles.add("coarse", 0.004, late_by({0, 0.001, -0.001}));
  CaseDefinition& definition = ensembles.made.definition;
  definition.inputs = {{Input::amplitude, 0.0005, "a ruler", "coarse"}};
  for (const RunDefinition& end :
       runs_at_ends(definition.inputs[0], run_named(definition, "coarse"))) {
    add_run(ensembles.made, end.name, end.solver,
            {pressure_of({.late = end.at_input->change > 0 ? -0.003 : 0.004})});
    definition.runs.back() = end;
  }
  const GateOutcome outcome = ensembles.judged(row_of(Metric::impact_arrival, "impact_2"));
  const Contribution& input = outcome.judgement.value().contributions.input;
  ASSERT_TRUE(input.half_width.has_value()) << input.basis;
  EXPECT_NEAR(*input.half_width, 0.004, 1e-9);  // the later end, against the run itself
  EXPECT_NEAR(outcome.value.value, 0, 1e-9);
}

TEST(ImpactRows, OfAMemberWithoutANumberAreNotCompared) {
  Ensembles ensembles;
  ensembles.add("fine", 0.002, late_by({0, 0, 0}));
  ensembles.made.runs.results.at("fine_2").series.at(0).value.at(5700) = not_a_number;
  EXPECT_EQ(ensembles.judged(row_of(Metric::impact_arrival, "impact_3")).verdict,
            Verdict::not_compared);
}

// Members as spread as the experiment's repeats but too high, so that some tests are near 5 %.
TEST(ImpactRows, OnPValuesAreCorrectedTogether) {
  Ensembles ensembles;
  std::vector<ImpactRun> members;
  for (int k = 0; k < 20; ++k) members.push_back({.scale = 1.17 * (0.5 + k / 19.0)});
  ensembles.add("fine", 0.004, members);
  std::vector<GateRow> rows;
  for (const char* mode : {"impact_1", "impact_2", "impact_3", "impact_4"})
    for (const Metric metric :
         {Metric::peak_mean_p_value, Metric::peak_ks_p_value, Metric::peak_ad_p_value})
      rows.push_back(row_of(metric, mode));
  std::vector<Estimate> raw;
  bool one_is_low = false;
  for (const GateRow& row : rows) {
    raw.push_back(ensembles.judged(row).value);
    one_is_low |= raw.back().value < 0.1;
  }
  EXPECT_TRUE(one_is_low);
  ensembles.made.definition.gate = rows;
  const std::vector<GateOutcome> together =
      assess(ensembles.made.definition, ensembles.made.runs).gate;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Estimate corrected = holm_corrected(raw, i);
    EXPECT_EQ(together[i].value.value, corrected.value) << i;
    EXPECT_EQ(together[i].value.half_width, corrected.half_width) << i;
    EXPECT_GT(together[i].value.value, raw[i].value) << i;
    EXPECT_TRUE(together[i].message.ends_with("; 20 repeats, Holm's correction"))
        << together[i].message;
  }
}

}  // namespace
}  // namespace slosh::judged_time_test
