// Every kind of mistake in a case file, made by changing keys of a valid text: where, key, value,
// what was expected and the nearest known name.
#include <gtest/gtest.h>

#include "verification/case_file/tests/refusals.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::case_parser_refusal_test {
namespace {

// Tables that rows add to the valid text.
const std::map<std::string, std::string> more{
    {"baffle",
     "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.9\nright_m = 1.1\nbottom_m = 0.0\ntop_m = 0.2\n"},
    {"step",
     "[[obstacle]]\nname = \"step\"\nleft_m = 0.0\nright_m = 0.5\nbottom_m = 0.0\ntop_m = 0.1\n"},
    {"row", valid_text.substr(valid_text.find("[[gate]]"))},
    {"block",
     "[[obstacle]]\nname = \"block\"\nleft_m = 0.9\nright_m = 1.1\nbottom_m = 0\ntop_m = 0.3\n"},
    {"sensor", "[[pressure_gauge]]\nname = \"b\"\nwall = \"left\"\nposition_m = 0.1\n"},
    {"probe", "[[probe]]\nname = \"a\"\nx_m = 1\nz_m = 0.2\n"},
    {"uncertain_depth",
     "[[input]]\nname = \"fill_depth\"\nhalf_width = 0.0005\nunit = \"m\"\nsource = \"a "
     "ruler\"\n"}};

TEST(CaseParserRefusal, SaysWhatEachKeyMayBe) {
  expect_refusals({valid_text, {}, more}, R"(
tank.lenght_m = 2: expected only these keys here: length_m, height_m, outline_m, diameter_m,
  breadth_m; nearest known key: length_m
gates = 3: expected only these keys here: schema_version,
run(mesh).modes = 3: expected only these keys here: name, solver, quick, cells_x, cells_z, processes,
  courant_number, interface_courant_number, outer_corrections, no_slip, wall_cell_m, cells_y,
  start_disorder, start_seed, repeats, quick_repeats, vary_inputs; nearest known key:
motion.surge.amplitude_deg = 0.02: expected only these keys here: type, amplitude_m,
  angular_frequency_rad_s, frequency_Hz, period_s, phase_deg, ramp_periods, sines, file,
  time_offset_s, segments; nearest known key: amplitude_m
motion.surge.type is missing: expected a motion, one of sine, sines, table
gas.air = {} -> gas.air = (a table): expected only these keys
schema_version = 2: expected 1
name = "a/b": expected a name of letters, digits, _ and -
gravity_m_s2 = nan: expected a number >= 0, in m/s2
gravity_m_s2 = -9.81: expected a number >= 0, in m/s2
gravity_m_s2 = 0 -> comparison.natural_modes = 2: expected 0 without gravity
tank.length_m = -2: expected a number > 0, in m
tank.breadth_m = 0.06 -> run(theory).solver = "linear": expected a solver that counts the friction of
  the gap walls, one of sph, interfoam and interisofoam, and with cells_y
  compressible_interfoam, where [tank] has breadth_m
liquid.fill_depth_m = 1.5: expected a number > 0 and below the tank's height (1), in m
liquid.column_width_m = 2.0: expected a number > 0 and below the tank's length (2), in m
liquid.column_width_m = 0.5 -> comparison.natural_modes = 2: expected 0 for a dam about to break
gas.density_kg_m3 = 1000: expected a number > 0 and below the liquid's density (1000), in kg/m3
motion.surge.type = "sin": expected a motion, one of sine, sines, table; nearest: sine
motion.surge.amplitude_m = 0: expected a number > 0, in m
motion.surge.ramp_periods = -1: expected a number >= 0, in periods
time.start = "Earth": expected the frame in which the liquid is first at rest (earth: the liquid
  stands still and a tank that moves off at once strikes it; tank: the liquid moves off with the
  tank), one of earth, tank; nearest: earth
time.start = "at_rest_in_tank": expected the frame ... one of earth, tank; nearest: tank
time.sample_interval_s = 21: expected a number > 0 and <= the duration (20), in s
time.sample_interval_s = 1e-09: expected a number > 0 and <= the duration (20), in s, and >= 1e-05,
  for at most two million samples
gauge(right).x_m = 2.05: expected a number from 0 to the tank's length (2), in m from the left wall
gauge(left).name = "right" -> gauge.name = "right": expected a name that no other gauge has
comparison.window_end_s is missing & comparison.window_begin_s = 20.0: expected a number below the
  duration (20), in s
comparison.window_end_s = 20.5: expected a number above window_begin_s (1) and <= duration_s (20), in s
comparison.natural_modes = -1: expected an integer from 0 to 100
run(mesh).name = "coarse" -> run.name = "coarse": expected a name that no other run has
run(mesh).solver = "interFoam": expected a solver, one of sph, interfoam, interisofoam,
  compressible_interfoam, linear, viscous_wave, potential, record, external, stored, pysph; nearest:
  interfoam
run(theory).modes = 0: expected an integer from 1 to 100000
run(theory).modes = 2000000000: expected an integer from 1 to 100000
run(theory).valid_elevation_over_depth = 1e+308: expected a number > 0 and < 1, in fill depths: a
  trough of one bares the bottom
run(coarse).particle_spacing_m = -0.02: expected a number > 0 and <= the fill depth (0.5), in m
run(coarse).particle_spacing_m = 1e-07: expected a number > 0 and <= the fill depth (0.5), in m, and
  >= 0.0001, the spacing of a hundred million particles
run(coarse).surface_particle_spacing_m = 0.03: expected a number > 0 and <= particle_spacing_m
  (0.02), in m
run(coarse).expected_speed = "fine_run": expected where the expected largest speed comes from, one
  of estimate, coarse_run
run(coarse).smoothing_length_ratio = 0: expected a number from 0.5 to 10, without unit
run(mesh).courant_number = 1.5: expected a number > 0 and <= 1
run(mesh).wall_cell_m = 0.1: expected a number > 0 and <=
run(mesh).cells_x = 5000000000: expected an integer from 2 to 10000
run(mesh).processes = 51: expected an integer from 1 to cells_x (50)
gate.candidate = "course": expected a run, one of theory, coarse, mesh; nearest: coarse
gate.reference = "coarse": expected a run other than the candidate, one of theory, mesh
gate.reference is missing: expected a run other than the candidate
gate.quantity = "elevation@rigth": expected a compared quantity, one of elevation@right,
  elevation@left, force_x, force_z, momentum_x, momentum_z, highest_surface@right,
  highest_surface@left; nearest: elevation@right
gate.quantity = "front_position": expected a compared quantity, one of elevation@right, elevation@left
gate.mode = "natural_2": expected what amplitude_error is measured on, one of forced, natural_1,
  natural_3; nearest: natural_
gate.mode = "whole": expected what amplitude_error is measured on
gate.metric = "normalised_rms" -> gate.mode = "forced": expected what normalised_rms is measured on,
  which is whole
gate.metric = "frequency_error" -> gate.mode = "forced": expected what frequency_error is measured
  on, one of natural_1, natural_3
gate.metric = "amplitude_eror": expected a metric, one of amplitude_error, phase_lag,
  frequency_error, decay_rate, decay_error, normalised_rms, aligned_rms, largest_magnitude,
  cross_correlation_lag, spectral_peak_error, rms_error, mean_offset, noise_share, initial_value,
  frequency, plateau_error, impact_arrival, impact_peak_error, impulse_error, peak_mean_p_value,
  peak_ks_p_value, peak_ad_p_value, peak_median_error, outside_band, pressure_field_rms,
  pressure_field_tension, cost_to_reach; nearest: amplitude_error
gate.metric = "aligned_rms" -> gate.mode = "forced": expected what aligned_rms is measured on, of
  which there is none
gate.metric = "cost_to_reach" & gate.unit = "s" & gate.error = 0.1 -> gate.mode = "forced": expected
  what cost_to_reach is measured on
gate.metric = "largest_magnitude" -> gate.reference = "theory": expected no reference:
  largest_magnitude is measured on the candidate alone
gate.reference is missing & gate.quantity = "wall_gap" & gate.metric = "largest_magnitude" ->
  gate.mode = "forced": expected what largest_magnitude is measured on, which is whole
gate.error = 0.1: expected no error: only cost_to_reach is of one
gate.unit = "%": expected the unit of amplitude_error, which is 1
gate.metric = "rms_error" -> gate.mode = "forced": expected what rms_error is measured on
gate.mode = "whole" & gate.metric = "mean_offset" -> gate.unit = "1": expected the unit of mean_offset
gate.mode = "whole" & gate.metric = "noise_share" -> gate.reference = "theory": expected no reference
gate.limit = -0.05: expected a number > 0 and below 1, without unit (a candidate that does not move
  has -1)
gate.limit = 1: expected a number > 0 and below 1, without unit (a candidate that does not move has -1)
gate.metric = "phase_lag" & gate.unit = "deg" & gate.limit = 180: expected a number > 0 and below
  180, in deg (a lag is known but for whole periods
gate.mode = "whole" & gate.metric = "mean_offset" & gate.unit = "m" & gate.limit = 1000000000.0:
  expected a number > 0 and below 2, in m (no elevation exceeds the tank's size
gate.limit is missing -> gate = {}: expected exactly one of limit | lower with upper | improves_on
gate.upper = 1 -> gate = {limit, upper}: expected exactly one of
gate.limit is missing & gate.lower = 1 -> gate = {lower}: expected exactly one of
gate.kind = "validation": accepted
gate.kind = "measured": expected what the limit comes from, one of validation, regression; nearest:
  regression
run(coarse).start_disorder = 0.21: expected a number from 0 to 0.2, in particle spacings
run(coarse).start_disorder = 0.1 & run(coarse).start_seed = -1: expected an integer >= 0
run(coarse).start_seed = 1: expected no such key without start_disorder > 0
run(coarse).start_disorder = 0 & run(coarse).start_seed = 1: expected no such key without
  start_disorder > 0
run(coarse).initial_state = "settled" & run(coarse).start_rotation_deg = 20: expected no such key
  beside surface_particle_spacing_m
run(mesh).start_disorder = 1e-3 & run(mesh).repeats = 2: accepted
run(coarse).repeats = 4: expected no such key without start_disorder > 0 or vary_inputs: there is
  nothing to vary (1e-6 particle spacings is enough in a chaotic flow)
run(coarse).start_disorder = 0 & run(coarse).repeats = 4: expected no such key without
  start_disorder > 0 or vary_inputs
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 1: expected an integer from 2 to 1000
run(coarse).start_disorder = 1e-6 & run(coarse).repeats = 1001: expected an integer from 2 to 1000
run(mesh).repeats = 3 & run(mesh).vary_inputs = true: expected no such key without an [[input]]:
  there is nothing to draw
gate.quantity = "force_x" & gate.metric = "phase_lag" & gate.unit = "deg": accepted
gate.quantity = "force_x" & gate.mode = "whole" & gate.metric = "mean_offset" & gate.unit = "N/m":
  accepted
gate.quantity = "momentum_z" & gate.mode = "whole" & gate.metric = "aligned_rms": accepted
gate.mode = "whole" & gate.metric = "mean_offset" & gate.unit = "m": accepted
gate.quantity = "force_x" & gate.mode = "whole" & gate.metric = "mean_offset" & gate.unit = "m":
  expected the unit of mean_offset, which is N/m
gate.quantity = "force_z" -> gate.mode = "forced": expected what amplitude_error is measured on, of
  which there is none
gate.quantity = "moment": expected a compared quantity, one of
time.snapshot_times_s = 3: expected an array of numbers, each a
time.snapshot_times_s = [1, 0] -> time.snapshot_times_s = 0: expected a number > 0 and <= the
  duration (20), a multiple of sample_interval_s (0.01), in s
time.snapshot_times_s = [3.455] -> time.snapshot_times_s = 3.455: expected a number > 0 and <= the
time.snapshot_times_s = ["1"] -> time.snapshot_times_s = "1": expected a number > 0 and <= the
time.snapshot_times_s = [2, 1] -> time.snapshot_times_s = 1: expected a number above the one before it
liquid.density_kg_m3 is missing: expected a number > 0, in kg/m3
liquid.kinematic_viscosity_m2_s is missing: expected
motion.surge.period_s = 4: expected exactly one of angular_frequency_rad_s | frequency_Hz | period_s
motion.surge.angular_frequency_rad_s is missing & motion.surge.period_s = 0: expected a number > 0, in
  s
motion.surge.angular_frequency_rad_s is missing: expected
comparison.forcing_period_s = 4: expected no such key without a motion table
comparison.forcing = "from_spectrum": expected no such key without a motion table: a sine has its own
  frequency
motion.surge.phase_deg = 361: expected a number from -360 to 360, in deg
comparison.forcing_angular_frequency_rad_s = 1.5: expected no such key without a motion table: a
  sine has its own frequency
+ baffle
obstacle.right_m = 0.9: expected a number above left_m (0.9) and <= the tank's length (2), in m
obstacle.bottom_m = 0.1 & obstacle.top_m = 1.2: expected a number above bottom_m (0.1) and <= the
  tank's height (1), in m
obstacle.left_m = 0 & obstacle.right_m = 2: expected a number below the tank's length (2), in m, for
  an obstacle from the left wall
obstacle.left_m = 1.9 & obstacle.right_m = 2.0 & obstacle.top_m = 0.5: expected a number below the
  fill depth (0.5), in m, or another place: the obstacle swallows the gauge right at 1.95 m
+ baffle + baffle
obstacle.name = "b" & obstacle.left_m = 1.0: expected a rectangle that does not overlap that of the
  obstacle baffle
obstacle.left_m = 1.1 & obstacle.right_m = 1.2 -> obstacle.name = "baffle": expected a name that no
  other obstacle has
+ step
run(mesh).wall_cell_m = 0.01: expected no such key in a tank with an obstacle
liquid.kinematic_viscosity_m2_s = 0.0 & run(mesh).no_slip = true: expected no such key for a liquid
  without viscosity
+ uncertain_depth
input.name = "depth": expected an input that this case has, one of fill_depth, period
input.unit = "mm": expected the unit of fill_depth, which is m; nearest: m
input.half_width = 0: expected a number > 0
input.sources = "a ruler": expected only these keys
input.coarse_run = "nothing": expected an SPH or OpenFOAM run of this case
run(mesh).vary_inputs = true: expected no such key without repeats
+ uncertain_depth + uncertain_depth
-> input.name = "fill_depth": expected each input once
+ probe
probe.x_m = 2.1: expected a number from 0 to the tank's length (2), in m from the left wall
probe.z_m = -0.2: expected a number from 0 to the tank's height (1), in m from the bottom
wall_forces = ["front"] -> wall_forces = (an array): expected a list of walls (left, right, bottom,
  roof), each once
wall_forces = ["left", "left"] -> wall_forces = (an array): expected a list of walls
+ probe + probe
-> probe.name = "a": expected a name that no other probe
+ gate.limit is missing
gate.lower = -0.3 & gate.upper = 1e+300: expected a number above lower (-0.3) and below 1.7, without
  unit (a candidate that does not move has -1)
gate.lower = -1.9 & gate.upper = 0.05: expected a number above lower (-1.9) and below -1, without
  unit, so that the range does not hold -1 (a candidate that does not move has -1)
gate.metric = "phase_lag" & gate.unit = "deg" & gate.lower = -179 & gate.upper = 180.9: expected a
  number above lower (-179) and below 180, in deg, so that the range does not hold 180
gate.metric = "phase_lag" & gate.unit = "deg" & gate.lower = -190 & gate.upper = 5: expected a number
  above lower (-190) and below -180
gate.mode = "whole" & gate.metric = "mean_offset" & gate.unit = "m" & gate.lower = -9 & gate.upper =
  0.1: expected a number above lower (-9) and below -5, in m
gate.lower = 1 & gate.upper = 0.5: expected a number above lower (1) and below 3, without unit
gate.improves_on = "coarse": expected a run other than the candidate and the reference, which is
  mesh; nearest: mesh
+ row
gate.limit is missing & gate.lower = 0.5 & gate.upper = 0.6 -> gate = a second bound on
  amplitude_error of coarse: expected one row for each candidate, reference, quantity, mode and
  metric; the first is at
+ gate.mode = "whole" & gate.metric = "cost_to_reach" & gate.unit = "s" & gate.limit = 20
-> gate.error is missing: expected a number > 0 and < 1, without unit: a normalised rms
gate.error = 10: expected a number > 0 and < 1, without unit: a normalised rms
gate.error = 0.1 & gate.limit is missing & gate.lower = 1 & gate.upper = 2 -> gate = a row on
  cost_to_reach: expected limit: cheaper is better
gate.error = 0.1 & gate.unit = "h": expected the unit of cost_to_reach, which is s
+ run(coarse).surface_particle_spacing_m is missing & run(coarse).quick = true
run(coarse).start_rotation_deg = 46: expected a number from 0 to 45, in degrees
run(coarse).start_rotation_deg = 20: expected initial_state = "settled" beside it: rotated rows do
  not fit the walls
run(coarse).initial_state = "projected" & run(coarse).start_rotation_deg = 20: expected
  initial_state = "settled" beside it
+ probe + block
-> obstacle.name = "block": expected an obstacle elsewhere: it holds the probe a at (1, 0.2) m
+ gate.reference is missing & gate.quantity = "highest_surface@left" & gate.mode = "whole" & gate.metric = "largest_magnitude"
gate.unit = "m": accepted
gate.unit = "mm": expected the unit of highest_surface@left, which is m
+ sensor
pressure_gauge.wall is missing: expected a wall, one of left, right, bottom
pressure_gauge.wall = "lift": expected a wall, one of left, right, bottom, roof; nearest: left
pressure_gauge.position_m is missing: expected a number from 0 to the tank's height (1), in m from
  the bottom
pressure_gauge.position_m = 1.001: expected a number from 0 to the tank's height (1)
pressure_gauge.wall = "bottom" & pressure_gauge.position_m = 2.1: expected a number from 0 to the
  tank's length (2), in m from the left wall
pressure_gauge.wall = "roof" & pressure_gauge.position_m = 2.1: expected a number from 0 to the
  tank's length (2), in m from the left wall
pressure_gauge.position_m = 0.005 & pressure_gauge.width_m = 0.011: expected a number >= 0 and <=
  0.01, in m: the whole sensor lies on the wall
pressure_gauge.filter_cutoff_Hz = 50: expected a number > 0 and below half the sampling rate (50), in
  Hz
+ sensor + sensor
-> pressure_gauge.name = "b": expected a name that no other pressure_gauge has
+ sensor + step + pressure_gauge.position_m = 0.205 & pressure_gauge.width_m = 0.02 & obstacle.right_m = 0.3 & obstacle.top_m = 0.2
-> obstacle.name = "step": expected an obstacle elsewhere: it covers the pressure gauge b at 0.205 m
pressure_gauge.position_m = 0.215: accepted
pressure_gauge.wall = "bottom" & pressure_gauge.position_m = 0.1 -> obstacle.name = "step": expected
pressure_gauge.wall = "bottom" & pressure_gauge.position_m = 0.4: accepted
pressure_gauge.wall = "right" & pressure_gauge.position_m = 0.1: accepted
pressure_gauge.wall = "bottom" & pressure_gauge.position_m = 0.1 & obstacle.bottom_m = 0.1: accepted
pressure_gauge.wall = "roof" & pressure_gauge.position_m = 0.1 & obstacle.bottom_m = 0.8 &
  obstacle.top_m = 1 -> obstacle.name = "step": expected
pressure_gauge.wall = "roof" & pressure_gauge.position_m = 0.1 & obstacle.bottom_m = 0.8 &
  obstacle.top_m = 0.9: accepted
pressure_gauge.wall = "right" & pressure_gauge.position_m = 0.3 & obstacle.left_m = 1.8 &
  obstacle.right_m = 2 & obstacle.bottom_m = 0.25 & obstacle.top_m = 0.4 -> obstacle.name = "step":
  expected
+ sensor + pressure_gauge.wall is missing & pressure_gauge.position_m is missing & pressure_gauge.z_m = 0
pressure_gauge.x_m = 1: expected no x_m in a rectangular tank, where wall and position_m tell a
  sensor's place
)");
}

TEST(CaseParserRefusal, SaysWhichKeysThereAre) {
  const auto refused = [](const Edit& edit, const std::string& row) {
    expect_refusals(edited(edit), row);
  };
  refused({"length_m = 2", "lenght_m = 2"},
          "-> tank.lenght_m = 2: expected only these keys here: ... nearest known key: length_m");
  refused({"[[gate]]", "[[gates]]"}, "-> gates = (an array of tables): expected only these keys");
  refused({"[tank]\nlength_m = 2\nheight_m = 1.0\n", ""},
          "-> tank is missing: expected a table, [tank]");
  refused({"[tank]\nlength_m = 2\nheight_m = 1.0\n", "tank = 3\n"},
          "-> tank = 3: expected a table, [tank]");
  refused({"[[gauge]]\nname = \"right\"\nx_m = 1.95\n[[gauge]]", "[gauge]"},
          "-> gauge = (a table): expected an array of tables, [[gauge]]");
}

TEST(CaseParserRefusal, TellsOfTextThatIsNoToml) {
  const auto refused = [](const Edit& edit, const char* message) {
    EXPECT_TRUE(begins(complaint_about(edit), message));
  };
  refused({"length_m = 2", "length_m = é"}, "trial.toml:8:12: not TOML: ");
  refused({"length_m = 2", "länge_m = 2"}, "trial.toml:8:2: not TOML: ");
  refused({"length_m = 2", "length_m = = 2"}, "trial.toml:8:12: not TOML: ");
  refused({"height_m = 1.0", "length_m = 1.0"}, "trial.toml:9:");
  refused({"[\"surge\"]", "[\n\"surge\",\n4]"}, "trial.toml:7: tags = 4: expected a text");
}

// A case file with several mistakes: all of them are reported at once, and each of them only once.

using Mistakes = std::vector<std::string>;

// Each up to ": expected", without the directory.
Mistakes mistakes_in(const std::string& text) {
  const Workspace workspace;
  const std::string directory = workspace.path().string() + "/trial.toml:";
  Mistakes found;
  try {
    read_case(workspace.write("trial.toml", text));
  } catch (const CaseFileErrors& errors) {
    for (const std::string& message : errors.messages) {
      const std::size_t begin = message.starts_with(directory) ? directory.size() : 0;
      found.push_back(message.substr(begin, message.find(": expected") - begin));
    }
  }
  return found;
}

Mistakes mistakes_of(const std::string& changes) {
  return mistakes_in(with_keys(valid_text, changes));
}

TEST(CaseParserComplaints, AreOfEverySectionAtOnce) {
  EXPECT_EQ(
      mistakes_of("title = 3 & gas.density_kg_m3 = 1200.0 & gauge(left).x_m = 5.0 & "
                  "comparison.window_end_s = 21.0 & run(theory).modes = 0 & run(mesh).cell_z = 40"),
      (Mistakes{"3: title = 3", "15: gas.density_kg_m3 = 1200.0", "30: gauge.x_m = 5.0",
                "33: comparison.window_end_s = 21.0", "38: run.modes = 0", "52: run.cell_z = 40"}));
}

TEST(CaseParserComplaints, AreOfEveryUnknownKeyOfATable) {
  EXPECT_EQ(mistakes_in(edited({"length_m = 2\nheight_m", "lenght_m = 2\nhight_m"})),
            (Mistakes{"9: tank.hight_m = 1.0", "8: tank.lenght_m = 2"}));
}

TEST(CaseParserComplaints, AreOfEveryWrongValueOfATable) {
  EXPECT_EQ(
      mistakes_of("tank.length_m = -2 & tank.height_m = 0 & time.start = \"moon\""),
      (Mistakes{"8: tank.length_m = -2", "9: tank.height_m = 0", "22: time.start = \"moon\""}));
  EXPECT_EQ(mistakes_of("run(mesh).cells_x = 1 & run(mesh).cells_z = 0 & gate.reason = \"\" & "
                        "gate.source = 4"),
            (Mistakes{"50: run.cells_x = 1", "51: run.cells_z = 0", "60: gate.reason = \"\"",
                      "61: gate.source = 4"}));
}

TEST(CaseParserComplaints, AreNotOfWhatRestsOnAnotherMistake) {
  // The sample interval is not checked against a duration that could not be read.
  EXPECT_EQ(mistakes_of("time.duration_s = 0 & time.sample_interval_s = 15"),
            Mistakes{"23: time.duration_s = 0"});
  // The gauges, runs and gate rows depend on the tank; the time does not.
  EXPECT_EQ(mistakes_of("tank.length_m = -2 & time.start = \"moon\""),
            (Mistakes{"8: tank.length_m = -2", "22: time.start = \"moon\""}));
  EXPECT_EQ(mistakes_of("gravity_m_s2 = -9.81"), Mistakes{"6: gravity_m_s2 = -9.81"});
}

TEST(CaseParserComplaints, OfAMisspeltSectionDoNotCallItMissing) {
  EXPECT_EQ(mistakes_in(edited({"[tank]", "[tnak]"})), Mistakes{"7: tnak = (a table)"});
  EXPECT_EQ(mistakes_in(edited({"title =", "titel ="})), Mistakes{"3: titel = \"A trial\""});
}

TEST(CaseParserComplaints, OfGaugesOrRunsThatCannotBeListedAreNotOfTheRowsThatNameThem) {
  EXPECT_EQ(mistakes_in(edited({"[[gauge]]\nname = \"right\"\nx_m = 1.95\n[[gauge]]", "[gauge]"})),
            Mistakes{"25: gauge = (a table)"});
  const std::size_t first = valid_text.find("[[run]]"), end = valid_text.find("[[gate]]");
  const std::string without_runs = valid_text.substr(0, first) + valid_text.substr(end);
  EXPECT_EQ(mistakes_in(without_runs), Mistakes{"1: run is missing"});
  EXPECT_EQ(mistakes_in("run = 3\n" + without_runs), Mistakes{"1: run = 3"});
}

TEST(CaseParserComplaints, AreOfTheRowsOnRunsAndGaugesThatCouldBeReadAlone) {
  const std::string row = valid_text.substr(valid_text.find("[[gate]]"));
  const auto with_rows = [&](const std::string& change, const std::string& of_first,
                             const std::string& of_second) {
    const std::string spoilt = " & gate.unit = \"%\"";
    return with_keys(valid_text, change + " & " + of_first + spoilt) +
           with_keys(row, of_second + spoilt);
  };
  EXPECT_EQ(mistakes_in(with_rows("run(mesh).cells_x = 1", "gate.candidate = \"mesh\"",
                                  "gate.quantity = \"elevation@left\"")),
            (Mistakes{"50: run.cells_x = 1", "68: gate.unit = \"%\""}));
  EXPECT_EQ(mistakes_in(with_rows("gauge(left).x_m = 5.0", "gate.quantity = \"elevation@left\"",
                                  "gate.quantity = \"elevation@right\"")),
            (Mistakes{"30: gauge.x_m = 5.0", "68: gate.unit = \"%\""}));
}

TEST(CaseParserComplaints, AreTheFirstTwentyAndSaySo) {
  std::string text = valid_text;
  for (int i = 0; i < 30; ++i) text += "[[gauge]]\nname = \"g\"\nx_m = -1\n";
  const Mistakes told = mistakes_in(text);
  ASSERT_EQ(told.size(), 21u);
  EXPECT_EQ(told[0], "64: gauge.x_m = -1");
  EXPECT_EQ(told[20], "these are the first 20; there may be more");
  EXPECT_STREQ(CaseFileErrors({"one", "two"}).what(), "one\ntwo");
}

}  // namespace
}  // namespace slosh::case_parser_refusal_test
