// Every kind of mistake in a case file, made by editing a valid text in one place: where, key,
// value, what was expected and the nearest known name.
#include <gtest/gtest.h>

#include "verification/tests/trial_case.hpp"

namespace slosh::case_parser_refusal_test {
namespace {

struct Mistake {
  std::string name;
  Edit edit;
  std::string message;  // how it must begin, after the directory
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.message; }

const std::string of_amplitude =
    "mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05";
const std::string of_cost = "mode = \"whole\"\nmetric = \"cost_to_reach\"\nunit = \"s\"\n";

class CaseParserRefusal : public ::testing::TestWithParam<Mistake> {};

TEST_P(CaseParserRefusal, SaysWhereWhatAndWhatWasExpected) {
  const std::string message = complaint_about(GetParam().edit);
  EXPECT_TRUE(message.starts_with(GetParam().message))
      << "got:    " << message << "\nwanted: " << GetParam().message;
  EXPECT_EQ(message.find('\n'), message.npos) << "one mistake is told of once: " << message;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, CaseParserRefusal,
    ::testing::Values(
        Mistake{"Misspelt",
                {"length_m = 2", "lenght_m = 2"},
                "trial.toml:8: tank.lenght_m = 2: expected only these keys here: length_m, "
                "height_m, outline_m, diameter_m, breadth_m; nearest known key: length_m"},
        Mistake{"Unknown",
                {"x_m = 1.95", "x_m = 1.95\ncolour = \"red\""},
                "trial.toml:28: gauge.colour = \"red\": expected only these keys here: name, x_m; "
                "nearest known key: "},
        Mistake{"UnknownAtTop",
                {"[[gate]]", "[[gates]]"},
                "trial.toml:52: gates = (an array of tables): expected only these keys here: "
                "schema_version, "},
        Mistake{"UnknownInRun",
                {"cells_z", "cell_z"},
                "trial.toml:51: run.cell_z = 40: expected only these keys here: "},
        Mistake{"OfAnotherSolver",
                {"cells_x = 50", "cells_x = 50\nmodes = 3"},
                "trial.toml:51: run.modes = 3: expected only these keys here: name, solver, quick, "
                "cells_x, cells_z, processes, courant_number, interface_courant_number, "
                "outer_corrections, no_slip, wall_cell_m, cells_y, start_disorder, start_seed, "
                "repeats, quick_repeats, "
                "vary_inputs; nearest known "
                "key: "},
        Mistake{"ExpectedSpeedOfAnotherSolver",
                {"cells_x = 50", "cells_x = 50\nexpected_speed = \"coarse_run\""},
                "trial.toml:51: run.expected_speed = \"coarse_run\": expected only these keys "
                "here: name, solver, quick, cells_x, "},
        Mistake{"ExpectedSpeedFromNowhere",
                {"quick = true", "expected_speed = \"fine_run\""},
                "trial.toml:46: run.expected_speed = \"fine_run\": expected where the expected "
                "largest speed comes from, one of estimate, coarse_run"},
        Mistake{"CourantNumberAboveOne",
                {"cells_x = 50", "cells_x = 50\ncourant_number = 1.5"},
                "trial.toml:51: run.courant_number = 1.5: expected a number > 0 and <= 1"},
        Mistake{"WallCellThickerThanTheCells",
                {"cells_x = 50", "cells_x = 50\nwall_cell_m = 0.1"},
                "trial.toml:51: run.wall_cell_m = 0.1: expected a number > 0 and <= "},
        Mistake{"CourantNumberOfZero",
                {"cells_x = 50", "cells_x = 50\ninterface_courant_number = 0.0"},
                "trial.toml:51: run.interface_courant_number = 0.0: expected a number > 0 and <= "
                "1"},
        Mistake{"OfAnotherMotion",
                {"amplitude_m", "amplitude_deg"},
                "trial.toml:19: motion.surge.amplitude_deg = 0.02: expected only these keys here: "
                "type, amplitude_m, angular_frequency_rad_s, frequency_Hz, period_s, phase_deg, "
                "ramp_periods, sines, file, time_offset_s; nearest known key: amplitude_m"},
        Mistake{"MissingType",
                {"type = \"sine\"\n", ""},
                "trial.toml:17: motion.surge.type is missing: expected a motion, one of sine, "
                "sines, table"},
        Mistake{"NestedTable",
                {"[gas]", "[gas.air]"},
                "trial.toml:14: gas.air = (a table): expected only these keys"},
        Mistake{"MissingSection",
                {"[tank]\nlength_m = 2\nheight_m = 1.0\n", ""},
                "trial.toml:1: tank is missing: expected a table, [tank]"},
        Mistake{"SingleGaugeTable",
                {"[[gauge]]\nname = \"right\"\nx_m = 1.95\n[[gauge]]", "[gauge]"},
                "trial.toml:25: gauge = (a table): expected an array of tables, [[gauge]]"},
        Mistake{"Twice", {"height_m = 1.0", "length_m = 1.0"}, "trial.toml:9:"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Types, CaseParserRefusal,
    ::testing::Values(
        Mistake{"NumberForInteger",
                {"cells_x = 50", "cells_x = 50.0"},
                "trial.toml:50: run.cells_x = 50.0: expected an integer from 2 to 10000"},
        Mistake{"NumberForTable",
                {"[tank]\nlength_m = 2\nheight_m = 1.0\n", "tank = 3\n"},
                "trial.toml:7: tank = 3: expected a table, [tank]"},
        Mistake{"NumberInTags",
                {"[\"surge\"]", "[\n\"surge\",\n4]"},
                "trial.toml:7: tags = 4: expected a text"},
        Mistake{"IntegerTooLarge",
                {"cells_x = 50", "cells_x = 5000000000"},
                "trial.toml:50: run.cells_x = 5000000000: expected an integer from 2 to 10000"},
        Mistake{"NotANumber",
                {"gravity_m_s2 = 9.81", "gravity_m_s2 = nan"},
                "trial.toml:6: gravity_m_s2 = nan: expected a number >= 0, in m/s2"},
        Mistake{"Infinite",
                {"amplitude_m = 0.02", "amplitude_m = inf"},
                "trial.toml:19: motion.surge.amplitude_m = inf: expected a number > 0, in m"},
        Mistake{
            "LetterBeyondAscii", {"length_m = 2", "length_m = é"}, "trial.toml:8:12: not TOML: "},
        Mistake{"LetterBeyondAsciiForAKey",
                {"length_m = 2", "länge_m = 2"},
                "trial.toml:8:2: not TOML: "},
        Mistake{"Syntax", {"length_m = 2", "length_m = = 2"}, "trial.toml:8:12: not TOML: "}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Physics, CaseParserRefusal,
    ::testing::Values(
        Mistake{"OtherSchema",
                {"schema_version = 1", "schema_version = 2"},
                "trial.toml:1: schema_version = 2: expected 1"},
        Mistake{"NameWithSlash",
                {"\"trial\"", "\"a/b\""},
                "trial.toml:2: name = \"a/b\": expected a name of letters, digits, _ and -"},
        Mistake{"NegativeGravity",
                {"9.81", "-9.81"},
                "trial.toml:6: gravity_m_s2 = -9.81: expected a number >= 0, in m/s2"},
        Mistake{"NaturalModesWithoutGravity",
                {"9.81", "0"},
                "trial.toml:34: comparison.natural_modes = 2: expected 0 without gravity"},
        Mistake{"NegativeLength",
                {"length_m = 2", "length_m = -2"},
                "trial.toml:8: tank.length_m = -2: expected a number > 0, in m"},
        Mistake{"NoBreadth",
                {"height_m = 1.0\n", "height_m = 1.0\nbreadth_m = 0.0\n"},
                "trial.toml:10: tank.breadth_m = 0.0: expected a number > 0, in m"},
        Mistake{"NegativeBreadth",
                {"height_m = 1.0\n", "height_m = 1.0\nbreadth_m = -0.06\n"},
                "trial.toml:10: tank.breadth_m = -0.06: expected a number > 0, in m"},
        Mistake{"BreadthForATheory",
                {"height_m = 1.0\n", "height_m = 1.0\nbreadth_m = 0.06\n"},
                "trial.toml:38: run.solver = \"linear\": expected a solver that counts the "
                "friction of the front and the back wall, one of sph, interfoam and interisofoam, "
                "and with "
                "cells_y compressible_interfoam, where [tank] has "
                "breadth_m"},
        Mistake{"FillAboveTank",
                {"fill_depth_m = 0.5", "fill_depth_m = 1.5"},
                "trial.toml:11: liquid.fill_depth_m = 1.5: expected a number > 0 and below the "
                "tank's height (1), in m"},
        Mistake{"FillToTheRoof",
                {"fill_depth_m = 0.5", "fill_depth_m = 1.0"},
                "trial.toml:11: liquid.fill_depth_m = 1.0: expected"},
        Mistake{"NoLiquid",
                {"fill_depth_m = 0.5", "fill_depth_m = 0.0"},
                "trial.toml:11: liquid.fill_depth_m = 0.0: expected"},
        Mistake{"NegativeDensity",
                {"= 1000.0", "= -1000.0"},
                "trial.toml:12: liquid.density_kg_m3 = -1000.0: expected a number > 0, in kg/m3"},
        Mistake{"ColumnAsWideAsTheTank",
                {"viscosity_m2_s = 1e-6", "viscosity_m2_s = 1e-6\ncolumn_width_m = 2.0"},
                "trial.toml:14: liquid.column_width_m = 2.0: expected a number > 0 and below the "
                "tank's length (2), in m"},
        Mistake{"NoColumn",
                {"viscosity_m2_s = 1e-6", "viscosity_m2_s = 1e-6\ncolumn_width_m = 0"},
                "trial.toml:14: liquid.column_width_m = 0: expected a number > 0"},
        Mistake{"ModesOfABreakingDam",
                {"viscosity_m2_s = 1e-6", "viscosity_m2_s = 1e-6\ncolumn_width_m = 0.5"},
                "trial.toml:35: comparison.natural_modes = 2: expected 0 for a dam about to break"},
        Mistake{"NegativeViscosity",
                {"1e-6", "-1e-6"},
                "trial.toml:13: liquid.kinematic_viscosity_m2_s = -1e-06: expected a number >= 0, "
                "in m2/s"},
        Mistake{"GasHeavierThanLiquid",
                {"= 1.2", "= 1000"},
                "trial.toml:15: gas.density_kg_m3 = 1000: expected a number > 0 and below the "
                "liquid's density (1000), in kg/m3"},
        Mistake{"UnknownMotion",
                {"\"sine\"", "\"sin\""},
                "trial.toml:18: motion.surge.type = \"sin\": expected a motion, one of sine, "
                "sines, table; nearest: sine"},
        Mistake{"NoAmplitude",
                {"amplitude_m = 0.02", "amplitude_m = 0"},
                "trial.toml:19: motion.surge.amplitude_m = 0: expected a number > 0, in m"},
        Mistake{
            "NegativeRamp",
            {"= 1.5\n", "= 1.5\nramp_periods = -1\n"},
            "trial.toml:21: motion.surge.ramp_periods = -1: expected a number >= 0, in periods"},
        Mistake{"UnknownStart",
                {"\"earth\"", "\"Earth\""},
                "trial.toml:22: time.start = \"Earth\": expected the frame in which the liquid is "
                "first at rest (earth: the liquid stands still and a tank that moves off at once "
                "strikes it; tank: the liquid moves off with the tank), one of earth, tank; "
                "nearest: earth"},
        Mistake{"StartInWords",
                {"\"earth\"", "\"at_rest_in_tank\""},
                "trial.toml:22: time.start = \"at_rest_in_tank\": expected the frame in which the "
                "liquid is first at rest (earth: the liquid stands still and a tank that moves off "
                "at once strikes it; tank: the liquid moves off with the tank), one of earth, "
                "tank; nearest: tank"},
        Mistake{"NoDuration",
                {"duration_s = 20.0", "duration_s = 0"},
                "trial.toml:23: time.duration_s = 0: expected a number > 0, in s"},
        Mistake{"SampledTooSeldom",
                {"interval_s = 0.01", "interval_s = 21"},
                "trial.toml:24: time.sample_interval_s = 21: expected a number > 0 and <= the "
                "duration (20), in s"},
        Mistake{"GaugeOutside",
                {"x_m = 1.95", "x_m = 2.05"},
                "trial.toml:27: gauge.x_m = 2.05: expected a number from 0 to the tank's length "
                "(2), in m from the left wall"},
        Mistake{"GaugeTwice",
                {"\"left\"", "\"right\""},
                "trial.toml:29: gauge.name = \"right\": expected a name that no other gauge has"},
        Mistake{"WindowBeforeStart",
                {"begin_s = 1.0", "begin_s = -1.0"},
                "trial.toml:32: comparison.window_begin_s = -1.0: expected a number >= 0, in s"},
        Mistake{"WindowAfterEnd",
                {"window_begin_s = 1.0\nwindow_end_s = 20.0", "window_begin_s = 20.0"},
                "trial.toml:32: comparison.window_begin_s = 20.0: expected a number below the "
                "duration (20), in s"},
        Mistake{"WindowBeyondEnd",
                {"end_s = 20.0", "end_s = 20.5"},
                "trial.toml:33: comparison.window_end_s = 20.5: expected a number above "
                "window_begin_s (1) and <= duration_s (20), in s"},
        Mistake{"WindowInverted",
                {"end_s = 20.0", "end_s = 0.5"},
                "trial.toml:33: comparison.window_end_s = 0.5: expected"},
        Mistake{"NegativeModes",
                {"natural_modes = 2", "natural_modes = -1"},
                "trial.toml:34: comparison.natural_modes = -1: expected an integer from 0 to 100"}),
    [](const auto& info) { return info.param.name; });

// The text is inserted before [comparison], line 31: the keys stand on lines 32 to 36.
Edit obstacle(const std::string& name, const std::string& left, const std::string& right,
              const std::string& bottom, const std::string& top) {
  return {"[comparison]", "[[obstacle]]\nname = \"" + name + "\"\nleft_m = " + left +
                              "\nright_m = " + right + "\nbottom_m = " + bottom +
                              "\ntop_m = " + top + "\n[comparison]"};
}

INSTANTIATE_TEST_SUITE_P(
    Obstacles, CaseParserRefusal,
    ::testing::Values(
        Mistake{"NameWithASpace", obstacle("a baffle", "0.9", "1.1", "0.0", "0.2"),
                "trial.toml:32: obstacle.name = \"a baffle\": expected a name of letters"},
        Mistake{"LeftOfTheTank", obstacle("baffle", "-0.1", "1.1", "0.0", "0.2"),
                "trial.toml:33: obstacle.left_m = -0.1: expected a number >= 0, in m"},
        Mistake{"Inverted", obstacle("baffle", "0.9", "0.9", "0.0", "0.2"),
                "trial.toml:34: obstacle.right_m = 0.9: expected a number above left_m (0.9) and "
                "<= the tank's length (2), in m"},
        Mistake{"RightOfTheTank", obstacle("baffle", "0.9", "2.1", "0.0", "0.2"),
                "trial.toml:34: obstacle.right_m = 2.1: expected a number above left_m (0.9)"},
        Mistake{"BelowTheTank", obstacle("baffle", "0.9", "1.1", "-0.1", "0.2"),
                "trial.toml:35: obstacle.bottom_m = -0.1: expected a number >= 0, in m"},
        Mistake{"AboveTheTank", obstacle("baffle", "0.9", "1.1", "0.1", "1.2"),
                "trial.toml:36: obstacle.top_m = 1.2: expected a number above bottom_m (0.1) and "
                "<= the tank's height (1), in m"},
        Mistake{"AsLongAsTheTank", obstacle("floor", "0", "2", "0.0", "0.2"),
                "trial.toml:34: obstacle.right_m = 2: expected a number below the tank's length "
                "(2), in m, for an obstacle from the left wall"},
        Mistake{"AroundAGauge", obstacle("block", "1.9", "2.0", "0.0", "0.5"),
                "trial.toml:36: obstacle.top_m = 0.5: expected a number below the fill depth "
                "(0.5), in m, or another place: the obstacle swallows the gauge right at 1.95 m"},
        Mistake{"WithoutATop",
                {"[comparison]",
                 "[[obstacle]]\nname = \"a\"\nleft_m = 0.9\nright_m = 1.0\n"
                 "bottom_m = 0\n[comparison]"},
                "trial.toml:31: obstacle.top_m is missing: expected a number above bottom_m (0)"},
        Mistake{"OverAnother",
                {"[comparison]",
                 "[[obstacle]]\nname = \"a\"\nleft_m = 0.9\nright_m = 1.1\nbottom_m = 0\n"
                 "top_m = 0.2\n[[obstacle]]\nname = \"b\"\nleft_m = 1.0\nright_m = 1.2\n"
                 "bottom_m = 0.1\ntop_m = 0.3\n[comparison]"},
                "trial.toml:39: obstacle.left_m = 1.0: expected a rectangle that does not overlap "
                "that of the obstacle a"},
        Mistake{
            "NamedAsAnother",
            {"[comparison]",
             "[[obstacle]]\nname = \"a\"\nleft_m = 0.9\nright_m = 1.0\nbottom_m = 0\n"
             "top_m = 0.2\n[[obstacle]]\nname = \"a\"\nleft_m = 1.0\nright_m = 1.2\n"
             "bottom_m = 0.1\ntop_m = 0.3\n[comparison]"},
            "trial.toml:38: obstacle.name = \"a\": expected a name that no other obstacle has"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Runs, CaseParserRefusal,
    ::testing::Values(
        Mistake{"Twice",
                {"\"mesh\"", "\"coarse\""},
                "trial.toml:48: run.name = \"coarse\": expected a name that no other run has"},
        Mistake{"UnknownSolver",
                {"\"interfoam\"", "\"interFoam\""},
                "trial.toml:49: run.solver = \"interFoam\": expected a solver, one of sph, "
                "interfoam, interisofoam, compressible_interfoam, linear, viscous_wave, potential, "
                "record, external, stored, pysph; nearest: "
                "interfoam"},
        Mistake{"NoModes",
                {"modes = 500", "modes = 0"},
                "trial.toml:38: run.modes = 0: expected an integer from 1 to 100000"},
        Mistake{"NegativeSpacing",
                {"e_spacing_m = 0.02", "e_spacing_m = -0.02"},
                "trial.toml:44: run.particle_spacing_m = -0.02: expected a number > 0 and <= the "
                "fill depth (0.5), in m"},
        Mistake{"SpacingAboveDepth",
                {"e_spacing_m = 0.02", "e_spacing_m = 0.6"},
                "trial.toml:44: run.particle_spacing_m = 0.6: expected"},
        Mistake{"SurfaceCoarserThanInside",
                {"spacing_m = 0.01", "spacing_m = 0.03"},
                "trial.toml:45: run.surface_particle_spacing_m = 0.03: expected a number > 0 and "
                "<= particle_spacing_m (0.02), in m"},
        Mistake{"EmptyVariant",
                {"quick = true", "variant = \"\""},
                "trial.toml:46: run.variant = \"\": expected a text that is not empty"},
        Mistake{"NoSmoothingLength",
                {"quick = true", "smoothing_length_ratio = 0"},
                "trial.toml:46: run.smoothing_length_ratio = 0: expected a number from 0.5 to "
                "10, without "
                "unit"},
        Mistake{"NoSound",
                {"quick = true", "sound_speed_ratio = -10.0"},
                "trial.toml:46: run.sound_speed_ratio = -10.0: expected a number from 1 to 1000, "
                "without unit"},
        Mistake{"NoTimeStep",
                {"quick = true", "courant_number = 0"},
                "trial.toml:46: run.courant_number = 0: expected a number from 0.001 to 10, "
                "without unit"},
        Mistake{"NegativeAlpha",
                {"quick = true", "artificial_viscosity = -0.1"},
                "trial.toml:46: run.artificial_viscosity = -0.1: expected a number >= 0, without "
                "unit"},
        Mistake{"NegativeDelta",
                {"quick = true", "density_diffusion = -0.1"},
                "trial.toml:46: run.density_diffusion = -0.1: expected a number >= 0, without "
                "unit"},
        Mistake{"VariantOfAMesh",
                {"cells_x = 50", "cells_x = 50\nvariant = \"a\""},
                "trial.toml:51: run.variant = \"a\": expected only these keys here: name, solver, "
                "quick, cells_x"},
        Mistake{"OneCellAlong",
                {"cells_x = 50", "cells_x = 1"},
                "trial.toml:50: run.cells_x = 1: expected an integer from 2 to 10000"},
        Mistake{"OneCellUp",
                {"cells_z = 40", "cells_z = 1"},
                "trial.toml:51: run.cells_z = 1: expected an integer from 2 to 10000"},
        Mistake{"NoProcesses",
                {"cells_z = 40", "cells_z = 40\nprocesses = 0"},
                "trial.toml:52: run.processes = 0: expected an integer from 1 to cells_x (50)"},
        Mistake{"MoreProcessesThanColumns",
                {"cells_z = 40", "cells_z = 40\nprocesses = 51"},
                "trial.toml:52: run.processes = 51: expected an integer from 1 to cells_x (50)"},
        Mistake{"NoRangeOfValidity",
                {"depth = 0.1", "depth = 0"},
                "trial.toml:39: run.valid_elevation_over_depth = 0: expected a number > 0"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Gate, CaseParserRefusal,
    ::testing::Values(
        Mistake{"UnknownRun",
                {"candidate = \"coarse\"", "candidate = \"course\""},
                "trial.toml:53: gate.candidate = \"course\": expected a run, one of theory, "
                "coarse, mesh; nearest: coarse"},
        Mistake{"ReferenceIsCandidate",
                {"reference = \"theory\"", "reference = \"coarse\""},
                "trial.toml:54: gate.reference = \"coarse\": expected a run other than the "
                "candidate, one of theory, mesh"},
        Mistake{"UnknownGauge",
                {"elevation@right", "elevation@rigth"},
                "trial.toml:55: gate.quantity = \"elevation@rigth\": expected a compared "
                "quantity, one of elevation@right, elevation@left, force_x, force_z, momentum_x, "
                "momentum_z, highest_surface@right, highest_surface@left; nearest: "
                "elevation@right"},
        Mistake{"UnknownQuantity",
                {"elevation@right", "pressure@right"},
                "trial.toml:55: gate.quantity = \"pressure@right\": expected"},
        Mistake{"UnknownMode",
                {"\"forced\"", "\"natural_3\""},
                "trial.toml:56: gate.mode = \"natural_3\": expected what amplitude_error is "
                "measured on, one of forced, natural_1, natural_2; nearest: natural_"},
        Mistake{
            "WholeForAMode",
            {"\"forced\"", "\"whole\""},
            "trial.toml:56: gate.mode = \"whole\": expected what amplitude_error is measured on"},
        Mistake{"ModeForAWhole",
                {"amplitude_error", "normalised_rms"},
                "trial.toml:56: gate.mode = \"forced\": expected what normalised_rms is measured "
                "on, which is whole"},
        Mistake{"FrequencyOfTheForcedMode",
                {"amplitude_error", "frequency_error"},
                "trial.toml:56: gate.mode = \"forced\": expected what frequency_error is measured "
                "on, one of natural_1, natural_2"},
        Mistake{"UnknownMetric",
                {"amplitude_error", "amplitude_eror"},
                "trial.toml:57: gate.metric = \"amplitude_eror\": expected a metric, one of "
                "amplitude_error, phase_lag, frequency_error, decay_rate, decay_error, "
                "normalised_rms, "
                "aligned_rms, largest_magnitude, "
                "cross_correlation_lag, spectral_peak_error, rms_error, "
                "mean_offset, noise_share, initial_value, frequency, "
                "plateau_error, impact_arrival, "
                "impact_peak_error, "
                "impulse_error, peak_mean_p_value, peak_ks_p_value, peak_ad_p_value, "
                "peak_median_error, outside_band, pressure_field_rms, "
                "pressure_field_tension, cost_to_reach; nearest: "
                "amplitude_error"},
        Mistake{
            "AlignmentOfWhatSwings",
            {"metric = \"amplitude_error\"\nunit = \"1\"",
             "metric = \"aligned_rms\"\nunit = \"1\""},
            "trial.toml:56: gate.mode = \"forced\": expected what aligned_rms is measured on, of "
            "which there is none"},
        Mistake{"ErrorOfAMetricThatHasNone",
                {"limit = 0.05", "limit = 0.05\nerror = 0.1"},
                "trial.toml:60: gate.error = 0.1: expected no error: only cost_to_reach is of one"},
        Mistake{"CostWithoutAnError",
                {of_amplitude, of_cost + "limit = 20"},
                "trial.toml:52: gate.error is missing: expected a normalised rms above 0 and below "
                "1, without unit"},
        Mistake{"CostOfAnErrorInPerCent",
                {of_amplitude, of_cost + "limit = 20\nerror = 10"},
                "trial.toml:60: gate.error = 10: expected a normalised rms above 0 and below 1, "
                "without unit"},
        Mistake{"CostOfAnErrorThatIsNotAboveZero",
                {of_amplitude, of_cost + "limit = 20\nerror = 0"},
                "trial.toml:60: gate.error = 0: expected a normalised rms above 0"},
        Mistake{"CostBoundedFromBelow",
                {of_amplitude, of_cost + "lower = 1\nupper = 2\nerror = 0.1"},
                "trial.toml:52: gate = a row on cost_to_reach: expected limit: cheaper is better"},
        Mistake{"CostInAnotherUnit",
                {of_amplitude,
                 "mode = \"whole\"\nmetric = \"cost_to_reach\"\nunit = \"h\"\n"
                 "limit = 20\nerror = 0.1"},
                "trial.toml:58: gate.unit = \"h\": expected the unit of cost_to_reach, which is s"},
        Mistake{
            "CostOfAMode",
            {"metric = \"amplitude_error\"\nunit = \"1\"",
             "metric = \"cost_to_reach\"\nunit = \"s\"\nerror = 0.1"},
            "trial.toml:56: gate.mode = \"forced\": expected what cost_to_reach is measured on"},
        Mistake{"ReferenceOfItsOwnSeries",
                {"amplitude_error", "largest_magnitude"},
                "trial.toml:54: gate.reference = \"theory\": expected no reference: "
                "largest_magnitude is measured on the candidate alone"},
        Mistake{"ModeOfItsOwnSeries",
                {"reference = \"theory\"\nquantity = \"elevation@right\"\nmode = \"forced\"\n"
                 "metric = \"amplitude_error\"",
                 "quantity = \"wall_gap\"\nmode = \"forced\"\nmetric = \"largest_magnitude\""},
                "trial.toml:55: gate.mode = \"forced\": expected what largest_magnitude is "
                "measured on, which is whole"},
        Mistake{
            "NoReference",
            {"reference = \"theory\"\n", ""},
            "trial.toml:52: gate.reference is missing: expected a run other than the candidate"},
        Mistake{
            "WrongUnit",
            {"unit = \"1\"", "unit = \"%\""},
            "trial.toml:58: gate.unit = \"%\": expected the unit of amplitude_error, which is 1"},
        Mistake{"NegativeLimit",
                {"limit = 0.05", "limit = -0.05"},
                "trial.toml:59: gate.limit = -0.05: expected a number > 0 and below 1, without "
                "unit (a candidate that does not move has -1)"},
        Mistake{"LimitThatACandidateAtRestKeeps",
                {"limit = 0.05", "limit = 1"},
                "trial.toml:59: gate.limit = 1: expected a number > 0 and below 1, without unit (a "
                "candidate that does not move has -1)"},
        Mistake{"LimitThatEveryNumberKeeps",
                {"limit = 0.05", "limit = 1e300"},
                "trial.toml:59: gate.limit = 1e+300: expected a number > 0 and below 1"},
        Mistake{"LimitOfHalfATurn",
                {"metric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05",
                 "metric = \"phase_lag\"\nunit = \"deg\"\nlimit = 180"},
                "trial.toml:59: gate.limit = 180: expected a number > 0 and below 180, in deg (a "
                "lag is known but for whole periods"},
        Mistake{"LimitOfAQuantityThatNoTankHolds",
                {"mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05",
                 "mode = \"whole\"\nmetric = \"mean_offset\"\nunit = \"m\"\nlimit = 1e9"},
                "trial.toml:59: gate.limit = 1000000000.0: expected a number > 0 and below 2, in m "
                "(no elevation exceeds the tank's size"},
        Mistake{
            "RangeThatEveryNumberKeeps",
            {"limit = 0.05", "lower = -0.3\nupper = 1e300"},
            "trial.toml:60: gate.upper = 1e+300: expected a number above lower (-0.3) and below "
            "1.7, without unit (a candidate that does not move has -1)"},
        Mistake{"RangeThatACandidateOfNothingKeeps",
                {"limit = 0.05", "lower = -1.9\nupper = 0.05"},
                "trial.toml:60: gate.upper = 0.05: expected a number above lower (-1.9) and below "
                "-1, without unit, so that the range does not hold -1 (a candidate that does not "
                "move has -1)"},
        Mistake{"RangeThatATurnedWaveKeeps",
                {"metric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05",
                 "metric = \"phase_lag\"\nunit = \"deg\"\nlower = -179\nupper = 180.9"},
                "trial.toml:60: gate.upper = 180.9: expected a number above lower (-179) and below "
                "180, in deg, so that the range does not hold 180"},
        Mistake{
            "RangeThatATurnedWaveKeepsOnTheOtherSide",
            {"metric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05",
             "metric = \"phase_lag\"\nunit = \"deg\"\nlower = -190\nupper = 5"},
            "trial.toml:60: gate.upper = 5: expected a number above lower (-190) and below -180"},
        Mistake{"RangeOfAPressureThatNoTankHolds",
                {"mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"\nlimit = 0.05",
                 "mode = \"whole\"\nmetric = \"mean_offset\"\nunit = \"m\"\nlower = -9\nupper = "
                 "0.1"},
                "trial.toml:60: gate.upper = 0.1: expected a number above lower (-9) and below -5, "
                "in m"},
        Mistake{"TooManyModes",
                {"modes = 500", "modes = 2000000000"},
                "trial.toml:38: run.modes = 2000000000: expected an integer from 1 to 100000"},
        Mistake{"TheoryThatMayAlwaysJudge",
                {"depth = 0.1", "depth = 1e308"},
                "trial.toml:39: run.valid_elevation_over_depth = 1e+308: expected a number > 0 and "
                "< 1, in fill depths: a trough of one bares the bottom"},
        Mistake{"TooManySamples",
                {"interval_s = 0.01", "interval_s = 1e-9"},
                "trial.toml:24: time.sample_interval_s = 1e-09: expected a number > 0 and <= the "
                "duration (20), in s, and >= 2e-06, for at most ten million samples"},
        Mistake{
            "TooManyParticles",
            {"particle_spacing_m = 0.02", "particle_spacing_m = 1e-7"},
            "trial.toml:44: run.particle_spacing_m = 1e-07: expected a number > 0 and <= the "
            "fill depth (0.5), in m, and >= 0.0001, the spacing of a hundred million particles"},
        Mistake{"SoundSlowerThanTheLiquid",
                {"quick = true", "quick = true\nsound_speed_ratio = 0.001"},
                "trial.toml:47: run.sound_speed_ratio = 0.001: expected a number from 1 to 1000"},
        Mistake{"SecondBoundOnTheSame",
                {"source = \"a source\"\n",
                 "source = \"a source\"\n[[gate]]\ncandidate = \"coarse\"\nreference = "
                 "\"theory\"\nquantity = \"elevation@right\"\nmode = \"forced\"\nmetric = "
                 "\"amplitude_error\"\nunit = \"1\"\nlower = 0.5\nupper = 0.6\nreason = \"r\"\n"
                 "source = \"s\"\n"},
                "trial.toml:62: gate = a second bound on amplitude_error of coarse: expected one "
                "row for each candidate, reference, quantity, mode and metric; the first is at "},
        Mistake{"NoBound",
                {"limit = 0.05\n", ""},
                "trial.toml:52: gate = {}: expected exactly one of limit | lower with upper | "
                "improves_on"},
        Mistake{"TwoBounds",
                {"limit = 0.05", "limit = 0.05\nupper = 1"},
                "trial.toml:52: gate = {limit, upper}: expected exactly one of"},
        Mistake{"HalfABound",
                {"limit = 0.05", "lower = 1"},
                "trial.toml:52: gate = {lower}: expected exactly one of"},
        Mistake{"BoundsInverted",
                {"limit = 0.05", "lower = 1\nupper = 0.5"},
                "trial.toml:60: gate.upper = 0.5: expected a number above lower (1) and below 3, "
                "without unit"},
        Mistake{"ImprovesOnItself",
                {"limit = 0.05", "improves_on = \"coarse\""},
                "trial.toml:59: gate.improves_on = \"coarse\": expected a run other than the "
                "candidate and the reference, which is mesh; nearest: mesh"},
        Mistake{"NoReason",
                {"\"a reason\"", "\"\""},
                "trial.toml:60: gate.reason = \"\": expected a text that is not empty"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slosh::case_parser_refusal_test
