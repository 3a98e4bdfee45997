#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/case/usual_values.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {

const std::vector<KeyTable>& case_key_tables() {
  static const std::vector<KeyTable> tables{
      {"case",
       "Top level",
       "yes",
       "The first keys of a case file, and its tables.",
       {{"schema_version", "1", "yes", "The version of this format."},
        {"name", "name", "yes", "The name of the case."},
        {"title", "text", "yes", "The title in reports."},
        {"source", "text", "yes", "Where the case comes from: paper, section, figure."},
        {"tags", "list of texts", "no", "Words by which `--tag` selects the case."},
        {"gravity_m_s2", "number >= 0, m/s2", "no",
         fmt::format("It may be 0 only where the tank moves. Default: {}.", usual_gravity)},
        {"tank", "the table [tank]", "yes", ""},
        {"liquid", "the table [liquid]", "yes", ""},
        {"gas", "the table [gas]", "no", ""},
        {"obstacle", "the table [[obstacle]]", "no", ""},
        {"initial_wave", "the table [initial_wave]", "no", ""},
        {"motion", "the table [motion]", "yes", ""},
        {"time", "the table [time]", "yes", ""},
        {"animation", "the table [animation]", "no", ""},
        {"gauge", "the table [[gauge]]", "at least one gauge of either kind", ""},
        {"pressure_gauge", "the table [[pressure_gauge]]", "at least one gauge of either kind", ""},
        {"probe", "the table [[probe]]", "no", ""},
        {"wall_forces", "list of \"left\", \"right\", \"bottom\", \"roof\"", "no",
         "The walls on which the force is recorded: force_x@WALL and force_z@WALL. Runs are "
         "compared on the component normal to the wall."},
        {"impacts", "the table [impacts]", "no", ""},
        {"comparison", "the table [comparison]", "yes", ""},
        {"run", "the table [[run]]", "at least one", ""},
        {"refinement", "the table [[refinement]]", "no", ""},
        {"input", "the table [[input]]", "no", ""},
        {"gate", "the table [[gate]]", "no", ""}}},
      {"tank",
       "[tank]",
       "yes",
       "A tank, seen from the side: a rectangle, a polygon or a lying cylinder. x counts from its "
       "left end and z from its lowest place. Beside outline_m or diameter_m there is no obstacle, "
       "no initial wave, no column_width_m and no wall_forces, and only the solvers sph, "
       "interfoam, interisofoam, compressible_interfoam, linear, record, external and stored take "
       "the case.",
       {{"length_m", "number > 0, m", "one of the three", "The inner length."},
        {"height_m", "number > 0, m", "with length_m", "The inner height, to the roof."},
        {"outline_m", "list of corners [x, z], m", "one of the three",
         "The corners of the inner outline, counter-clockwise: 3 to 1000, with the smallest x and "
         "the smallest z 0. The sides meet at the corners alone, and each horizontal line cuts the "
         "outline in two places at most."},
        {"diameter_m", "number > 0, m", "one of the three",
         "The diameter of a lying cylinder. The tank is a regular polygon of 128 corners, flat at "
         "the bottom, with the area of the circle; its length and height are 0.9999 diameters."},
        {"breadth_m", "number > 0, m", "no",
         "The inner breadth of a narrow tank, from the front to the back wall. With it, SPH, "
         "interFoam and interIsoFoam count the friction of these two walls, which they do not see "
         "otherwise; the theories and compressibleInterFoam, which have no friction there, are "
         "refused, but for a run of the latter in three dimensions (cells_y). Beside outline_m or "
         "diameter_m the "
         "motion must have a single frequency. Default: no friction."}}},
      {"liquid",
       "[liquid]",
       "yes",
       "",
       {{"fill_depth_m", "number > 0 and below the tank's height, m", "yes", "The still depth."},
        {"density_kg_m3", "number > 0, kg/m3", "with kinematic_viscosity_m2_s",
         fmt::format("Without both the liquid is water at 20 °C, rounded: {} kg/m3 and {:g} m2/s "
                     "(IAPWS R6-95: 998.2; R12-08: 1.003e-6).",
                     water_density, water_kinematic_viscosity)},
        {"kinematic_viscosity_m2_s", "number >= 0, m2/s", "with density_kg_m3", ""},
        {"column_width_m", "number > 0 and below the tank's length, m", "no",
         "Makes the liquid a dam about to break: it stands from the left wall to here."}}},
      {"gas",
       "[gas]",
       "no",
       fmt::format(
           "The gas above the liquid, for OpenFOAM and the two-layer theory. Without it the "
           "gas is air at 20 °C, rounded: {} kg/m3 and {:g} m2/s (ISO 2533: 1.204 and "
           "1.51e-5).",
           air.density, air.kinematic_viscosity),
       {{"density_kg_m3", "number > 0 and below the liquid's density, kg/m3", "yes", ""},
        {"kinematic_viscosity_m2_s", "number >= 0, m2/s", "yes", ""}}},
      {"obstacle",
       "[[obstacle]]",
       "no",
       "A solid rectangle that the tank carries. Rectangles may touch and must not overlap. None "
       "may reach from wall to wall, fill a gauge's column from the bottom to the still level, "
       "touch a pressure gauge, or hold a probe.",
       {{"name", "name", "yes", ""},
        {"left_m", "number >= 0, m from the left wall", "yes", ""},
        {"right_m", "number above left_m and <= the tank's length, m from the left wall", "yes",
         ""},
        {"bottom_m", "number >= 0, m from the bottom", "yes", ""},
        {"top_m", "number above bottom_m and <= the tank's height, m from the bottom", "yes", ""}}},
      {"initial_wave",
       "[initial_wave]",
       "no, and not with column_width_m or an obstacle",
       "A standing wave A cos(mode pi x / L) that is released from rest; x counts from the left "
       "wall.",
       {{"mode", "integer >= 1", "yes", "The number of half waves between the walls."},
        {"amplitude_m", "number other than 0, m", "yes",
         "The amplitude A. Where it is positive, the crest is at the left wall. Its magnitude is "
         "below the fill depth and below the room under the roof."}}},
      {"motion",
       "[motion]",
       "yes",
       "The tank stands still, surges, rolls, or does both.",
       {{"still", "true", "where neither table is there", "The tank stands."},
        {"surge", "the table [motion.surge]", "no", ""},
        {"roll", "the table [motion.roll]", "no", ""}}},
      {"surge",
       "[motion.surge]",
       "no",
       "The tank's horizontal displacement.",
       {{"type", "\"sine\", \"sines\" or \"table\"", "yes", ""},
        {"amplitude_m", "number > 0, m", "with type = \"sine\"", ""},
        {"angular_frequency_rad_s", "number > 0, rad/s", "one of the three with type = \"sine\"",
         ""},
        {"frequency_Hz", "number > 0, Hz", "one of the three with type = \"sine\"", ""},
        {"period_s", "number > 0, s", "one of the three with type = \"sine\"", ""},
        {"phase_deg", "number from -360 to 360, deg", "no",
         "The phase of A sin(omega t + phase); refused with a table. Default: 0."},
        {"ramp_periods", "number >= 0, periods", "no",
         "The time over which a sine grows to its amplitude; refused with a table. Default: 0."},
        {"sines", "the table [[motion.surge.sines]]", "with type = \"sines\"", ""},
        {"file", "path, relative to the case file", "with type = \"table\"",
         "A CSV file with the columns time_s,displacement_m, from the time 0 to duration_s or "
         "beyond, joined by a cubic spline. Or with time_s,acceleration_m_s2: the spline through "
         "these is integrated twice, from the position 0 and the velocity 0 at the time 0. Points "
         "less than 2 ms after another are left out. A table whose acceleration is mostly noise is "
         "doubted."},
        {"time_offset_s", "number, s", "no",
         "Added to the times of a table's file: with -12.5 the file's 12.5 s are the case's 0 s. "
         "Refused with a sine. Default: 0."}}},
      {"surge.sines",
       "[[motion.surge.sines]]",
       "with type = \"sines\"",
       "The motion is the sum of two sines or more, each with its own ramp. They read best as one "
       "list, which may run over several lines: `sines = [{ amplitude_m = 0.02, period_s = 1.3 }, "
       "{ amplitude_m = 0.005, period_s = 0.7, phase_deg = 90 }]`. Each frequency has a forced "
       "mode: forced_1, forced_2, ...",
       {{"amplitude_m", "number > 0, m", "yes", ""},
        {"angular_frequency_rad_s", "number > 0, rad/s", "one of the three", ""},
        {"frequency_Hz", "number > 0, Hz", "one of the three", ""},
        {"period_s", "number > 0, s", "one of the three", ""},
        {"phase_deg", "number from -360 to 360, deg", "no", ""},
        {"ramp_periods", "number >= 0, periods", "no", "Periods of this sine."}}},
      {"roll",
       "[motion.roll]",
       "no",
       "The tank's rotation about an axis, which moves with a surge and may lie outside the tank.",
       {{"type", "\"sine\", \"sines\" or \"table\"", "yes", ""},
        {"amplitude_deg", "number > 0 and <= 360, deg", "with type = \"sine\"", ""},
        {"angular_frequency_rad_s", "number > 0, rad/s", "one of the three with type = \"sine\"",
         ""},
        {"frequency_Hz", "number > 0, Hz", "one of the three with type = \"sine\"", ""},
        {"period_s", "number > 0, s", "one of the three with type = \"sine\"", ""},
        {"phase_deg", "number from -360 to 360, deg", "no",
         "The same as for a surge. The tank starts level, so that another phase than 0 or 180 "
         "needs a ramp."},
        {"ramp_periods", "number >= 0, periods", "no", "The same as for a surge."},
        {"sines", "the table [[motion.roll.sines]]", "with type = \"sines\"", ""},
        {"file", "path, relative to the case file", "with type = \"table\"",
         "A CSV file with the columns time_s,angle_deg, from the time and the angle 0 to "
         "duration_s or beyond, or with time_s,acceleration_deg_s2. The same as for a surge."},
        {"time_offset_s", "number, s", "no", "The same as for a surge."},
        {"axis_x_m", "number, m from the left wall", "yes", "Within 1000 tank lengths."},
        {"axis_z_m", "number, m from the bottom", "yes", "Within 1000 tank lengths."}}},
      {"roll.sines",
       "[[motion.roll.sines]]",
       "with type = \"sines\"",
       "As for a surge. The forced modes of a surge come first.",
       {{"amplitude_deg", "number > 0 and <= 360, deg", "yes", ""},
        {"angular_frequency_rad_s", "number > 0, rad/s", "one of the three", ""},
        {"frequency_Hz", "number > 0, Hz", "one of the three", ""},
        {"period_s", "number > 0, s", "one of the three", ""},
        {"phase_deg", "number from -360 to 360, deg", "no", ""},
        {"ramp_periods", "number >= 0, periods", "no", "Periods of this sine."}}},
      {"time",
       "[time]",
       "yes",
       "",
       {{"start", "\"earth\" or \"tank\"", "yes",
         "The frame in which the liquid is at rest at the start. Earth: it stands still, and a "
         "tank that moves off at once strikes it. Tank: it moves off with the tank."},
        {"duration_s", "number > 0, s", "yes", ""},
        {"sample_interval_s", "number > 0 and <= duration_s, s", "yes",
         "The interval of the recorded samples. SPH lands on each, so a short one shortens its "
         "time step. There are ten million at most."},
        {"snapshot_times_s", "increasing list of numbers > 0 and <= duration_s, s", "no",
         "The times at which fields are kept: multiples of sample_interval_s."}}},
      {"animation",
       "[animation]",
       "no",
       "SPH and OpenFOAM keep their fields at 3 to 60 moments, and the report plays the finest "
       "run of each scheme and of each program of OpenFOAM side by side.",
       {{"begin_s", "number > 0 and <= duration_s, s", "yes",
         "A multiple of sample_interval_s, as are the others."},
        {"end_s", "number > 0 and <= duration_s, s", "yes", ""},
        {"interval_s", "number > 0 and <= duration_s, s", "yes", ""}}},
      {"gauge",
       "[[gauge]]",
       "at least one gauge of either kind",
       "A gauge of the surface's elevation. SPH measures the depth of liquid there, so a gauge "
       "should stand six particle spacings away from an obstacle: nearer, it reads too low.",
       {{"name", "name", "yes", "The NAME in elevation@NAME."},
        {"x_m", "number from 0 to the tank's length, m", "yes",
         "The distance from the left wall. In a tank that is no rectangle it lies where the still "
         "surface reaches at the fill depth."}}},
      {"pressure_gauge",
       "[[pressure_gauge]]",
       "at least one gauge of either kind",
       "A pressure sensor in a wall.",
       {{"name", "name", "yes", "The NAME in wall_pressure@NAME."},
        {"wall", "\"left\", \"right\", \"bottom\" or \"roof\"", "in a rectangular tank", ""},
        {"position_m", "number >= 0, m", "in a rectangular tank",
         "The middle of the sensor: above the bottom, or on the bottom or the roof from the left "
         "wall; within that wall."},
        {"x_m", "number, m", "in another tank",
         "With z_m: the middle of the sensor, a place on the outline to within a millionth of the "
         "tank's size."},
        {"z_m", "number, m", "in another tank", ""},
        {"width_m", "number >= 0, m", "no",
         "The sensor's extent along the wall. The whole sensor must lie on the wall, of an outline "
         "on one side. Default: 0, a point."},
        {"filter_cutoff_Hz", "number > 0 and below half the sampling rate, Hz", "no",
         "Adds the series wall_pressure@NAME/filtered, through a low-pass filter."}}},
      {"probe",
       "[[probe]]",
       "no",
       "A place in the tank, which moves with it, where velocity and pressure are recorded. The "
       "velocity is relative to the tank, along its axes. While the surface is below the place, "
       "all three are 0. Linear theory records them only at a place below the still level, as it "
       "has no liquid above it.",
       {{"name", "name", "yes", "The NAME in velocity_x@NAME, velocity_z@NAME and pressure@NAME."},
        {"x_m", "number from 0 to the tank's length, m", "yes",
         "The distance from the left wall. The place lies inside the tank's outline."},
        {"z_m", "number from 0 to the tank's height, m", "yes", "The height above the bottom."}}},
      {"impacts",
       "[impacts]",
       "no",
       "Published impacts on a pressure gauge, for the metrics of impacts.",
       {{"gauge", "name of a pressure gauge", "yes", ""},
        {"times_s", "increasing list of numbers, s", "yes",
         "The published times of the peaks, one or more, at least half a period apart and a "
         "quarter of it inside the run."},
        {"period_s", "number > 0, s", "where sought_within_s is absent",
         "The period of the motion that brings the impacts."},
        {"sought_within_s", "number > 0, s", "no",
         "In place of period_s, for a single impact: it is sought this long to either side of its "
         "time, of which a quarter of the period is the measure otherwise."},
        {"peaks_Pa", "list of numbers > 0, Pa", "yes",
         "The published mean peak of each impact: as many as times_s."},
        {"peaks_sd_Pa", "list of numbers > 0, Pa", "with period_s",
         "The standard deviation of each, over the repeats."},
        {"peaks_half_width_Pa", "number > 0, Pa", "no",
         "Half the 95 % interval of the mean peaks."},
        {"plateau_begin_s", "number >= 0, s", "with period_s",
         "The plateau may be left out beside sought_within_s."},
        {"plateau_end_s", "number > plateau_begin_s and <= duration_s, s", "with plateau_begin_s",
         ""},
        {"plateau_Pa", "number > 0, Pa", "with plateau_begin_s",
         "The published mean pressure between the two."},
        {"arrival_share", "number > 0 and < 1", "with arrivals_s",
         "An impact arrives when the pressure comes to this share of its published peak and holds "
         "it."},
        {"arrivals_s", "list of numbers > 0, s", "with arrival_share",
         "The published arrivals: as many as times_s."},
        {"arrivals_half_width_s", "number > 0, s", "no", "Half the 95 % interval of the arrivals."},
        {"rise_times_s", "list of numbers > 0, s", "no",
         "The published rise times, twice the time from half the peak to the peak, for the "
         "tables: as many as times_s."},
        {"rise_times_half_width_s", "number > 0, s", "no",
         "Half the 95 % interval of the rise times."},
        {"impulse_duration_s", "number > 0, s", "with impulses_Pa_s",
         "The time from the arrival on over which the impulse is taken."},
        {"impulses_Pa_s", "list of numbers > 0, Pa s", "with impulse_duration_s",
         "The published impulses: as many as times_s."},
        {"impulses_half_width_Pa_s", "number > 0, Pa s", "no",
         "Half the 95 % interval of the impulses."},
        {"plateau_half_width_Pa", "number > 0, Pa", "no", "Half the 95 % interval of the plateau."},
        {"peak_table", "path below the directory of the user's records", "no",
         "The repeats' own peaks, of up to four impacts."},
        {"source", "text", "yes", ""}}},
      {"comparison",
       "[comparison]",
       "yes",
       "The window in which histories are compared.",
       {{"window_begin_s", "number >= 0, s", "yes", ""},
        {"window_end_s", "number above window_begin_s and <= duration_s, s", "no",
         "Default: duration_s."},
        {"natural_modes", "integer from 0 to 100", "yes",
         "The number of natural modes that are fitted beside the forced one: 0 for a dam or "
         "without gravity, at most 1 for a still tank's initial wave."},
        {"forcing", "\"from_spectrum\"", "no",
         "Finds the forcing frequency of a motion table from its spectrum in this window, and "
         "refuses a table that is not nearly one sine there."},
        {"forcing_angular_frequency_rad_s", "number > 0, rad/s", "no",
         "The forcing frequency of a motion table that is nearly a sine; refused where no motion "
         "is a table."},
        {"forcing_frequency_Hz", "number > 0, Hz", "no", "The same in another unit."},
        {"forcing_period_s", "number > 0, s", "no", "The same as a period."}}},
      {"run",
       "[[run]]",
       "at least one",
       "A solution of the case. These keys are common to all solvers; each solver adds its own. "
       "Where the name is a pattern, a key may hold a list: there is a run for every combination "
       "of the listed values.",
       {{"name", "name, or a pattern of keys", "yes",
         "The run's name in gate rows, reports and file names. In a pattern {key} stands for the "
         "value at the key, with a 'p' for a '.'; {particle_spacing_mm} for that length in "
         "millimetres; {start_seed:02} for a number of two digits."},
        {"solver", "text", "yes", "The solver: one of the tables below."},
        {"quick", "true or false, or a list of names or patterns", "no",
         "Whether the run belongs to the quick form of campaigns, or which of the runs of a "
         "pattern."}}},
      {"run.sph",
       "[[run]] with solver = \"sph\"",
       "no",
       "An SPH run. [SPH schemes](schemes.md) lists the schemes and their variants.",
       {{"scheme", "text", "yes",
         "The scheme: kernel, integrator, walls and terms under one name."},
        {"particle_spacing_m", "number > 0 and <= the fill depth, m", "yes",
         "The spacing dp of the particles, a hundred million at most."},
        {"surface_particle_spacing_m", "number > 0 and <= particle_spacing_m, m", "no",
         "A finer spacing at the surface, for li2010 in a tank that does not roll. Default: "
         "particle_spacing_m."},
        {"variant", "text", "no", "One part of `recommended` that is exchanged or left out."},
        {"initial_state", "\"lattice\", \"settled\" or \"projected\"", "no",
         "How the particles start: on a lattice, after they have settled, or with the impulsive "
         "start's velocity projected onto a divergence-free one. Default: the scheme's."},
        {"smoothing_length_ratio", "number from 0.5 to 10", "no",
         "h / dp, the smoothing length over the spacing. Default: the scheme's."},
        {"sound_speed_ratio", "number from 1 to 1000", "no",
         "c0 / V_max, the speed of sound over the expected largest speed. Default: the scheme's."},
        {"expected_speed", "\"estimate\" or \"coarse_run\"", "no",
         "Where V_max comes from: sqrt(g h) plus the tank's largest speed, or a first run of the "
         "same flow at a coarser spacing: see [The speed of "
         "sound](scheme_choices.md#the-speed-of-sound). A coarse run is refused where tank and "
         "liquid are at rest. Default: estimate."},
        {"courant_number", "number from 0.001 to 10", "no", "Default: the scheme's."},
        {"artificial_viscosity", "number >= 0", "no",
         "The coefficient alpha of the artificial viscosity. Default: the scheme's."},
        {"density_diffusion", "number >= 0", "no",
         "The coefficient delta of the density diffusion. Default: the scheme's."},
        {"start_disorder", "number from 0 to 0.2, particle spacings", "no",
         "Each particle's start is shifted at random by up to this much."},
        {"start_seed", "integer >= 0", "no",
         "The seed of the shifts and of drawn inputs. It needs start_disorder > 0 or "
         "vary_inputs."},
        {"start_rotation_deg", "number from 0 to 45, degrees", "no",
         "The angle by which the initial lattice is turned, in a rectangular tank without "
         "obstacles. It needs initial_state = \"settled\". Default: 0."},
        {"repeats", "integer from 2 to 1000", "no",
         "The number of runs of an ensemble, which differ only in their seed. It needs "
         "start_disorder > 0 or vary_inputs."},
        {"quick_repeats", "integer from 1 to repeats", "no",
         "How many of the repeats belong to the quick form of campaigns. It needs repeats and "
         "quick. Default: all."},
        {"vary_inputs", "true or false", "no",
         "Whether each repeat draws every [[input]] of the case anew, from the normal distribution "
         "with the declared 95 % interval, by its seed. It needs repeats. Default: false."},
        {"energy_budget", "true or false", "no",
         "Whether the run records where the liquid's energy goes."}}},
      {"run.interfoam",
       "[[run]] with solver = \"interfoam\", \"interisofoam\" or \"compressible_interfoam\"",
       "no",
       "A run of the same tank by volume of fluid with a program of OpenFOAM: interFoam keeps the "
       "interface sharp by MULES, interIsoFoam by isoAdvector, and compressibleInterFoam is "
       "interFoam for a compressible liquid (sound at 1482 m/s) and a gas that is compressed at "
       "constant temperature, 20 °C, from 101325 Pa. SPH is compared with the finest mesh of "
       "interFoam.",
       {{"cells_x", "integer from 2 to 10000", "yes", "The number of cells along the tank."},
        {"cells_z", "integer from 2 to 10000", "yes",
         "The number of cells over the tank's height."},
        {"processes", "integer from 1 to cells_x", "no",
         "The number of MPI processes. Default: 1."},
        {"courant_number", "number > 0 and <= 1", "no",
         "The largest Courant number of any cell, which shortens the time step of violent flow. "
         "Default: 0.5."},
        {"interface_courant_number", "number > 0 and <= 1", "no",
         "The largest Courant number of the cells that the interface cuts. Default: "
         "courant_number."},
        {"outer_corrections", "integer from 1 to 10", "no",
         "How often a time step solves all equations (nOuterCorrectors). With 3, "
         "compressible_interfoam keeps the liquid's volume in breaking waves; the steps then damp "
         "a wave at the rate omega^2 dt / 2. Default: 1."},
        {"no_slip", "true or false", "no",
         "Whether the liquid sticks to the walls, which cells much thinner than the Stokes layer "
         "resolve: see wall_cell_m. Default: it slips."},
        {"wall_cell_m", "number > 0, m", "no",
         "The thickness of the cells beside all walls, three to five of them in a Stokes layer. "
         "From there each cell is thicker by a fifth at most, up to uniform ones in the middle; "
         "cells_x and cells_z stay the numbers of cells. Refused with an obstacle, outline_m or "
         "diameter_m. Default: uniform cells."},
        {"cells_y", "integer from 4 to 1000", "no",
         "Solves a narrow tank in three dimensions: the number of cells across half of breadth_m, "
         "from the front wall to a plane of symmetry. They grow from wall_cell_m at the wall, each "
         "at most twice as thick as the one before; without that the last is seven times as thick "
         "as the first. It needs breadth_m and no_slip = true. Elevations are means over the gap, "
         "pressures, probes and fields are those in its middle, and loads stay per metre of "
         "breadth. Refused with an obstacle, outline_m or diameter_m. Default: two dimensions, "
         "with "
         "the friction of the front and the back wall as that of a porous medium."},
        {"start_disorder", "number from 0 to 0.2, cell heights", "no",
         "The still level is disturbed by up to this much. Only a plain level can be disturbed: "
         "not a dam, an initial wave or a tank with obstacles."},
        {"start_seed", "integer >= 0", "no", "The same as for SPH."},
        {"repeats", "integer from 2 to 1000", "no", "The same as for SPH."},
        {"quick_repeats", "integer from 1 to repeats", "no", "The same as for SPH."},
        {"vary_inputs", "true or false", "no", "The same as for SPH."}}},
      {"run.linear",
       "[[run]] with solver = \"linear\"",
       "no",
       "Linear potential theory, in closed form, or in a tank that is no rectangle by spectral "
       "elements. A dam, an obstacle, and a still tank without an "
       "initial wave are refused.",
       {{"modes", "integer from 1 to 100000", "yes, but refused for a still tank's initial wave",
         "The number of natural modes that are summed; at most 150 in a tank that is no rectangle, "
         "whose modes are computed."},
        {"two_layer", "true or false", "no",
         "Whether the gas above the liquid takes part: the form to compare interFoam with. Refused "
         "in a tank that is no rectangle."},
        {"valid_elevation_over_depth", "number > 0 and < 1, fill depths", "yes",
         "The elevation up to which the solution may judge. Beyond it the curve is drawn and never "
         "gates."}}},
      {"run.viscous_wave",
       "[[run]] with solver = \"viscous_wave\"",
       "no",
       "The exact linear wave of a viscous liquid (Prosperetti 1976), of a still tank's initial "
       "wave.",
       {{"valid_elevation_over_depth", "number > 0 and < 1, fill depths", "yes",
         "The same as for linear theory."}}},
      {"run.potential",
       "[[run]] with solver = \"potential\"",
       "no",
       "Fully nonlinear potential flow, spectral. The run ends where the solution leaves its "
       "range. A dam and an obstacle are refused.",
       {{"nodes_x", "integer from 16 to 128", "no",
         "The number of nodes along the tank. Default: 64."},
        {"nodes_z", "integer from 16 to 128", "no",
         "The number of nodes over the depth. Default: 24."}}},
      {"run.record",
       "[[run]] with solver = \"record\", shipped",
       "no",
       "A published series that lies beside the case file. It serves only as a reference.",
       {{"file", "path, relative to the case file", "yes",
         "A CSV file: time_s and a compared quantity with its unit, as in front_position_m."},
        {"time_offset_s", "number, s", "no", "Added to the file's times. Default: 0."},
        {"earlier_run", "true or false", "no",
         "Whether the series is an earlier run of this harness. Only rows of kind = \"regression\" "
         "may then rest on it."},
        {"uncertainty", "number > 0, the record's unit", "no",
         "Half the width of the record's 95 % interval."}}},
      {"run.experiment",
       "[[run]] with solver = \"record\", supplied by the user",
       "no",
       "A published series below the directory that `--experiments` or `SLOSH_EXPERIMENTS` names. "
       "Rows that need it are not compared where it is absent.",
       {{"experiment", "path below that directory", "yes", "A CSV file."},
        {"time_column", "text", "yes",
         "The name of the column of times, in s where the file does not say it."},
        {"value_column", "text", "yes", "The name of the column of values."},
        {"quantity", "compared quantity", "yes", "What the record measures."},
        {"unit", "unit of the quantity", "yes", "The unit of the values."},
        {"time_offset_s", "number, s", "no", "The same as for a shipped record."},
        {"scale", "number > 0", "no",
         "The values, and those of the band, are scale times their column. Default: 1."},
        {"lower_column", "text", "with upper_column",
         "The name of the column of a lower quantile of the experiment's repeats. The two make a "
         "band about the values, for outside_band."},
        {"upper_column", "text", "with lower_column", "The same of an upper quantile."},
        {"uncertainty", "number > 0, the record's unit", "no",
         "The same as for a shipped record."}}},
      {"run.external",
       "[[run]] with solver = \"external\"",
       "no",
       "A program of yours, started without a shell: see [Other solvers](other_solvers.md).",
       {{"command", "list of texts", "yes",
         "The program and its arguments. {case_file}, {case_directory}, {work_directory}, "
         "{tank_file}, {peers_directory}, {duration_s}, {sample_interval_s} and "
         "{particle_spacing_m} are filled in. A program with a / in its name is found relative to "
         "the case file, another on the PATH."},
        {"method", "name", "with particle_spacing_m",
         "What the program solves the case with. Runs of one method differ in their spacing alone, "
         "as those of an SPH scheme do: they have an order, a cost of an error and a curve in each "
         "figure. No run and no scheme of the case has this name."},
        {"particle_spacing_m", "number > 0 and <= the fill depth, m", "with method",
         "The spacing of the particles, another one in each run of the method."},
        {"directory", "path, relative to the case file", "no",
         "Where the program starts. Default: a fresh work directory."},
        {"time_limit_s", "number > 0, s", "no",
         "The longest wall-clock time that the program may take."},
        {"inputs", "list of paths or patterns, relative to the case file", "no",
         "Files, directories with all below them, and patterns of either that count as part of the "
         "run: a "
         "change of one file makes the run be computed again."},
        {"fail_on", "list of texts", "no",
         "Regular expressions (RE2). A line of the program's log that one of them matches "
         "makes the run fail."},
        {"cores", "integer >= 1", "no",
         "The number of cores to which the program is bound, and its OMP_NUM_THREADS. Default: it "
         "is not bound."},
        {"version_command", "list of texts", "no",
         "A program and its arguments, as in command, of which the first line of output is the "
         "version that the report names. It has a minute."},
        {"facts", "path below the work directory", "no",
         "A JSON file in which the program tells its numbers of particles and steps and its costs: "
         "see [What the program tells of "
         "itself](other_solvers.md#what-the-program-tells-of-itself)."},
        {"series", "[[run.series]]", "yes", "One table or more, below."}}},
      {"run.stored",
       "[[run]] with solver = \"stored\"",
       "no",
       "A result that another code left elsewhere: it is read, and no program is started. See "
       "[Stored results](other_solvers.md#stored-results).",
       {{"method", "name", "yes", "The same as for an external run."},
        {"particle_spacing_m", "number > 0 and <= the fill depth, m", "yes",
         "The spacing of the particles, another one in each run of the method."},
        {"facts", "path, relative to the case file", "yes",
         "A JSON file: which code, when and on which machine, and what the run took."},
        {"series", "[[run.series]]", "yes", "One table or more, below."}}},
      {"run.series",
       "[[run.series]]",
       "with solver = \"external\" or \"stored\", one or more",
       "A series that the program leaves.",
       {{"quantity", "compared quantity", "yes", "Each quantity may appear once."},
        {"file", "path", "yes",
         "The file that the program writes, below the work directory; of a stored run the file "
         "that "
         "is read, relative to the case file."},
        {"format", "text", "yes", "One of the formats of `./slosh import`."},
        {"column", "text", "yes", "The column, or the path of an HDF5 data set."},
        {"unit", "unit of the quantity", "where the file does not say it",
         "The unit of the column."},
        {"time_column", "text", "with format = \"csv\"",
         "The column of times of a csv or hdf5 file; other formats refuse it."},
        {"time_unit", "\"s\", \"ms\" or \"min\"", "where a csv or hdf5 file does not say it",
         "The unit of the times of such a file; other formats refuse it."},
        {"time_offset_s", "number, s", "no", "Added to the file's times. Default: 0."},
        {"scale", "number other than 0", "no",
         "The series is scale times the column plus offset. Default: 1."},
        {"offset", "number, the quantity's unit", "no", "Default: 0."},
        {"datum", "\"first\"", "no",
         "With `first` the first value counts as zero, in place of an offset."},
        {"whole_tank", "true or false", "no",
         "Whether the force of a gauge of DualSPHysics is that on the whole tank. Without it such "
         "a file gives the force on one wall, `force_x@WALL`."}}},
      {"run.pysph",
       "[[run]] with solver = \"pysph\"",
       "no",
       "PySPH, from Debian's package python3-pysph, by the driver that Slosh ships: see "
       "[PySPH](other_solvers.md#pysph). It is an external run of the method pysph_SCHEME. The "
       "tank surges or stands still, with or without an initial wave, and has no obstacle.",
       {{"scheme", "\"delta_sph\", \"edac\" or \"adami\"", "yes", "One of PySPH's own schemes."},
        {"particle_spacing_m", "number > 0, m", "yes",
         "A whole fraction of the tank's length and of the fill depth, another one in each run of "
         "the scheme."}}},
      {"refinement",
       "[[refinement]]",
       "no",
       "Runs that differ in one number only. They give the order and the numerical uncertainty.",
       {{"name", "name", "yes", ""},
        {"number", "text", "yes",
         "particle_spacing, smoothing_length_ratio, speed_of_sound, courant_number or mesh."},
        {"runs", "list of run names", "yes",
         "Two or more, each once: SPH runs, with number = \"particle_spacing\" also the runs of "
         "one "
         "method of an external program, or with number = \"mesh\" the runs of one program of "
         "OpenFOAM."}}},
      {"input",
       "[[input]]",
       "no",
       "An input that the experiment knows only within an interval.",
       {{"name", "text", "yes",
         "fill_depth, period, amplitude, start_phase, sensor_position, density, "
         "kinematic_viscosity "
         "or gravity, each at most once. A still tank has neither period nor amplitude nor "
         "start_phase; a tank that surges and rolls has no amplitude, and a motion by a table no "
         "start_phase."},
        {"half_width", "number > 0", "yes", "Half the width of the 95 % interval, in `unit`."},
        {"unit", "text", "yes", "The input's unit."},
        {"source", "text", "yes", ""},
        {"coarse_run", "name of an SPH or OpenFOAM run", "no",
         "Where no theory of the case holds, this run is repeated at both ends of the interval. "
         "Without it the input's share of such a row's uncertainty is unknown."}}},
      {"gate",
       "[[gate]]",
       "no",
       "One requirement, or with candidates, modes and limits several: one for each run, mode and "
       "metric that they list. Exactly one of limit, lower with upper, and improves_on is given "
       "for "
       "each metric. No two rows have the same candidate, reference, quantity, mode, metric, "
       "error, "
       "part and improves_on.",
       {{"candidate", "run name", "where candidates is absent",
         "The run that is judged. A record is never a candidate."},
        {"candidates", "list of run names or patterns", "no",
         "In place of candidate: runs, or patterns such as recommended_*, each of which must match "
         "a run. A pattern never means the reference."},
        {"reference", "run name",
         "yes, but refused with a metric of the candidate alone or of impacts",
         "What the candidate is compared with; for a metric of fields an OpenFOAM run. Beside "
         "limits it is that of the metrics that take one."},
        {"quantity", "quantity", "no",
         "A compared quantity, below. A metric of the candidate alone takes any series, one of "
         "impacts the pressure at their gauge, one of fields pressure_field, and a row against a "
         "record the record's quantity, of a pressure also the filtered one. "
         "Default: the case's first, which is that of its first gauge but for a dam's front."},
        {"mode", "text", "no",
         "forced, forced_1, ..., natural_1, ..., impact_1, ..., moment_1, ..., or whole, as the "
         "metric asks. Of "
         "impacts and of several forced modes one must be named. Default: forced where the tank "
         "moves and the metric can be of it, else "
         "natural_1; whole for the other metrics."},
        {"modes", "list of texts", "no", "In place of mode: a row for each."},
        {"metric", "text", "where limits is absent", "One of the metrics below."},
        {"limits", "table of metrics", "no",
         "In place of metric and its bound: each metric with its limit, as in "
         "limits.phase_lag = 5, or with a table of the keys that differ from those of the group, "
         "as in limits.phase_lag = { lower = 0, upper = 5, reason = \"...\" }."},
        {"unit", "text", "no",
         "The metric's unit, which a series that is not compared must name for a metric that has "
         "the quantity's. Default: the unit that it must be."},
        {"limit", "number > 0", "one of the three",
         "The largest magnitude that passes. cost_to_reach takes only a limit."},
        {"lower", "number", "one of the three",
         "With upper: the range that passes, narrower than twice the widest bound. The p-values "
         "take only a range."},
        {"upper", "number above lower", "with lower", ""},
        {"improves_on", "run name", "one of the three",
         "The candidate must be nearer to zero than this third run, by more than the intervals."},
        {"error", "number above 0 and below 1", "with metric = \"cost_to_reach\" alone",
         "The normalised rms error whose cost is bounded."},
        {"part_begin_s", "number, s, within the comparison's window",
         "with part_end_s, of outside_band alone",
         "The part of the comparison's window over which the metric is taken. Default: all of it."},
        {"part_end_s", "number above part_begin_s, s, within the comparison's window",
         "with part_begin_s", ""},
        {"kind", "\"validation\" or \"regression\"", "no",
         "Where the limit comes from: theory, experiment, requirement; or earlier measurements. "
         "Default: validation."},
        {"reason", "text", "yes, or each of limits has its own", "Why the row is there."},
        {"source", "text", "yes, but for kind = \"regression\"",
         "Where its limit comes from. Default of a regression: the measurement that the reason "
         "names."}}}};
  return tables;
}

}  // namespace slosh
