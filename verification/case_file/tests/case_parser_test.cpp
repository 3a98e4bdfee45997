// The case parser on valid and on absent files. Motions and pressure gauges have tests of their
// own; case_parser_refusal_test.cpp has every other mistake.
#include "verification/case_file/case_parser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::case_parser_test {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(SLOSH_SOURCE_DIR) / "verification/cases";

TEST(CaseParser, ReadsEveryShippedCase) {
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition definition = read_case(entry.path());
    EXPECT_EQ(definition.name, entry.path().stem());
    EXPECT_FALSE(definition.text.empty());
    ++count;
  }
  EXPECT_GE(count, 7);
}

bool is_earlier_run(const CaseDefinition& definition, const std::string& run) {
  if (run.empty()) return false;
  const auto* record = std::get_if<RecordRun>(&run_named(definition, run).solver);
  return record && record->earlier_run;
}

TEST(CaseParser, CallsEachShippedRowOnWhatWasMeasuredBeforeARegressionRow) {
  int regressions = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition definition = read_case(entry.path());
    for (const GateRow& row : definition.gate) {
      EXPECT_EQ(row.kind == RowKind::regression,
                row.source.starts_with("measured") || is_earlier_run(definition, row.reference))
          << entry.path().stem() << ", line " << row.where.line << ": " << row.source;
      regressions += row.kind == RowKind::regression;
    }
  }
  EXPECT_GE(regressions, 23);
}

TEST(CaseParser, ReadsThePapersSmallAmplitudeCase) {
  const CaseDefinition definition = read_case(cases / "li2010_small_amplitude.toml");
  EXPECT_EQ(definition.tank.length, 1.0);
  EXPECT_EQ(definition.liquid.fill_depth, 0.35);
  EXPECT_EQ(definition.gas.density, 1.2);
  const auto& motion = std::get<SineMotion>(definition.motion.surge.value());
  EXPECT_EQ(motion.amplitude, 0.02);
  EXPECT_NEAR(motion.angular_frequency, 0.3 * 4.94488, 1e-9);
  EXPECT_EQ(motion.ramp_periods, 0);
  EXPECT_EQ(definition.start, Start::earth);
  EXPECT_EQ(definition.gauges.at(0).x, 0.95);
  EXPECT_EQ(std::get<LinearRun>(definition.runs.at(0).solver).two_layer, false);
  EXPECT_EQ(std::get<LinearRun>(definition.runs.at(1).solver).two_layer, true);
  EXPECT_EQ(std::get<SphRun>(definition.runs.at(2).solver).particle_spacing, 0.025);
  EXPECT_EQ(definition.gate.at(0).candidate, "interfoam_50x50");
  EXPECT_EQ(definition.gate.at(0).reference, "linear_two_layer");
}

TEST(CaseParser, ReadsTheVariantsOfThePapersCases) {
  const auto ramped = read_case(cases / "li2010_small_amplitude_ramp.toml");
  EXPECT_EQ(std::get<SineMotion>(ramped.motion.surge.value()).ramp_periods, 2);
  EXPECT_EQ(read_case(cases / "li2010_small_amplitude_tank_start.toml").start, Start::tank);
  const auto resonant = read_case(cases / "li2010_resonant_T13_b025.toml");
  EXPECT_DOUBLE_EQ(std::get<SineMotion>(resonant.motion.surge.value()).angular_frequency,
                   2 * std::numbers::pi / 1.3);
  EXPECT_EQ(std::get<SineMotion>(resonant.motion.surge.value()).amplitude, 0.025);
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

TEST(CaseParser, LetsRowsOfRegressionAloneRestOnAnEarlierRun) {
  const fs::path shipped = cases / "extreme_zero_gravity.toml";
  const CaseDefinition definition = read_case(shipped);
  EXPECT_TRUE(std::get<RecordRun>(run_named(definition, "earlier").solver).earlier_run);
  const TemporaryDirectory temporary;
  fs::create_directory(temporary.path() / "records");
  fs::copy_file(cases / "records/extreme_zero_gravity.csv",
                temporary.path() / "records/extreme_zero_gravity.csv");
  std::string text = definition.text;
  const std::string kind = "kind = \"regression\"";
  text.replace(text.find(kind), kind.size(), "kind = \"validation\"");
  std::ofstream(temporary.path() / "case.toml") << text;
  const std::string message =
      message_of<CaseFileError>([&] { read_case(temporary.path() / "case.toml"); });
  EXPECT_TRUE(holds(message, "an earlier run of this harness"));
}

TEST(CaseParser, FillsInTheWholeDefinition) {
  const CaseDefinition definition = read_text(valid_text);
  EXPECT_EQ(definition.tank.length, 2.0);  // written as an integer
  EXPECT_EQ(definition.tags, std::vector<std::string>{"surge"});
  EXPECT_EQ(definition.text, valid_text);
  EXPECT_EQ(definition.gauges.size(), 2u);
  const auto& sph = std::get<SphRun>(definition.runs.at(1).solver);
  EXPECT_EQ(sph.scheme, "any");
  EXPECT_EQ(sph.surface_particle_spacing, 0.01);
  EXPECT_TRUE(definition.runs.at(1).quick);
  EXPECT_FALSE(definition.runs.at(0).quick);
  const auto& foam = std::get<InterFoamRun>(definition.runs.at(2).solver);
  EXPECT_EQ(foam.cells_z, 40);
  EXPECT_EQ(foam.processes, 1);
  const GateRow& row = definition.gate.at(0);
  EXPECT_EQ(row.metric, Metric::amplitude_error);
  EXPECT_EQ(row.limit, 0.05);
  EXPECT_FALSE(row.between || row.improves_on);
  EXPECT_EQ(row.where.line, 52);
}

TEST(CaseParser, ReadsTheProgramOfOpenFoamAndItsSettings) {
  const auto run_of = [](const std::string& solver, const std::string& settings) {
    const CaseDefinition definition =
        read_text(edited({"solver = \"interfoam\"", "solver = \"" + solver + "\"\n" + settings}));
    return std::get<InterFoamRun>(definition.runs.at(2).solver);
  };
  EXPECT_EQ(run_of("interfoam", "").program, FoamProgram::inter_foam);
  EXPECT_EQ(run_of("interisofoam", "").program, FoamProgram::inter_iso_foam);
  EXPECT_EQ(run_of("compressible_interfoam", "").program, FoamProgram::compressible_inter_foam);
  const InterFoamRun plain = run_of("interfoam", "");
  EXPECT_EQ(plain.courant_number, 0.5);
  EXPECT_EQ(plain.interface_courant_number, 0.5);
  EXPECT_EQ(plain.outer_corrections, 1);
  EXPECT_EQ(run_of("compressible_interfoam", "outer_corrections = 3").outer_corrections, 3);
  const InterFoamRun short_steps = run_of("interfoam", "courant_number = 0.25");
  EXPECT_EQ(short_steps.courant_number, 0.25);
  EXPECT_EQ(short_steps.interface_courant_number, 0.25);
  EXPECT_FALSE(plain.no_slip || plain.wall_cell);
  const InterFoamRun changed =
      run_of("interfoam", "interface_courant_number = 0.25\nno_slip = true\nwall_cell_m = 0.02");
  EXPECT_EQ(changed.courant_number, 0.5);
  EXPECT_EQ(changed.interface_courant_number, 0.25);
  EXPECT_TRUE(changed.no_slip);
  EXPECT_EQ(changed.wall_cell, 0.02);
}

const std::string step =
    "[[obstacle]]\nname = \"step\"\nleft_m = 0.0\nright_m = 0.2\nbottom_m = 0.0\ntop_m = 0.1\n";

TEST(CaseParser, RefusesGradedCellsBesideAnObstacleAndNoSlipOfAnInviscidLiquid) {
  expect_refusals(valid_text + step, R"(
run(mesh).wall_cell_m = 0.01: expected no such key in a tank with an obstacle
liquid.kinematic_viscosity_m2_s = 0.0 & run(mesh).no_slip = true: expected no such key for a liquid
  without viscosity
)");
}

// The case with a narrow tank, an SPH run and one of cells instead of all its runs.
const std::string narrow_case =
    with_keys(valid_text.substr(0, valid_text.find("[[run]]")), "tank.breadth_m = 0.062") +
    "[[run]]\nname = \"sph\"\nsolver = \"sph\"\nscheme = \"any\"\nparticle_spacing_m = 0.01\n"
    "[[run]]\nname = \"mesh\"\nsolver = \"interfoam\"\ncells_x = 50\ncells_z = 40\n";

TEST(CaseParser, ReadsTheBreadthOfANarrowTankAndTheCellsAcrossIt) {
  EXPECT_FALSE(read_text(valid_text).tank.breadth);
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
run.no_slip = true & run.cells_y = 3: expected
)");
  expect_refusals(narrow_case + step, R"(
run.no_slip = true & run.cells_y = 8: expected no such key in a tank with an obstacle
)");
}

TEST(CaseParser, TakesTheInnerSpacingAtTheSurfaceUnlessTold) {
  const auto definition = read_text(edited({"surface_particle_spacing_m = 0.01\n", ""}));
  EXPECT_EQ(std::get<SphRun>(definition.runs.at(1).solver).surface_particle_spacing, 0.02);
}

TEST(CaseParser, ReadsWhatARunChangesOfItsScheme) {
  const auto definition = read_text(edited({"quick = true",
                                            "variant = \"antuono\"\nsmoothing_length_ratio = 2\n"
                                            "sound_speed_ratio = 20.0\ncourant_number = 0.4\n"
                                            "artificial_viscosity = 0\ndensity_diffusion = 0.1"}));
  const auto& changed = std::get<SphRun>(definition.runs.at(1).solver);
  EXPECT_EQ(changed.variant, "antuono");
  EXPECT_EQ(changed.numbers.smoothing_length_ratio, 2);
  EXPECT_EQ(changed.numbers.sound_speed_ratio, 20);
  EXPECT_EQ(changed.numbers.courant_number, 0.4);
  EXPECT_EQ(changed.numbers.artificial_viscosity, 0);
  EXPECT_EQ(changed.numbers.density_diffusion, 0.1);
  const CaseDefinition plain = read_text(valid_text);
  const auto& unchanged = std::get<SphRun>(plain.runs.at(1).solver);
  EXPECT_EQ(unchanged.variant, "");
  for (const auto& [name, number] : sph_number_names)
    EXPECT_FALSE(unchanged.numbers.*number) << name;
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
  EXPECT_EQ(row_with("gate.kind = \"validation\"").kind, RowKind::validation);
  expect_refusals(valid_text, R"(
gate.kind = "measured": expected what the limit comes from, one of validation, regression; nearest:
  regression
)");
}

const std::string uncertain_depth =
    "[[input]]\nname = \"fill_depth\"\nhalf_width = 0.0005\nunit = \"m\"\nsource = \"a ruler\"\n";

TEST(CaseParser, ReadsHowWellAnExperimentKnewItsInputs) {
  const CaseDefinition definition = read_text(valid_text + uncertain_depth);
  ASSERT_EQ(definition.inputs.size(), 1U);
  EXPECT_EQ(definition.inputs[0].input, Input::fill_depth);
  EXPECT_EQ(definition.inputs[0].half_width, 0.0005);
  EXPECT_EQ(definition.inputs[0].source, "a ruler");
}

TEST(CaseParser, AddsACoarseRunAtBothEndsOfAnUncertainInput) {
  const CaseDefinition plain = read_text(valid_text);
  const std::string coarse =
      std::find_if(plain.runs.begin(), plain.runs.end(), [](const auto& run) {
        return std::holds_alternative<SphRun>(run.solver);
      })->name;
  const std::string told = uncertain_depth + "coarse_run = \"" + coarse + "\"\n";
  const CaseDefinition definition = read_text(valid_text + told);
  ASSERT_EQ(definition.runs.size(), plain.runs.size() + 2);
  const RunDefinition &lower = *(definition.runs.end() - 2), &upper = definition.runs.back();
  EXPECT_EQ(lower.name, coarse + "_fill_depth_lower");
  EXPECT_EQ(upper.name, coarse + "_fill_depth_upper");
  EXPECT_EQ(lower.at_input->change, -0.0005);
  EXPECT_EQ(upper.at_input->change, 0.0005);
  EXPECT_EQ(upper.at_input->repeated_run, coarse);
  EXPECT_EQ(definition_solved_by(upper, definition).liquid.fill_depth,
            definition.liquid.fill_depth + 0.0005);
  EXPECT_EQ(definition_solved_by(definition.runs.front(), definition).liquid.fill_depth,
            definition.liquid.fill_depth);
}

TEST(CaseParser, RefusesAnInputThatIsNoneOrIsThereTwice) {
  expect_refusals(valid_text + uncertain_depth, R"(
input.name = "depth": expected an input that this case has, one of fill_depth, period
input.unit = "mm": expected the unit of fill_depth, which is m; nearest: m
input.half_width = 0: expected a number > 0
input.sources = "a ruler": expected only these keys
input.coarse_run = "nothing": expected an SPH or OpenFOAM run of this case
)");
  expect_refusals(valid_text + uncertain_depth + uncertain_depth, R"(
-> input.name = "fill_depth": expected each input once
)");
}

TEST(CaseParser, ReadsRowsOnARunsOwnSeriesOnAWaveAndOnWhatAnErrorCosts) {
  const GateRow own = row_with(
      "gate.reference is missing & gate.quantity = \"liquid_volume\" & gate.mode = \"whole\" & "
      "gate.metric = \"largest_magnitude\" & gate.unit = \"m2\"");
  EXPECT_EQ(own.reference, "");
  EXPECT_EQ(own.quantity, "liquid_volume");
  EXPECT_EQ(own.metric, Metric::largest_magnitude);
  EXPECT_EQ(own.unit, "m2");
  const std::string whole = "gate.mode = \"whole\" & gate.metric = ";
  EXPECT_EQ(row_with(whole + "\"rms_error\"").metric, Metric::rms_error);
  EXPECT_EQ(row_with(whole + "\"mean_offset\" & gate.unit = \"m\"").metric, Metric::mean_offset);
  const GateRow noise = row_with("gate.reference is missing & " + whole + "\"noise_share\"");
  EXPECT_EQ(noise.metric, Metric::noise_share);
  EXPECT_EQ(noise.reference, "");
  const GateRow cost = row_with(
      whole + "\"cost_to_reach\" & gate.unit = \"s\" & gate.error = 0.1 & gate.limit = 20");
  EXPECT_EQ(cost.metric, Metric::cost_to_reach);
  EXPECT_EQ(cost.error, 0.1);
  EXPECT_EQ(cost.limit, 20);
  EXPECT_FALSE(row_with("").error);
}

TEST(CaseParser, ReadsATankThatStandsWhichHasNoForcedModeAndNoSpeedToMeasure) {
  const std::string still = edited({sine_surge, "[motion]\nstill = true\n"});
  const std::string free = still.substr(0, still.find("[[gate]]"));
  EXPECT_TRUE(read_text(free).motion.still());
  EXPECT_TRUE(read_text(with_keys(free, "time.start = \"tank\"")).motion.still());
  EXPECT_FALSE(read_text(valid_text).motion.still());
  expect_refusals(still, R"(-> gate.mode = "forced": expected)");
  expect_refusals(free, R"(
run(coarse).expected_speed = "coarse_run": expected "estimate" in a case without motion, initial
  wave or dam: nothing flows
)");
}

TEST(CaseParser, ReadsADamAboutToBreak) {
  EXPECT_EQ(read_text(with_keys(valid_text,
                                "liquid.column_width_m = 0.25 & "
                                "comparison.natural_modes = 0"))
                .liquid.column_width,
            0.25);
  EXPECT_FALSE(read_text(valid_text).liquid.column_width);
}

TEST(CaseParser, ReadsObstaclesThatTouchWallsAndOneAnother) {
  const auto definition =
      read_text(edited({"[comparison]",
                        "[[obstacle]]\nname = \"step\"\nleft_m = 0\nright_m = 0.5\nbottom_m = 0\n"
                        "top_m = 0.3\n[[obstacle]]\nname = \"lid\"\nleft_m = 0.5\nright_m = 2\n"
                        "bottom_m = 0.8\ntop_m = 1\n[comparison]"}));
  ASSERT_EQ(definition.obstacles.size(), 2u);
  EXPECT_EQ(definition.obstacles[0].name, "step");
  EXPECT_EQ(definition.obstacles[0].right, 0.5);
  EXPECT_EQ(definition.obstacles[1].bottom, 0.8);
  EXPECT_TRUE(read_text(valid_text).obstacles.empty());
}

TEST(CaseParser, RefusesACaseWithoutRunsOrGauges) {
  const std::size_t runs = valid_text.find("[[run]]"), gauges = valid_text.find("[[gauge]]");
  const std::size_t comparison = valid_text.find("[comparison]");
  const Workspace workspace;
  EXPECT_EQ(complaint(workspace.write("a.toml", valid_text.substr(0, runs))),
            "a.toml:1: run is missing: expected at least one [[run]]");
  EXPECT_EQ(complaint(workspace.write(
                "b.toml", valid_text.substr(0, gauges) + valid_text.substr(comparison))),
            "b.toml:1: gauge is missing: expected at least one [[gauge]] or [[pressure_gauge]]");
}

TEST(CaseParser, RefusesAFileThatCannotBeRead) {
  EXPECT_THROW(read_case("/nowhere/at_all.toml"), CaseFileError);
  EXPECT_THROW(read_case(cases), CaseFileError);
}

TEST(FindCase, TakesTheNameOfAShippedCaseOrAPath) {
  const fs::path file = cases / "li2010_small_amplitude.toml";
  EXPECT_EQ(find_case("li2010_small_amplitude", cases), file);
  EXPECT_EQ(find_case(file.string(), "/nowhere"), file);
}

TEST(FindCase, NamesTheNearestOfTheShippedCases) {
  const std::string message =
      message_of<CaseFileError>([&] { find_case("li2010_small_amplitud_ramp", cases); });
  EXPECT_TRUE(
      holds(message, "case = \"li2010_small_amplitud_ramp\": expected a path or a name in"));
  EXPECT_TRUE(holds(message, "nearest: li2010_small_amplitude_ramp, "));
  EXPECT_THROW(find_case("./li2010_small_amplitude.toml", cases), CaseFileError);
}

SphRun sph_of(const std::string& changes) {
  return std::get<SphRun>(read_text(with_keys(valid_text, changes)).runs.at(1).solver);
}

TEST(ExpectedSpeedOfARun, IsEstimatedUnlessACoarseRunIsAskedFor) {
  EXPECT_FALSE(sph_of("").speed_from_coarse_run);
  EXPECT_FALSE(sph_of("run(coarse).expected_speed = \"estimate\"").speed_from_coarse_run);
  EXPECT_TRUE(sph_of("run(coarse).expected_speed = \"coarse_run\"").speed_from_coarse_run);
}

TEST(StartOfARun, MayBeDisorderedBySeed) {
  const SphRun repeat = sph_of("run(coarse).start_disorder = 0.05 & run(coarse).start_seed = 7");
  EXPECT_EQ(repeat.start_disorder, 0.05);
  EXPECT_EQ(repeat.start_seed, 7);
  EXPECT_EQ(sph_of("").start_disorder, 0);
  EXPECT_EQ(sph_of("run(coarse).start_disorder = 0.2").start_seed, 0);
}

TEST(StartOfARun, IsRefusedWhereItIsTooFarOrHasNothingToVary) {
  expect_refusals(valid_text, R"(
run(coarse).start_disorder = -0.01: expected a number from 0 to 0.2, in particle spacings
run(coarse).start_disorder = 0.21: expected a number from 0 to 0.2, in particle spacings
run(coarse).start_disorder = nan: expected a number from 0 to 0.2, in particle spacings
run(coarse).start_disorder = 0.1 & run(coarse).start_seed = -1: expected an integer >= 0
run(coarse).start_seed = 1: expected no such key without start_disorder > 0
run(coarse).start_disorder = 0 & run(coarse).start_seed = 1: expected no such key without
  start_disorder > 0
)");
}

TEST(StartOfARun, MayBeATurnedLatticeThatSettles) {
  const std::string uniform = "run(coarse).surface_particle_spacing_m is missing & ",
                    settled = uniform + "run(coarse).initial_state = \"settled\" & ";
  EXPECT_EQ(sph_of(settled + "run(coarse).start_rotation_deg = 20").start_rotation_deg, 20);
  EXPECT_EQ(sph_of("").start_rotation_deg, 0);
  expect_refusals(with_keys(valid_text, uniform + "run(coarse).quick = true"), R"(
run(coarse).start_rotation_deg = -1: expected a number from 0 to 45, in degrees
run(coarse).start_rotation_deg = 46: expected a number from 0 to 45, in degrees
run(coarse).start_rotation_deg = nan: expected a number from 0 to 45, in degrees
run(coarse).start_rotation_deg = 20: expected initial_state = "settled" beside it: rotated rows do
  not fit the walls
run(coarse).initial_state = "projected" & run(coarse).start_rotation_deg = 20: expected
  initial_state = "settled" beside it
)");
  expect_refusals(valid_text, R"(
run(coarse).initial_state = "settled" & run(coarse).start_rotation_deg = 20: expected no such key
  beside surface_particle_spacing_m
)");
}

TEST(Ensemble, OfOneRunIsAsManyThatDifferInTheirSeedAlone) {
  const CaseDefinition definition = read_text(edited(
      {"quick = true\n", "start_disorder = 1e-6\nstart_seed = 5\nrepeats = 3\nquick = true\n"}));
  ASSERT_EQ(definition.runs.size(), 5U);
  const char* names[] = {"coarse", "coarse_2", "coarse_3"};
  SphRun alike = std::get<SphRun>(definition.runs[1].solver);
  for (int k = 0; k < 3; ++k) {
    const RunDefinition& member = definition.runs[static_cast<std::size_t>(k) + 1];
    EXPECT_EQ(member.name, names[k]);
    EXPECT_EQ(member.ensemble, "coarse");
    EXPECT_EQ(is_later_member(member), k > 0);
    EXPECT_TRUE(member.quick);
    alike.start_seed = 5 + k;
    EXPECT_EQ(std::get<SphRun>(member.solver), alike);
  }
  const std::vector<std::string> all{"coarse", "coarse_2", "coarse_3"};
  EXPECT_EQ(members_of(definition, "coarse"), all);
  EXPECT_EQ(members_of(definition, "coarse_2"), std::vector<std::string>{"coarse_2"});
  EXPECT_EQ(members_of(definition, "theory"), std::vector<std::string>{"theory"});
}

TEST(Ensemble, OfInterFoamStartsFromDisturbedLevels) {
  const CaseDefinition definition =
      read_text(edited({"cells_z = 40\n", "cells_z = 40\nstart_disorder = 1e-3\nrepeats = 2\n"}));
  ASSERT_EQ(definition.runs.size(), 4U);
  const auto& second = std::get<InterFoamRun>(definition.runs[3].solver);
  EXPECT_EQ(definition.runs[3].name, "mesh_2");
  EXPECT_EQ(second.start_disorder, 1e-3);
  EXPECT_EQ(second.start_seed, 1);
  EXPECT_EQ(std::get<InterFoamRun>(definition.runs[2].solver).start_seed, 0);
}

TEST(Ensemble, MayDrawTheInputsOfItsMembersAndNeedsNoDisorderThen) {
  const CaseDefinition definition =
      read_text(with_keys(valid_text,
                          "run(mesh).repeats = 3 & run(mesh).vary_inputs = true & "
                          "run(mesh).start_seed = 5") +
                uncertain_depth);
  ASSERT_EQ(definition.runs.size(), 5U);
  for (std::size_t k = 0; k < 3; ++k) {
    const RunDefinition& member = definition.runs[k + 2];
    EXPECT_EQ(member.ensemble, "mesh");
    EXPECT_EQ(std::get<InterFoamRun>(member.solver).start_disorder, 0);
    ASSERT_EQ(member.drawn_inputs.size(), 1U) << member.name;
    EXPECT_EQ(member.drawn_inputs, drawn_inputs(definition.inputs, 5 + static_cast<int>(k)));
  }
  EXPECT_TRUE(definition.runs[1].drawn_inputs.empty());
}

TEST(Ensemble, IsRefusedWhereItsMembersWouldBeOneRunOrHaveNothingToDraw) {
  expect_refusals(valid_text, R"(
run(coarse).repeats = 4: expected no such key without start_disorder > 0 or vary_inputs: there is
  nothing to vary (1e-6 particle spacings is enough in a chaotic flow)
run(coarse).start_disorder = 0 & run(coarse).repeats = 4: expected no such key without
  start_disorder > 0 or vary_inputs
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 1: expected an integer from 2 to 1000
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 0: expected an integer from 2 to 1000
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = -2: expected an integer from 2 to 1000
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 1001: expected an integer from 2 to 1000
run(mesh).repeats = 3 & run(mesh).vary_inputs = true: expected no such key without an [[input]]:
  there is nothing to draw
)");
  expect_refusals(valid_text + uncertain_depth, R"(
run(mesh).vary_inputs = true: expected no such key without repeats
)");
}

TEST(Ensemble, MayHaveFewerMembersInTheQuickForm) {
  CaseDefinition definition = read_text(edited(
      {"quick = true\n", "start_disorder = 1e-6\nrepeats = 3\nquick_repeats = 2\nquick = true\n"}));
  ASSERT_EQ(definition.runs.size(), 5U);
  EXPECT_TRUE(definition.runs[1].quick);
  EXPECT_TRUE(definition.runs[2].quick);
  EXPECT_FALSE(definition.runs[3].quick);
  EXPECT_EQ(members_of(definition, "coarse").size(), 3U);
  keep_quick_members(definition);
  EXPECT_EQ(members_of(definition, "coarse"), (std::vector<std::string>{"coarse", "coarse_2"}));
  EXPECT_EQ(definition.runs.size(), 4U) << "single runs stay, as the quick form tells of them";

  expect_refusals(with_keys(valid_text, "run(coarse).start_disorder = 1e-6"), R"(
run(coarse).quick_repeats = 2: expected no such key without repeats and quick
run(coarse).quick is missing & run(coarse).repeats = 3 & run(coarse).quick_repeats = 2: expected no
  such key without repeats and quick
run(coarse).repeats = 3 & run(coarse).quick_repeats = 0: expected an integer from 1 to repeats (3)
run(coarse).repeats = 3 & run(coarse).quick_repeats = 4: expected an integer from 1 to repeats (3)
)");
}

TEST(Ensemble, HasNamesOfItsOwnAndIsNamedInAGateRowByItsFirstMember) {
  expect_refusals(with_keys(valid_text, "run(mesh).start_disorder = 1e-3 & run(mesh).repeats = 3") +
                      "[[run]]\nname = \"mesh_3\"\nsolver = \"potential\"\n",
                  R"(-> run.name = "mesh_3": expected a name that no other run has)");
  expect_refusals(
      with_keys(valid_text, "run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 3"),
      R"(gate.candidate = "coarse_2": expected a run, one of theory, coarse, mesh;)");
}

}  // namespace
}  // namespace slosh::case_parser_test
