// The papers' figures, redrawn from results made by hand: which runs a panel shows over which
// range, and what is said of a panel that is left out.
#include "reports/figures/paper_panels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "reports/figures/figure_runs.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/summary/report_sections.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/tests/figure_results.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::paper_panels_test {
namespace {

using Names = std::vector<std::string>;

const Paper &li = paper_named("li2010"), &zhao = paper_named("zhao2021");

// A case of that name with theory and these runs, which nothing judged.
CaseAssessment paper_case(const std::string& name, const std::vector<ScaledRun>& runs) {
  CaseAssessment assessment = unjudged(runs);
  assessment.definition.name = name;
  assessment.definition.gate.clear();
  return assessment;
}

const std::vector<ScaledRun> usual_runs{
    {"recommended_5mm", SphRun{"recommended", 0.005, 0.005}, 1, {}},
    {"li2010_10mm", SphRun{"li2010", 0.01, 0.01}, 0.9, {}},
    {"li2010_20mm", SphRun{"li2010", 0.02, 0.02}, 0.8, {}},
    {"other", SphRun{"delta_sph", 0.01, 0.01}, 1, {}},
    {"interfoam_50x100", InterFoamRun{50, 100}, 1, {}}};

CaseAssessment small_surge(const std::vector<ScaledRun>& runs = usual_runs) {
  return paper_case("li2010_small_amplitude", runs);
}

const RedrawnFigure& redrawn(const PaperPanels& panels, const std::string& number) {
  for (const RedrawnFigure& one : panels.redrawn)
    if (one.number == number) return one;
  throw std::out_of_range("no figure " + number);
}

void add_record(CaseAssessment& assessment, const std::string& name, bool earlier_run = false) {
  RecordRun record{name + ".csv", surge_quantity, "m", {0, 20}, {}, {}};
  record.earlier_run = earlier_run;
  assessment.definition.runs.push_back(sample_run(record));
  assessment.definition.runs.back().name = name;
  assessment.runs.results[name] = result_of(name, elevation_of({}));
  assessment.runs.status[name] = {RunState::finished, ""};
}

TEST(PaperPanels, ShowThePapersSpanQuantityAndSchemeBesideTheoryAndTheFinestOthers) {
  const CaseAssessment assessment = small_surge();
  const PaperPanels panels = paper_panels(li, {assessment}, {});
  ASSERT_EQ(ids(panels.figures), Names{"li2010-figure-1-li2010_small_amplitude-elevation-right"});
  const reports::Figure& figure = panels.figures[0];
  EXPECT_EQ(figure.title, "Li et al. 2010, figure 1. Surface elevation 0.95 m from the left wall");
  EXPECT_EQ(figure.x_range, (std::pair{0.0, 12.0}));
  EXPECT_EQ(figure.x_label, "time [s]");
  EXPECT_EQ(figure.y_label, "elevation [mm]");
  EXPECT_EQ(redrawn(panels, "1").anchors, Names{"figure-" + figure.id});
  EXPECT_EQ(redrawn(panels, "1").missing, Names{});
  EXPECT_EQ(labels(figure),
            (Names{"theory", "recommended_5mm", "li2010_20mm", "interfoam_50x100"}));
  EXPECT_EQ(figure.curves.at(2).y.at(300),
            1000 * assessment.runs.results.at("li2010_20mm").at(surge_quantity).value[300]);
  for (const reports::Curve& curve : figure.curves)
    EXPECT_EQ(curve.look, look_of(assessment.definition, curve.label)) << curve.label;
  EXPECT_TRUE(figure.curves.at(0).look->is_reference);
}

TEST(PaperPanels, ShowTheFinestRunOfASchemeWithoutOneAtThePapersSpacing) {
  std::vector<ScaledRun> runs = usual_runs;
  runs.erase(runs.begin() + 2);
  SphRun graded{"li2010", 0.02, 0.01}, changed{"li2010", 0.02, 0.02};
  changed.numbers.courant_number = 0.1;
  runs.push_back({"graded", graded, 1, {}});
  runs.push_back({"changed", changed, 1, {}});
  EXPECT_EQ(labels(paper_panels(li, {small_surge(runs)}, {}).figures.at(0)),
            (Names{"theory", "recommended_5mm", "li2010_10mm", "interfoam_50x100"}));
}

TEST(PaperPanels, ShowACurveThatTheUserDigitised) {
  CaseAssessment assessment = small_surge();
  add_record(assessment, "digitised");
  add_record(assessment, "last_year", true);
  const reports::Figure figure = paper_panels(li, {assessment}, {}).figures.at(0);
  EXPECT_EQ(labels(figure),
            (Names{"theory", "recommended_5mm", "li2010_20mm", "interfoam_50x100", "digitised"}));
  EXPECT_TRUE(figure.curves.back().look->is_reference);
  EXPECT_EQ(figure.curves.back().style, reports::Curve::Style::points);
  assessment.runs.results.erase("digitised");
  assessment.runs.status["digitised"] = {RunState::not_supplied, ""};
  EXPECT_EQ(paper_panels(li, {assessment}, {}).figures.at(0).curves.size(),
            figure.curves.size() - 1);
  for (const char* name : {"a", "b", "c"}) add_record(assessment, name);
  const PaperPanels panels = paper_panels(li, {assessment}, {});
  ASSERT_EQ(panels.figures.size(), 2u) << "of more than six curves";
  for (const reports::Figure& one : panels.figures) EXPECT_LE(one.curves.size(), 6u);
  EXPECT_EQ(redrawn(panels, "1").anchors.size(), 2u);
}

// Both large amplitudes, the second with waves twice as high.
std::vector<CaseAssessment> large_surges() {
  std::vector<CaseAssessment> cases;
  for (const auto& [name, scale] :
       {std::pair{"li2010_large_b075", 1.0}, {"li2010_large_b125", 2.0}}) {
    cases.push_back(paper_case(name, usual_runs));
    CaseAssessment& one = cases.back();
    one.definition.title = name;
    one.definition.duration = 50;
    for (const char* run : {"li2010_20mm", "interfoam_50x100"}) {
      add_series(one.runs, run, "highest_surface@right", "m", 0.1 * scale);
      add_series(one.runs, run, "momentum_x", "kg/s", 10 * scale);
    }
  }
  return cases;
}

std::vector<reports::Figure> of_number(const PaperPanels& panels, const std::string& number) {
  std::vector<reports::Figure> found;
  for (const reports::Figure& figure : panels.figures)
    if (figure.title.find(", figure " + number + ".") != std::string::npos) found.push_back(figure);
  return found;
}

TEST(PaperPanels, AreLeftOutWhereSomethingIsMissingAndItIsSaid) {
  const PaperPanels small = paper_panels(li, {small_surge()}, {}),
                    large = paper_panels(li, large_surges(), {});
  const std::string absent = "not part of this campaign: li2010_large_b075, li2010_large_b125";
  EXPECT_EQ(redrawn(small, "5").missing, Names{absent});
  EXPECT_EQ(redrawn(small, "5").anchors, Names{});
  EXPECT_EQ(redrawn(paper_panels(li, {small_surge({})}, {}), "1").missing,
            Names{"no simulation of li2010_small_amplitude has a result with elevation@right"});
  EXPECT_EQ(redrawn(large, "6").missing,
            (Names{"no simulation of li2010_large_b075 has a result with momentum_z",
                   "no simulation of li2010_large_b125 has a result with momentum_z"}));
  EXPECT_EQ(redrawn(paper_panels(zhao, {}, {}), "6").missing,
            Names{"not known here: what it shows: our text of the paper says nothing of it"});
  const reports::Table table = paper_section(li, {small_surge()}, small.redrawn).tables.back();
  EXPECT_EQ(table.rows.at(0).at(2), "in 1 panel");
  EXPECT_EQ(table.links.at(0).at(2), small.redrawn.at(0).anchors.at(0));
  EXPECT_EQ(table.rows.at(4).at(2), "no");
  EXPECT_EQ(table.rows[4].at(3), absent);
  EXPECT_EQ(table.links.at(4).at(2), "");
}

TEST(PaperPanels, OfOneFigureHaveOneScaleWithoutDimensionsWhereThePaperHasNone) {
  const auto figures = of_number(paper_panels(li, large_surges(), {}), "5");
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[1].title,
            "Li et al. 2010, figure 5. Highest surface 0.95 m from the left wall "
            "(li2010_large_b125)");
  const double period = 2 * 3.14159265358979 / (0.3 * 4.94488);
  for (const reports::Figure& figure : figures) {
    EXPECT_EQ(figure.y_range, figures[0].y_range);
    EXPECT_GE(figure.y_range.second, 0.4 / 0.35) << "the higher waves fit";
    EXPECT_EQ(figure.x_range.first, 0);
    EXPECT_NEAR(figure.x_range.second, 40 / period, 1e-6);
    EXPECT_EQ(figure.y_label, "highest surface, η/h [1]");
    EXPECT_EQ(labels(figure), (Names{"li2010_20mm", "interfoam_50x100"}));
    EXPECT_TRUE(begins(figure.caption, "h = 0.35 m, T = 4.235 s. "));
    EXPECT_TRUE(figure.caption.ends_with(
        " Of the paper's figure we do not know what it is divided by: the still depth and the "
        "forcing's period are ours."))
        << figure.caption;
  }
}

TEST(PaperPanels, OfASpectrumMarkTheForcingAndTwiceThat) {
  const auto figures = of_number(paper_panels(li, large_surges(), {}), "7");
  ASSERT_EQ(figures.size(), 2u);
  for (const reports::Figure& figure : figures) {
    EXPECT_EQ(labels(figure), (Names{"li2010_20mm", "interfoam_50x100"}));
    EXPECT_EQ(figure.x_label, "frequency [Hz]");
    EXPECT_EQ(figure.y_range, figures[0].y_range);
    Names marked;
    for (const reports::Marker& marker : figure.markers) marked.push_back(marker.label);
    EXPECT_EQ(marked, (Names{"forced", "natural_1", "2 x forced"}));
  }
}

// The violent roll with a study of each scheme's spacing, and of the time step of one.
CaseAssessment violent_roll() {
  SphRun short_steps{"zhao2021_fixed", 0.004, 0.004};
  short_steps.numbers.courant_number = 0.1;
  CaseAssessment assessment = paper_case(
      "zhao2021_violent_roll", {{"moving_4mm", SphRun{"zhao2021_moving", 0.004, 0.004}, 1, {}},
                                {"moving_2mm", SphRun{"zhao2021_moving", 0.002, 0.002}, 1, {}},
                                {"fixed_4mm", SphRun{"zhao2021_fixed", 0.004, 0.004}, 1, {}},
                                {"fixed_2mm", SphRun{"zhao2021_fixed", 0.002, 0.002}, 1, {}},
                                {"fixed_4mm_cfl01", short_steps, 1, {}},
                                {"other_4mm", SphRun{"recommended", 0.004, 0.004}, 1, {}},
                                {"other_2mm", SphRun{"recommended", 0.002, 0.002}, 1, {}}});
  assessment.definition.pressure_gauges = {{"B", Wall::left, 0.093, 0.004, 5}};
  for (const RunDefinition& run : assessment.definition.runs)
    add_series(assessment.runs, run.name, "wall_pressure@B/filtered", "Pa", 1000);
  return assessment;
}

TEST(PaperPanels, OfStudiesShowEachOfThePapersSchemes) {
  const PaperPanels panels = paper_panels(zhao, {violent_roll()}, {});
  const auto steps = of_number(panels, "10"), spacings = of_number(panels, "11");
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].title, "Zhao et al. 2021, figure 10. Time step: zhao2021_fixed");
  EXPECT_EQ(labels(steps[0]), (Names{"the scheme's Courant number (fixed_4mm)",
                                     "Courant number 0.1 (fixed_4mm_cfl01)"}));
  EXPECT_EQ(redrawn(panels, "10").missing,
            Names{"zhao2021_violent_roll has no results of zhao2021_moving that differ in their "
                  "time step alone"});
  ASSERT_EQ(spacings.size(), 2u);
  EXPECT_EQ(labels(spacings[0]), (Names{"4 mm (moving_4mm)", "2 mm (moving_2mm)"}));
  EXPECT_EQ(labels(spacings[1]), (Names{"4 mm (fixed_4mm)", "2 mm (fixed_2mm)"}));
}

TEST(PaperPanels, OfFieldsAreThoseOfTheCasesPage) {
  reports::Section section{"a", "", {}, {}, {}};
  for (const char* id : {"li2010_large_b125-fields-1", "li2010_large_b125-animation"}) {
    section.fields.emplace_back();
    section.fields.back().id = id;
  }
  const PaperPanels panels = paper_panels(li, large_surges(), {section});
  EXPECT_EQ(redrawn(panels, "4").anchors, Names{"figure-li2010_large_b125-fields-1"});
  EXPECT_EQ(redrawn(panels, "4").missing, Names{"the report has no fields of li2010_large_b075"});
}

// The links of all tables, and the panels, stand in one report.
TEST(PaperPanels, AreWhatTheCampaignsReportLinksTo) {
  std::vector<CaseAssessment> cases = large_surges();
  cases.push_back(small_surge());
  CampaignDefinition campaign{"surges", "Surges", "none", "", {}, "", "surges.toml"};
  campaign.paper = "li2010";
  reports::Report report = campaign_report(campaign, false, "", cases);
  ASSERT_NO_THROW(reports::check_report(report));
  ASSERT_EQ(report.sections.back().id, "li2010-figures");
  EXPECT_EQ(report.sections.back().page, "across");
  EXPECT_EQ(report.sections.back().figures.size(), 7u);
  report.sections.back().figures.erase(report.sections.back().figures.begin());
  EXPECT_THROW(reports::check_report(report), reports::ReportError) << "a link leads nowhere";
}

TEST(PaperFigures, NameShippedCasesAndTheirQuantities) {
  const std::filesystem::path cases =
      std::filesystem::path(SLOSH_SOURCE_DIR) / "verification" / "cases";
  for (const Paper* paper : {&li, &zhao})
    for (const PaperFigure& figure : paper->figures)
      for (const std::string& name : figure.cases) {
        const CaseDefinition definition = read_case(cases / (name + ".toml"));
        const Names quantities = compared_quantities(definition);
        for (const std::string& quantity : figure.quantities)
          EXPECT_NE(std::find(quantities.begin(), quantities.end(), quantity), quantities.end())
              << name << " " << quantity;
        EXPECT_LE(figure.time_span_s.second, definition.duration) << name;
        EXPECT_TRUE(figure.redrawn != Redrawn::fields || !definition.snapshot_times.empty())
            << name;
      }
}

}  // namespace
}  // namespace slosh::paper_panels_test
