// A case: one sloshing experiment, as every solver, reference, metric and gate sees it. It is plain
// data in SI units. Only case_parser.hpp makes one from a file, and it refuses cases that are
// physically impossible.
#pragma once

#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "verification/case/metric_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/enum_names.hpp"

namespace slosh {

inline constexpr double radians_per_degree = std::numbers::pi / 180;

// A place in the tank [m], from its left end and above its lowest place.
struct Corner {
  double x, z;
};

struct TankDefinition {
  double length;  // [m], along x
  double height;  // [m], roof above bottom
  // [m] Between the gap walls, which are parallel to the section. Given, it makes SPH, interFoam
  // and interIsoFoam count the friction of these walls (gap_friction.hpp), which they do not see
  // otherwise.
  std::optional<double> breadth = {};
  // The corners of a tank that is no rectangle, counter-clockwise: a simple polygon that each
  // horizontal line meets in one piece (outline.hpp). Length and height are then those of the
  // rectangle around it, which begins at (0, 0).
  std::vector<Corner> outline = {};
  std::optional<double> diameter = {};  // [m], where the outline is that of a lying cylinder
};

struct LiquidDefinition {
  double fill_depth;           // [m], still water
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
  // [m] The width of a dam about to break, which stands at the left wall. Without it the liquid
  // fills the tank's length.
  std::optional<double> column_width = {};
};

// A solid rectangle fixed to the tank. Its sides are measured from the tank's left wall and bottom
// [m].
struct ObstacleDefinition {
  std::string name;
  double left, right, bottom, top;
};

// The elevation of the surface at the start, A cos(m pi x / L), with x from the left wall: m half
// waves between the walls. The liquid is released from rest.
struct InitialWaveDefinition {
  int mode;          // m
  double amplitude;  // A [m], positive if the crest is at the left wall
};

// The gas above the liquid. Only OpenFOAM's programs and the two-layer linear theory use it.
struct GasDefinition {
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
};

// amplitude sin(omega t + phase), times a smooth ramp over the first ramp_periods periods (0: no
// ramp).
struct SineMotion {
  double amplitude;          // [m], or [rad]
  double angular_frequency;  // [rad/s]
  double ramp_periods = 0;
  double phase = 0;  // [rad]
};

// The sum of two sines or more, each with its own ramp.
struct SumOfSines {
  std::vector<SineMotion> sines;
};

// A motion read from a CSV file (path relative to the case file), of at least four points.
struct TableMotion {
  std::filesystem::path file;
  std::vector<double> time, value;  // [s]; [m], or [rad]
  bool of_accelerations = false;    // whether the file holds these, and not positions
  double largest = 0;               // the largest magnitude in the file during the case [SI]
};

using MotionHistory = std::variant<SineMotion, SumOfSines, TableMotion>;

// theta(t), positive counter-clockwise, about an axis that is fixed to the tank and may lie outside
// it.
struct RollDefinition {
  MotionHistory angle;
  double axis_x, axis_z;  // [m] from the left wall and from the bottom
};

// How well the frequency is known that was found from the spectrum of a motion's table, within the
// window of the comparison.
struct FoundForcing {
  double half_width;  // [rad/s], of its 95 % interval
  double rest;        // the rms of the rest of the motion over that of the sine
};

// The tank surges, rolls, does both or stands still.
struct MotionDefinition {
  std::optional<MotionHistory> surge = {};
  std::optional<RollDefinition> roll = {};

  bool still() const { return !surge && !roll; }
};

// The frame in which the liquid is first at rest: the earth's (the tank starts with the velocity
// X'(0)) or the tank's.
enum class Start { earth, tank };

inline constexpr EnumName<Start> start_names[] = {{Start::earth, "earth"}, {Start::tank, "tank"}};

// Measures the elevation of the free surface above the still level at a place fixed in the tank.
struct GaugeDefinition {
  std::string name;
  double x;  // [m] from the left wall, or from the left end of an outline
};

enum class Wall { left, right, bottom, roof };

inline constexpr EnumName<Wall> wall_names[] = {
    {Wall::left, "left"}, {Wall::right, "right"}, {Wall::bottom, "bottom"}, {Wall::roof, "roof"}};

// Measures the pressure on a wall of the tank above that of the gas, as a mean over the sensor's
// width or, for the width 0, at a point. With a cutoff frequency there is also a low-pass filtered
// series.
struct PressureGaugeDefinition {
  std::string name;
  Wall wall;
  double position;                           // [m], of the sensor's middle: above the bottom; on
                                             // bottom and roof from the left wall
  double width = 0;                          // [m], along the wall
  std::optional<double> filter_cutoff = {};  // [Hz]
  // The sensor's middle on the outline of a tank that is no rectangle; wall and position then say
  // nothing.
  std::optional<Corner> at = {};
};

// Measures the liquid's velocity relative to the tank, and its pressure above that of the gas, at a
// place fixed in the tank. Where the surface is below that place, all three are zero.
struct ProbeDefinition {
  std::string name;
  double x, z;  // [m] from the left wall and above the bottom
};

// The dimensionless numbers of its scheme that a run changes. An absent one keeps the scheme's
// value.
struct SphNumbers {
  std::optional<double> smoothing_length_ratio;  // h / particle spacing
  std::optional<double> sound_speed_ratio;       // c0 / largest expected speed of the liquid
  std::optional<double> courant_number;          // dt c0 / h
  std::optional<double> artificial_viscosity;    // alpha
  std::optional<double> density_diffusion;       // delta

  bool operator==(const SphNumbers&) const = default;
};

// Their names in case files and results.
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
  double start_rotation_deg = 0;  // by which the initial lattice is turned
  bool energy_budget = false;     // record where the liquid's energy goes
  // The largest speed that the speed of sound follows is measured by a coarse run, not estimated.
  bool speed_from_coarse_run = false;

  bool operator==(const SphRun&) const = default;
};

// The programs of OpenFOAM that solve a case by volume of fluid: interFoam keeps the interface
// sharp by MULES, interIsoFoam by isoAdvector, and compressibleInterFoam is interFoam for
// compressible fluids.
enum class FoamProgram { inter_foam, inter_iso_foam, compressible_inter_foam };

inline constexpr EnumName<FoamProgram> foam_program_names[] = {
    {FoamProgram::inter_foam, "interFoam"},
    {FoamProgram::inter_iso_foam, "interIsoFoam"},
    {FoamProgram::compressible_inter_foam, "compressibleInterFoam"}};

// A run of interFoam or of a program of its family.
struct InterFoamRun {
  int cells_x, cells_z;
  int processes = 1;  // above 1: decomposePar and mpirun
  // The surface starts this far from its place at most [heights of a cell], as the seed decides:
  // repeats of one run.
  double start_disorder = 0;
  int start_seed = 0;
  FoamProgram program = FoamProgram::inter_foam;
  double courant_number = 0.5;            // the largest of any cell
  double interface_courant_number = 0.5;  // the largest of the cells that the interface cuts
  int outer_corrections = 1;              // solutions of all equations in a time step
  bool no_slip = false;                   // the liquid sticks to the walls
  // [m], of the cells beside the walls, from where they grow to uniform ones in the middle. Without
  // it all cells are uniform.
  std::optional<double> wall_cell = {};
  // Across half of the gap of a narrow tank, which is then
  // solved in three dimensions. Without it the case is one in two, with the friction of these walls
  // as that of a porous medium.
  std::optional<int> cells_y = {};
};

// In the rectangle around the tank's outline.
inline double number_of_cells(const InterFoamRun& run) {
  return 1.0 * run.cells_x * run.cells_y.value_or(1) * run.cells_z;
}

// Linear potential flow (reference/linear_surge.hpp, standing_wave.hpp). It may gate while the
// highest elevation that it predicts stays below valid_elevation_over_depth times the fill depth.
struct LinearRun {
  int modes;               // that the tank's motion excites; 0 of a still tank
  bool two_layer = false;  // of liquid and gas, else of the liquid alone
  double valid_elevation_over_depth;
};

// Fully nonlinear potential flow (reference/potential_flow/nonlinear_potential_flow.hpp). It may
// gate where it has not left its own range before the comparison's window ends.
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
  // The quantiles of the experiment's repeats about the values, at the same times. The edges are
  // empty where the record is not supplied.
  bool has_band = false;
  std::vector<double> lower = {}, upper = {};
  // What a run of this harness gave earlier: it tells what has moved and not what is right, so that
  // rows of regression alone may rest on it and nothing else is compared with it.
  bool earlier_run = false;
};

// Where a quantity stands in a file of another program (verification/import/), and how it becomes
// ours: scale times the column's value in the quantity's unit, plus offset in that unit, less the
// first of these values where first_is_zero.
struct SeriesSource {
  std::string quantity;  // of quantities.hpp
  std::filesystem::path file;
  std::string format, column;
  std::string unit = {};                         // of the column; empty: as the file says
  std::string time_column = {}, time_unit = {};  // where the format does not fix them
  double scale = 1, offset = 0;
  double time_offset = 0;  // [s], added to the file's times
  bool first_is_zero = false;
  // The file's force is that on the whole tank, where its format is of forces on parts of it.
  bool whole_tank = false;
};

// A program of the user's own that is started for the case and leaves files of series. It is a
// candidate, compared as SPH is.
struct ExternalRun {
  std::vector<std::string> command;       // program and arguments, with placeholders in braces
  std::filesystem::path directory = {};   // in which it is started; empty: its work directory
  std::optional<double> time_limit = {};  // [s] of wall time
  std::vector<std::filesystem::path> inputs = {};  // whose content counts as part of the run
  std::vector<SeriesSource> series = {};           // their files are below the work directory
  // Runs of one method differ in their particle spacing alone; a run without one has no family.
  std::string method = {};
  std::optional<double> particle_spacing = {};  // [m]
  // What the program tells of itself (external_facts.hpp), below the work directory; empty:
  // nothing.
  std::filesystem::path facts = {};
  std::vector<std::string> version_command = {};  // as `command`; it prints the program's version
  // Regular expressions: a line of the program's log that one of them matches is a failure.
  std::vector<std::string> fail_on = {};
  std::optional<int> cores = {};  // to which it is bound
};

// Series that another code left elsewhere and that are only read: the result of a code that is not
// installed. It is a candidate of its method.
struct StoredRun {
  std::vector<SeriesSource> series;  // their files lie beside the case file
  std::string method;                // as of an external run
  double particle_spacing;           // [m]
  // Which code, when and on which machine, and what it took (external_facts.hpp).
  std::filesystem::path facts;
};

enum class RefinedNumber {
  particle_spacing,
  smoothing_length_ratio,  // the step is its inverse: more neighbours
  speed_of_sound,          // the step is its inverse: less compressible
  courant_number,
  mesh  // the step is the root of a cell's area
};

// Runs that differ in one number only. The numerical uncertainty is estimated from them.
struct RefinementDefinition {
  std::string name;
  RefinedNumber number;
  std::vector<std::string> runs;
};

// Inputs of a case that the experiment may know only within an interval.
enum class Input {
  fill_depth,           // m
  period,               // s, of the motion
  amplitude,            // m, or deg of a roll
  sensor_position,      // m, of every gauge, along x or along its wall
  density,              // kg/m3
  kinematic_viscosity,  // m2/s
  gravity,              // m/s2
  start_phase           // deg, of a motion of sines at the start
};

inline constexpr EnumName<Input> input_names[] = {
    {Input::fill_depth, "fill_depth"}, {Input::period, "period"},
    {Input::amplitude, "amplitude"},   {Input::sensor_position, "sensor_position"},
    {Input::density, "density"},       {Input::kinematic_viscosity, "kinematic_viscosity"},
    {Input::gravity, "gravity"},       {Input::start_phase, "start_phase"}};

// The half width of the 95 % interval of an input, in its unit.
struct InputUncertainty {
  Input input;
  double half_width;
  std::string source;
  std::string coarse_run = {};  // repeated at both ends of the interval; empty: theory alone
};

// One end of an input's interval, and the run that is repeated there.
struct InputEnd {
  Input input;
  double change;  // in the input's unit, minus or plus the half width
  std::string repeated_run;
};

// A change of an input, in its unit.
struct InputChange {
  Input input;
  double change;

  bool operator==(const InputChange&) const = default;
};

struct RunDefinition {
  std::string name;
  std::variant<SphRun, InterFoamRun, LinearRun, ViscousWaveRun, PotentialRun, RecordRun,
               ExternalRun, StoredRun>
      solver;
  bool quick = false;  // part of the campaign's --quick form
  SourceLocation where;
  // The name of the ensemble's first member, if repeats = N makes an ensemble of the [[run]] whose
  // members differ only in the seed of their disturbed start. Empty for a single run.
  std::string ensemble = {};
  // Set for a run that the case adds for an uncertain input: it solves the case with this input
  // changed (changed_input.hpp).
  std::optional<InputEnd> at_input = {};
  // A member of an ensemble with vary_inputs solves the case with these inputs changed, each drawn
  // from its interval (ensemble.hpp).
  bool varies_inputs = false;
  std::vector<InputChange> drawn_inputs = {};
};

// Where a row's limit comes from, and so what its passing shows. A row is of validation, the
// stricter kind, unless the file says otherwise.
enum class RowKind {
  validation,  // from theory, an experiment, a standard, a requirement or a stated tolerance
  regression   // from earlier measurements: passing shows that nothing has become worse
};

inline constexpr EnumName<RowKind> row_kind_names[] = {{RowKind::validation, "validation"},
                                                       {RowKind::regression, "regression"}};

inline std::string kind_name(RowKind kind) { return name_of(kind, row_kind_names); }

// One row of the gate. It passes if |value| <= limit, if lower <= value <= upper, or if |value| is
// below that of the run `improves_on`. Exactly one of the three is given.
struct GateRow {
  std::string candidate, reference;  // run names; empty: the metric needs no reference
  // One of compared_quantities(). A metric of the candidate alone takes any series of its result.
  std::string quantity;
  // "forced", "natural_1", "natural_3", ... (natural_modes() in quantities.hpp, lowest first),
  // "impact_1", "impact_2", ... (the published ones), or "whole"
  std::string mode;
  Metric metric;
  std::string unit;
  std::optional<double> limit;
  std::optional<std::pair<double, double>> between;
  std::optional<std::string> improves_on;
  std::string reason, source;
  SourceLocation where;
  std::optional<double> error = {};  // normalised rms, for cost_to_reach only
  RowKind kind = RowKind::validation;
  // The part of the run [s] over which the row is judged; without it judged_time() says which.
  std::optional<std::pair<double, double>> part = {};
};

// The published arrivals of impacts: when the pressure comes to a share of the peak and holds it.
struct ArrivalsDefinition {
  double share;                           // of each mean peak
  std::vector<double> times;              // [s], by impact
  std::optional<double> half_width = {};  // [s], of the 95 % interval of the times, if published
};

// The published rise times of impacts (rise_time() of series/impact_peaks.hpp).
struct RiseTimesDefinition {
  std::vector<double> values;             // [s], by impact
  std::optional<double> half_width = {};  // [s], of their 95 % interval, if published
};

// The published impulses: the integral of the pressure over a time after the arrival.
struct ImpulsesDefinition {
  double duration;                        // [s], from the arrival on
  std::vector<double> values;             // [Pa s], by impact
  std::optional<double> half_width = {};  // [Pa s], of the 95 % interval, if published
};

// Published measurements of a tank in which the liquid hits a wall, once or once a period: the
// peaks, the arrivals, the impulses and the plateau of the pressure at one gauge, over repeats of
// the experiment.
struct ImpactsDefinition {
  std::string gauge;          // of pressure
  std::vector<double> times;  // [s], of the peaks in the published record
  // [s], of the motion; of a single impact four times the time within which it is sought to either
  // side.
  double period;
  std::vector<double> peak_means;       // [Pa], by impact
  std::vector<double> peak_deviations;  // [Pa], by impact, if published, else empty
  // [s], after an impact, and the published record's mean there [Pa]; 0 where none is published.
  double plateau_begin, plateau_end, plateau;
  // The half widths of the 95 % intervals of the plateau and of the mean peaks [Pa], if published.
  std::optional<double> plateau_half_width = {}, peaks_half_width = {};
  // The table of the repeats: the path where it lies or should lie (empty: the case names none),
  // and its peaks [Pa] by impact (empty: it is not supplied).
  std::filesystem::path peak_table;
  std::vector<std::vector<double>> repeats;
  std::string source;
  std::optional<ArrivalsDefinition> arrivals = {};
  std::optional<ImpulsesDefinition> impulses = {};
  std::optional<RiseTimesDefinition> rise_times = {};
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
  // [s], the times at which a run writes its fields: increasing multiples of the sample interval
  std::vector<double> snapshot_times;
  std::vector<double> animation_times = {};  // [s], likewise, evenly spaced; empty: no animation
  std::vector<GaugeDefinition> gauges;
  std::vector<PressureGaugeDefinition> pressure_gauges;
  std::vector<ProbeDefinition> probes = {};
  std::vector<Wall> wall_forces = {};  // the walls on which the force is recorded
  std::optional<ImpactsDefinition> impacts = {};
  // The comparison: its window, and the number of natural modes (quantities.hpp) that are fitted
  // beside the forced one.
  double window_begin, window_end;  // [s]
  // [rad/s], for a motion table that is nearly a sine
  std::optional<double> declared_forcing_frequency;
  std::optional<FoundForcing> found_forcing = {};  // where it was found from the table's spectrum
  int natural_modes;
  std::vector<RunDefinition> runs;
  std::vector<RefinementDefinition> refinements = {};
  std::vector<InputUncertainty> inputs = {};  // each input at most once
  std::vector<GateRow> gate;
  std::string text;  // the file as read
  std::filesystem::path file;
  std::filesystem::path experiments = {};  // the directory of the user's records; may be empty
};

// Returns the definition of a run. Throws std::invalid_argument for a name that no run has.
inline const RunDefinition& run_named(const CaseDefinition& definition, const std::string& name) {
  for (const RunDefinition& run : definition.runs)
    if (run.name == name) return run;
  throw std::invalid_argument("case " + definition.name + " has no run " + name);
}

// [s], over which the row is judged: its part of the run, or else of a series of the candidate
// alone the whole run and of any other metric the comparison's window.
inline std::pair<double, double> judged_time(const GateRow& row, const CaseDefinition& definition) {
  if (row.part) return *row.part;
  if (metric_entry(row.metric).measured_on == MeasuredOn::own_series)
    return {0, definition.duration};
  return {definition.window_begin, definition.window_end};
}

// The case with that time as the comparison's window.
inline CaseDefinition judged_over(const GateRow& row, CaseDefinition definition) {
  std::tie(definition.window_begin, definition.window_end) = judged_time(row, definition);
  return definition;
}

}  // namespace slosh
