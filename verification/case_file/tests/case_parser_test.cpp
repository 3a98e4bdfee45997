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
  try {
    read_case(temporary.path() / "case.toml");
    FAIL();
  } catch (const CaseFileError& error) {
    EXPECT_NE(std::string(error.what()).find("an earlier run of this harness"), std::string::npos)
        << error.what();
  }
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

TEST(CaseParser, RefusesGradedCellsBesideAnObstacleAndNoSlipOfAnInviscidLiquid) {
  const std::string mesh = "[[run]]\nname = \"mesh\"\nsolver = \"interfoam\"\n";
  const std::string obstacle =
      "[[obstacle]]\nname = \"step\"\nleft_m = 0.0\nright_m = 0.2\nbottom_m = 0.0\ntop_m = 0.1\n";
  const std::string graded = complaint_about({mesh, obstacle + mesh + "wall_cell_m = 0.01\n"});
  EXPECT_NE(graded.find("run.wall_cell_m = 0.01: expected no such key in a tank with an obstacle"),
            std::string::npos)
      << graded;
  std::string inviscid = edited({mesh, mesh + "no_slip = true\n"});
  const std::string water = "kinematic_viscosity_m2_s = 1e-6";
  inviscid.replace(inviscid.find(water), water.size(), "kinematic_viscosity_m2_s = 0.0");
  const Workspace workspace;
  EXPECT_NE(complaint(workspace.write("trial.toml", inviscid))
                .find("run.no_slip = true: expected no such key for a liquid without viscosity"),
            std::string::npos);
}

TEST(CaseParser, ReadsTheBreadthOfANarrowTank) {
  EXPECT_FALSE(read_text(valid_text).tank.breadth);
  std::string text = edited({"height_m = 1.0\n", "height_m = 1.0\nbreadth_m = 0.062\n"});
  text = text.substr(0, text.find("[[gate]]"));
  const std::size_t theory = text.find("[[run]]"), sph = text.find("[[run]]", theory + 1);
  EXPECT_EQ(read_text(text.erase(theory, sph - theory)).tank.breadth, 0.062);
}

// Returns the case with a narrow tank and this run instead of all its runs.
std::string narrow_case(const std::string& breadth, const std::string& run) {
  std::string text = edited({"height_m = 1.0\n", "height_m = 1.0\n" + breadth});
  text = text.substr(0, text.find("[[run]]"));
  return text + "[[run]]\nname = \"sph\"\nsolver = \"sph\"\nscheme = \"any\"\n" +
         "particle_spacing_m = 0.01\n\n[[run]]\nname = \"mesh\"\ncells_x = 50\ncells_z = 40\n" +
         run;
}

TEST(CaseParser, ReadsTheCellsAcrossANarrowTank) {
  const std::string narrow = "breadth_m = 0.062\n", sticking = "no_slip = true\ncells_y = 8\n";
  for (const char* solver : {"interfoam", "interisofoam", "compressible_interfoam"}) {
    const CaseDefinition read =
        read_text(narrow_case(narrow, "solver = \"" + std::string(solver) + "\"\n" + sticking));
    EXPECT_EQ(std::get<InterFoamRun>(read.runs.at(1).solver).cells_y, 8) << solver;
  }
  const auto refused = [](const std::string& breadth, const std::string& settings) {
    const Workspace workspace;
    return complaint(
        workspace.write("trial.toml", narrow_case(breadth, "solver = \"interfoam\"\n" + settings)));
  };
  const auto expect = [](const std::string& message, const char* part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect(refused("", sticking),
         "run.cells_y = 8: expected no such key in a tank without breadth_m");
  expect(refused(narrow, "cells_y = 8\n"), "run.cells_y = 8: expected no_slip = true beside it");
  expect(refused(narrow, "no_slip = true\ncells_y = 3\n"), "run.cells_y = 3: expected");
  expect(refused(narrow, sticking + "[[obstacle]]\nname = \"step\"\nleft_m = 0.0\nright_m = "
                                    "0.2\nbottom_m = 0.0\ntop_m = 0.1\n"),
         "run.cells_y = 8: expected no such key in a tank with an obstacle");
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

TEST(CaseParser, AcceptsACaseWithoutGateRows) {
  const std::string text = valid_text.substr(0, valid_text.find("[[gate]]"));
  EXPECT_TRUE(read_text(text).gate.empty());
}

TEST(CaseParser, ReadsTheOtherBoundsOfAGateRow) {
  const auto between = read_text(edited({"limit = 0.05", "lower = -0.2\nupper = 0.05"}));
  EXPECT_EQ(between.gate.at(0).between, std::make_pair(-0.2, 0.05));
  const auto improves = read_text(edited({"limit = 0.05", "improves_on = \"mesh\""}));
  EXPECT_EQ(improves.gate.at(0).improves_on, "mesh");
  EXPECT_FALSE(improves.gate.at(0).limit);
}

TEST(CaseParser, TakesAGateRowForAValidationRowUnlessItIsToldOtherwise) {
  EXPECT_EQ(read_text(valid_text).gate.at(0).kind, RowKind::validation);
  EXPECT_EQ(read_text(valid_text + "kind = \"regression\"\n").gate.at(0).kind, RowKind::regression);
  EXPECT_EQ(read_text(valid_text + "kind = \"validation\"\n").gate.at(0).kind, RowKind::validation);
  const Workspace workspace;
  EXPECT_EQ(complaint(workspace.write("trial.toml", valid_text + "kind = \"measured\"\n")),
            "trial.toml:62: gate.kind = \"measured\": expected what the limit comes from, one of "
            "validation, regression; nearest: regression");
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
  const Workspace workspace;
  EXPECT_NE(complaint(workspace.write("trial.toml",
                                      valid_text + uncertain_depth + "coarse_run = \"nothing\"\n"))
                .find("input.coarse_run = \"nothing\": expected an SPH or OpenFOAM run of this "
                      "case"),
            std::string::npos);
}

TEST(CaseParser, RefusesAnInputThatIsNoneOrIsThereTwice) {
  const auto said = [](const std::string& from, const std::string& to) {
    std::string text = uncertain_depth;
    text.replace(text.find(from), from.size(), to);
    const Workspace workspace;
    return complaint(workspace.write("trial.toml", valid_text + text));
  };
  EXPECT_EQ(said("fill_depth", "depth")
                .find("trial.toml:63: input.name = \"depth\": expected an "
                      "input that this case has, one of fill_depth, period"),
            0U);
  EXPECT_EQ(said("\"m\"", "\"mm\""),
            "trial.toml:65: input.unit = \"mm\": expected the unit of fill_depth, which is m; "
            "nearest: m");
  EXPECT_EQ(said("0.0005", "0").find("trial.toml:64: input.half_width = 0: expected a number > 0"),
            0U);
  EXPECT_EQ(said("source", "sources").find("trial.toml:66: input.sources"), 0U);
  EXPECT_EQ(said("a ruler\"\n", "a ruler\"\n" + uncertain_depth)
                .find("trial.toml:68: input.name = \"fill_depth\": expected each input once"),
            0U);
}

TEST(CaseParser, ReadsAGateRowOnARunsOwnSeries) {
  const auto definition = read_text(
      edited({"reference = \"theory\"\nquantity = \"elevation@right\"\nmode = \"forced\"\n"
              "metric = \"amplitude_error\"\nunit = \"1\"",
              "quantity = \"liquid_volume\"\nmode = \"whole\"\nmetric = \"largest_magnitude\"\n"
              "unit = \"m2\""}));
  const GateRow& row = definition.gate.at(0);
  EXPECT_EQ(row.reference, "");
  EXPECT_EQ(row.quantity, "liquid_volume");
  EXPECT_EQ(row.metric, Metric::largest_magnitude);
  EXPECT_EQ(row.unit, "m2");
}

TEST(CaseParser, ReadsGateRowsOnTheStatisticsOfAWave) {
  const auto row_on = [](const std::string& metric, const std::string& mode,
                         const std::string& unit) {
    return read_text(edited({"mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"",
                             "mode = \"" + mode + "\"\nmetric = \"" + metric + "\"\nunit = \"" +
                                 unit + "\""}))
        .gate.at(0)
        .metric;
  };
  EXPECT_EQ(row_on("rms_error", "whole", "1"), Metric::rms_error);
  EXPECT_EQ(row_on("mean_offset", "whole", "m"), Metric::mean_offset);
  EXPECT_THROW(row_on("rms_error", "forced", "1"), CaseFileError);
  EXPECT_THROW(row_on("mean_offset", "whole", "1"), CaseFileError);
  EXPECT_THROW(row_on("noise_share", "whole", "1"), CaseFileError);  // has a reference
}

TEST(CaseParser, ReadsAGateRowOnTheNoiseOfARun) {
  const auto definition = read_text(
      edited({"reference = \"theory\"\nquantity = \"elevation@right\"\nmode = \"forced\"\n"
              "metric = \"amplitude_error\"",
              "quantity = \"elevation@right\"\nmode = \"whole\"\nmetric = \"noise_share\""}));
  EXPECT_EQ(definition.gate.at(0).metric, Metric::noise_share);
  EXPECT_EQ(definition.gate.at(0).reference, "");
}

TEST(CaseParser, ReadsAGateRowOnWhatAnErrorCosts) {
  const auto definition =
      read_text(edited({"mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"\n"
                        "limit = 0.05",
                        "mode = \"whole\"\nmetric = \"cost_to_reach\"\nunit = \"s\"\n"
                        "error = 0.1\nlimit = 20"}));
  const GateRow& row = definition.gate.at(0);
  EXPECT_EQ(row.metric, Metric::cost_to_reach);
  EXPECT_EQ(row.error, 0.1);
  EXPECT_EQ(row.limit, 20);
  EXPECT_FALSE(read_text(valid_text).gate.at(0).error);
}

TEST(CaseParser, ReadsATankThatStands) {
  std::string text = edited({sine_surge, "[motion]\nstill = true\n"});
  text = text.substr(0, text.find("[[gate]]"));
  EXPECT_TRUE(read_text(text).motion.still());
  const std::string earth = "start = \"earth\"";
  text.replace(text.find(earth), earth.size(), "start = \"tank\"");
  EXPECT_TRUE(read_text(text).motion.still());
  EXPECT_FALSE(read_text(valid_text).motion.still());
}

TEST(CaseParser, KnowsNoForcedModeOfATankThatStands) {
  const std::string message = complaint_about({sine_surge, "[motion]\nstill = true\n"});
  EXPECT_TRUE(message.starts_with("trial.toml:54: gate.mode = \"forced\": expected")) << message;
}

TEST(CaseParser, ReadsADamAboutToBreak) {
  std::string text =
      edited({"viscosity_m2_s = 1e-6", "viscosity_m2_s = 1e-6\ncolumn_width_m = 0.25"});
  const std::string modes = "natural_modes = 2";
  text.replace(text.find(modes), modes.size(), "natural_modes = 0");
  EXPECT_EQ(read_text(text).liquid.column_width, 0.25);
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
  try {
    find_case("li2010_small_amplitud_ramp", cases);
    FAIL() << "found a case that is not there";
  } catch (const CaseFileError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("case = \"li2010_small_amplitud_ramp\": expected a path or a name in"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("nearest: li2010_small_amplitude_ramp, "), std::string::npos) << message;
  }
  EXPECT_THROW(find_case("./li2010_small_amplitude.toml", cases), CaseFileError);
}

SphRun sph_of(const std::string& keys) {
  return std::get<SphRun>(
      read_text(edited({"quick = true\n", keys + "quick = true\n"})).runs.at(1).solver);
}

TEST(ExpectedSpeedOfARun, IsEstimatedUnlessACoarseRunIsAskedFor) {
  EXPECT_FALSE(sph_of("").speed_from_coarse_run);
  EXPECT_FALSE(sph_of("expected_speed = \"estimate\"\n").speed_from_coarse_run);
  EXPECT_TRUE(sph_of("expected_speed = \"coarse_run\"\n").speed_from_coarse_run);
}

TEST(ExpectedSpeedOfARun, IsNotMeasuredWhereNothingFlows) {
  std::string text = edited({sine_surge, "[motion]\nstill = true\n"});
  text.replace(text.find("quick = true\n"), 0, "expected_speed = \"coarse_run\"\n");
  const Workspace workspace;
  const std::string message = complaint(workspace.write("trial.toml", text));
  EXPECT_NE(message.find("run.expected_speed = \"coarse_run\": expected \"estimate\" in a case "
                         "without motion, initial wave or dam: nothing flows"),
            std::string::npos)
      << message;
}

TEST(StartOfARun, MayBeDisorderedBySeed) {
  const SphRun repeat = sph_of("start_disorder = 0.05\nstart_seed = 7\n");
  EXPECT_EQ(repeat.start_disorder, 0.05);
  EXPECT_EQ(repeat.start_seed, 7);
  EXPECT_EQ(sph_of("").start_disorder, 0);
  EXPECT_EQ(sph_of("start_disorder = 0.2\n").start_seed, 0);
}

TEST(StartOfARun, IsRefusedWhereItIsTooFarOrHasNothingToVary) {
  const auto complaint_of = [](const std::string& keys) {
    return complaint_about({"quick = true\n", keys + "quick = true\n"});
  };
  for (const char* value : {"-0.01", "0.21", "nan"}) {
    const std::string message = complaint_of(std::string("start_disorder = ") + value + "\n");
    EXPECT_TRUE(message.starts_with(std::string("trial.toml:46: run.start_disorder = ") + value +
                                    ": expected a number from 0 to 0.2, in particle spacings"))
        << message;
  }
  EXPECT_TRUE(complaint_of("start_disorder = 0.1\nstart_seed = -1\n")
                  .starts_with("trial.toml:47: run.start_seed = -1: expected an integer >= 0"));
  for (const char* keys : {"start_seed = 1\n", "start_disorder = 0\nstart_seed = 1\n"})
    EXPECT_NE(complaint_of(keys).find("run.start_seed = 1: expected no such key without "
                                      "start_disorder > 0"),
              std::string::npos);
}

const std::string surface_spacing = "surface_particle_spacing_m = 0.01\n",
                  turned = "start_rotation_deg = 20\ninitial_state = \"settled\"\n";

TEST(StartOfARun, MayBeATurnedLatticeThatSettles) {
  const auto definition = read_text(edited({surface_spacing, turned}));
  EXPECT_EQ(std::get<SphRun>(definition.runs.at(1).solver).start_rotation_deg, 20);
  EXPECT_EQ(sph_of("").start_rotation_deg, 0);
}

TEST(StartOfARun, RefusesATurnedLatticeThatWouldNotComeToRest) {
  const auto complains = [](const std::string& keys, const char* about) {
    return complaint_about({surface_spacing, keys}).find(about) != std::string::npos;
  };
  for (const char* value : {"-1", "46", "nan"})
    EXPECT_TRUE(complains(std::string("start_rotation_deg = ") + value + "\n",
                          ": expected a number from 0 to 45, in degrees"))
        << value;
  for (const char* state : {"", "initial_state = \"projected\"\n"})
    EXPECT_TRUE(complains(std::string("start_rotation_deg = 20\n") + state,
                          "run.start_rotation_deg = 20: expected initial_state = \"settled\" "
                          "beside it: rotated rows do not fit the walls"))
        << state;
  EXPECT_TRUE(complains(turned + surface_spacing,
                        "expected no such key beside surface_particle_spacing_m"));
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

std::string drawing(const std::string& keys, const std::string& input = uncertain_depth) {
  return edited({"cells_z = 40\n", "cells_z = 40\n" + keys}) + input;
}

TEST(Ensemble, MayDrawTheInputsOfItsMembersAndNeedsNoDisorderThen) {
  const CaseDefinition definition =
      read_text(drawing("repeats = 3\nvary_inputs = true\nstart_seed = 5\n"));
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

TEST(Ensemble, DrawsNoInputsWithoutRepeatsOrAnInput) {
  const Workspace workspace;
  const auto said = [&](const std::string& text) {
    return complaint(workspace.write("trial.toml", text));
  };
  EXPECT_NE(said(drawing("vary_inputs = true\n"))
                .find("run.vary_inputs = true: expected no such key without repeats"),
            std::string::npos);
  EXPECT_NE(said(drawing("repeats = 3\nvary_inputs = true\n", ""))
                .find("run.vary_inputs = true: expected no such key without an [[input]]: there is "
                      "nothing to draw"),
            std::string::npos);
}

TEST(Ensemble, IsRefusedWhereItsMembersWouldBeOneRun) {
  const auto complaint_of = [](const std::string& keys) {
    return complaint_about({"quick = true\n", keys + "quick = true\n"});
  };
  for (const char* keys : {"repeats = 4\n", "start_disorder = 0\nrepeats = 4\n"})
    EXPECT_NE(
        complaint_of(keys).find(
            "run.repeats = 4: expected no such key without start_disorder > 0 or vary_inputs: "
            "there is nothing to vary (1e-6 particle spacings is enough in a chaotic flow)"),
        std::string::npos)
        << complaint_of(keys);
  for (const char* count : {"1", "0", "-2", "1001"})
    EXPECT_NE(complaint_of(std::string("start_disorder = 1e-6\nrepeats = ") + count + "\n")
                  .find("expected an integer from 2 to 1000"),
              std::string::npos);
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

  const auto complaint_of = [](const std::string& keys) {
    return complaint_about({"quick = true\n", "start_disorder = 1e-6\n" + keys});
  };
  const char* needed = "expected no such key without repeats and quick";
  EXPECT_NE(complaint_of("quick = true\nquick_repeats = 2\n").find(needed), std::string::npos);
  EXPECT_NE(complaint_of("repeats = 3\nquick_repeats = 2\n").find(needed), std::string::npos);
  for (const char* count : {"0", "4"})
    EXPECT_NE(
        complaint_of(std::string("repeats = 3\nquick = true\nquick_repeats = ") + count + "\n")
            .find("expected an integer from 1 to repeats (3)"),
        std::string::npos);
}

TEST(Ensemble, IsRefusedWhereAMemberHasTheNameOfAnotherRun) {
  const std::string message = complaint_about(
      {"cells_z = 40\n",
       "cells_z = 40\nstart_disorder = 1e-3\nrepeats = 3\n[[run]]\nname = \"mesh_3\"\n"
       "solver = \"potential\"\n"});
  EXPECT_NE(message.find("run.name = \"mesh_3\": expected a name that no other run has"),
            std::string::npos)
      << message;
}

TEST(Ensemble, IsNamedInAGateRowByItsFirstMember) {
  std::string text =
      edited({"quick = true\n", "start_disorder = 1e-6\nrepeats = 3\nquick = true\n"});
  const std::string named = "candidate = \"coarse\"";
  text.replace(text.find(named), named.size(), "candidate = \"coarse_2\"");
  const Workspace workspace;
  const std::string message = complaint(workspace.write("trial.toml", text));
  EXPECT_NE(
      message.find("gate.candidate = \"coarse_2\": expected a run, one of theory, coarse, mesh;"),
      std::string::npos)
      << message;
}

}  // namespace
}  // namespace slosh::case_parser_test
