// The ablation table, and the other places that show runs with a change to their scheme.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/results_json.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::ablation_table_test {
namespace {

struct Ablation {
  std::string name;
  SphRun sph;
  double scale;      // of theory's elevation: the error is this less one
  double user_time;  // [s]
};

CaseAssessment assess_ablations(const std::vector<Ablation>& ablations) {
  std::vector<ScaledRun> runs;
  for (const Ablation& ablation : ablations)
    runs.push_back({ablation.name, ablation.sph, ablation.scale,
                    RunCost{.wall_time = 9,
                            .user_time = ablation.user_time,
                            .system_time = 0.5,
                            .peak_memory = 2e5,
                            .steps = 1000,
                            .elements = 100}});
  return assess_scaled(runs);
}

SphRun changed(const std::string& variant, double spacing = 0.01) {
  SphRun run{"recommended", spacing, spacing};
  run.variant = variant;
  return run;
}

SphRun with_courant_number(double value) {
  SphRun run = changed("");
  run.numbers.courant_number = value;
  return run;
}

std::string cell(const reports::Table& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table.header.size(); ++i)
    if (table.header[i] == column) return table.rows.at(row).at(i);
  throw std::logic_error("no column " + column);
}

TEST(ChangesOfARun, AreItsVariantAndItsNumbers) {
  EXPECT_EQ(changes_of(changed("")), "");
  EXPECT_EQ(changes_of(changed("antuono")), "antuono");
  SphRun run = with_courant_number(0.4);
  run.variant = "antuono";
  run.numbers.density_diffusion = 0;
  EXPECT_EQ(changes_of(run), "antuono, courant_number = 0.4, density_diffusion = 0");
}

TEST(AblationTable, ComparesEachChangeWithTheUnchangedRun) {
  EXPECT_TRUE(ablation_table(assess_ablations({{"plain", changed(""), 1.1, 2}})).rows.empty());
  const reports::Table table = ablation_table(assess_ablations(
      {{"plain", changed(""), 1.1, 1.5}, {"faster", with_courant_number(0.4), 1.2, 0.5}}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(cell(table, 0, "change"), "unchanged");
  EXPECT_EQ(cell(table, 0, "rms over unchanged"), "");
  for (const auto& [column, text] : {std::pair{"run", "faster"},
                                     {"scheme", "recommended"},
                                     {"spacing [mm]", "10"},
                                     {"change", "courant_number = 0.4"},
                                     {"reference", "theory"},
                                     {"rms over unchanged", "2"},
                                     {"CPU time [s]", "1.00"},
                                     {"CPU time over unchanged", "0.5"},
                                     {"steps", "1000"},
                                     // 1 s, 100 particles, 20 s
                                     {"CPU time [us per particle and simulated s]", "500"},
                                     {"peak memory [byte per particle]", "2000"}})
    EXPECT_EQ(cell(table, 1, column), text) << column;
  // A fifth too high: the mean of the reference is not quite zero.
  EXPECT_NEAR(std::stod(cell(table, 1, "normalised rms [%]")), 20, 0.1);
  EXPECT_NEAR(std::stod(cell(table, 1, "forced amplitude error [%]")), 20, 0.1);
  const reports::Table other_spacing = ablation_table(assess_ablations(
      {{"coarse", changed("", 0.02), 1.1, 1.5}, {"other", changed("antuono"), 1.2, 0.5}}));
  EXPECT_EQ(cell(other_spacing, 1, "rms over unchanged"), "");
  EXPECT_EQ(cell(other_spacing, 1, "CPU time over unchanged"), "");
}

TEST(AblationTable, NamesTheTermsThatAVariantAndANumberChange) {
  using Terms = std::vector<std::string>;
  const Terms plain{"quintic kernel", "viscosity", "leapfrog"};
  CaseAssessment assessment = assess_ablations({{"plain", changed(""), 1.1, 1.5},
                                                {"kernel", changed("wendland_c2"), 1.2, 0.5},
                                                {"inviscid", changed("no_viscosity"), 1.2, 0.5},
                                                {"added", changed("antuono"), 1.2, 0.5},
                                                {"faster", with_courant_number(0.4), 1.2, 0.5}});
  const std::tuple<const char*, Terms, const char*> rows[]{
      {"plain", plain, ""},
      {"kernel",
       {"Wendland kernel", "viscosity", "leapfrog"},
       "Wendland kernel instead of quintic kernel"},
      {"inviscid", {"quintic kernel", "leapfrog"}, "without viscosity"},
      {"added", {"quintic kernel", "viscosity", "gradients", "leapfrog"}, "with gradients"},
      {"faster", plain, "time step: dt c0 / h"}};
  for (const auto& [run, terms, affected] : rows) assessment.runs.results[run].active_terms = terms;
  const reports::Table table = ablation_table(assessment);
  for (std::size_t i = 0; i < std::size(rows); ++i)
    EXPECT_EQ(cell(table, i, "affected terms"), std::get<2>(rows[i])) << std::get<0>(rows[i]);
  CaseRuns runs = assessment.runs;
  runs.results.erase("kernel");
  runs.status["kernel"] = {RunState::failed, "diverged"};
  const reports::Table without = ablation_table(assess(assessment.definition, runs));
  EXPECT_EQ(cell(without, 1, "reference"), "solver failed");
  EXPECT_EQ(cell(without, 1, "CPU time [s]"), "");
}

reports::Figure cost_figure(const std::vector<reports::Figure>& figures) {
  return figures.at(figures.size() - 2);  // the last is that of memory
}

TEST(CostFigure, ShowsEachChangeAsPointsOfItsOwn) {
  const auto figures = case_figures(assess_ablations({{"plain", changed(""), 1.1, 1.5},
                                                      {"coarse", changed("", 0.02), 1.2, 0.5},
                                                      {"other", changed("antuono"), 1.3, 1}}));
  const reports::Figure cost = cost_figure(figures);
  ASSERT_EQ(cost.curves.size(), 3u);
  EXPECT_EQ(cost.curves[1].label, "recommended, slope -1.00");
  EXPECT_EQ(cost.curves[1].x, (std::vector<double>{1.0, 2.0}));  // coarse first
  EXPECT_EQ(cost.curves[2].label, "recommended, antuono");
  EXPECT_TRUE(holds(cost.caption, "rms error from theory over"))
      << "the one reference: " << cost.caption;
  EXPECT_EQ(cost.curves[2].style, reports::Curve::Style::points);
  for (const reports::Curve& curve : figures.front().curves)
    EXPECT_NE(curve.label, "other") << "the history shows the unchanged scheme";
}

TEST(CostFigure, GathersManyChangesUnderOneLabel) {
  std::vector<Ablation> ablations{{"plain", changed(""), 1.1, 1.5}};
  for (int i = 0; i < 12; ++i) {
    const std::string name = "variant_" + std::to_string(i);
    ablations.push_back({name, changed(name), 1.2 + 0.01 * i, 1.0 + i});
  }
  const auto figures = case_figures(assess_ablations(ablations));
  const reports::Figure cost = cost_figure(figures);
  ASSERT_EQ(cost.curves.size(), 3u);
  EXPECT_EQ(cost.curves[2].label, "recommended, one change");
  EXPECT_EQ(cost.curves[2].x.size(), 12u);
  EXPECT_EQ(cost.curves[0].label, "Pareto front");
}

TEST(AblationJson, StatesTheChanges) {
  const std::vector<CaseAssessment> cases{assess_ablations(
      {{"plain", changed(""), 1.1, 1.5}, {"faster", with_courant_number(0.4), 1.2, 0.5}})};
  const auto document = nlohmann::json::parse(results_json("surges", false, cases));
  const auto& runs = document.at("cases").at(0).at("runs");
  EXPECT_FALSE(runs.at(0).contains("scheme"));
  EXPECT_EQ(runs.at(2).at("scheme"), "recommended");
  EXPECT_EQ(runs.at(2).at("particle_spacing_m"), 0.01);
  EXPECT_TRUE(runs.at(2).at("variant").is_null());
  EXPECT_EQ(runs.at(2).at("numbers").at("courant_number"), 0.4);
  EXPECT_TRUE(runs.at(2).at("numbers").at("density_diffusion").is_null());
}

}  // namespace
}  // namespace slosh::ablation_table_test
