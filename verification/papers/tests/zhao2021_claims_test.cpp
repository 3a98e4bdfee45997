// The claims of Zhao et al. 2021 on results made by hand: confirmed where they are as claimed,
// refuted where they are scaled or shifted, not decidable where they are missing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "reports/pages/check_report.hpp"
#include "verification/papers/paper_claims.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/tests/impact_runs.hpp"

namespace slosh::zhao2021_claims_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double rate = 2.0;  // [rad/s], of the mild roll

struct MildRun {
  double scale = 1;
  double late = 0;  // [s]
};

TimeSeries mild_series(const std::string& name, const std::string& unit, const MildRun& run,
                       double mean, double amplitude, double sampling = 0.02) {
  TimeSeries series{name, unit, {}, {}};
  for (int i = 0; i * sampling <= 12 * (1 + 1e-12); ++i) {
    series.time.push_back(i * sampling);
    series.value.push_back(mean + run.scale * amplitude *
                                      std::cos(rate * (series.time.back() - run.late)));
  }
  return series;
}

std::vector<TimeSeries> mild_results(const MildRun& run) {
  return {mild_series("wall_pressure@right", "Pa", run, 2894, 323),
          mild_series("wall_pressure@right/filtered", "Pa", run, 2894, 323),
          mild_series("force_x", "N/m", run, 0, 50), mild_series("moment", "N", run, 0, 20)};
}

const std::string mild_quantity = "wall_pressure@right";

// The record is 330 Pa higher and swings by 14 % more; its samples do not end with a period, which
// takes 1 Pa off the difference of the means.
CaseAssessment mild_roll(const MildRun& moving = {}, const MildRun& fixed = {}) {
  CaseDefinition definition = sample_case();
  definition.name = "zhao2021_mild_roll";
  definition.motion = {.roll = RollDefinition{SineMotion{0.07, rate}, 0.46, 0.31}};
  definition.duration = 12;
  definition.window_begin = 2;
  definition.window_end = 12;
  definition.gauges.clear();
  definition.pressure_gauges = {
      {.name = "right", .wall = Wall::right, .position = 0.17, .filter_cutoff = 5}};
  CaseAssessment assessment = no_runs_of(definition);
  const TimeSeries record = mild_series(mild_quantity, "Pa", {.scale = 1.14}, 3224, 323, 0.4);
  add_run(assessment, "akyildiz",
          RecordRun{"a.csv", mild_quantity, "Pa", record.time, record.value, {}}, {record});
  add_run(assessment, "moving_7p5mm", SphRun{"moving", 0.0075, 0.0075}, mild_results(moving));
  add_run(assessment, "fixed_7p5mm", SphRun{"fixed", 0.0075, 0.0075}, mild_results(fixed));
  return assessment;
}

struct Way {
  double spread = 1;     // of the coarser runs' errors
  double noise = 10;     // [Pa]
  double crossings = 0;  // of each run
};

// An impact pressure with an error that shrinks with the spacing and the time step, and a noise at
// 40 Hz.
RunResult violent_result(const std::string& run, const ImpactRun& impact, double error,
                         const Way& way) {
  TimeSeries pressure = pressure_of(impact), filtered = pressure;
  filtered.name += "/filtered";
  for (std::size_t i = 0; i < pressure.value.size(); ++i) {
    const double t = pressure.time[i];
    const double wave = error * way.spread * std::sin(3 * t);
    pressure.value[i] += wave + way.noise * std::sin(2 * std::numbers::pi * 40 * t);
    filtered.value[i] += wave;
  }
  RunResult result = result_with(run, {pressure, filtered});
  result.diagnostics["wall_crossings"] = way.crossings;
  return result;
}

CaseAssessment violent_roll(const Way& moving = {.spread = 2, .noise = 20, .crossings = 10},
                            const Way& fixed = {}, const ImpactRun& finest = {}) {
  CaseDefinition definition = impact_case();
  definition.name = "zhao2021_violent_roll";
  definition.pressure_gauges[0].filter_cutoff = 50;
  CaseAssessment assessment = no_runs_of(definition);
  for (const auto& [way, name] : {std::pair{moving, "moving_"}, {fixed, "fixed_"}})
    for (const auto& [study, error] : {std::pair{"8mm", 160.0},
                                       {"6mm", 120.0},
                                       {"4mm", 80.0},
                                       {"2mm", 40.0},
                                       {"4mm_cfl01", 60.0},
                                       {"4mm_cfl04", 120.0}}) {
      const std::string run = std::string(name) + study;
      add_run(assessment, run, SphRun{"any", 0.004, 0.004}, {});
      assessment.runs.results[run] =
          violent_result(run, run == "fixed_2mm" ? finest : ImpactRun{}, error, way);
    }
  return assessment;
}

using Cases = std::vector<CaseAssessment>;

DecidedClaim claim(std::size_t number, const Cases& cases) {
  return decide(claims_of("zhao2021", cases).at(number - 1));
}

void fail(CaseAssessment& assessment, const std::string& run) {
  assessment.runs.results.erase(run);
  assessment.runs.status[run] = {RunState::failed, "diverged"};
}

TEST(ClaimsOfZhao2021, AreConfirmedByWhatIsAsClaimed) {
  const Cases cases{mild_roll(), violent_roll()};
  ASSERT_EQ(claims_of("zhao2021", cases).size(), 5u);
  for (std::size_t n = 1; n <= 5; ++n) {
    const DecidedClaim one = claim(n, cases);
    EXPECT_EQ(one.held, Held::yes) << n << ": " << one.found << " WHY " << one.why;
  }
}

TEST(ClaimsOfZhao2021, AreNotDecidableWithoutAnyCase) {
  for (std::size_t n = 1; n <= 5; ++n) {
    EXPECT_EQ(claim(n, {}).held, Held::undecided);
    EXPECT_NE(claim(n, {}).why.find("is not part of this campaign"), std::string::npos);
  }
}

TEST(ClaimOnTheMildRoll, StatesWhatTheRecordsOffsetDoes) {
  const std::string found = claim(1, {mild_roll()}).found;
  EXPECT_NE(found.find("the record lies +329 Pa off"), std::string::npos) << found;
  EXPECT_NE(found.find("rms difference to the record, both freed of their means, +12.3 %"),
            std::string::npos)
      << found;
}

TEST(ClaimOnTheMildRoll, IsRefutedByAPressureThatIsLateOrScaled) {
  const double late = 15 * std::numbers::pi / 180 / rate;
  EXPECT_EQ(claim(1, {mild_roll({.late = late})}).held, Held::no);
  EXPECT_EQ(claim(1, {mild_roll({}, {.late = -late})}).held, Held::no);
  EXPECT_EQ(claim(1, {mild_roll({.scale = 0.6})}).held, Held::no);
  EXPECT_EQ(claim(1, {mild_roll({.scale = 1.7})}).held, Held::no);
}

TEST(ClaimOnTheMildRoll, IsNotDecidableWithoutRecordRunOrNumbers) {
  CaseAssessment unsupplied = mild_roll(), failed = mild_roll(), poisoned = mild_roll();
  unsupplied.runs.results.erase("akyildiz");
  unsupplied.runs.status["akyildiz"] = {RunState::not_supplied, "expected a.csv"};
  fail(failed, "fixed_7p5mm");
  for (TimeSeries& series : poisoned.runs.results["moving_7p5mm"].series) series.value[300] = nan;
  EXPECT_EQ(claim(1, {unsupplied}).why,
            "akyildiz of zhao2021_mild_roll: not supplied (expected a.csv)");
  for (const CaseAssessment& one : {unsupplied, failed, poisoned})
    EXPECT_EQ(claim(1, {one}).held, Held::undecided);
}

TEST(ClaimOnBothWays, IsRefutedByADifferenceInAnyLoad) {
  EXPECT_EQ(claim(2, {mild_roll({.scale = 1.15})}).held, Held::no);
  EXPECT_EQ(claim(2, {mild_roll({}, {.late = 0.08})}).held, Held::no);
  for (const std::size_t series : {1u, 2u, 3u}) {
    CaseAssessment assessment = mild_roll();
    for (double& value : assessment.runs.results["moving_7p5mm"].series[series].value) value *= 1.3;
    EXPECT_EQ(claim(2, {assessment}).held, Held::no) << series;
  }
}

TEST(ClaimOnBothWays, IsNotDecidableWithoutARunASeriesOrNumbers) {
  CaseAssessment failed = mild_roll(), without = mild_roll(), poisoned = mild_roll();
  fail(failed, "moving_7p5mm");
  without.runs.results["fixed_7p5mm"].series.pop_back();
  poisoned.runs.results["fixed_7p5mm"].series[2].value[300] = nan;
  for (const CaseAssessment& one : {failed, without, poisoned})
    EXPECT_EQ(claim(2, {one}).held, Held::undecided);
}

Held impact_held(const ImpactRun& finest, bool with_repeats = true) {
  CaseAssessment assessment = violent_roll({}, {}, finest);
  if (!with_repeats) assessment.definition.impacts->repeats.clear();
  return claim(3, {assessment}).held;
}

TEST(ClaimOnTheImpacts, IsRefutedByImpactsThatAreLateMissingOrScaled) {
  for (const bool with_repeats : {true, false}) {
    EXPECT_EQ(impact_held({}, with_repeats), Held::yes);
    EXPECT_EQ(impact_held({.late = 0.1}, with_repeats), Held::no);
    EXPECT_EQ(impact_held({.scale = 1.8}, with_repeats), Held::no);
    EXPECT_EQ(impact_held({.scale = 0.4}, with_repeats), Held::no);
    EXPECT_EQ(impact_held({.impacts = 3}, with_repeats), Held::no);
  }
}

TEST(ClaimOnTheImpacts, IsNotDecidableWithoutTheRunOrItsNumbers) {
  CaseAssessment failed = violent_roll(), poisoned = violent_roll();
  fail(failed, "fixed_2mm");
  for (double& value : poisoned.runs.results["fixed_2mm"].series[0].value) value = nan;
  EXPECT_EQ(claim(3, {failed}).why, "fixed_2mm of zhao2021_violent_roll: solver failed (diverged)");
  EXPECT_EQ(claim(3, {poisoned}).held, Held::undecided);
}

TEST(ClaimOnStability, IsRefutedWhereTheFixedAreNoisierCrossMoreOrFail) {
  EXPECT_EQ(claim(4, {violent_roll({.noise = 10}, {.noise = 20})}).held, Held::no);
  EXPECT_EQ(claim(4, {violent_roll({}, {.crossings = 5})}).held, Held::no);
  CaseAssessment failed = violent_roll({}, {});
  fail(failed, "fixed_8mm");
  EXPECT_EQ(claim(4, {failed}).held, Held::no);
}

// Two equal rates give such counts by chance in more than one of twenty cases.
TEST(ClaimOnStability, IsNotDecidedByCountsThatDifferByChance) {
  for (const auto& [moving, fixed] : {std::pair{6.0, 4.0}, {5.0, 0.0}, {4.0, 6.0}}) {
    CaseAssessment counted = violent_roll({}, {});
    counted.runs.results["moving_8mm"].diagnostics["wall_crossings"] = moving;
    counted.runs.results["fixed_8mm"].diagnostics["wall_crossings"] = fixed;
    EXPECT_EQ(claim(4, {counted}).held, Held::undecided) << moving << " and " << fixed;
  }
  CaseAssessment clear = violent_roll({}, {});
  clear.runs.results["moving_8mm"].diagnostics["wall_crossings"] = 6;
  EXPECT_EQ(claim(4, {clear}).held, Held::yes);
}

TEST(ClaimOnStability, IsConfirmedByARunOfTheMovingThatFailed) {
  CaseAssessment failed = violent_roll({}, {});
  fail(failed, "moving_4mm_cfl04");
  EXPECT_EQ(claim(4, {failed}).held, Held::yes);
}

TEST(ClaimOnStability, IsNotDecidableWhereNothingTellsThemApartOrTheyContradict) {
  EXPECT_EQ(claim(4, {violent_roll({}, {})}).held, Held::undecided);
  const DecidedClaim contradiction =
      claim(4, {violent_roll({.noise = 20, .crossings = 1}, {.crossings = 9})});
  EXPECT_EQ(contradiction.held, Held::undecided);
  EXPECT_TRUE(contradiction.why.ends_with("they contradict one another")) << contradiction.why;
}

TEST(ClaimOnStability, IsNotDecidableWithoutARunItsCrossingsOrNumbers) {
  CaseAssessment absent = violent_roll(), uncounted = violent_roll(), poisoned = violent_roll();
  absent.runs.results.erase("moving_8mm");
  absent.runs.status["moving_8mm"] = {RunState::not_selected, ""};
  uncounted.runs.results["fixed_4mm"].diagnostics.clear();
  poisoned.runs.results["fixed_4mm"].series[0].value[3000] = nan;
  for (const CaseAssessment& one : {absent, uncounted, poisoned})
    EXPECT_EQ(claim(4, {one}).held, Held::undecided);
  EXPECT_EQ(claim(4, {absent}).why, "moving_8mm of zhao2021_violent_roll: not selected");
}

TEST(ClaimOnConvergence, IsRefutedWhereTheFixedSpreadMore) {
  EXPECT_EQ(claim(5, {violent_roll({.spread = 1}, {.spread = 2})}).held, Held::no);
  EXPECT_EQ(claim(5, {violent_roll({.spread = 1}, {.spread = 1})}).held, Held::undecided);
  EXPECT_EQ(claim(5, {violent_roll({.spread = 1.1}, {.spread = 1})}).held, Held::undecided);
}

TEST(ClaimOnConvergence, IsNotDecidableWithoutARunOrItsNumbers) {
  CaseAssessment failed = violent_roll(), poisoned = violent_roll();
  fail(failed, "moving_4mm_cfl04");
  poisoned.runs.results["moving_8mm"].series[1].value[3000] = nan;
  for (const CaseAssessment& one : {failed, poisoned})
    EXPECT_EQ(claim(5, {one}).held, Held::undecided);
}

const reports::Table& table_named(const reports::Section& section, const std::string& id) {
  for (const reports::Table& table : section.tables)
    if (table.id == id) return table;
  throw std::logic_error("no table " + id);
}

// What a report has of the paper's figures where none could be redrawn.
RedrawnFigures nothing_redrawn() {
  RedrawnFigures redrawn;
  for (const PaperFigure& figure : paper_named("zhao2021").figures)
    redrawn.push_back({.number = figure.number, .missing = {"no run"}});
  return redrawn;
}

TEST(SectionOfZhao2021, StandsWithAndWithoutItsCases) {
  for (const Cases& cases : {Cases{}, Cases{mild_roll(), violent_roll()}}) {
    reports::Report report;
    report.title = "t";
    report.results_json = "{}";
    report.sections = {zhao2021_section(cases, nothing_redrawn())};
    EXPECT_NO_THROW(reports::check_report(report));
    EXPECT_EQ(table_named(report.sections[0], "zhao2021-claims").rows.size(), 5u);
  }
}

TEST(SectionOfZhao2021, SaysOfEachFigureWhyItHasNoPanel) {
  const reports::Table table =
      table_named(zhao2021_section({}, nothing_redrawn()), "zhao2021-figures");
  ASSERT_EQ(table.rows.size(), 9u);
  EXPECT_EQ(table.rows[0].at(0), "figures 1 and 2");
  EXPECT_EQ(table.rows[1],
            (std::vector<std::string>{
                "figure 3",
                "pressure on the right wall 0.17 m above the bottom in the mildly rolling tank, "
                "here the left wall, as its roll begins clockwise",
                "no", "no run", "zhao2021_mild_roll", "the whole run; the paper's is not known",
                "time [s]; pressure [Pa]", "whether its pressure is filtered: ours is not"}));
  for (const auto& links : table.links) EXPECT_EQ(links, std::vector<std::string>(8));
}

// The numbers of the facts' section 6: 3.277 rad/s, 1.917 s, 3.85 rad/s, a ratio of periods of
// 0.85.
TEST(ErrataOfZhao2021, CarryTheComputedFigures) {
  const auto rows = table_named(zhao2021_section({}, nothing_redrawn()), "zhao2021-errata").rows;
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].at(2), "omega_1 = 3.277 rad/s, period 1.917 s (-0.10 % off 1.919)");
  EXPECT_EQ(rows[1].at(2), "omega = 3.852 rad/s; periods 0.850, frequencies 1.175");
  EXPECT_TRUE(rows[2].at(2).starts_with("still water presses with 819 Pa at 0.0093 m and 0 Pa"));
  EXPECT_NE(rows[3].at(2).find("is not part of this campaign"), std::string::npos);
  EXPECT_NE(rows[4].at(2).find("integrates to 1.795196 h^2, and 7/(4 pi) times that is 1.000000"),
            std::string::npos)
      << rows[4][2];
}

// Against a sine of 4 deg with 3.85 rad/s, which starts at 15.4 deg/s: a roll of half of it.
TEST(ErrataOfZhao2021, SetTheMeasuredRollBesideTheSine) {
  CaseAssessment measured = violent_roll(), sine = violent_roll();
  sine.definition.name = "zhao2021_violent_sine";
  constexpr double degree = std::numbers::pi / 180;
  measured.definition.motion.roll->angle = SineMotion{2 * degree, 3.85};
  sine.definition.motion.roll->angle = SineMotion{4 * degree, 3.85};
  const auto rows =
      table_named(zhao2021_section({measured, sine}, nothing_redrawn()), "zhao2021-errata").rows;
  EXPECT_TRUE(
      rows[3].at(2).starts_with("it starts at 7.7 deg/s, the sine at 15.4; apart by up to "
                                "2.00 deg (at "))
      << rows[3][2];
}

}  // namespace
}  // namespace slosh::zhao2021_claims_test
