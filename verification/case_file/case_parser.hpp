// The one reader of case files (TOML, verification/cases/*.toml). Strict: an unknown or missing
// key, a wrong type, a value that no tank can have, each is refused with file:line, key, value,
// what was expected and its unit, and the nearest known key. The schema, version 1 (? marks what
// may be left out):
//
//   schema_version = 1, name, title, source, tags = [...], gravity_m_s2
//   [tank]        length_m, height_m
//   [liquid]      fill_depth_m, density_kg_m3, kinematic_viscosity_m2_s, column_width_m? (of a dam
//                 about to break: the liquid stands from the left wall to there)
//   [gas]         density_kg_m3, kinematic_viscosity_m2_s
//   [[obstacle]]? name, left_m, right_m (from the left wall), bottom_m, top_m (from the bottom)
//   [initial_wave]? mode (half waves between the walls), amplitude_m (of A cos(mode pi x / L) above
//                 the still level, x from the left wall; a crest there where above zero): the
//                 liquid is let go from rest under it; neither with column_width_m nor with an
//                 [[obstacle]]
//   [motion]      still = true, or at least one of the two tables
//   [motion.surge]? type = "sine": amplitude_m, angular_frequency_rad_s, ramp_periods?
//                 type = "table": file (CSV: time_s,displacement_m; relative to the case file)
//   [motion.roll]? type = "sine": amplitude_deg, angular_frequency_rad_s, ramp_periods?
//                 type = "table": file (CSV: time_s,angle_deg, from 0; relative to the case file)
//                 both: axis_x_m (from the left wall), axis_z_m (from the bottom); the axis moves
//                 with the tank and may lie outside it
//   [time]        start = "earth" | "tank", duration_s, sample_interval_s, snapshot_times_s?
//                 (a list of increasing multiples of sample_interval_s)
//   [animation]?  begin_s, end_s, interval_s (multiples of sample_interval_s; 3 to 60 moments): SPH
//                 and interFoam leave their fields then, and the report plays the finest of each
//   [[gauge]]?    name, x_m (from the left wall; SPH measures the depth of liquid there, which over
//                 an obstacle, and within six particle spacings of one, lacks the obstacle's share)
//   [[pressure_gauge]]? name, wall = "left" | "right" | "bottom", position_m (of the
//                 sensor's middle above the bottom; on the bottom from the left wall), width_m? (of
//                 the sensor along the wall; 0: a point), filter_cutoff_Hz? (of a low-pass filter,
//                 below half the sampling rate). At least one gauge of either kind
//   [impacts]?    gauge (a pressure gauge), times_s = [...] (published, of the peaks), period_s,
//                 peaks_Pa and peaks_sd_Pa = [...] (published mean and standard deviation over the
//                 repeats, one for each time), plateau_begin_s, plateau_end_s, plateau_Pa, source,
//                 times_half_width_s? and plateau_half_width_Pa? (of their 95 % intervals),
//                 peak_table? (the repeats' peaks, of up to four impacts: path of a file of
//                 peak_table.hpp's form below the directory that a user names)
//   [comparison]  window_begin_s, window_end_s, natural_modes (0 with column_width_m;
//                 of a still tank's initial wave at most 1),
//                 forcing_angular_frequency_rad_s? (of a table that nearly is a sine)
//   [[run]]       name, quick?, and
//                 solver = "sph": scheme, particle_spacing_m, surface_particle_spacing_m?,
//                 variant?, initial_state? = "lattice" | "settled" | "projected", and changes of
//                 the scheme's numbers: smoothing_length_ratio?, sound_speed_ratio?,
//                 courant_number?, artificial_viscosity?, density_diffusion?; start_disorder?
//                 (each particle's start is shifted by up to this many spacings, at most 0.2) and
//                 then start_seed? (an integer >= 0: of runs that repeat one another) and repeats?
//                 (an ensemble of so many, ensemble.hpp);
//                 energy_budget? (records where the liquid's energy goes)
//                 solver = "interfoam": cells_x, cells_z, processes?; start_disorder? (the level is
//                 waved by up to this many heights of a cell, at most 0.2) and then start_seed? and
//                 repeats?
//                 solver = "linear": modes (not of a still tank's initial wave), two_layer?,
//                 valid_elevation_over_depth
//                 solver = "viscous_wave": valid_elevation_over_depth
//                 solver = "record": a published series, with uncertainty? (half width of its 95 %
//                 interval, in the record's unit), either shipped: file (CSV: time_s and a compared
//                 quantity with its unit, as in front_position_m; relative to the case file; with
//                 earlier_run = true what a run of this harness gave earlier, for rows with kind =
//                 "regression" alone), or
//                 supplied by the user: experiment (a CSV file's path below a directory that the
//                 user names), time_column (in s) and value_column (their names in the file's first
//                 line), quantity, unit (one of units.hpp's for it)
//                 solver = "external": a program of the user's own: command = [program,
//                 arguments...] (no shell; a program with a / in its name lies relative to the case
//                 file, another on the PATH; placeholders {case_file}, {case_directory},
//                 {work_directory}, {duration_s}, {sample_interval_s}), directory? (in which it
//                 starts, relative to the case file; else its fresh work directory), time_limit_s?
//                 (of wall time), inputs? = [files, relative to the case file] (whose content is
//                 part of the run's key, as the program's is), and
//                 [[run.series]], one or more: quantity (a compared one, each once), file (below
//                 the work directory), format (one of import/import_series.hpp's), column, unit?
//                 (one of units.hpp's for it; where the file does not say it), time_column?,
//                 time_unit? (of a csv or hdf5 file), scale?, offset? (in the quantity's unit: the
//                 series is scale times the column plus offset)
//   [[input]]?    name (of inputs.hpp), half_width (of the 95 % interval to which the experiment
//                 knows it), unit, source
//   [[gate]]?     candidate, reference, quantity (one of quantities.hpp's that the case has), mode,
//                 metric, unit, one of limit | lower with upper | improves_on, kind? (of
//                 row_kind.hpp), reason, source; with
//                 metric = "largest_magnitude", which is measured on the candidate alone: no
//                 reference, quantity = any series of its result, its unit; metric = "time_lag" and
//                 "aligned_rms" are of quantities without modes alone; metric = "impact_time",
//                 "impact_percentile" (mode = "impact_1", ...; the latter with lower and upper) and
//                 "plateau_error" are measured against [impacts]: no reference, quantity = the
//                 pressure at its gauge, as it is or "/filtered"; metric = "cost_to_reach" (of the
//                 candidate's family, in s of one core; mode = "whole", with limit alone) needs
//                 error (a normalised rms, 0 to 1). No bound is as wide as metric_table.hpp's, and
//                 no two rows bound the same metric of the same runs (an improvement on another run
//                 may stand beside a limit)
//
// The names of SPH schemes and their variants are not known here: whoever starts a run checks its
// own.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case_file/case_definition.hpp"
#include "verification/case_file/case_file_error.hpp"

namespace slosh {

// `experiments` is the directory of the user's records, empty where none is named; a record that is
// not there is read as not supplied. Throws CaseFileError; of all that is wrong in the file's
// tables CaseFileErrors (complaints.hpp), but for what may only follow from another mistake.
CaseDefinition read_case(const std::filesystem::path& file,
                         const std::filesystem::path& experiments = {});

// The file of a case: a path (it holds a / or ends in .toml), or the name of a case in the
// directory. Throws CaseFileError when there is none, with the nearest names.
std::filesystem::path find_case(const std::string& name_or_path,
                                const std::filesystem::path& directory);

}  // namespace slosh
