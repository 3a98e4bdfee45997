// The tables of distances, fields, orders, rest and steps: their numbers, and where they have none.
#include "reports/tables/case_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/summary/results_json.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/tests/field_results.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::case_tables_test {
namespace {

using Row = TableRow;

TEST(DistanceTable, ComparesTheFinestOfEachKind) {
  const reports::Table table = distance_table(
      assess(surge_case(), surge_runs_with("particles", scaled(elevation_of({}), 0.5))));
  EXPECT_EQ(table.header, (Row{"run", "theory", "theory_with_gas", "particles", "fine_mesh"}));
  EXPECT_TRUE(holds(table.caption, "`particles` is an outlier"));
  // rms(a - a/2) over the root of rms(a) rms(a/2) is 1/sqrt(2) of a wave about zero.
  EXPECT_NEAR(std::stod(table.rows.at(0).at(3)), 100 / std::sqrt(2.0), 2);
  EXPECT_EQ(table.rows.at(0).at(3), table.rows.at(2).at(1));
}

double at_rest(double, double z) { return 9810 * (0.35 - z); }

// The particles lack liquid above 0.28 m, and the coarse mesh is 500 Pa high at the second moment.
CaseAssessment with_fields() {
  CaseDefinition definition = surge_case();
  definition.snapshot_times = {2, 4};
  CaseRuns runs = surge_runs();
  for (const double time : definition.snapshot_times) {
    const double offset = time == 4 ? 500 : 0;
    const auto high = [offset](double x, double z) { return at_rest(x, z) + offset; };
    const auto leave = [&](const char* run, const Tiles& tiles, const PressureAt& pressure) {
      runs.results.at(run).snapshots.push_back(tiled_field(time, tiles, pressure));
    };
    leave("fine_mesh", {.width = 0.02, .height = 0.01}, at_rest);
    leave("particles", {.width = 0.005, .height = 0.005, .depth = 0.28}, at_rest);
    leave("coarse_mesh", {.width = 0.02, .height = 0.01}, high);
  }
  return assess(definition, runs);
}

TEST(FieldTable, HasARowForARunAndAColumnForAMomentAndItsNumbersInTheResultsForPrograms) {
  const CaseAssessment assessment = with_fields(), without = assess(surge_case(), surge_runs());
  const reports::Table table = field_table(assessment);
  EXPECT_EQ(table.header, (Row{"run", "against", "rms at 2 s [%]", "rms at 4 s [%]", "mean rms [%]",
                               "tension [%]", "lowest [Pa]", "not covered [%]", "excess [%]"}));
  EXPECT_EQ(table.rows, (std::vector<Row>{{"particles", "fine_mesh", "0.0", "0.0", "0.0",
                                           "0.00 (0.00)", "736 (736)", "20.0", "0.0"},
                                          {"coarse_mesh", "fine_mesh", "0.0", "14.6", "7.3",
                                           "0.00 (0.00)", "49 (49)", "0.0", "0.0"}}));
  EXPECT_TRUE(field_table(without).rows.empty());
  const auto json_of = [](const CaseAssessment& one) {
    return nlohmann::json::parse(results_json("a_campaign", false, {one}))["cases"][0];
  };
  const auto fields = json_of(assessment)["fields"];
  EXPECT_EQ(fields[1]["candidate"], "coarse_mesh");
  EXPECT_EQ(fields[1]["reference"], "fine_mesh");
  EXPECT_EQ(fields[1]["moments"][1]["time_s"], 4);
  EXPECT_NEAR(fields[1]["moments"][1]["pressure_rms_Pa"], 500, 1e-6);
  EXPECT_NEAR(fields[1]["moments"][1]["pressure_rms"], 500 / (9810 * 0.35), 1e-9);
  EXPECT_NEAR(fields[0]["moments"][0]["uncovered_share"], 0.2, 1e-9);
  EXPECT_FALSE(json_of(without).contains("fields"));
  CaseRuns cut = assessment.runs;
  cut.results.at("particles").snapshots.pop_back();
  const CaseAssessment again = assess(assessment.definition, cut);
  EXPECT_FALSE(fields_compared(again, "particles", "fine_mesh"));
  EXPECT_TRUE(fields_compared(again, "coarse_mesh", "fine_mesh"));
  EXPECT_EQ(again.not_comparable.back(),
            "the fields of particles against fine_mesh: particles has no field at 4 s");
}

ErrorAtSpacing at(double spacing, double error, double half_width = 0) {
  return {spacing, {error, half_width}};
}

TEST(ObservedOrder, IsTheExponentOfTheSpacingAndNoneOfAnErrorWithinItsInterval) {
  EXPECT_DOUBLE_EQ(*observed_order(at(0.02, 0.4), at(0.01, 0.1)), 2);
  EXPECT_DOUBLE_EQ(*observed_order(at(0.02, -0.4), at(0.01, 0.2)), 1);
  EXPECT_LT(*observed_order(at(0.02, 0.1), at(0.01, 0.2)), 0);
  EXPECT_FALSE(observed_order(at(0.02, 0.4), at(0.01, 0.1, 0.1)));
  EXPECT_FALSE(observed_order(at(0.02, 0.4, 0.5), at(0.01, 0.1)));
  EXPECT_FALSE(observed_order(at(0.02, 0.4), at(0.01, 0)));
  EXPECT_FALSE(observed_order(at(0.02, std::nan("")), at(0.01, 0.1)));
}

TEST(LeastSquaresOrder, IsTheSlopeThroughThreeErrorsOrMoreThatHaveASize) {
  EXPECT_NEAR(*least_squares_order({at(0.04, 1.6), at(0.02, 0.4), at(0.01, 0.1)}), 2, 1e-12);
  // Slopes of 1 and 2 between equal ratios: the line has their mean.
  EXPECT_NEAR(*least_squares_order({at(0.04, 0.8), at(0.02, 0.4), at(0.01, 0.1)}), 1.5, 1e-12);
  EXPECT_FALSE(least_squares_order({at(0.04, 1.6), at(0.02, 0.4)}));
  EXPECT_FALSE(least_squares_order({at(0.04, 1.6), at(0.02, 0.4), at(0.01, 0.1, 0.2)}));
}

// The surge by a solver at these spacings, with errors of the elevation of spacing squared.
template <class Solver>
CaseAssessment assess_spacings(const std::vector<double>& spacings, const Solver& solver) {
  std::vector<ScaledRun> runs;
  for (const double spacing : spacings)
    runs.push_back({"spacing_" + std::to_string(runs.size() + 1),
                    solver(spacing),
                    1 + 100 * spacing * spacing,
                    {.wall_time = 1, .user_time = 1, .steps = 10, .elements = 100}});
  return assess_scaled(runs);
}

SphRun particles(double spacing) { return {"recommended", spacing, spacing}; }

ExternalRun my_method(double spacing) { return {{"my_sph"}, {}, {}, {}, {}, "my_sph", spacing}; }

TEST(OrderTable, TellsTheOrderOfAKnownErrorOfASchemeAndOfAnExternalProgramsMethod) {
  const std::vector<double> spacings{0.01, 0.04, 0.02};
  for (const auto& [name, assessment] :
       {std::pair{"recommended", assess_spacings(spacings, particles)},
        {"my_sph", assess_spacings(spacings, my_method)}}) {
    const reports::Table table = order_table(assessment);
    ASSERT_EQ(table.rows.size(), 4u);
    EXPECT_EQ(table.rows[0][0], name);
    EXPECT_EQ(table.rows[0][1], "40");  // coarsest first, whatever the order of the case
    EXPECT_EQ(table.rows[0][3], "");
    EXPECT_EQ(table.rows[3][1], "all, least squares");
    for (const std::size_t row : {1u, 2u, 3u}) EXPECT_EQ(table.rows[row][3], "2.00");
    for (const Row& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  }
}

TEST(OrderTable, NeedsThreeSpacingsOfTheUnchangedScheme) {
  EXPECT_TRUE(order_table(assess_spacings({0.01, 0.02}, particles)).rows.empty());
  CaseAssessment assessment = assess_spacings({0.01, 0.02, 0.04}, particles);
  std::get<SphRun>(assessment.definition.runs.back().solver).variant = "antuono";
  EXPECT_TRUE(order_table(assess(assessment.definition, assessment.runs)).rows.empty());
}

// The surge's case and window (from 1 s); its run `particles` records these values from 0 s on, one
// a second.
CaseAssessment recorded(const std::vector<double>& values) {
  CaseRuns runs = surge_runs();
  for (const char* name : rest_quantities) {
    TimeSeries series{name, "1", {}, values};
    for (std::size_t i = 0; i < values.size(); ++i) series.time.push_back(static_cast<double>(i));
    runs.results.at("particles").series.push_back(series);
  }
  return {surge_case(), runs, {}, {}, {}};
}

TEST(RestTable, GivesTheLargestMagnitudesOfTheWholeRunAndOfTheWindow) {
  EXPECT_TRUE(rest_table({surge_case(), surge_runs(), {}, {}, {}}).rows.empty());
  const reports::Table table = rest_table(recorded({-0.5, 0.25, -0.3}));
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.header.at(1), "hydrostatic pressure error");
  EXPECT_EQ(table.rows[0].size(), table.header.size());
  EXPECT_EQ(table.rows[0].at(1), "0.5");
  EXPECT_EQ(table.rows[0].at(2), "0.3");
  for (const double broken : {NAN, INFINITY})
    EXPECT_EQ(rest_table(recorded({0.5, broken, 0.3})).rows[0].at(1), "not available");
}

CaseAssessment own_run() {
  CaseAssessment assessment = no_runs_of(impact_case());
  add_run(assessment, "own", SphRun{"recommended", 0.01, 0.01}, {});
  RunResult& own = assessment.runs.results.at("own");
  own.cost = {.user_time = 3, .system_time = 1, .steps = 1000, .elements = 4000};
  own.diagnostics = {{"speed_of_sound_m_s", 20}, {"evaluations_per_step", 1}};
  own.provenance = {{"compiler_flags", "-O3"}};
  return assessment;
}

CaseAssessment with_peer() {
  CaseAssessment assessment = own_run();
  add_run(assessment, "peer",
          ExternalRun{.command = {"peer"}, .method = "peer", .particle_spacing = 0.01}, {});
  RunResult& peer = assessment.runs.results.at("peer");
  peer.cost = {.user_time = 100, .steps = 2000, .elements = 4000};
  peer.diagnostics = {
      {"wall_particles", 1000}, {"loop_processor_time_s", 16}, {"speed_of_sound_m_s", 18.5}};
  peer.provenance = {};
  return assessment;
}

// The peer took 16 s over 8 million steps of the liquid's particles, and 10 million of all. Slosh's
// flags did not build interFoam.
TEST(StepTable, CountsTheTimeLoopWhereItIsToldAndTheWholeRunElse) {
  CaseAssessment assessment = with_peer();
  add_run(assessment, "mesh", InterFoamRun{.cells_x = 20, .cells_z = 20}, {});
  assessment.runs.results.at("mesh").provenance = {{"compiler_flags", "-O3"},
                                                   {"openfoam_version", "1912"}};
  const reports::Table table = step_table(assessment);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0],
            (Row{"own", "4000", "", "1000", "1", "whole run", "1e+03", "", "20", "-O3"}));
  EXPECT_EQ(table.rows[1],
            (Row{"peer", "4000", "1000", "2000", "", "time loop", "2e+03", "1.6e+03", "18.5", ""}));
  EXPECT_EQ(table.rows[2].back(), "");
  EXPECT_TRUE(step_table(own_run()).rows.empty()) << "no other code";
  CaseAssessment silent = with_peer();
  silent.runs.results.at("peer").cost.steps = 0;
  EXPECT_TRUE(step_table(silent).rows.empty());
}

}  // namespace
}  // namespace slosh::case_tables_test
