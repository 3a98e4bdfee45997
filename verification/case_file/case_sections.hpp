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

// The tables of the keys of each struct, in the order in which a case is read. What a table needs
// of the case must have been read: the tank for all that stands in it, the runs for what names
// them.
extern const FieldTable<CaseDefinition> case_keys;
extern const FieldTable<TankDefinition> tank_keys;
extern const FieldTable<LiquidDefinition> liquid_keys;  // without properties, of water
extern const FieldTable<GasDefinition> gas_keys;
extern const FieldTable<CaseDefinition> time_keys;
struct Animation {
  double begin, end, interval;     // [s]
  std::vector<double> times = {};  // [s]
};
extern const FieldTable<Animation> animation_keys;
extern const FieldTable<GaugeDefinition> gauge_keys;
extern const FieldTable<PressureGaugeDefinition> pressure_gauge_keys;
extern const FieldTable<ProbeDefinition> probe_keys;
extern const FieldTable<ImpactsDefinition> impacts_keys;
extern const FieldTable<ObstacleDefinition> obstacle_keys;
extern const FieldTable<InitialWaveDefinition> initial_wave_keys;
extern const FieldTable<CaseDefinition> comparison_keys;
extern const FieldTable<SphRun> sph_keys;
extern const FieldTable<InterFoamRun> interfoam_keys;
extern const FieldTable<LinearRun> linear_keys;
extern const FieldTable<ViscousWaveRun> viscous_wave_keys;
extern const FieldTable<PotentialRun> potential_keys;
extern const FieldTable<RecordRun> record_keys, experiment_keys;  // shipped, and the user's own
extern const FieldTable<ExternalRun> external_keys, pysph_keys;
extern const FieldTable<StoredRun> stored_keys;
extern const FieldTable<SeriesSource> series_keys;
extern const FieldTable<RefinementDefinition> refinement_keys;
extern const FieldTable<InputUncertainty> input_keys;
extern const FieldTable<GateRow> gate_keys;
extern const FieldTable<MotionDefinition> motion_keys;
extern const FieldTable<TimingDefinition> timing_keys;
extern const FieldTable<CampaignDefinition> campaign_keys;
extern const FieldTable<ProblemGateRow> problem_gate_keys;

// [motion.surge], [motion.roll] and the tables in them.
std::vector<KeyTable> motion_tables();

// What a tank that is no rectangle excludes. The first needs the definition's tank alone; the
// second its motion and its comparison too.
void refuse_beside_outline(const TomlTable& root, const CaseDefinition& definition);
void refuse_breadth_of_outline(const TomlTable& root, const CaseDefinition& definition);
void refuse_solver_of_outline(const TomlTable& run, const CaseDefinition& definition);
Rule<int> modes_of_outline(const CaseDefinition& definition);

// Refuses obstacles, read from these tables, that overlap. They may touch.
void refuse_overlaps(const std::vector<TomlTable>& tables,
                     const std::vector<ObstacleDefinition>& obstacles);

// The keys of the three ways to give a frequency, of which a table uses one, and what it gives
// [rad/s]; nullopt where none is there.
std::vector<std::string> names_of_frequency(const std::string& prefix = "");
std::optional<double> find_angular_frequency(const TomlTable& table,
                                             const std::string& prefix = "");

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

// Reads the walls at this key of the top level.
void read_wall_forces(const KeyEntry& key, const TomlTable& root, const CaseDefinition& definition,
                      CaseDefinition& read);

// Reads [[run]] and returns one run, or with `repeats` the members of an ensemble (ensemble.hpp).
// The definition's liquid, motion and gauges must have been read.
std::vector<RunDefinition> read_runs(const TomlTable& run, const CaseDefinition& definition);

// The rule of particle_spacing_m.
Rule<double> a_particle_spacing(const CaseDefinition& definition);

// Refuses the run, read from this table, where it and an earlier run of the definition would count
// as one method although they are not: an external program's method must be no other solver's
// family, and have one run for each spacing. Its runs start programs of the same names and take
// their series alike; their settings and directories may differ.
void refuse_shared_method(const TomlTable& table, const RunDefinition& run,
                          const CaseDefinition& definition);

// Reads what the rows of gate_keys do not.
void finish_gate_row(const TomlTable& row, const CaseDefinition& definition, GateRow& gate_row);

// Returns the rows of a [[gate]]. The definition's runs must have been read.
std::vector<TomlTable> gate_rows(const TomlTable& group, const CaseDefinition& definition);

// The rows `kind`, `reason` and `source` of a gate row of a case or a problem. A row of regression
// needs no source: it rests on what was measured before.
template <class Row>
std::vector<Field<Row>> with_origin(std::vector<Field<Row>> rows) {
  using namespace key;
  using namespace needed;
  rows.push_back(field("kind", &Row::kind, row_kind_names, "what the limit comes from", no,
                       "Where the limit comes from: theory, experiment, requirement; or earlier "
                       "measurements. Default: validation."));
  rows.push_back(field("reason", &Row::reason, text(),
                       where("yes, or each of limits has its own").when(yes.in),
                       "Why the row is there."));
  const auto by_kind = [](const TomlTable& row) { return row.written("kind") != "regression"; };
  rows.push_back(field("source", &Row::source, text(),
                       where("yes, but for kind = \"regression\"").when(by_kind),
                       "Where its limit comes from. Default of a regression: the measurement that "
                       "the reason names."));
  return rows;
}
inline constexpr const char* measured_before = "measured before: the reason names it";

// One [[gate]] or [[problem.gate]] may hold several rows: it lists what is judged, by names or by
// patterns, and the metrics with their bounds at `limits`. Each of its rows becomes a table with
// the keys of a single row, so that what reads rows knows nothing of groups.
//
//   candidates = ["recommended_*", "interfoam_50x50"]      a row for each run that is matched
//   modes = ["natural_1", "natural_3"]                     and for each mode
//   limits.amplitude_error = 0.05                          and for each metric: its limit,
//   limits.phase_lag = { limit = 5, reason = "..." }       or the keys that are its own

// What the rows of a kind judge: the runs of a case, or the measures of a problem.
struct RowSubjects {
  std::string key, key_of_several;  // "candidate", "candidates"
  std::string what;                 // "a run"
  std::vector<std::string> names;   // in the order of the rows
  std::vector<std::string> metrics;
  std::string table;  // of a row's keys, in key_table.hpp
};

// Returns the rows of the group, by subject, then by mode, then by metric. A table that is no group
// is its own only row. Throws CaseFileError for a pattern that matches none of the names.
std::vector<TomlTable> rows_of_group(const TomlTable& group, const RowSubjects& subjects);

// One [[run]] may hold several runs, as a [[sweep]] of a campaign does: each key that holds a list
// makes a run for each of its values, and `name` is a pattern of the keys.
//
//   name = "recommended_{particle_spacing_mm}mm"     "recommended_25mm", "recommended_12p5mm"
//   particle_spacing_m = [0.025, 0.0125]             {..._mm} is a length at ..._m in millimetres,
//   quick = ["*_25mm"]                               {start_seed:02} a number of two digits

// Returns the tables of the runs, one for every combination of the values in lists. A table without
// lists is its own only run. Throws CaseFileError.
std::vector<TomlTable> runs_of_group(const TomlTable& group);

// Returns a length in a run's name: "12p5" for 0.0125 m.
std::string millimetres_in_name(double metres);

}  // namespace slosh
