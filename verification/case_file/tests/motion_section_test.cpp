// [motion] of a case file: a surge, a roll or both, as a sine or a table, and every mistake.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "reports/wording/case_text.hpp"
#include "verification/case/motion.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::motion_section_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

const std::string axis = "axis_x_m = 1.0\naxis_z_m = -0.5\n";
const std::string sine_roll =
    "[motion.roll]\ntype = \"sine\"\namplitude_deg = 4\nangular_frequency_rad_s = 1.5\n" + axis;
const std::string table_roll = "[motion.roll]\ntype = \"table\"\nfile = \"roll.csv\"\n" + axis;
const std::string table_surge = "[motion.surge]\ntype = \"table\"\nfile = \"surge.csv\"\n";

// The motion replaces the sine surge on lines 17 to 20. There is no gate row, since a table has no
// forced mode.
std::string moved_by(const std::string& motion) {
  const std::string text = edited({sine_surge, motion});
  return text.substr(0, text.find("[[gate]]"));
}

CaseDefinition with_table(const std::string& motion, const std::string& name,
                          const std::string& csv) {
  return read_trial({moved_by(motion), {{name, csv}}});
}

TEST(MotionSection, ReadsASurgeAndARollAboutAnyPointTogether) {
  const CaseDefinition definition =
      read_text(moved_by(sine_surge + "phase_deg = -90\n" + sine_roll + "ramp_periods = 2\n"));
  const auto& surge = std::get<SineMotion>(definition.motion.surge.value());
  EXPECT_EQ(surge.amplitude, 0.02);
  EXPECT_DOUBLE_EQ(surge.phase, -90 * degree);
  const RollDefinition& roll = definition.motion.roll.value();
  EXPECT_DOUBLE_EQ(std::get<SineMotion>(roll.angle).amplitude, 4 * degree);
  EXPECT_EQ(std::get<SineMotion>(roll.angle).angular_frequency, 1.5);
  EXPECT_EQ(std::get<SineMotion>(roll.angle).ramp_periods, 2);
  EXPECT_EQ(roll.axis_x, 1);
  EXPECT_EQ(roll.axis_z, -0.5);
  EXPECT_EQ(forcing_frequency(definition), 1.5);
  EXPECT_FALSE(read_text(moved_by(sine_roll)).motion.surge);
}

const std::string uncertain_start =
    "[[input]]\nname = \"start_phase\"\nhalf_width = 2\nunit = \"deg\"\nsource = \"a trigger\"\n";

TEST(MotionSection, OfSinesMayStartAtAnUncertainPhase) {
  const CaseDefinition definition = read_text(moved_by(sine_surge) + uncertain_start);
  EXPECT_EQ(definition.inputs.at(0).input, Input::start_phase);
  EXPECT_EQ(definition.inputs.at(0).half_width, 2);
  expect_refusals({moved_by(table_roll) + uncertain_start,
                   {{"roll.csv", "time_s,angle_deg\n0,0\n10,1\n20,0\n30,1\n40,0\n"}}},
                  R"(-> input.name = "start_phase": expected an input that this case has, one of
  fill_depth)");
}

const std::string two_sines =
    "[motion.surge]\ntype = \"sines\"\nsines = [{ amplitude_m = 0.02, period_s = 4 },\n"
    "  { amplitude_m = 0.005, frequency_Hz = 0.75, phase_deg = 90, ramp_periods = 2 }]\n";

TEST(MotionSection, ReadsSinesAsAListOrAsTables) {
  const std::string as_tables =
      "[motion.surge]\ntype = \"sines\"\n[[motion.surge.sines]]\namplitude_m = 0.02\n"
      "period_s = 4\n[[motion.surge.sines]]\namplitude_m = 0.005\nfrequency_Hz = 0.75\n"
      "phase_deg = 90\nramp_periods = 2\n";
  for (const std::string& text : {two_sines, as_tables}) {
    const CaseDefinition definition = read_text(moved_by(text));
    const auto& sines = std::get<SumOfSines>(definition.motion.surge.value()).sines;
    ASSERT_EQ(sines.size(), 2u);
    EXPECT_EQ(sines[0].amplitude, 0.02);
    EXPECT_DOUBLE_EQ(sines[0].angular_frequency, std::numbers::pi / 2);
    EXPECT_EQ(sines[0].phase, 0);
    EXPECT_EQ(sines[1].amplitude, 0.005);
    EXPECT_DOUBLE_EQ(sines[1].angular_frequency, 1.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(sines[1].phase, std::numbers::pi / 2);
    EXPECT_EQ(sines[1].ramp_periods, 2);
    EXPECT_EQ(forced_modes(definition).size(), 2u);
  }
  const std::string of_roll =
      "sines = [{ amplitude_deg = 4, period_s = 2 }, { amplitude_deg = 1, period_s = 0.7 }]\n";
  const CaseDefinition rolls =
      read_text(moved_by("[motion.roll]\ntype = \"sines\"\n" + axis + of_roll));
  EXPECT_DOUBLE_EQ(std::get<SumOfSines>(rolls.motion.roll.value().angle).sines.at(1).amplitude,
                   degree);
}

TEST(MotionSection, RefusesSinesThatMakeNoSense) {
  expect_refusals(moved_by(two_sines), R"(
motion.surge.phase_deg = 3: expected only these keys here: type, sines
)");
  expect_refusals(moved_by("[motion.surge]\ntype = \"sines\"\n"), R"(
-> motion.surge.sines is missing: expected two sines or more; a single one is type = "sine"
motion.surge.sines = [{ amplitude_m = 0.02, period_s = 4 }] -> motion.surge.sines = (an array of
  tables): expected two sines or more
motion.surge.sines = [0.02, 4] -> motion.surge.sines = (an array): expected an array of tables
)");
  const auto of = [](const char* first, const std::string& said) {
    const std::string sines =
        fmt::format("sines = [{{ {} }}, {{ amplitude_m = 1, period_s = 1 }}]\n", first);
    const Workspace workspace;
    const std::string message = complaint(
        workspace.write("trial.toml", moved_by("[motion.surge]\ntype = \"sines\"\n" + sines)));
    EXPECT_TRUE(begins(message, "trial.toml:19: motion.surge.sines." + said));
  };
  of("amplitude_m = 0, period_s = 1", "amplitude_m = 0: expected a number > 0, in m");
  of("amplitude_m = 0.02", "angular_frequency_rad_s is missing");
  of("amplitude_deg = 2, period_s = 4",
     "amplitude_deg = 2: expected only these keys here: amplitude_m, phase_deg, ramp_periods, "
     "angular_frequency_rad_s, frequency_Hz, period_s");
}

// Solvers start from a surface that is parallel to the bottom.
TEST(MotionSection, RefusesARollThatStartsTilted) {
  expect_refusals(moved_by(sine_roll), R"(
motion.roll.phase_deg = 30: expected an angle of 0 to within 0.001 at the start, in deg, where this
  is 2: the tank starts level; ramp_periods > 0 lets any phase begin level
motion.roll.phase_deg = 30 & motion.roll.ramp_periods = 1: accepted
motion.roll.phase_deg = 180: accepted
)");
  const std::string sines =
      "[motion.roll]\ntype = \"sines\"\n" + axis +
      "sines = [{ amplitude_deg = 4, period_s = 2, phase_deg = 90 }, { amplitude_deg = ";
  const auto said = [&](const char* second) {
    const Workspace workspace;
    return complaint(workspace.write("trial.toml", moved_by(sines + second + " }]\n")));
  };
  EXPECT_TRUE(holds(said("1, period_s = 1"), "where this is 4"));
  EXPECT_EQ(said("4, period_s = 1, phase_deg = -90"), "");
}

TEST(MotionSection, WantsTheForcedModeOfSeveralToBeNamed) {
  const std::string text = edited({sine_surge, two_sines});
  expect_refusals(text, R"(
-> gate.mode = "forced": expected what amplitude_error is measured on, one of forced_1, forced_2,
  natural_1, natural_3
gate.mode is missing: expected what amplitude_error is measured on, one of forced_1, forced_2
)");
  EXPECT_EQ(read_text(with_keys(text, "gate.mode = \"forced_2\"")).gate.at(0).mode, "forced_2");
}

TEST(MotionSection, ReadsASurgeTableBesideTheCase) {
  const CaseDefinition definition = with_table(
      table_surge, "surge.csv", "time_s,displacement_m\r\n0,0\r\n1, 0.1\r\n2.5,-2e-1\r\n20,0\r\n");
  const auto& table = std::get<TableMotion>(definition.motion.surge.value());
  EXPECT_EQ(table.time, (std::vector<double>{0, 1, 2.5, 20}));
  EXPECT_EQ(table.value, (std::vector<double>{0, 0.1, -0.2, 0}));
}

TEST(MotionSection, ReadsARollTableInDegrees) {
  const CaseDefinition definition =
      with_table(table_roll, "roll.csv", "time_s,angle_deg\n0,0.0009\n1,90\n2.5,-360\n20,0\n");
  const auto& table = std::get<TableMotion>(definition.motion.roll.value().angle);
  EXPECT_EQ(table.time, (std::vector<double>{0, 1, 2.5, 20}));
  EXPECT_DOUBLE_EQ(table.value[0], 0.0009 * degree);
  EXPECT_DOUBLE_EQ(table.value[1], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(table.value[2], -2 * std::numbers::pi);
  EXPECT_EQ(forcing_frequency(definition), 0);
}

TEST(MotionSection, RefusesAMotionThatMakesNoSense) {
  expect_refusals(moved_by("[motion]\n"), R"(
-> motion = {}: expected still = true, [motion.surge], [motion.roll] or both
motion.still = false: expected true, or [motion.surge] or [motion.roll]
motion.stil = true: expected only these keys here: still, surge, roll; nearest known key: still
)");
  expect_refusals(moved_by("[motion]\nstill = true\n" + sine_roll),
                  "-> motion.still = true: expected no such key beside [motion.surge] or");
}

TEST(MotionSection, RefusesARollOrASurgeThatMakesNoSense) {
  expect_refusals(moved_by(sine_roll), R"(
motion.roll.amplitude_deg = 0: expected a number > 0 and <= 360, in deg
motion.roll.axis_x_m is missing: expected a number from -2000 to 2000 (1000 tank lengths), in m from
  the left wall
motion.roll.axis_z_m = inf: expected a number from -2000 to 2000 (1000 tank lengths), in m from the
  bottom
)");
  expect_refusals(moved_by(table_roll), R"(
motion.roll.ramp_periods = 1: expected only these keys here: type, file
-> motion.roll.file = "roll.csv": expected a file relative
)");
  expect_refusals(moved_by(table_surge), R"(
motion.surge.phase_deg = 1: expected only these keys here: type, file
-> motion.surge.file = "surge.csv": expected a file relative
)");
}

TEST(MotionSection, RefusesABadTableByItsOwnLine) {
  expect_refusals_of("surge.csv", moved_by(table_surge), R"(
-> 1: head = (nothing): expected a line with the columns' names above the numbers
t,x | 0,0 -> 1: header = t,x: expected time_s and one of displacement_m,
time_s,displacement_m | 0,0 | 1,0 | 20,0 -> 4: rows = 3: expected at least 4
time_s,displacement_m | 0,0 | 1,0 | 2,0 | 19.9,0 -> 5: time_s = 19.9: expected a last time of at
  least the case's duration (20), in s
time_s,displacement_m | 0.1,0 | 1,0 | 2,0 | 20,0 -> 2: time_s = 0.1: expected 0 or less in the first
  row, in s
time_s,displacement_m | 0,0 | 2,0 | 1,0 | 20,0 -> 4: time_s = 1: expected a number above the last
  row's 2, in s
time_s,displacement_m | 0,0 | 1,nan | 2,0 | 20,0 -> 3: displacement_m = nan: expected a number, in m
time_s,acceleration_m_s2 | 0,0 | 2,0 | 2.001,-4 | 5,-4 | 21,0 -> 4: time_s = 2.001: expected a time
  0.002 s or more after the row before, as the row after is more than 0.02 s away, in s
time_s,displacement_m | 0,0 | 1,0,5 | 2,0 | 20,0 -> 3: row = 1,0,5: expected 2 values
time_s,displacement_m | 0,0 | one,0 | 2,0 | 20,0 -> 3: time_s = one: expected a number, in s
time_s,displacement_m | 0,0 | 1 0 | 2,0 | 20,0 -> 3: row = 1 0: expected 2 values
)");
  expect_refusals_of("roll.csv", moved_by(table_roll), R"(
time_s,displacement_m | 0,0 -> 1: header = time_s,displacement_m: expected time_s and one of
  angle_deg, acceleration_deg_s2
time_s,angle_deg | 0,-0.0011 | 1,0 | 2,0 | 20,0 -> 2: angle_deg = -0.0011: expected an angle of 0 to
  within 0.001 at the start, in deg: the tank starts level
time_s,angle_deg | 0,0 | 1,0 | 2,-360.5 | 20,0 -> 4: angle_deg = -360.5: expected angles from -360 to
  360, in deg
)");
}

TEST(MotionSection, IntegratesATableOfAccelerationsFromRestAtTheStart) {
  // Positions t^2 + t^3 / 6, in m and in deg, of rows that begin before the start.
  std::string rows;
  for (int i = -20; i <= 500; ++i) rows += fmt::format("{},{}\n", 0.05 * i, 2 + 0.05 * i);
  const auto check = [](const TableMotion& table, double unit) {
    EXPECT_EQ(table.time.front(), 0);
    for (std::size_t i = 0; i < table.time.size(); ++i) {
      const double t = table.time[i];
      EXPECT_NEAR(table.value[i], unit * (t * t + t * t * t / 6), 1e-9 * (1 + t * t * t)) << t;
    }
  };
  check(
      std::get<TableMotion>(
          *with_table(table_surge, "surge.csv", "time_s,acceleration_m_s2\n" + rows).motion.surge),
      1);
  std::string few;
  for (int i = 0; i <= 500; ++i) few += fmt::format("{},{}\n", 0.05 * i, 0.02 * (2 + 0.05 * i));
  check(
      std::get<TableMotion>(with_table(table_roll, "roll.csv", "time_s,acceleration_deg_s2\n" + few)
                                .motion.roll->angle),
      0.02 * degree);
  const Workspace workspace;
  workspace.write("roll.csv", "time_s,acceleration_deg_s2\n" + rows);
  EXPECT_TRUE(holds(complaint(workspace.write("trial.toml", moved_by(table_roll))),
                    "expected angles from -360 to 360, in deg"));
}

// A brake that is put on within 0.2 s and taken off as fast.
TEST(MotionSection, GoesStraightBetweenAccelerationsOrTellsHowFarASplineGoesBeyondThem) {
  const std::string brake = "0,0\n2,0\n2.2,-4\n5,-4\n5.2,0\n21,0\n";
  const auto of = [&](const std::string& keys, const std::string& column) {
    return with_table(table_surge + keys, "surge.csv", "time_s," + column + "\n" + brake);
  };
  const CaseDefinition straight = of("segments = \"straight\"\n", "acceleration_m_s2");
  const SurgeMotion surge = surge_motion(straight);
  for (const auto& [t, a] : {std::pair{1.0, 0.0},
                             {2.0, 0.0},
                             {2.1, -2.0},
                             {2.2, -4.0},
                             {3.3, -4.0},
                             {5.15, -1.0},
                             {12.0, 0.0}})
    EXPECT_NEAR(surge.acceleration(t), a, 1e-9) << t;
  EXPECT_NEAR(surge.velocity(20), -4 * 3.0, 1e-9);
  EXPECT_EQ(motion_peaks(straight), "; at most 197 m, 12 m/s and 4 m/s2");
  const std::string beyond = motion_peaks(of("", "acceleration_m_s2"));
  EXPECT_TRUE(holds(beyond, "beyond its largest acceleration, 4 m/s2")) << beyond;
  EXPECT_TRUE(holds(motion_peaks(of("", "displacement_m")), "beyond its largest position, 4 m"));
  expect_refusals({moved_by(table_surge + "segments = \"straight\"\n"),
                   {{"surge.csv", "time_s,displacement_m\n" + brake}}},
                  R"(
-> motion.surge.segments = "straight": expected "spline" for a table of positions, whose corners
  would be blows
)");
}

TEST(MotionSection, AddsTheTimeOffsetToTheTimesOfATable) {
  const std::string rows = "10,9\n12.5,0\n13,1\n14,2\n33,5\n";
  const CaseDefinition definition = with_table(table_surge + "time_offset_s = -12.5\n", "surge.csv",
                                               "time_s,displacement_m\n" + rows);
  const auto& table = std::get<TableMotion>(*definition.motion.surge);
  EXPECT_EQ(table.time, (std::vector<double>{0, 0.5, 1.5, 20.5}));
  EXPECT_EQ(table.value, (std::vector<double>{0, 1, 2, 5}));
  EXPECT_EQ(
      with_table(table_roll + "time_offset_s = -12.5\n", "roll.csv", "time_s,angle_deg\n" + rows)
          .motion.roll->angle.index(),
      definition.motion.surge->index());
  const auto offset = [](const std::string& seconds) {
    return moved_by(table_surge + "time_offset_s = " + seconds + "\n");
  };
  expect_refusals_of("surge.csv", offset("-9.5"), R"(
time_s,displacement_m | 10,9 | 12.5,0 | 13,1 | 14,2 | 33,5 -> 2: time_s = 10: expected 0 or less in
  the first row, in s, with time_offset_s = -9.5 added
)");
  expect_refusals_of("surge.csv", offset("-13.5"), R"(
time_s,displacement_m | 10,9 | 12.5,0 | 13,1 | 14,2 | 33,5 -> 6: time_s = 33: expected a last time of
  at least the case's duration (20), in s, with time_offset_s = -13.5 added
)");
  expect_refusals_of("surge.csv", offset("-12.9"), R"(
time_s,displacement_m | 0,0 | 11,0 | 12,0 | 13,1 | 33,2 -> 4: time_s = 12: expected three rows after
  0 or more
)");
  // 32.05 - 12.05 is less than 20, the case's duration, by rounding.
  expect_refusals({offset("-12.05"),
                   {{"surge.csv", "time_s,displacement_m\n0,0\n12,1\n13,0\n14,1\n32.05,2\n"}}},
                  "motion.surge.time_offset_s = -12.05: accepted");
}

TEST(MotionSection, KnowsNoForcedModeOfATableUnlessItsFrequencyIsDeclared) {
  const Trial trial(edited({sine_surge, table_roll}),
                    {{"roll.csv", "time_s,angle_deg\n0,0\n1,1\n2,0\n20,0\n"}});
  expect_refusals(trial, R"(
-> gate.mode = "forced": expected
comparison.forcing_angular_frequency_rad_s = 3.84: accepted
)");
  const CaseDefinition definition = read_trial(
      {with_keys(trial.text, "comparison.forcing_angular_frequency_rad_s = 3.84"), trial.files});
  EXPECT_EQ(forcing_frequency(definition), 3.84);
  EXPECT_EQ(definition.gate.at(0).mode, "forced");
}

}  // namespace
}  // namespace slosh::motion_section_test
