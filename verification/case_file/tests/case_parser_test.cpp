// The case parser on valid and on absent files. Motions and pressure gauges have tests of their
// own; case_parser_refusal_test.cpp has every other mistake.
#include "verification/case_file/case_parser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::case_parser_test {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(SLOSH_SOURCE_DIR) / "verification/cases";

bool is_earlier_run(const CaseDefinition& definition, const std::string& run) {
  if (run.empty()) return false;
  const auto* record = std::get_if<RecordRun>(&run_named(definition, run).solver);
  return record && record->earlier_run;
}

TEST(CaseParser, ReadsEveryShippedCaseAndCallsItsRowsOnEarlierMeasurementsRegression) {
  int count = 0, regressions = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition definition = read_case(entry.path());
    EXPECT_EQ(definition.name, entry.path().stem());
    EXPECT_FALSE(definition.text.empty());
    ++count;
    for (const GateRow& row : definition.gate) {
      EXPECT_EQ(row.kind == RowKind::regression,
                row.source.starts_with("measured") || is_earlier_run(definition, row.reference))
          << entry.path().stem() << ", line " << row.where.line << ": " << row.source;
      regressions += row.kind == RowKind::regression;
    }
  }
  EXPECT_GE(count, 30);
  EXPECT_GE(regressions, 23);
}

TEST(CaseParser, ReadsTheBreakingDamWithItsRecord) {
  const CaseDefinition definition = read_case(cases / "dam_break_martin_moyce.toml");
  const auto& record = std::get<RecordRun>(definition.runs.at(0).solver);
  EXPECT_EQ(record.quantity, "front_position");
  ASSERT_EQ(record.time.size(), 15u);
  // Table 2: Z = 1.44 at T = 1.19, a = 2.25 in; the file has five decimals.
  const double base = 2.25 * 0.0254, per_second = std::sqrt(2 * 9.81 / base);
  EXPECT_EQ(definition.liquid.column_width, base);
  EXPECT_NEAR(record.time[2] * per_second, 1.19, 1e-5 * per_second);
  EXPECT_NEAR(record.value[2] / base, 1.44, 1e-5 / base);
  EXPECT_LT(record.time.back(), definition.window_end);
}

TEST(CaseParser, FillsInTheWholeDefinition) {
  const CaseDefinition definition = read_text(valid_text);
  EXPECT_EQ(definition.tank.length, 2.0);  // written as an integer
  EXPECT_EQ(definition.liquid.fill_depth, 0.5);
  EXPECT_EQ(definition.gas.density, 1.2);
  const auto& motion = std::get<SineMotion>(definition.motion.surge.value());
  EXPECT_EQ(motion.amplitude, 0.02);
  EXPECT_EQ(motion.angular_frequency, 1.5);
  EXPECT_EQ(motion.ramp_periods, 0);
  EXPECT_EQ(definition.start, Start::earth);
  EXPECT_EQ(definition.tags, std::vector<std::string>{"surge"});
  EXPECT_EQ(definition.text, valid_text);
  EXPECT_EQ(definition.gauges.at(0).x, 1.95);
  EXPECT_EQ(definition.gauges.size(), 2u);
  EXPECT_TRUE(definition.runs.at(1).quick);
  EXPECT_FALSE(definition.runs.at(0).quick);
  const GateRow& row = definition.gate.at(0);
  EXPECT_EQ(row.candidate, "coarse");
  EXPECT_EQ(row.reference, "theory");
  EXPECT_EQ(row.metric, Metric::amplitude_error);
  EXPECT_EQ(row.limit, 0.05);
  EXPECT_FALSE(row.between || row.improves_on || row.error);
  EXPECT_EQ(row.where.line, 52);
  EXPECT_FALSE(definition.tank.breadth || definition.liquid.column_width);
  EXPECT_TRUE(definition.obstacles.empty());
  EXPECT_FALSE(definition.motion.still());
}

// The settings are those that the run's key hashes.
void expect_settings(const std::string& run, const std::string& changes,
                     const std::string& settings) {
  const CaseDefinition definition = read_text(with_keys(valid_text, changes));
  EXPECT_EQ(hashed_settings(run_named(definition, run)).dump(), settings) << changes;
}

TEST(CaseParser, ReadsTheSettingsOfAnSphRun) {
  const std::string none =
      R"({"artificial_viscosity":null,"courant_number":null,"density_diffusion":null,)"
      R"("smoothing_length_ratio":null,"sound_speed_ratio":null})";
  const std::string plain = R"("sph":["any",0.02,0.01,"","",)" + none + "]";
  const auto expect = [](const std::string& changes, const std::string& settings) {
    expect_settings("coarse", changes, "{" + settings + "}");
  };
  expect("", plain);
  expect("run(coarse).surface_particle_spacing_m is missing",
         R"("sph":["any",0.02,0.02,"","",)" + none + "]");
  expect("run(coarse).expected_speed = \"estimate\"", plain);
  expect("run(coarse).expected_speed = \"coarse_run\"",
         R"("expected_speed":"coarse_run",)" + plain);
  expect("run(coarse).energy_budget = true", R"("energy_budget":true,)" + plain);
  expect("run(coarse).start_disorder = 0.05 & run(coarse).start_seed = 7",
         plain + R"(,"start":[0.05,7])");
  expect("run(coarse).start_disorder = 0.2", plain + R"(,"start":[0.2,0])");
  expect(
      "run(coarse).surface_particle_spacing_m is missing & run(coarse).initial_state = \"settled\" "
      "& run(coarse).start_rotation_deg = 20",
      R"("sph":["any",0.02,0.02,"","settled",)" + none + R"(],"start_rotation_deg":20.0)");
  expect(
      "run(coarse).variant = \"antuono\" & run(coarse).smoothing_length_ratio = 2 & "
      "run(coarse).sound_speed_ratio = 20.0 & run(coarse).courant_number = 0.4 & "
      "run(coarse).artificial_viscosity = 0 & run(coarse).density_diffusion = 0.1",
      R"("sph":["any",0.02,0.01,"antuono","",{"artificial_viscosity":0.0,"courant_number":0.4,)"
      R"("density_diffusion":0.1,"smoothing_length_ratio":2.0,"sound_speed_ratio":20.0}])");
}

TEST(CaseParser, ReadsTheProgramOfOpenFoamAndItsSettings) {
  const std::string cells = R"("interfoam":[50,40,1])";
  for (const auto& [change, settings] :
       {std::pair<std::string, std::string>{"processes = 1", cells},
        {"solver = \"interisofoam\"", cells + R"(,"program":"interIsoFoam")"},
        {"solver = \"compressible_interfoam\"", cells + R"(,"program":"compressibleInterFoam")"},
        {"courant_number = 0.25", R"("changes":[0.25,0.25,1,false,0.0],)" + cells},
        {"outer_corrections = 3", R"("changes":[0.5,0.5,3,false,0.0],)" + cells},
        {"interface_courant_number = 0.25", R"("changes":[0.5,0.25,1,false,0.0],)" + cells},
        {"no_slip = true", R"("changes":[0.5,0.5,1,true,0.0],)" + cells},
        {"wall_cell_m = 0.02", R"("changes":[0.5,0.5,1,false,0.02],)" + cells}})
    expect_settings("mesh", "run(mesh)." + change, "{" + settings + "}");
}

const std::string step =
    "[[obstacle]]\nname = \"step\"\nleft_m = 0.0\nright_m = 0.5\nbottom_m = 0.0\ntop_m = 0.1\n";

// The case with a narrow tank, an SPH run and one of cells instead of all its runs.
const std::string narrow_case =
    with_keys(valid_text.substr(0, valid_text.find("[[run]]")), "tank.breadth_m = 0.062") +
    "[[run]]\nname = \"sph\"\nsolver = \"sph\"\nscheme = \"any\"\nparticle_spacing_m = 0.01\n"
    "[[run]]\nname = \"mesh\"\nsolver = \"interfoam\"\ncells_x = 50\ncells_z = 40\n";

TEST(CaseParser, ReadsTheBreadthOfANarrowTankAndTheCellsAcrossIt) {
  EXPECT_EQ(read_text(narrow_case).tank.breadth, 0.062);
  for (const char* solver : {"interfoam", "interisofoam", "compressible_interfoam"}) {
    const CaseDefinition read =
        read_text(with_keys(narrow_case, "run.solver = \"" + std::string(solver) +
                                             "\" & run.no_slip = true & run.cells_y = 8"));
    EXPECT_EQ(std::get<InterFoamRun>(read.runs.at(1).solver).cells_y, 8) << solver;
  }
  expect_refusals(narrow_case, R"(
tank.breadth_m is missing & run.no_slip = true & run.cells_y = 8: expected no such key in a tank
  without breadth_m
run.cells_y = 8: expected no_slip = true beside it
)");
  expect_refusals(narrow_case + step, R"(
run.no_slip = true & run.cells_y = 8: expected no such key in a tank with an obstacle
)");
}

GateRow row_with(const std::string& changes) {
  return read_text(with_keys(valid_text, changes)).gate.at(0);
}

TEST(CaseParser, ReadsTheOtherBoundsOfAGateRow) {
  EXPECT_EQ(row_with("gate.limit is missing & gate.lower = -0.2 & gate.upper = 0.05").between,
            std::make_pair(-0.2, 0.05));
  const GateRow improves = row_with("gate.limit is missing & gate.improves_on = \"mesh\"");
  EXPECT_EQ(improves.improves_on, "mesh");
  EXPECT_FALSE(improves.limit);
  EXPECT_TRUE(read_text(valid_text.substr(0, valid_text.find("[[gate]]"))).gate.empty());
}

TEST(CaseParser, TakesAGateRowForAValidationRowUnlessItIsToldOtherwise) {
  EXPECT_EQ(row_with("").kind, RowKind::validation);
  EXPECT_EQ(row_with("gate.kind = \"regression\"").kind, RowKind::regression);
}

// A record of the gauge, which is an earlier run of this harness.
TEST(CaseParser, LetsRowsOfRegressionAloneRestOnAnEarlierRun) {
  const std::string record =
      "[[run]]\nname = \"earlier\"\nsolver = \"record\"\nfile = \"r.csv\"\nearlier_run = true\n";
  std::string text = with_keys(valid_text, "gate.reference = \"earlier\"");
  text.insert(text.find("[[gate]]"), record);
  expect_refusals({text, {{"r.csv", "time_s,elevation@right_m\n0,0\n1,1\n2,0\n3,1\n"}}}, R"(
gate.kind = "regression": accepted
gate.kind = "validation": expected regression: the reference is an earlier run of this harness
)");
}

const std::string uncertain_depth =
    "[[input]]\nname = \"fill_depth\"\nhalf_width = 0.0005\nunit = \"m\"\nsource = \"a ruler\"\n";

TEST(CaseParser, AddsACoarseRunAtBothEndsOfAnUncertainInput) {
  const CaseDefinition definition =
      read_text(valid_text + uncertain_depth + "coarse_run = \"coarse\"\n");
  ASSERT_EQ(definition.inputs.size(), 1U);
  EXPECT_EQ(definition.inputs[0].input, Input::fill_depth);
  EXPECT_EQ(definition.inputs[0].half_width, 0.0005);
  EXPECT_EQ(definition.inputs[0].source, "a ruler");
  ASSERT_EQ(definition.runs.size(), 5u);
  const RunDefinition &lower = definition.runs[3], &upper = definition.runs[4];
  EXPECT_EQ(lower.name, "coarse_fill_depth_lower");
  EXPECT_EQ(upper.name, "coarse_fill_depth_upper");
  EXPECT_EQ(lower.at_input->change, -0.0005);
  EXPECT_EQ(upper.at_input->change, 0.0005);
  EXPECT_EQ(upper.at_input->repeated_run, "coarse");
  EXPECT_EQ(definition_solved_by(upper, definition).liquid.fill_depth, 0.5005);
  EXPECT_EQ(definition_solved_by(definition.runs[1], definition).liquid.fill_depth, 0.5);
}

TEST(CaseParser, ReadsRowsOnARunsOwnSeriesOnAWaveAndOnWhatAnErrorCosts) {
  const std::string whole = "gate.mode = \"whole\" & gate.metric = ",
                    alone = "gate.reference is missing & " + whole;
  const GateRow own = row_with(alone +
                               "\"largest_magnitude\" & gate.quantity = \"liquid_volume\" & "
                               "gate.unit = \"m2\"");
  EXPECT_EQ(own.reference, "");
  EXPECT_EQ(own.quantity, "liquid_volume");
  EXPECT_EQ(own.unit, "m2");
  EXPECT_EQ(row_with(whole + "\"rms_error\"").metric, Metric::rms_error);
  EXPECT_EQ(row_with(whole + "\"mean_offset\" & gate.unit = \"m\"").metric, Metric::mean_offset);
  EXPECT_EQ(row_with(alone + "\"noise_share\"").reference, "");
  EXPECT_EQ(row_with(whole + "\"cost_to_reach\" & gate.unit = \"s\" & gate.error = 0.1 & "
                             "gate.limit = 20")
                .error,
            0.1);
}

TEST(CaseParser, ReadsATankThatStandsWhichHasNoForcedModeAndNoSpeedToMeasure) {
  const std::string still = edited({sine_surge, "[motion]\nstill = true\n"});
  const std::string free = still.substr(0, still.find("[[gate]]"));
  EXPECT_TRUE(read_text(free).motion.still());
  expect_refusals(still, R"(-> gate.mode = "forced": expected)");
  expect_refusals(free, R"(
time.start = "tank": accepted
run(coarse).expected_speed = "coarse_run": expected "estimate" in a case without motion, initial
  wave or dam: nothing flows
)");
}

TEST(CaseParser, ReadsObstaclesThatTouchWallsAndOneAnother) {
  const auto definition =
      read_text(valid_text + step +
                "[[obstacle]]\nname = \"lid\"\nleft_m = 0.5\nright_m = 2\nbottom_m = 0.8\n"
                "top_m = 1\n");
  ASSERT_EQ(definition.obstacles.size(), 2u);
  EXPECT_EQ(definition.obstacles[0].name, "step");
  EXPECT_EQ(definition.obstacles[0].right, 0.5);
  EXPECT_EQ(definition.obstacles[1].bottom, 0.8);
}

TEST(CaseParser, RefusesACaseWithoutRunsOrGauges) {
  const std::size_t runs = valid_text.find("[[run]]"), gauges = valid_text.find("[[gauge]]");
  const std::size_t comparison = valid_text.find("[comparison]");
  expect_refusals(valid_text.substr(0, runs), "-> run is missing: expected at least one [[run]]");
  expect_refusals(valid_text.substr(0, gauges) + valid_text.substr(comparison),
                  "-> gauge is missing: expected at least one [[gauge]] or [[pressure_gauge]]");
}

TEST(CaseParser, RefusesAFileThatCannotBeRead) {
  EXPECT_THROW(read_case("/nowhere/at_all.toml"), CaseFileError);
  EXPECT_THROW(read_case(cases), CaseFileError);
}

TEST(FindCase, TakesTheNameOfAShippedCaseOrAPathAndNamesTheNearest) {
  const fs::path file = cases / "li2010_small_amplitude.toml";
  EXPECT_EQ(find_case("li2010_small_amplitude", cases), file);
  EXPECT_EQ(find_case(file.string(), "/nowhere"), file);
  const std::string message =
      message_of<CaseFileError>([&] { find_case("li2010_small_amplitud_ramp", cases); });
  EXPECT_TRUE(
      holds(message, "case = \"li2010_small_amplitud_ramp\": expected a path or a name in"));
  EXPECT_TRUE(holds(message, "nearest: li2010_small_amplitude_ramp, "));
  EXPECT_THROW(find_case("./li2010_small_amplitude.toml", cases), CaseFileError);
}

TEST(Ensemble, OfOneRunIsAsManyThatDifferInTheirSeedAlone) {
  const CaseDefinition definition =
      read_text(with_keys(valid_text,
                          "run(coarse).start_disorder = 1e-6 & run(coarse).start_seed = 5 & "
                          "run(coarse).repeats = 3"));
  ASSERT_EQ(definition.runs.size(), 5U);
  const std::vector<std::string> all{"coarse", "coarse_2", "coarse_3"};
  SphRun alike = std::get<SphRun>(definition.runs[1].solver);
  for (std::size_t k = 0; k < 3; ++k) {
    const RunDefinition& member = definition.runs[k + 1];
    EXPECT_EQ(member.name, all[k]);
    EXPECT_EQ(member.ensemble, "coarse");
    EXPECT_EQ(is_later_member(member), k > 0);
    EXPECT_TRUE(member.quick);
    alike.start_seed = 5 + static_cast<int>(k);
    EXPECT_EQ(std::get<SphRun>(member.solver), alike);
  }
  EXPECT_EQ(members_of(definition, "coarse"), all);
  EXPECT_EQ(members_of(definition, "coarse_2"), std::vector<std::string>{"coarse_2"});
  EXPECT_EQ(members_of(definition, "theory"), std::vector<std::string>{"theory"});
}

TEST(Ensemble, MayDrawTheInputsOfItsMembersAndNeedsNoDisorderThen) {
  const CaseDefinition definition =
      read_text(with_keys(valid_text,
                          "run(mesh).repeats = 3 & run(mesh).vary_inputs = true & "
                          "run(mesh).start_seed = 5") +
                uncertain_depth);
  ASSERT_EQ(definition.runs.size(), 5U);
  for (int k = 0; k < 3; ++k) {
    const RunDefinition& member = definition.runs[static_cast<std::size_t>(k) + 2];
    EXPECT_EQ(member.ensemble, "mesh");
    EXPECT_EQ(std::get<InterFoamRun>(member.solver).start_seed, 5 + k);
    EXPECT_EQ(std::get<InterFoamRun>(member.solver).start_disorder, 0);
    ASSERT_EQ(member.drawn_inputs.size(), 1U) << member.name;
    EXPECT_EQ(member.drawn_inputs, drawn_inputs(definition.inputs, 5 + k));
  }
  EXPECT_TRUE(definition.runs[1].drawn_inputs.empty());
}

TEST(Ensemble, MayHaveFewerMembersInTheQuickForm) {
  const std::string disordered = with_keys(valid_text, "run(coarse).start_disorder = 1e-6");
  CaseDefinition definition =
      read_text(with_keys(disordered, "run(coarse).repeats = 3 & run(coarse).quick_repeats = 2"));
  ASSERT_EQ(definition.runs.size(), 5U);
  EXPECT_TRUE(definition.runs[2].quick);
  EXPECT_FALSE(definition.runs[3].quick);
  EXPECT_EQ(members_of(definition, "coarse").size(), 3U);
  keep_quick_members(definition);
  EXPECT_EQ(members_of(definition, "coarse"), (std::vector<std::string>{"coarse", "coarse_2"}));
  EXPECT_EQ(definition.runs.size(), 4U) << "single runs stay, as the quick form tells of them";
  expect_refusals(disordered, R"(
run(coarse).quick_repeats = 2: expected no such key without repeats and quick
run(coarse).quick is missing & run(coarse).repeats = 3 & run(coarse).quick_repeats = 2: expected no
  such key without repeats and quick
run(coarse).repeats = 3 & run(coarse).quick_repeats = 0: expected an integer from 1 to repeats (3)
run(coarse).repeats = 3 & run(coarse).quick_repeats = 4: expected an integer from 1 to repeats (3)
)");
}

TEST(Ensemble, HasNamesOfItsOwnAndIsNamedInAGateRowByItsFirstMember) {
  const std::string three =
      with_keys(valid_text, "run(mesh).start_disorder = 1e-3 & run(mesh).repeats = 3");
  expect_refusals(three + "[[run]]\nname = \"mesh_3\"\nsolver = \"potential\"\n",
                  R"(-> run.name = "mesh_3": expected a name that no other run has)");
  expect_refusals(three,
                  R"(gate.candidate = "mesh_2": expected a run, one of theory, coarse, mesh;)");
}

}  // namespace
}  // namespace slosh::case_parser_test
