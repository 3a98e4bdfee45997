// A case: one sloshing experiment, as every solver, reference, metric and gate is told of it. Plain
// data, SI units; only case_parser.hpp makes one from a file, and it hands over none that is not
// physically possible.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace slosh {

// Where a value was written, for messages and for reports that point at a row.
struct SourceLocation {
  std::string file;
  int line = 0;
};

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

// What fills the tank above the liquid; seen by interFoam and by the two-layer linear theory.
struct GasDefinition {
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
};

// X(t) = amplitude sin(omega t), times a smooth ramp over the first ramp_periods periods (0: none).
struct SineSurge {
  double amplitude;          // [m]
  double angular_frequency;  // [rad/s]
  double ramp_periods = 0;
};

// X(t) from a CSV file with the columns time_s, displacement_m (path relative to the case file).
struct TableSurge {
  std::filesystem::path file;
  std::vector<double> time, displacement;
};

// The tank stands.
struct Still {};

// theta(t) = amplitude sin(omega t) about an axis; declared here, not solved yet.
struct SineRoll {
  double amplitude;          // [rad] (the file gives degrees)
  double angular_frequency;  // [rad/s]
  double axis_x, axis_z;     // [m] from the tank's bottom left corner
  SourceLocation where;
};

using MotionDefinition = std::variant<SineSurge, TableSurge, SineRoll, Still>;

// At rest in the earth's frame (the tank is set off with X'(0)), or at rest relative to the tank.
enum class Start { earth, tank };

// Free-surface elevation above the still level at a place fixed in the tank.
struct GaugeDefinition {
  std::string name;
  double x;  // [m] from the left wall
};

// What a run changes of its scheme's own numbers, none of which has a unit; absent: as the scheme
// has it.
struct SphNumbers {
  std::optional<double> smoothing_length_ratio;  // h / particle spacing
  std::optional<double> sound_speed_ratio;       // c0 / largest expected speed of the liquid
  std::optional<double> courant_number;          // dt c0 / h
  std::optional<double> artificial_viscosity;    // alpha
  std::optional<double> density_diffusion;       // delta
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
};

struct InterFoamRun {
  int cells_x, cells_z;
  int processes = 1;  // above 1: decomposePar and mpirun
};

// Linear potential flow (reference/linear_surge.hpp). It may gate while the highest elevation that
// it predicts stays below valid_elevation_over_depth times the fill depth.
struct LinearRun {
  int modes;
  bool two_layer = false;  // count the gas in the dispersion relation
  double valid_elevation_over_depth;
};

// A published record of one quantity, from a CSV file (path relative to the case file); it may
// gate.
struct RecordRun {
  std::filesystem::path file;
  std::string quantity, unit;
  std::vector<double> time, value;    // [s], unit
  std::optional<double> uncertainty;  // half width of the values' 95 % interval, in the unit
};

struct RunDefinition {
  std::string name;
  std::variant<SphRun, InterFoamRun, LinearRun, RecordRun> solver;
  bool quick = false;  // part of the campaign's --quick form
  SourceLocation where;
};

enum class Metric {
  amplitude_error,   // 1
  phase_lag,         // deg
  frequency_error,   // 1
  decay_rate,        // 1/s, of the candidate
  normalised_rms,    // 1, whole window
  maximum_residual,  // the quantity's unit, whole window
  time_lag,          // s, whole window; of a quantity without modes, as the next
  aligned_rms,       // 1, whole window, free of that lag
  largest_magnitude  // the quantity's unit, whole window; of the candidate alone
};

// One visible row of the gate. Passes when |value| <= limit, or when lower <= value <= upper, or
// when |value| is below that of the run `improves_on` for the same row: exactly one of the three is
// given.
struct GateRow {
  std::string candidate, reference;  // run names; no reference where the metric needs none
  // "elevation@<gauge>", "front_position"; of the candidate alone any series of its result.
  std::string quantity;
  // "forced", "natural_1", "natural_2", ... (of those that surge excites, lowest first), "whole"
  std::string mode;
  Metric metric;
  std::string unit;
  std::optional<double> limit;
  std::optional<std::pair<double, double>> between;
  std::optional<std::string> improves_on;
  std::string reason, source;
  SourceLocation where;
};

struct CaseDefinition {
  std::string name, title, source;
  std::vector<std::string> tags;
  double gravity;  // [m/s2]
  TankDefinition tank;
  LiquidDefinition liquid;
  GasDefinition gas;
  std::vector<ObstacleDefinition> obstacles;
  MotionDefinition motion;
  Start start;
  double duration;         // [s]
  double sample_interval;  // [s], of every recorded series
  std::vector<GaugeDefinition> gauges;
  // The comparison: the window and how many natural modes (of those that surge excites, lowest
  // first) are fitted beside the forced one.
  double window_begin, window_end;  // [s]
  int natural_modes;
  std::vector<RunDefinition> runs;
  std::vector<GateRow> gate;
  std::string text;  // the file as read
  std::filesystem::path file;
};

}  // namespace slosh
