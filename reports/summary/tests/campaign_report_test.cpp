// What a campaign's report and its JSON say of assessed cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "reports/figures/figure_runs.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/summary/headline.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "verification/assessment/campaign_cost.hpp"
#include "verification/tests/figure_results.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::campaign_report_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CampaignDefinition surge_campaign() {
  CampaignDefinition campaign;
  campaign.name = "surges";
  campaign.title = "Surges";
  campaign.source = "none";
  return campaign;
}

// Judged once for all tests of this program, as the fits take most of their time.
const CaseAssessment& good() {
  static const CaseAssessment assessment = assess(surge_case(), surge_runs());
  return assessment;
}

const CaseAssessment& not_comparable() {
  static const CaseAssessment assessment = [] {
    TimeSeries broken = elevation_of({});
    broken.value[250] = nan;
    return assess(surge_case(), surge_runs_with("particles", broken));
  }();
  return assessment;
}

reports::Report report_of(const CampaignDefinition& campaign,
                          const std::vector<CaseAssessment>& cases) {
  return campaign_report(campaign, false, "./slosh campaign surges", cases, {});
}

TEST(VerdictSentence, CountsTheRowsThatHoldAndEveryKindOfTrouble) {
  const TimeSeries high = scaled(elevation_of({}), 1.1);
  const auto without = [](const char* run, RunState why) {
    return assess(surge_case(), surge_runs_without(run, why, "x"));
  };
  const std::vector<std::pair<std::vector<CaseAssessment>, const char*>> sentences{
      {{}, "0 of 0 gate rows hold."},
      {{good()}, "3 of 3 gate rows hold."},
      {{assess(surge_case(), surge_runs_with("particles", high))},
       "2 of 3 gate rows hold, 1 violated."},
      {{good(), not_comparable()},
       "3 of 6 gate rows hold, 3 not compared, 2 pairs not comparable. Not comparable: particles "
       "against theory: candidate elevation@right: sample 250 is not finite: time 10 s, value nan "
       "m."},
      {{without("particles", RunState::failed)}, "0 of 3 gate rows hold, 1 run failed."},
      {{without("particles", RunState::missing)},
       "0 of 3 gate rows hold, 3 not compared, 1 run without a result."},
      {{without("particles", RunState::not_selected)}, "0 of 0 gate rows hold, 3 not selected."},
      {{without("theory", RunState::not_supplied), good()},
       "3 of 3 gate rows hold, 1 record not supplied, 3 gate rows without their record."}};
  for (const auto& [cases, sentence] : sentences) EXPECT_EQ(verdict_sentence(cases), sentence);
}

template <class Part>
std::vector<std::string> ids_of(const std::vector<Part>& parts) {
  std::vector<std::string> ids;
  for (const Part& part : parts) ids.push_back(part.id);
  return ids;
}

const reports::Section& section_of(const reports::Report& report, const std::string& id) {
  for (const reports::Section& section : report.sections)
    if (section.id == id) return section;
  throw std::out_of_range("no section " + id);
}

TEST(CampaignReport, HasItsSummaryFirstAndAPageForEachCaseAndForThePaper) {
  CaseAssessment second = good();
  second.definition.name = "another_surge";
  CampaignDefinition campaign = surge_campaign();
  const reports::Report both = report_of(campaign, {good(), second});
  EXPECT_EQ(
      ids_of(both.sections),
      (std::vector<std::string>{"gate", "worst", "bias", "small_surge-summary", "small_surge-gate",
                                "small_surge", "small_surge-figures", "small_surge-tables",
                                "another_surge-summary", "another_surge-gate", "another_surge",
                                "another_surge-figures", "another_surge-tables"}));
  EXPECT_EQ(ids_of(both.pages),
            (std::vector<std::string>{"small_surge", "small_surge-appendix", "another_surge",
                                      "another_surge-appendix"}));
  EXPECT_EQ(both.pages.at(3).continues, "another_surge");
  EXPECT_EQ(section_of(both, "another_surge-tables").page, "another_surge-appendix");
  for (const char* paper : {"li2010", "zhao2021"}) {
    campaign.paper = paper;
    const reports::Report report = report_of(campaign, {good()});
    EXPECT_EQ(ids_of(report.pages),
              (std::vector<std::string>{"small_surge", "small_surge-appendix"}));
    EXPECT_EQ(section_of(report, paper).page, "") << "claims stand on the first page";
    EXPECT_NO_THROW(reports::check_report(report));
  }
}

TEST(CampaignReport, TellsOnEachCasesPageItsOwnVerdict) {
  CaseAssessment bad = not_comparable();
  bad.definition.name = "another_surge";
  CaseAssessment unjudged = good();
  unjudged.definition.name = "third_surge";
  unjudged.gate.clear();
  const reports::Report report = report_of(surge_campaign(), {good(), bad, unjudged});
  EXPECT_EQ(report.pages.at(0).outcome, reports::Outcome::pass);
  EXPECT_EQ(report.pages[0].verdict, "3 of 3 gate rows hold.");
  EXPECT_EQ(report.pages.at(2).outcome, reports::Outcome::not_compared);
  EXPECT_TRUE(begins(report.pages[2].verdict, "0 of 3 gate rows hold"));
  EXPECT_EQ(report.pages.at(4).verdict, "") << "nothing judges it";
  EXPECT_EQ(report.outcome, reports::Outcome::not_compared);
  EXPECT_EQ(report_of(surge_campaign(), {good()}).outcome, reports::Outcome::pass);
  EXPECT_TRUE(holds(report.sections[0].paragraphs[0], "`./slosh campaign surges`"));
  CaseAssessment watched = good();
  for (GateOutcome& outcome : watched.gate) outcome.row.kind = RowKind::regression;
  const reports::Report of_regressions = report_of(surge_campaign(), {watched});
  EXPECT_EQ(of_regressions.outcome, reports::Outcome::watched);
  EXPECT_EQ(of_regressions.pages.at(0).outcome, reports::Outcome::watched);
  EXPECT_TRUE(begins(of_regressions.verdict, "SPH at 10 mm against linear theory: amplitude "));
}

// Names of cases that are made of another's name and what its pages, tables and figures are called.
TEST(CampaignReport, OfCasesNamedAsPartsOfOthersHasNoIdTwice) {
  const CaseAssessment one = good();
  std::vector<CaseAssessment> cases{one};
  for (const char* part : {"-appendix", "-gate", "-1", "-figures", "-spectrum", "-history"}) {
    cases.push_back(one);
    cases.back().definition.name += part;
  }
  for (const char* name : {"gate", "worst", "bias", "index", "case", "matrix", "across"}) {
    cases.push_back(one);
    cases.back().definition.name = name;
  }
  EXPECT_NO_THROW(reports::check_report(report_of(surge_campaign(), cases)));
}

// Five per cent too high, with noise that makes the interval of the amplitude reach across that.
TimeSeries near_limit() {
  TimeSeries series = scaled(elevation_of({}), 1.05);
  std::minstd_rand random(1);
  for (double& value : series.value)
    value += 1e-3 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
  return series;
}

// The row or the run that decides, where the banner leads, and what it says of it.
TEST(CampaignReport, NamesInItsBannerWhatDecides) {
  CaseAssessment second = not_comparable();
  second.definition.name = "another_surge";
  CaseDefinition one_row = surge_case();
  one_row.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  const TimeSeries high = scaled(elevation_of({}), 1.1);
  struct Banner {
    std::vector<CaseAssessment> cases;
    const char *lead, *text, *anchor, *found;
  };
  const Banner banners[] = {
      {{good(), second},
       "Decided by",
       "another_surge: particles, forced amplitude error of elevation@right",
       "row-another_surge-1",
       ""},
      {{assess(surge_case(), surge_runs_with("particles", high))},
       "Decided by",
       "small_surge: particles",
       "row-small_surge-1",
       "10 %"},
      {{assess(one_row, surge_runs_with("particles", near_limit()))},
       "Decided by",
       "small_surge: particles",
       "row-small_surge-1",
       "What would decide it: "},
      {{assess(surge_case(), surge_runs_without("coarse_mesh", RunState::failed, "diverged"))},
       "Decided by",
       "small_surge/coarse_mesh",
       "",
       "solver failed: diverged."},
      {{good()}, "Nearest to its limit is", "small_surge: ", "row-small_surge-", ""}};
  for (const Banner& banner : banners) {
    const reports::Report report = report_of(surge_campaign(), banner.cases);
    EXPECT_NO_THROW(reports::check_report(report));
    const reports::Decision& decision = report.decision;
    EXPECT_EQ(decision.lead, banner.lead);
    EXPECT_TRUE(begins(decision.row.text, banner.text));
    EXPECT_TRUE(begins(decision.row.anchor, banner.anchor));
    EXPECT_TRUE(holds(decision.finding, banner.found));
  }
}

TEST(CampaignReport, TellsOfRunsThatAreNotSoundAndDrawsAReferenceOutOfItsRange) {
  CaseRuns runs = surge_runs();
  runs.results.at("particles").series.push_back({"mach_number", "1", {0, 20}, {0.42, 0.42}});
  runs.results.at("theory").diagnostics["highest_elevation_over_depth"] = 0.2;
  const reports::Report report = report_of(surge_campaign(), {assess(surge_case(), runs)});
  ASSERT_EQ(report.doubts.size(), 1U);
  EXPECT_TRUE(begins(report.doubts[0], "doubtful: small_surge: particles is not sound"));
  EXPECT_EQ(report.pages.at(0).doubts, report.doubts);
  EXPECT_TRUE(report_of(surge_campaign(), {good()}).doubts.empty());
  const reports::Section& section = section_of(report, "small_surge");
  EXPECT_TRUE(holds(section.paragraphs.back(), "never gates"));
  const auto& curves = section.figures[0].curves;
  EXPECT_TRUE(std::any_of(curves.begin(), curves.end(), [](const reports::Curve& curve) {
    return curve.label == "theory (out of its range)";
  }));
}

TEST(CampaignReport, TellsTheCoverageOfTheGatesAndShowsEachCaseAtAGlance) {
  CaseAssessment unjudged = good();
  unjudged.definition.name = "third_surge";
  unjudged.gate.clear();
  const reports::Report report = report_of(surge_campaign(), {good(), unjudged});
  EXPECT_TRUE(holds(report.coverage, "the gate rows of 0 of 2 cases detect"));
  EXPECT_TRUE(holds(report.coverage, "third_surge miss some"));
  ASSERT_TRUE(report.pages.at(0).glance);
  EXPECT_EQ(report.pages[0].glance->id, "small_surge-glance");
  const reports::Page& third = report.pages.at(2);  // after the first case's appendix
  EXPECT_TRUE(begins(third.remark, "The rows would not detect: amplitude"));
}

TEST(CampaignReport, ShowsTheOwnWordsOfAProgramThatFailedAndStandsWithoutASingleResult) {
  CaseRuns runs = surge_runs_without("fine_mesh", RunState::failed, "exit status 3: a fatal error");
  runs.status.at("fine_mesh").failure = RunFailure{
      "solver failed", "a fatal error", "--> FOAM FATAL ERROR :\n    Unknown word Eular", "log.x"};
  const reports::Report report = report_of(surge_campaign(), {assess(surge_case(), runs)});
  EXPECT_NO_THROW(reports::check_report(report));
  const reports::Table& table = section_of(report, "small_surge-gate").tables.back();
  ASSERT_EQ(table.id, "small_surge-failures");
  EXPECT_EQ(table.rows.at(0),
            (std::vector<std::string>{"fine_mesh", "solver failed", "a fatal error", "log.x"}));
  EXPECT_EQ(table.rows.at(1).at(2), "--> FOAM FATAL ERROR :");
  EXPECT_EQ(table.rows.at(2).at(2), "    Unknown word Eular");
  const nlohmann::json failure =
      nlohmann::json::parse(report.results_json).at("cases")[0].at("runs")[4].at("failure");
  EXPECT_EQ(failure.at("details"), "--> FOAM FATAL ERROR :\n    Unknown word Eular");
  CaseRuns none;
  for (const RunDefinition& run : surge_case().runs)
    none.status[run.name] = {RunState::failed, "killed by signal 9 (Killed)"};
  const reports::Report empty = report_of(surge_campaign(), {assess(surge_case(), none)});
  EXPECT_NO_THROW(reports::check_report(empty));
  EXPECT_TRUE(section_of(empty, "small_surge").figures.empty());
  EXPECT_EQ(empty.outcome, reports::Outcome::fail);
}

TEST(CampaignReport, HasARowWithAnAnchorForEveryGateRowAndLeadsThere) {
  CaseAssessment second = not_comparable();
  second.definition.name = "another_surge";
  const reports::Report report = report_of(surge_campaign(), {good(), second});
  const reports::Table& first = section_of(report, "small_surge-gate").tables.at(0);
  ASSERT_EQ(first.rows.size(), 3u);
  EXPECT_EQ(first.rows[0][0], "pass");
  EXPECT_EQ(first.row_ids.at(2), "small_surge-3");
  EXPECT_EQ(section_of(report, "another_surge-gate").tables.at(0).rows.at(0)[0], "not compared");
  const reports::Table& lines = report.sections.at(0).tables.at(0);
  ASSERT_EQ(lines.rows.size(), 2u);
  EXPECT_EQ(lines.rows[1][6], "not compared");
  EXPECT_EQ(lines.links[1].front(), "section-another_surge-gate");
  EXPECT_EQ(lines.links[1].back(), "row-another_surge-1");
}

TEST(CampaignReport, TellsReasonsOnceAndShowsRowsThatFailOrAreInDoubtFirstAndFoldsTheOthers) {
  CaseAssessment assessment = good();
  for (GateOutcome& outcome : assessment.gate) {
    outcome.row.reason = "Peers reach 1 %";
    outcome.row.source = "Li et al. 2010";
  }
  const auto tables = [&] {
    return section_of(report_of(surge_campaign(), {assessment}), "small_surge-gate").tables;
  };
  const std::string reason = "Peers reach 1 %. Source: Li et al. 2010.";
  EXPECT_EQ(tables().at(0).reasons, (std::vector<std::string>{reason, "", ""}));
  assessment.gate[1].is_doubtful = true;
  assessment.gate[2].verdict = Verdict::violated;
  EXPECT_FALSE(tables().at(0).is_folded);
  EXPECT_EQ(tables()[0].row_ids, (std::vector<std::string>{"small_surge-3", "small_surge-2"}));
  EXPECT_EQ(tables()[0].reasons, (std::vector<std::string>{reason, ""}));
  EXPECT_TRUE(tables().at(1).is_folded);
  EXPECT_EQ(tables()[1].row_ids, std::vector<std::string>{"small_surge-1"});
}

// All that a section says of a case.
std::string words_of(const CaseAssessment& assessment, const std::string& section) {
  const reports::Report report = report_of(surge_campaign(), {assessment});
  std::string words;
  for (const std::string& one : section_of(report, section).paragraphs) words += one + "\n";
  return words;
}

TEST(CampaignReport, SaysInTheSummaryOfACaseWhatItsTablesFind) {
  const auto summary = [](const CaseAssessment& assessment) {
    return words_of(assessment, "small_surge-summary");
  };
  EXPECT_TRUE(begins(summary(good()), "No single one of the 4 solutions stands apart"));
  EXPECT_TRUE(begins(
      summary(assess(surge_case(), surge_runs_with("particles", scaled(elevation_of({}), 3)))),
      "`particles` stands apart"));
  const std::string from_record = "No gate row judges against the record `measured`";
  CaseDefinition definition = gauged_surge();
  EXPECT_TRUE(holds(summary(assess(definition, gauged_runs())), from_record));
  definition.gate.push_back(surge_row("whole", Metric::normalised_rms, "1", 0.1));
  definition.gate.back().reference = "measured";
  definition.gate.back().quantity = "wall_pressure@B";
  EXPECT_FALSE(holds(summary(assess(definition, gauged_runs())), from_record));
}

TEST(CampaignReport, TellsOfARecordThatIsNotSuppliedAndWhetherARowNeedsIt) {
  const auto told = [](const CaseDefinition& definition, CaseRuns runs, const char* record) {
    runs.results.erase(record);
    runs.status[record] = {RunState::not_supplied, "expected SLOSH_EXPERIMENTS/b.csv"};
    return words_of(assess(definition, runs), "small_surge");
  };
  EXPECT_TRUE(holds(told(surge_case(), surge_runs(), "theory"),
                    "`theory` is not supplied: expected SLOSH_EXPERIMENTS/b.csv. Rows that need"));
  EXPECT_TRUE(holds(told(gauged_surge(), gauged_runs(), "measured"), "No gate row needs it."));
}

TEST(CampaignReport, DrawsTheToleratedResidualOfTheQuantityThatTheRowNames) {
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("whole", Metric::normalised_rms, "1", 0.1)};
  TimeSeries high = elevation_of({});
  for (double& value : high.value) value *= 1.05;
  const auto residuals = [&] {
    const reports::Report report =
        report_of(surge_campaign(), {assess(definition, surge_runs_with("particles", high))});
    return section_of(report, "small_surge").figures[1];
  };
  ASSERT_EQ(residuals().bands.size(), 1u);
  EXPECT_EQ(residuals().bands[0].look, look_of(definition, "particles"));
  EXPECT_TRUE(holds(residuals().caption, "Bands show"));
  definition.gate[0].quantity = "elevation@left";
  EXPECT_EQ(residuals().bands.size(), 0u);
  EXPECT_FALSE(holds(residuals().caption, "Bands show"));
}

nlohmann::json json_of(const std::vector<CaseAssessment>& cases) {
  return nlohmann::json::parse(results_json("surges", true, cases));
}

TEST(ResultsJson, HasTheClaimsOfTheCampaignsPaperUnderItsNumbers) {
  CampaignDefinition campaign = surge_campaign();
  campaign.paper = "zhao2021";
  const auto claims =
      nlohmann::json::parse(report_of(campaign, {good()}).results_json).at("claims");
  EXPECT_EQ(claims.at(0).at("number"), "Z3.1");
  EXPECT_EQ(claims.at(0).at("verdict"), "not decidable");
  EXPECT_TRUE(holds(std::string(claims[0].at("why")), "is not part of this campaign"));
  EXPECT_FALSE(json_of({good()}).contains("claims"));
}

// results_schema_test.cpp compares all of it with the schema.
TEST(ResultsJson, HasTheNumbersOfTheAssessment) {
  const nlohmann::json document = json_of({good()}), &one = document.at("cases").at(0);
  EXPECT_EQ(document.at("exit_status"), 0);
  EXPECT_EQ(document.at("core_seconds_s"), campaign_cost({good()}, {}).core_seconds);
  EXPECT_GT(document.at("core_seconds_s"), 0);
  EXPECT_EQ(one.at("runs").size(), 5u);
  EXPECT_EQ(one.at("runs").at(2).at("user_time_s"), 1);
  EXPECT_EQ(one.at("comparisons").size(), 4u);
  const nlohmann::json& comparison = one.at("comparisons").at(0);
  EXPECT_EQ(comparison.at("candidate"), "particles");
  EXPECT_EQ(comparison.at("window_end_s"), 20);
  EXPECT_NEAR(comparison.at("modes").at(0).at("amplitude_error").at("value"), 0, 1e-12);
  EXPECT_EQ(one.at("gate").size(), 3u);
  const nlohmann::json& row = one.at("gate").at(0);
  EXPECT_EQ(row.at("uncertainty_95").at("all"), row.at("uncertainty_95").at("time_history"));
  EXPECT_EQ(row.at("verdict"), "pass");
  EXPECT_EQ(row.at("limit"), 0.05);
  EXPECT_EQ(row.at("line"), 50);
}

TEST(CampaignReport, TellsHowTheTankMovesAndWhatDoubtsTheModels) {
  const auto told = [](const MotionDefinition& motion) {
    CaseAssessment assessment = good();
    assessment.definition.motion = motion;
    return words_of(assessment, "small_surge");
  };
  const SineMotion surge{0.02, 1.5};
  const RollDefinition roll{SineMotion{4 * 3.14159265358979 / 180, 2, 1}, 0.5, 0.1};
  EXPECT_TRUE(holds(told({}), "deep; at rest; 20 s from rest"));
  EXPECT_TRUE(holds(told({surge, roll}),
                    "; surge X = 0.02 m sin(1.5 rad/s t) and roll = 4 deg sin(2 rad/s t), ramped "
                    "over 1 period about the point 0.5 m from the left wall and 0.1 m above"));
  EXPECT_TRUE(holds(told({SumOfSines{{SineMotion{0.02, 1.5, 0, 3.14159265358979 / 2},
                                      SineMotion{0.01, 2, 1, -3.14159265358979 / 6}}},
                          {}}),
                    "sin(1.5 rad/s t + 90 deg) + 0.01 m sin(2 rad/s t - 30 deg), ramped"));
  CaseAssessment found = good();
  found.definition.motion = {TableMotion{"tables/a.csv", {0, 5, 10, 20}, {0, 0, 0, 0}}, {}};
  found.definition.declared_forcing_frequency = 1.50002;
  found.definition.found_forcing = {0.0003, 0.021};
  const std::string words = words_of(found, "small_surge");
  for (const char* part : {"surge X = the table a.csv; its forcing frequency, 1.50002 ± 0.0003",
                           "2.1 % of that sine (rms)"})
    EXPECT_TRUE(holds(words, part));
}

// The surge's elevations taken for pressures, a thousand pascals to the metre.
TEST(CampaignReport, ShowsPressureInPascalWhereTheCaseIsAboutIt) {
  CaseDefinition definition = surge_case();
  definition.gauges.clear();
  definition.pressure_gauges = {{"b", Wall::left, 0.093}};
  definition.gate.clear();
  CaseRuns runs = surge_runs();
  for (auto& [name, result] : runs.results) {
    result.series.resize(1);
    result.series[0].name = "wall_pressure@b";
    result.series[0].unit = "Pa";
    for (double& value : result.series[0].value) value *= name == "particles" ? 1010 : 1000;
  }
  const reports::Report report = report_of(surge_campaign(), {assess(definition, runs)});
  EXPECT_NO_THROW(reports::check_report(report));
  const reports::Section& section = section_of(report, "small_surge");
  EXPECT_EQ(section.figures.at(0).title, "Pressure on the left wall 0.093 m above the bottom");
  EXPECT_EQ(section.figures[0].y_label, "pressure [Pa]");
  EXPECT_EQ(section.figures[0].curves.at(0).y, runs.results.at("theory").series[0].value);
  EXPECT_EQ(section.figures.at(1).y_label, "residual [Pa]");
  const std::vector<reports::Figure>& further = section_of(report, "small_surge-figures").figures;
  const auto spectrum = std::find_if(
      further.begin(), further.end(),
      [](const reports::Figure& figure) { return figure.title == "Spectrum of the pressure"; });
  ASSERT_NE(spectrum, further.end());
  EXPECT_EQ(spectrum->y_label, "power [Pa2]");
  for (const reports::Table& table : section_of(report, "small_surge-tables").tables)
    if (table.id == "small_surge-histories") {
      EXPECT_TRUE(table.rows.at(0).at(4).ends_with(" Pa")) << table.rows[0][4];
      EXPECT_TRUE(holds(table.rows[0].at(5), " Pa2)"));
    }
}

TEST(ResultsJson, WritesANumberThatIsNoneAsNullAndHowARunEndedInWhateverBytes) {
  const nlohmann::json document = json_of({not_comparable()});
  EXPECT_EQ(document.at("exit_status"), 4);
  const nlohmann::json& row = document.at("cases").at(0).at("gate").at(0);
  EXPECT_EQ(row.at("verdict"), "not compared");
  EXPECT_TRUE(row.at("value").is_null());
  EXPECT_NE(row.at("message"), "");
  const nlohmann::json failed = json_of(
      {assess(surge_case(), surge_runs_without("fine_mesh", RunState::failed, "at 20 \xb0"))});
  const nlohmann::json& run = failed.at("cases").at(0).at("runs").at(4);
  EXPECT_EQ(run.at("state"), "solver failed");
  EXPECT_EQ(run.at("message"), "at 20 \xef\xbf\xbd");
  EXPECT_FALSE(run.contains("user_time_s"));
}

}  // namespace
}  // namespace slosh::campaign_report_test
