// A case: one sloshing experiment, as every solver, reference, metric and gate is told of it. Plain
// data, SI units; only case_parser.hpp makes one from a file, and it hands over none that is not
// physically possible.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "verification/input/case_file_error.hpp"

namespace slosh {

struct TankDefinition {
  double length;  // [m], along x
  double height;  // [m], roof above bottom
};

struct LiquidDefinition {
  double fill_depth;           // [m], still water
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
  // A dam about to break: the liquid stands from the left wall to here [m], and fills the tank's
  // length otherwise.
  std::optional<double> column_width = {};
};

// A rectangle that the tank carries, from its left wall and its bottom [m].
struct ObstacleDefinition {
  std::string name;
  double left, right, bottom, top;
};

// The surface at the start, A cos(m pi x / L) above the still level, x from the left wall, m half
// waves between the walls; the liquid under it is let go from rest.
struct InitialWaveDefinition {
  int mode;          // m
  double amplitude;  // A [m], above zero with the crest at the left wall
};

// What fills the tank above the liquid; seen by interFoam and by the two-layer linear theory.
struct GasDefinition {
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
};

// amplitude sin(omega t), times a smooth ramp over the first ramp_periods periods (0: none).
struct SineMotion {
  double amplitude;          // [m], or [rad]
  double angular_frequency;  // [rad/s]
  double ramp_periods = 0;
};

// From a CSV file (path relative to the case file), at least four points.
struct TableMotion {
  std::filesystem::path file;
  std::vector<double> time, value;  // [s]; [m], or [rad]
};

using MotionHistory = std::variant<SineMotion, TableMotion>;

// theta(t), positive counter-clockwise, about a point that the tank carries; it may lie outside it.
struct RollDefinition {
  MotionHistory angle;
  double axis_x, axis_z;  // [m] from the left wall and from the bottom
};

// The tank surges, rolls, does both or stands.
struct MotionDefinition {
  std::optional<MotionHistory> surge = {};
  std::optional<RollDefinition> roll = {};

  bool still() const { return !surge && !roll; }
};

// At rest in the earth's frame (the tank is set off with X'(0)), or at rest relative to the tank.
enum class Start { earth, tank };

// Free-surface elevation above the still level at a place fixed in the tank.
struct GaugeDefinition {
  std::string name;
  double x;  // [m] from the left wall
};

enum class Wall { left, right, bottom };

// Pressure on a wall of the tank above that of the gas, the mean over a sensor's width; 0: at a
// point. With a cutoff it is also recorded through a low-pass filter.
struct PressureGaugeDefinition {
  std::string name;
  Wall wall;
  double position;                           // [m], of the sensor's middle: above the bottom; on
                                             // the bottom from the left wall
  double width = 0;                          // [m], along the wall
  std::optional<double> filter_cutoff = {};  // [Hz]
};

// What a run changes of its scheme's own numbers, none of which has a unit; absent: as the scheme
// has it.
struct SphNumbers {
  std::optional<double> smoothing_length_ratio;  // h / particle spacing
  std::optional<double> sound_speed_ratio;       // c0 / largest expected speed of the liquid
  std::optional<double> courant_number;          // dt c0 / h
  std::optional<double> artificial_viscosity;    // alpha
  std::optional<double> density_diffusion;       // delta

  bool operator==(const SphNumbers&) const = default;
};

// Their names in case files and results: one list for whoever reads, hashes or shows them.
inline constexpr std::pair<const char*, std::optional<double> SphNumbers::*> sph_number_names[] = {
    {"smoothing_length_ratio", &SphNumbers::smoothing_length_ratio},
    {"sound_speed_ratio", &SphNumbers::sound_speed_ratio},
    {"courant_number", &SphNumbers::courant_number},
    {"artificial_viscosity", &SphNumbers::artificial_viscosity},
    {"density_diffusion", &SphNumbers::density_diffusion}};

struct SphRun {
  std::string scheme;               // a name of sph/schemes.hpp's closed list
  double particle_spacing;          // [m], inside the liquid
  double surface_particle_spacing;  // [m], near the free surface; equal to particle_spacing unless
                                    // given
  std::string variant = {};         // of the scheme, one thing changed; empty: none
  std::string initial_state = {};   // lattice, settled or projected; empty: the scheme's own
  SphNumbers numbers = {};
  // Each particle starts this far from its place at most [particle spacings], in a direction that
  // the seed decides: repeats of one run, as an experiment is repeated.
  double start_disorder = 0;
  int start_seed = 0;
  bool energy_budget = false;  // record where the liquid's energy goes

  bool operator==(const SphRun&) const = default;
};

struct InterFoamRun {
  int cells_x, cells_z;
  int processes = 1;  // above 1: decomposePar and mpirun
  // The surface starts this far from its place at most [heights of a cell], as the seed decides:
  // repeats of one run.
  double start_disorder = 0;
  int start_seed = 0;
};

// Linear potential flow (reference/linear_surge.hpp, standing_wave.hpp). It may gate while the
// highest elevation that it predicts stays below valid_elevation_over_depth times the fill depth.
struct LinearRun {
  int modes;               // that the tank's motion excites; 0 of a tank that stands
  bool two_layer = false;  // count the gas in the dispersion relation
  double valid_elevation_over_depth;
};

// Fully nonlinear potential flow (reference/nonlinear_potential_flow.hpp). It may gate where it has
// not left its own range before the comparison's window ends.
struct PotentialRun {
  int nodes_x = 64, nodes_z = 24;
};

// The free wave of a viscous liquid (reference/viscous_standing_wave.hpp); it may gate as linear
// theory.
struct ViscousWaveRun {
  double valid_elevation_over_depth;
};

// A published record of one quantity, from a CSV file; it may gate. What the project ships is
// there; what only its user has may not be.
struct RecordRun {
  std::filesystem::path file;  // where it lies, or where it was looked for
  std::string quantity, unit;
  std::vector<double> time, value;    // [s], unit; none where it is not supplied
  std::optional<double> uncertainty;  // half width of the values' 95 % interval, in the unit
  bool supplied = true;
  // What a run of this harness gave earlier: it tells what has moved and not what is right, so that
  // rows of regression alone may rest on it and nothing else is compared with it.
  bool earlier_run = false;
};

// Where a quantity stands in a file of another program (verification/import/), and how it becomes
// ours: scale times the column's value in the quantity's unit, plus offset in that unit.
struct SeriesSource {
  std::string quantity;  // of quantities.hpp
  std::filesystem::path file;
  std::string format, column;
  std::string unit = {};                         // of the column; empty: as the file says
  std::string time_column = {}, time_unit = {};  // where the format does not fix them
  double scale = 1, offset = 0;
};

// A program of the user's own that is started for the case and leaves files of series. It is a
// candidate, compared as SPH is.
struct ExternalRun {
  std::vector<std::string> command;           // program and arguments, with placeholders in braces
  std::filesystem::path directory;            // in which it is started; empty: its work directory
  std::optional<double> time_limit;           // [s] of wall time
  std::vector<std::filesystem::path> inputs;  // whose content counts as part of the run
  std::vector<SeriesSource> series;           // their files are below the work directory
};

enum class RefinedNumber {
  particle_spacing,
  smoothing_length_ratio,  // the step is its inverse: more neighbours
  speed_of_sound,          // the step is its inverse: less compressible
  courant_number,
  mesh  // the step is the root of a cell's area
};

// Runs that are alike but for one number, from which the numerical uncertainty is estimated.
struct RefinementDefinition {
  std::string name;
  RefinedNumber number;
  std::vector<std::string> runs;
};

// What every solver is told of an experiment, and what the experiment knew only so well.
enum class Input {
  fill_depth,           // m
  period,               // s, of the motion
  amplitude,            // m, or deg of a roll
  sensor_position,      // m, of every gauge, along x or along its wall
  density,              // kg/m3
  kinematic_viscosity,  // m2/s
  gravity               // m/s2
};

// Half width of the 95 % interval of an input, in its unit.
struct InputUncertainty {
  Input input;
  double half_width;
  std::string source;
  std::string coarse_run = {};  // repeated at both ends of the interval; empty: theory alone tells
};

// An end of an input's interval, and the run that is repeated there.
struct InputEnd {
  Input input;
  double change;  // in the input's unit, minus or plus the half width
  std::string repeated_run;
};

struct RunDefinition {
  std::string name;
  std::variant<SphRun, InterFoamRun, LinearRun, ViscousWaveRun, PotentialRun, RecordRun,
               ExternalRun>
      solver;
  bool quick = false;  // part of the campaign's --quick form
  SourceLocation where;
  // The first member's name, of each of the runs into which repeats = N makes one [[run]]; they
  // differ in the seed of their disturbed start alone. Empty: a run for itself.
  std::string ensemble = {};
  // Of a run that the case adds for its uncertain input: it solves the case with that input
  // changed (changed_input.hpp).
  std::optional<InputEnd> at_input = {};
};

enum class Metric {
  amplitude_error,    // 1
  phase_lag,          // deg
  frequency_error,    // 1
  decay_rate,         // 1/s, of the candidate
  decay_error,        // 1, of the candidate's decay rate
  normalised_rms,     // 1, whole window
  maximum_residual,   // the quantity's unit, whole window
  time_lag,           // s, whole window; of a quantity without modes, as the next
  aligned_rms,        // 1, whole window, free of that lag
  largest_magnitude,  // the quantity's unit, whole window; of the candidate alone
  // Of waves whose single crests are chance (wave_statistics.hpp, spectrum.hpp), each a ratio less
  // 1 but for the lag and the last three.
  band_energy_error,  // 1, of one mode: energy within a fifth of its frequency to either side
  // deg of the first mode's period, whole window: one lag of the whole wave (cross_correlation.hpp)
  cross_correlation_lag,
  spectral_peak_error,  // 1, whole window: frequency of the highest peak
  rms_error,            // 1, whole window: deviation from the mean
  crest_error,          // 1, whole window: mean over the periods of the highest value
  trough_error,         // 1, whole window: mean over the periods of the lowest value
  mean_offset,          // the quantity's unit, whole window: mean less the reference's
  noise_share,          // 1, whole window: white noise over the deviation, of the candidate alone
  initial_value,        // the quantity's unit: at the start of the time, of the candidate alone
  // Of the candidate's impacts against the published ones (impact_metrics.hpp).
  impact_time,        // s, one impact: that of its peak less the published one
  plateau_error,      // 1, "whole": mean over the plateau's time over the published one, less 1
  impact_percentile,  // 1, one impact: the share of the experiment's repeats that peak below it
  // s of one core, "whole": what the row's error costs the candidate's family (work_precision.hpp).
  cost_to_reach
};

// What a row's limit comes from, and so what its passing tells.
enum class RowKind {
  validation,  // from theory, an experiment, a standard, a requirement or a stated tolerance
  regression   // from what was measured before: it tells that nothing has become worse
};

// One visible row of the gate. Passes when |value| <= limit, or when lower <= value <= upper, or
// when |value| is below that of the run `improves_on` for the same row: exactly one of the three is
// given.
struct GateRow {
  std::string candidate, reference;  // run names; no reference where the metric needs none
  // One of compared_quantities(); of the candidate alone any series of its result.
  std::string quantity;
  // "forced", "natural_1", "natural_2", ... (of natural_modes.hpp, lowest first),
  // "impact_1", "impact_2", ... (the published ones), "whole"
  std::string mode;
  Metric metric;
  std::string unit;
  std::optional<double> limit;
  std::optional<std::pair<double, double>> between;
  std::optional<std::string> improves_on;
  std::string reason, source;
  SourceLocation where;
  std::optional<double> error = {};  // normalised rms, of cost_to_reach alone
  RowKind kind = RowKind::validation;
};

// What is published of a tank in which the liquid hits a wall once a period: peaks and plateau of
// the pressure at one gauge, over repeats of the experiment.
struct ImpactsDefinition {
  std::string gauge;                                // of pressure
  std::vector<double> times;                        // [s], of the peaks in the published record
  double period;                                    // [s], of the motion
  std::vector<double> peak_means, peak_deviations;  // [Pa], by impact: mean and standard deviation
  double plateau_begin, plateau_end;                // [s], after an impact
  double plateau;                                   // [Pa], the published record's mean there
  // Half widths of the 95 % intervals of the times [s] and of the plateau [Pa], where published.
  std::optional<double> times_half_width = {}, plateau_half_width = {};
  // The table of the repeats: where it lies, or where it was looked for; empty where the case names
  // none. Its peaks [Pa] by impact, none where it is not supplied.
  std::filesystem::path peak_table;
  std::vector<std::vector<double>> repeats;
  std::string source;
};

struct CaseDefinition {
  std::string name, title, source;
  std::vector<std::string> tags;
  double gravity;  // [m/s2]
  TankDefinition tank;
  LiquidDefinition liquid;
  GasDefinition gas;
  std::vector<ObstacleDefinition> obstacles;
  std::optional<InitialWaveDefinition> initial_wave = {};
  MotionDefinition motion;
  Start start;
  double duration;         // [s]
  double sample_interval;  // [s], of every recorded series
  // [s], when a run leaves its whole fields; increasing multiples of the sample interval
  std::vector<double> snapshot_times;
  std::vector<double> animation_times = {};  // likewise, evenly spaced; none: no animation
  std::vector<GaugeDefinition> gauges;
  std::vector<PressureGaugeDefinition> pressure_gauges;
  std::optional<ImpactsDefinition> impacts = {};
  // The comparison: the window and how many natural modes (natural_modes.hpp) are fitted beside the
  // forced one.
  double window_begin, window_end;  // [s]
  // [rad/s], of a tank that nearly follows a sine, but after a table
  std::optional<double> declared_forcing_frequency;
  int natural_modes;
  std::vector<RunDefinition> runs;
  std::vector<RefinementDefinition> refinements = {};
  std::vector<InputUncertainty> inputs = {};  // each input once; none where nothing is declared
  std::vector<GateRow> gate;
  std::string text;  // the file as read
  std::filesystem::path file;
};

// The run's definition by its name. Throws std::invalid_argument where the case has none.
inline const RunDefinition& run_named(const CaseDefinition& definition, const std::string& name) {
  for (const RunDefinition& run : definition.runs)
    if (run.name == name) return run;
  throw std::invalid_argument("case " + definition.name + " has no run " + name);
}

}  // namespace slosh
