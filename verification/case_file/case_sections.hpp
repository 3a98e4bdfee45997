// The sections of case and campaign files. Only the two parsers, the sweeps and the fuzz tests use
// them. All of them throw CaseFileError.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

// What a case file means where it says nothing: the earth's gravity, water and air at 20 °C, each
// rounded as the papers of the field round it.

// [m/s2]. Standard gravity is 9.80665 (3rd CGPM, 1901).
inline constexpr double usual_gravity = 9.81;

// Water at 20 °C and 101325 Pa has 998.2 kg/m3 (IAPWS R6-95) and 1.003e-6 m2/s (IAPWS R12-08).
inline constexpr double water_density = 1000;              // [kg/m3]
inline constexpr double water_kinematic_viscosity = 1e-6;  // [m2/s]

// Dry air at 20 °C and 101325 Pa has 1.204 kg/m3 and 1.51e-5 m2/s: the equation of state and
// Sutherland's formula as ISO 2533:1975 gives them.
inline constexpr GasDefinition air{.density = 1.2, .kinematic_viscosity = 1.5e-5};

// The names of those that are kept, in their order.
template <class All, class Keep>
std::vector<std::string> names_where(const All& all, const Keep& keep) {
  std::vector<std::string> names;
  for (const auto& one : all)
    if (keep(one)) names.push_back(one.name);
  return names;
}
template <class All>
std::vector<std::string> names_of(const All& all) {
  return names_where(all, [](const auto&) { return true; });
}

// The keys of the tables that a struct holds.
extern const FieldTable<TankDefinition> tank_table;
extern const FieldTable<LiquidDefinition> liquid_table;
extern const FieldTable<GasDefinition> gas_table;
extern const FieldTable<ObstacleDefinition> obstacle_table;
extern const FieldTable<InitialWaveDefinition> initial_wave_table;
extern const FieldTable<CaseDefinition> time_table;
extern const FieldTable<CaseDefinition> comparison_table;
struct Animation {
  double begin, end, interval;  // [s]
};
extern const FieldTable<Animation> animation_table;
extern const FieldTable<GaugeDefinition> gauge_table;
extern const FieldTable<PressureGaugeDefinition> pressure_gauge_table;
extern const FieldTable<ProbeDefinition> probe_table;
extern const FieldTable<ImpactsDefinition> impacts_table;
extern const FieldTable<SphRun> sph_table;
extern const FieldTable<InterFoamRun> interfoam_table;
extern const FieldTable<LinearRun> linear_table;
extern const FieldTable<ViscousWaveRun> viscous_wave_table;
extern const FieldTable<PotentialRun> potential_table;
extern const FieldTable<ExternalRun> external_table;
extern const FieldTable<StoredRun> stored_table;
extern const FieldTable<SeriesSource> series_table;
extern const FieldTable<TimingDefinition> timing_table;

// Read [tank] and [liquid], in this order. Without properties a liquid is water.
TankDefinition read_tank(const TomlTable& tank, const CaseDefinition& definition);
LiquidDefinition read_liquid(const TomlTable& liquid, const CaseDefinition& definition);

// What a tank that is no rectangle excludes. The first needs the definition's tank alone; the
// second its motion and its comparison too.
void refuse_beside_outline(const TomlTable& root, const CaseDefinition& definition);
void refuse_breadth_of_outline(const TomlTable& root, const CaseDefinition& definition);
void refuse_solver_of_outline(const TomlTable& run, const CaseDefinition& definition);
Rule<int> modes_of_outline(const CaseDefinition& definition);

// Reads [[obstacle]]. The definition's tank, liquid and gauges must have been read.
ObstacleDefinition read_obstacle(const TomlTable& obstacle, const CaseDefinition& definition);

// Refuses obstacles, read from these tables, that overlap. They may touch.
void refuse_overlaps(const std::vector<TomlTable>& tables,
                     const std::vector<ObstacleDefinition>& obstacles);

// Reads [initial_wave]. The definition's tank, liquid and obstacles must have been read.
InitialWaveDefinition read_initial_wave(const TomlTable& wave, const CaseDefinition& definition);

// Reads [time].
void read_time(const TomlTable& time, CaseDefinition& definition);

// Reads [comparison]. The definition's gravity, liquid, motion and initial wave must have been
// read.
void read_comparison(const TomlTable& comparison, CaseDefinition& definition);

// The three ways to give a frequency, of which a table uses one.
struct FrequencyKeys {
  std::string angular_frequency, frequency, period;

  std::vector<std::string> all() const;
};
FrequencyKeys frequency_keys(const std::string& prefix = "");

// Return what the table gives at one of the keys, as an angular frequency [rad/s]. The first
// returns nullopt if none is there.
std::optional<double> find_angular_frequency(const TomlTable& table, const FrequencyKeys& keys);
double read_angular_frequency(const TomlTable& table, const FrequencyKeys& keys);

// Returns the key time_offset_s [s], which is added to the times of a file; 0 without it.
double read_time_offset(const TomlTable& table);

// Reads the keys of [comparison] that tell the forcing frequency of a motion table. The
// definition's motion and its comparison's window must have been read.
void read_forcing(const TomlTable& comparison, CaseDefinition& definition);

// Reads [animation] and returns its times [s]. The definition's time must have been read.
std::vector<double> read_animation(const TomlTable& animation, const CaseDefinition& definition);

// Reads [motion]. The definition's tank and duration must have been read. The files of motion
// tables are relative to the case file.
MotionDefinition read_motion(const TomlTable& motion, const CaseDefinition& definition);

// A motion's CSV file.
struct TableFile {
  std::filesystem::path file;
  double duration;        // of the case [s], for which the motion must last
  double time_offset;     // added to the file's times [s]
  bool straight = false;  // between accelerations, in place of a spline
};

// Read a motion from a CSV file of positions, whose first line is "time_s,displacement_m" (surge)
// or "time_s,angle_deg" (roll), or of accelerations, "time_s,acceleration_m_s2" or
// "time_s,acceleration_deg_s2", which are integrated from a position and a velocity of 0 at the
// time 0: at least four rows, times that increase strictly from 0 or less to at least the case's
// duration. The motion is `thinned` (motion_times.hpp). A roll starts level, at 0 to within 1e-3
// deg. The errors name the line of the CSV file.
TableMotion read_surge_table(const TableFile& table);
TableMotion read_roll_table(const TableFile& table);

// Reads [[pressure_gauge]]. The definition's tank and sample interval must have been read.
PressureGaugeDefinition read_pressure_gauge(const TomlTable& gauge,
                                            const CaseDefinition& definition);

// Reads [[probe]]. The definition's tank must have been read.
ProbeDefinition read_probe(const TomlTable& probe, const CaseDefinition& definition);

// Reads the key `wall_forces` of the top level, which must be there.
std::vector<Wall> read_wall_forces(const TomlTable& root);

// Reads [impacts]. The definition's duration and gauges must have been read. The table of repeats
// lies below the directory `experiments`, which may be empty.
ImpactsDefinition read_impacts(const TomlTable& impacts, const CaseDefinition& definition,
                               const std::filesystem::path& experiments);

// Reads [[run]] and returns one run, or with `repeats` the members of an ensemble (ensemble.hpp).
// The definition's liquid, motion and gauges must have been read. The files of shipped records are
// relative to the case file; those of experiments lie below the directory `experiments`, which may
// be empty.
std::vector<RunDefinition> read_runs(const TomlTable& run, const CaseDefinition& definition,
                                     const std::filesystem::path& experiments);

// The rule of particle_spacing_m.
Rule<double> a_particle_spacing(const CaseDefinition& definition);

// Reads the keys of [[run]] with solver = "external". The files are relative to the case file.
ExternalRun read_external_run(const TomlTable& run, const CaseDefinition& definition);

// Reads the keys of [[run]] with solver = "stored". Its files must be there.
StoredRun read_stored_run(const TomlTable& run, const CaseDefinition& definition);

// Reads the keys of [[run]] with solver = "pysph": an external run of the driver that Slosh ships.
// The definition's tank, obstacles and initial wave must have been read.
ExternalRun read_pysph_run(const TomlTable& run, const CaseDefinition& definition);

// Refuses the run, read from this table, where it and an earlier run of the definition would count
// as one method although they are not: an external program's method must be no other solver's
// family, and have one run for each spacing. Its runs start programs of the same names and take
// their series alike; their settings and directories may differ.
void refuse_shared_method(const TomlTable& table, const RunDefinition& run,
                          const CaseDefinition& definition);

// Reads [[refinement]]. The definition's runs must have been read.
RefinementDefinition read_refinement(const TomlTable& refinement, const CaseDefinition& definition);

// Reads [[input]]. The definition's motion, comparison and earlier inputs must have been read.
InputUncertainty read_input(const TomlTable& table, const CaseDefinition& definition);

// Returns the rows of a [[gate]] (groups.hpp). The definition's runs must have been read.
std::vector<TomlTable> gate_rows(const TomlTable& group, const CaseDefinition& definition);

// Reads a row of [[gate]]. The definition's motion, gauges, comparison and runs must have been
// read.
GateRow read_gate_row(const TomlTable& row, const CaseDefinition& definition);

// Read the keys `kind` and `source` of a gate row of a case or a problem. A row of regression needs
// no source: it rests on what was measured before.
RowKind read_row_kind(const TomlTable& row);
std::string read_row_source(const TomlTable& row, RowKind kind);

}  // namespace slosh
