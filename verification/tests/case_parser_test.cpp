// The case parser on files that are right, on motion tables, and on files that are not there; every
// other mistake is in case_parser_refusal_test.cpp.
#include "verification/case_file/case_parser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "verification/tests/trial_case.hpp"

namespace slosh {
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

TEST(CaseParser, ReadsThePapersSmallAmplitudeCase) {
  const CaseDefinition definition = read_case(cases / "li2010_small_amplitude.toml");
  EXPECT_EQ(definition.tank.length, 1.0);
  EXPECT_EQ(definition.liquid.fill_depth, 0.35);
  EXPECT_EQ(definition.gas.density, 1.2);
  const auto& motion = std::get<SineSurge>(definition.motion);
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
  EXPECT_EQ(std::get<SineSurge>(ramped.motion).ramp_periods, 2);
  EXPECT_EQ(read_case(cases / "li2010_small_amplitude_tank_start.toml").start, Start::tank);
  const auto resonant = read_case(cases / "li2010_resonant_T13_b025.toml");
  EXPECT_DOUBLE_EQ(std::get<SineSurge>(resonant.motion).angular_frequency,
                   2 * std::numbers::pi / 1.3);
  EXPECT_EQ(std::get<SineSurge>(resonant.motion).amplitude, 0.025);
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

TEST(CaseParser, TakesTheInnerSpacingAtTheSurfaceUnlessTold) {
  const auto definition = read_text(edited({"surface_particle_spacing_m = 0.01\n", ""}));
  EXPECT_EQ(std::get<SphRun>(definition.runs.at(1).solver).surface_particle_spacing, 0.02);
}

TEST(CaseParser, ReadsWhatARunChangesOfItsScheme) {
  const auto definition = read_text(edited({"quick = true",
                                            "variant = \"shifting\"\nsmoothing_length_ratio = 2\n"
                                            "sound_speed_ratio = 20.0\ncourant_number = 0.4\n"
                                            "artificial_viscosity = 0\ndensity_diffusion = 0.1"}));
  const auto& changed = std::get<SphRun>(definition.runs.at(1).solver);
  EXPECT_EQ(changed.variant, "shifting");
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

TEST(CaseParser, ReadsARollAlthoughNothingSolvesItYet) {
  const auto definition =
      read_text(edited({"type = \"sine_surge\"\namplitude_m = 0.02",
                        "type = \"sine_roll\"\namplitude_deg = 4\naxis_x_m = 1.0\naxis_z_m = 0"}));
  const auto& roll = std::get<SineRoll>(definition.motion);
  EXPECT_DOUBLE_EQ(roll.amplitude, 4 * std::numbers::pi / 180);
  EXPECT_EQ(roll.where.line, 17);
}

TEST(CaseParser, ReadsATankThatStands) {
  std::string text =
      edited({"type = \"sine_surge\"\namplitude_m = 0.02\n"
              "angular_frequency_rad_s = 1.5\n",
              "type = \"still\"\n"});
  text = text.substr(0, text.find("[[gate]]"));
  EXPECT_TRUE(std::holds_alternative<Still>(read_text(text).motion));
  const std::string earth = "start = \"earth\"";
  text.replace(text.find(earth), earth.size(), "start = \"tank\"");
  EXPECT_TRUE(std::holds_alternative<Still>(read_text(text).motion));
}

TEST(CaseParser, KnowsNoForcedModeOfATankThatStands) {
  const std::string message =
      complaint_about({"type = \"sine_surge\"\namplitude_m = 0.02\nangular_frequency_rad_s = 1.5\n",
                       "type = \"still\"\n"});
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
            "b.toml:1: gauge is missing: expected at least one [[gauge]]");
}

const Edit by_table{"type = \"sine_surge\"\namplitude_m = 0.02\nangular_frequency_rad_s = 1.5\n",
                    "type = \"table_surge\"\nfile = \"motion.csv\"\n"};

std::string complaint_about_table(const std::string& csv) {
  const Workspace workspace;
  workspace.write("motion.csv", csv);
  std::string text = edited(by_table);
  return complaint(workspace.write("trial.toml", text.substr(0, text.find("[[gate]]"))));
}

TEST(CaseParser, ReadsAMotionTableBesideTheCase) {
  const Workspace workspace;
  workspace.write("motion.csv", "time_s,displacement_m\r\n0,0\r\n1, 0.1\r\n2.5,-2e-1\r\n20,0\r\n");
  const std::string text = edited(by_table);
  const auto definition =
      read_case(workspace.write("trial.toml", text.substr(0, text.find("[[gate]]"))));
  const auto& table = std::get<TableSurge>(definition.motion);
  EXPECT_EQ(table.time, (std::vector<double>{0, 1, 2.5, 20}));
  EXPECT_EQ(table.displacement, (std::vector<double>{0, 0.1, -0.2, 0}));
}

TEST(CaseParser, KnowsNoForcedModeOfAMotionTable) {
  const Workspace workspace;
  workspace.write("motion.csv", "time_s,displacement_m\n0,0\n1,0\n2,0\n20,0\n");
  const std::string message = complaint(workspace.write("trial.toml", edited(by_table)));
  EXPECT_TRUE(message.starts_with("trial.toml:55: gate.mode = \"forced\": expected")) << message;
}

TEST(CaseParser, RefusesABadMotionTableByItsOwnLine) {
  const std::string head = "time_s,displacement_m\n";
  const std::vector<std::pair<std::string, std::string>> tables{
      {"", "motion.csv:1: header = : expected time_s,displacement_m"},
      {"t,x\n0,0\n", "motion.csv:1: header = t,x: expected time_s,displacement_m"},
      {head + "0,0\n1,0\n20,0\n", "motion.csv:4: rows = 3: expected at least 4"},
      {head + "0,0\n1,0\n2,0\n19.9,0\n",
       "motion.csv:5: time_s = 19.9: expected a last time of at least the case's duration (20), in "
       "s"},
      {head + "0.1,0\n1,0\n2,0\n20,0\n",
       "motion.csv:2: time_s = 0.1: expected 0 in the first row, in s"},
      {head + "0,0\n2,0\n1,0\n20,0\n",
       "motion.csv:4: time_s = 1: expected a number above the last row's 2, in s"},
      {head + "0,0\n1,0\n1,0\n20,0\n", "motion.csv:4: time_s = 1: expected"},
      {head + "0,0\n1,nan\n2,0\n20,0\n",
       "motion.csv:3: displacement_m = nan: expected a number, in m"},
      {head + "0,0\n1,0,5\n2,0\n20,0\n",
       "motion.csv:3: displacement_m = 0,5: expected a number, in m"},
      {head + "0,0\none,0\n2,0\n20,0\n", "motion.csv:3: time_s = one: expected a number, in s"},
      {head + "0,0\n1 0\n2,0\n20,0\n", "motion.csv:3: row = 1 0: expected two numbers"}};
  for (const auto& [csv, wanted] : tables) {
    const std::string message = complaint_about_table(csv);
    EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
  }
}

TEST(CaseParser, RefusesAMotionTableThatIsNotThere) {
  const std::string message = complaint_about(by_table);
  EXPECT_TRUE(message.starts_with(
      "trial.toml:19: motion.file = \"motion.csv\": expected a CSV file's path"))
      << message;
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

}  // namespace
}  // namespace slosh
