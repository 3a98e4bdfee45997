// The claims of Li et al. 2010 on results made by hand: confirmed where they are as claimed,
// refuted where they are scaled or shifted, not decidable where they are missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "reports/pages/check_report.hpp"
#include "verification/papers/paper_claims.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::li2010_claims_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct SmallRun {
  double gravity = 9.81, scale = 0.95;
  double crests = 0.85;  // of what they would be
};

// Linear theory and a run of the paper's scheme.
CaseAssessment small_case(const SmallRun& small) {
  CaseDefinition definition = surge_case();
  definition.name = "li2010_small_amplitude";
  definition.gate.clear();
  definition.runs = {sample_run(LinearRun{500, false, 0.1}),
                     sample_run(SphRun{"li2010", 0.02, 0.02})};
  definition.runs[0].name = "linear";
  definition.runs[1].name = "li2010_20mm";
  CaseRuns runs;
  TimeSeries elevation = elevation_of({.gravity = small.gravity});
  for (double& value : elevation.value) value *= small.scale * (value > 0 ? small.crests : 1);
  runs.results["linear"] = result_of("linear", elevation_of({}));
  runs.results["li2010_20mm"] = result_of("li2010_20mm", elevation);
  for (const char* run : {"linear", "li2010_20mm"}) runs.status[run] = {RunState::finished, ""};
  return assess(definition, runs);
}

struct LargeRun {
  double first = 0.048, second = 0.024;  // powers of the two peaks
  double frequency = 1 / 1.3;            // [Hz]
  double highest = 0.4;                  // [m]
  double lowest = 0.15;                  // [m], below the still level
};
const LargeRun larger{.first = 0.2423, .second = 0.0493};

RunResult large_result(const std::string& run, const LargeRun& large) {
  RunResult result = result_of(run, {});
  TimeSeries elevation{"elevation@right", "m", {}, {}},
      highest{"highest_surface@right", "m", {}, {}};
  for (int i = 0; i <= 4000; ++i) {
    const double t = 0.01 * i, angle = 2 * std::numbers::pi * large.frequency * t;
    elevation.time.push_back(t);
    highest.time.push_back(t);
    elevation.value.push_back((large.highest - large.lowest) / 2 +
                              (large.highest + large.lowest) / 2 * std::cos(angle));
    highest.value.push_back(0.01 * (std::sqrt(2 * large.first) * std::cos(angle) +
                                    std::sqrt(2 * large.second) * std::cos(2 * angle)));
  }
  result.series = {elevation, highest};
  return result;
}

CaseAssessment large_case(const std::string& name, double amplitude, const LargeRun& large) {
  CaseDefinition definition = surge_case();
  definition.name = name;
  definition.motion.surge = SineMotion{amplitude, 2 * std::numbers::pi / 1.3};
  definition.duration = 40;
  definition.window_begin = 5;
  definition.window_end = 40;
  definition.gate.clear();
  definition.runs = {sample_run(SphRun{"li2010", 0.02, 0.02}), sample_run(InterFoamRun{50, 50}),
                     sample_run(InterFoamRun{100, 100})};
  CaseAssessment assessment{definition, {}, {}, {}, {}};
  int i = 0;
  for (const char* run : {"li2010_20mm", "interfoam_50x50", "interfoam_100x100"}) {
    assessment.definition.runs[static_cast<std::size_t>(i++)].name = run;
    assessment.runs.results[run] = large_result(run, large);
    assessment.runs.status[run] = {RunState::finished, ""};
  }
  return assessment;
}

std::vector<CaseAssessment> good() {
  return {small_case({}), large_case("li2010_large_b075", 0.075, {}),
          large_case("li2010_large_b125", 0.125, larger)};
}

DecidedClaim claim(std::size_t number, const std::vector<CaseAssessment>& cases) {
  return decide(claims_of("li2010", cases).at(number - 1));
}

TEST(ClaimsOfLi2010, AreConfirmedByWhatIsAsClaimed) {
  const auto cases = good();
  ASSERT_EQ(claims_of("li2010", cases).size(), 4u);
  for (std::size_t n = 1; n <= 4; ++n) {
    const DecidedClaim one = claim(n, cases);
    EXPECT_EQ(one.held, Held::yes) << n << ": " << one.found << " WHY " << one.why;
  }
}

TEST(ClaimsOfLi2010, AreNotDecidableWithoutAnyCase) {
  for (std::size_t n = 1; n <= 4; ++n) {
    EXPECT_EQ(claim(n, {}).held, Held::undecided);
    EXPECT_NE(claim(n, {}).why.find("is not part of this campaign"), std::string::npos);
  }
}

Held small_held(const SmallRun& small) { return claim(1, {small_case(small)}).held; }

TEST(ClaimOnSmallAmplitude, IsRefutedByAnotherPeriodAmplitudeOrShape) {
  EXPECT_EQ(small_held({}), Held::yes);
  EXPECT_EQ(small_held({.gravity = 9.0}), Held::no);
  EXPECT_EQ(small_held({.scale = 0.75}), Held::no);
  EXPECT_EQ(small_held({.scale = 1.2}), Held::no);
  EXPECT_EQ(small_held({.crests = 1.1}), Held::no);
}

TEST(ClaimOnSmallAmplitude, IsNotDecidableWithoutItsRunItsTheoryOrItsNumbers) {
  CaseAssessment failed = small_case({}), out = small_case({}), poisoned = small_case({});
  failed.runs.results.erase("li2010_20mm");
  failed.runs.status["li2010_20mm"] = {RunState::failed, "diverged"};
  EXPECT_EQ(claim(1, {failed}).held, Held::undecided);
  EXPECT_EQ(claim(1, {failed}).why,
            "li2010_20mm of li2010_small_amplitude: solver failed (diverged)");
  out.runs.status["linear"] = {RunState::out_of_range, ""};
  EXPECT_EQ(claim(1, {out}).held, Held::undecided);
  poisoned.runs.results["li2010_20mm"].series[0].value[700] = nan;
  poisoned = assess(poisoned.definition, poisoned.runs);
  EXPECT_EQ(claim(1, {poisoned}).held, Held::undecided);
}

// The larger amplitude's runs, or one of them alone, spoiled.
std::vector<CaseAssessment> spoiled(const LargeRun& large, const char* run = nullptr) {
  auto cases = good();
  for (auto& [name, result] : cases[2].runs.results)
    if (!run || name == run) result = large_result(name, large);
  return cases;
}

TEST(ClaimOnViolentMotion, IsRefutedByALowWaveOrOneWithoutHigherCrests) {
  EXPECT_EQ(claim(2, spoiled({.highest = 0.1, .lowest = 0.05})).held, Held::no);
  EXPECT_EQ(claim(2, spoiled({.highest = 0.3, .lowest = 0.31})).held, Held::no);
  EXPECT_EQ(claim(2, spoiled({.highest = 0.3, .lowest = 0.27})).held, Held::undecided);
}

TEST(ClaimOnTheSpectrum, IsRefutedByPeaksElsewhereMissingOrNotGrowing) {
  LargeRun elsewhere = larger, single = larger;
  elsewhere.frequency = 0.8;
  single.second = 0;
  EXPECT_EQ(claim(3, spoiled(elsewhere)).held, Held::no);
  EXPECT_EQ(claim(3, spoiled(single)).held, Held::no);
  EXPECT_EQ(claim(3, spoiled({.first = 0.04, .second = 0.03})).held, Held::no);
  EXPECT_EQ(claim(3, spoiled({.first = 0.05, .second = 0.03})).held, Held::undecided);
}

TEST(ClaimOnTheGrowth, IsRefutedByAnEqualRatioOrOneFarFromThePrinted) {
  EXPECT_EQ(claim(4, spoiled({.first = 0.096, .second = 0.05})).held, Held::no);
  EXPECT_EQ(claim(4, spoiled({.first = 0.5, .second = 0.0493})).held, Held::no);
  EXPECT_EQ(claim(4, spoiled(larger)).held, Held::yes);
}

TEST(ClaimsOnTheFlow, AreDecidedByTheFinestMeshToo) {
  const LargeRun flat{.first = 0.04, .second = 0.04, .highest = 0.05, .lowest = 0.05};
  for (const std::size_t n : {2u, 3u, 4u}) {
    EXPECT_EQ(claim(n, spoiled(flat, "interfoam_100x100")).held, Held::no) << n;
    EXPECT_EQ(claim(n, spoiled(flat, "li2010_20mm")).held, Held::no) << n;
    EXPECT_EQ(claim(n, spoiled(flat, "interfoam_50x50")).held, Held::yes) << n;
  }
}

TEST(ClaimsOnTheFlow, AreNotDecidableWithoutADecidingRunOrItsNumbers) {
  for (const char* run : {"li2010_20mm", "interfoam_100x100"}) {
    auto gone = good(), poisoned = good(), cut = good();
    gone[2].runs.results.erase(run);
    gone[2].runs.status[run] = {RunState::not_selected, ""};
    for (TimeSeries& series : poisoned[2].runs.results[run].series) series.value[2000] = nan;
    for (TimeSeries& series : cut[2].runs.results[run].series) {
      series.time.resize(2000);
      series.value.resize(2000);
    }
    for (const std::size_t n : {2u, 3u, 4u}) {
      EXPECT_EQ(claim(n, gone).held, Held::undecided) << n;
      EXPECT_EQ(claim(n, gone).why, std::string(run) + " of li2010_large_b125: not selected");
      EXPECT_EQ(claim(n, poisoned).held, Held::undecided) << n;
      EXPECT_EQ(claim(n, cut).held, Held::undecided) << n;
    }
  }
}

// The larger amplitude's run of the paper's scheme as an ensemble, whose other members are spoiled.
std::vector<CaseAssessment> with_repeats(const std::vector<LargeRun>& others) {
  auto cases = good();
  CaseAssessment& large = cases[2];
  large.definition.runs[0].ensemble = "li2010_20mm";
  for (std::size_t i = 0; i < others.size(); ++i) {
    RunDefinition member = large.definition.runs[0];
    member.name = "li2010_20mm_" + std::to_string(i + 2);
    large.definition.runs.push_back(member);
    large.runs.results[member.name] = large_result(member.name, others[i]);
    large.runs.status[member.name] = {RunState::finished, ""};
  }
  return cases;
}

TEST(ClaimsOnTheFlow, AreJudgedOnTheMeanOfAnEnsembleWithItsInterval) {
  LargeRun near = larger, other = larger, one_peak = larger;
  near.first *= 1.02;
  other.first *= 0.98;
  one_peak.second = 0;
  const LargeRun flat{.first = 0.04, .second = 0.04, .highest = 0.05, .lowest = 0.05};
  for (const std::size_t n : {2u, 3u, 4u}) {
    EXPECT_EQ(claim(n, with_repeats({near, other})).held, Held::yes) << n;
    EXPECT_NE(claim(n, with_repeats({near, other})).found.find("(mean of 3 repeats)"),
              std::string::npos);
    EXPECT_EQ(claim(n, with_repeats({near, flat})).held, Held::undecided)
        << n << ": the first member alone would confirm it";
  }
  const auto without = with_repeats({near, one_peak});
  EXPECT_EQ(claim(3, without).held, Held::undecided);
  EXPECT_NE(claim(3, without).found.find("none in 1 of 3"), std::string::npos)
      << claim(3, without).found;
  EXPECT_NE(claim(4, without).found.find("to unknown"), std::string::npos)
      << claim(4, without).found;
  EXPECT_EQ(claim(2, with_repeats(std::vector<LargeRun>(300, flat))).held, Held::no);
}

TEST(ClaimsOnTheFlow, AreDecidedByACoarserMeshThatAloneHasThreeRepeats) {
  const LargeRun flat{.first = 0.04, .second = 0.04, .highest = 0.05, .lowest = 0.05};
  auto cases = spoiled(flat, "interfoam_100x100");
  for (CaseAssessment* large : {&cases[1], &cases[2]}) {
    large->definition.runs[1].ensemble = "interfoam_50x50";
    for (const char* name : {"interfoam_50x50_2", "interfoam_50x50_3"}) {
      RunDefinition member = large->definition.runs[1];
      member.name = name;
      large->definition.runs.push_back(member);
      large->runs.results[name] = large->runs.results["interfoam_50x50"];
      large->runs.status[name] = {RunState::finished, ""};
    }
  }
  for (const std::size_t n : {2u, 3u, 4u}) {
    EXPECT_EQ(claim(n, cases).held, Held::yes) << n << claim(n, cases).why;
    EXPECT_NE(claim(n, cases).found.find("interfoam_50x50 (mean of 3 repeats)"), std::string::npos);
  }
}

TEST(ClaimsOnTheFlow, AreNotDecidableWithoutAMemberOfAnEnsemble) {
  auto cases = with_repeats({larger, larger});
  cases[2].runs.results.erase("li2010_20mm_3");
  cases[2].runs.status["li2010_20mm_3"] = {RunState::failed, "diverged"};
  for (const std::size_t n : {2u, 3u, 4u}) {
    EXPECT_EQ(claim(n, cases).held, Held::undecided) << n;
    EXPECT_EQ(claim(n, cases).why, "li2010_20mm_3 of li2010_large_b125: solver failed (diverged)");
  }
}

TEST(SurfaceSpectrum, FindsThePowersOfKnownTones) {
  const auto cases = good();
  const SurfaceSpectrum found = surface_spectrum(cases[2], "li2010_20mm");
  EXPECT_NEAR(found.excitation, 1 / 1.3, 1e-12);
  EXPECT_NEAR(found.peak[0].frequency, 1 / 1.3, 1e-3);
  EXPECT_NEAR(found.peak[1].frequency, 2 / 1.3, 1e-3);
  EXPECT_NEAR(found.peak[0].power, 0.2423e-4, 0.003e-4);
  EXPECT_NEAR(found.ratio(), 4.915, 0.05);
  EXPECT_TRUE(found.highest);
}

TEST(SurfaceSpectrumTable, SetsEveryRunBesideThePrintedNumbers) {
  auto cases = good();
  cases[2].runs.results.erase("interfoam_50x50");
  cases[2].runs.status["interfoam_50x50"] = {RunState::failed, ""};
  const reports::Table table =
      surface_spectrum_table(cases[1], cases[2], {{"7", {"figure-seven"}}});
  ASSERT_EQ(table.rows.size(), 8u);
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"printed", "0.125", "0.77", "0.2423", "1.54",
                                                     "0.0493", "4.915", "5.05", "2.05"}));
  EXPECT_EQ(table.rows[3].at(0), "li2010_20mm");
  EXPECT_EQ(table.rows[3].at(1), "0.125");
  EXPECT_EQ(table.rows[3].at(7), "5.05");
  EXPECT_NE(table.rows[5].at(2).find("solver failed"), std::string::npos);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  ASSERT_EQ(table.links.size(), 8u);
  for (const auto& links : table.links) EXPECT_EQ(links.at(0), "figure-seven");
}

// What a report has of the paper's figures where none could be redrawn.
RedrawnFigures nothing_redrawn() {
  RedrawnFigures redrawn;
  for (const PaperFigure& figure : paper_named("li2010").figures)
    redrawn.push_back({.number = figure.number, .missing = {"no run"}});
  return redrawn;
}

TEST(SectionOfLi2010, StandsWithAndWithoutItsCases) {
  for (const auto& cases : {good(), std::vector<CaseAssessment>{}}) {
    reports::Report report;
    report.title = "t";
    report.results_json = "{}";
    report.sections = {li2010_section(cases, nothing_redrawn())};
    EXPECT_NO_THROW(reports::check_report(report));
    EXPECT_EQ(report.sections[0].tables.size(), cases.empty() ? 4u : 5u);
  }
}

TEST(SectionOfLi2010, LinksEachRowToThePanelThatItSpeaksOf) {
  RedrawnFigures redrawn = nothing_redrawn();
  for (RedrawnFigure& one : redrawn) one.anchors = {"figure-" + one.number, "figure-second"};
  std::vector<std::string> linked;
  for (const reports::Table& table : li2010_section(good(), redrawn).tables)
    for (const std::vector<std::string>& links : table.links)
      linked.push_back(table.id + " " +
                       links.at(table.id == "li2010-spectrum"  ? 0
                                : table.id == "li2010-figures" ? 2
                                                               : links.size() - 1));
  const auto of = [&](const std::string& row) {
    return std::count(linked.begin(), linked.end(), row);
  };
  EXPECT_EQ(of("li2010-claims figure-1"), 1);
  EXPECT_EQ(of("li2010-claims figure-2 and 3"), 1);
  EXPECT_EQ(of("li2010-claims figure-7"), 2);
  EXPECT_EQ(of("li2010-spectrum figure-7"), 8);
  EXPECT_EQ(of("li2010-numbers figure-1"), 3);
  EXPECT_EQ(of("li2010-numbers "), 2) << "the natural frequency and the number of particles";
  EXPECT_EQ(of("li2010-errata figure-1"), 2);
  EXPECT_EQ(of("li2010-errata figure-7"), 1);
  EXPECT_EQ(of("li2010-errata figure-2 and 3"), 1);
  EXPECT_EQ(of("li2010-figures figure-4"), 1);
}

// A force that is lower than theory's must not be told as the wave's amplitude.
TEST(PrintedNumbersOfLi2010, AreThoseOfTheElevationAlone) {
  CaseAssessment both = small_case({});
  for (const auto& [run, scale] : {std::pair{"linear", 100.0}, {"li2010_20mm", 50.0}}) {
    RunResult& result = both.runs.results.at(run);
    TimeSeries force = result.series[0];
    force.name = "force_x";
    force.unit = "N/m";
    for (double& value : force.value) value *= scale;
    result.series.push_back(force);
  }
  const auto numbers = [](const CaseAssessment& assessment) {
    return li2010_section({assessment}, nothing_redrawn()).tables.at(1).rows;
  };
  EXPECT_GT(assess(both.definition, both.runs).comparisons.size(), both.comparisons.size());
  EXPECT_EQ(numbers(assess(both.definition, both.runs)), numbers(small_case({})));
}

// "+12.3 ± 180.0 deg" would be no number.
TEST(PrintedNumbersOfLi2010, AreNotResolvedWhereTheRunHasNoSuchMode) {
  CaseAssessment noisy = small_case({});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  for (double& value : noisy.runs.results.at("li2010_20mm").series.at(0).value)
    value = noise(random);
  const auto rows = [](const CaseAssessment& assessment) {
    return li2010_section({assessment}, nothing_redrawn()).tables.at(1).rows;
  };
  const auto clear = rows(small_case({})), spoiled = rows(assess(noisy.definition, noisy.runs));
  for (const std::size_t row : {2u, 3u, 4u}) {
    EXPECT_NE(spoiled.at(row).at(2).find("li2010_20mm: not resolved"), std::string::npos)
        << spoiled[row][2];
    EXPECT_EQ(clear.at(row).at(2).find("not resolved"), std::string::npos) << clear[row][2];
  }
}

}  // namespace
}  // namespace slosh::li2010_claims_test
