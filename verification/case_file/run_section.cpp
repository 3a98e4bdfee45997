#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/tables/time_table.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

using Keys = std::vector<std::string>;

// More would not fit the memory, which is then exhausted without a word.
constexpr double most_particles = 1e8;
constexpr int most_cells = 10000, most_modes = 100000;

double finest_spacing(const CaseDefinition& definition) {
  return std::sqrt(liquid_area(definition) / most_particles);
}

Keys together(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// Below a ratio of 1 the liquid would move faster than sound in it. Damping may be switched off by
// a zero.
SphNumbers read_numbers(const TomlTable& run) {
  return {
      .smoothing_length_ratio = run.find("smoothing_length_ratio", number_between(0.5, 10, "1")),
      .sound_speed_ratio = run.find("sound_speed_ratio", number_between(1, 1000, "1")),
      .courant_number = run.find("courant_number", number_between(0.001, 10, "1")),
      .artificial_viscosity = run.find("artificial_viscosity", not_negative("1")),
      .density_diffusion = run.find("density_diffusion", not_negative("1"))};
}

const Rule<std::string> an_initial_state{"one of lattice | settled | projected",
                                         [](const std::string& state) {
                                           return state == "lattice" || state == "settled" ||
                                                  state == "projected";
                                         },
                                         "lattice"};

// With more than a fifth of a spacing, particles come so close that the start is a shock.
const Rule<double> a_disorder = number_between(0, 0.2, "particle spacings");

// A square lattice repeats itself after a quarter turn, and is mirrored after an eighth.
const Rule<double> a_rotation = number_between(0, 45, "degrees");

const Rule<double> a_disturbed_level = number_between(0, 0.2, "heights of a cell");

// Throws for a coarse run of liquid at rest in a tank at rest.
bool read_speed_from_coarse_run(const TomlTable& run, const CaseDefinition& definition) {
  if (!run.has("expected_speed")) return false;
  if (run.choice("expected_speed", "where the expected largest speed comes from",
                 std::vector<std::string>{"estimate", "coarse_run"}) == "estimate")
    return false;
  if (definition.motion.still() && !definition.initial_wave && !definition.liquid.column_width)
    run.refuse("expected_speed",
               "\"estimate\" in a case without motion, initial wave or dam: nothing flows whose "
               "speed a coarse run could measure");
  return true;
}

struct DisturbedStart {
  double disorder;
  int seed;
};

DisturbedStart read_start(const TomlTable& run, const Rule<double>& rule) {
  const double disorder = run.find("start_disorder", rule).value_or(0);
  const bool varies = run.flag("vary_inputs");
  if (varies && !run.has("repeats"))
    run.refuse("vary_inputs", "no such key without repeats, whose inputs it draws");
  for (const char* key : {"start_seed", "repeats"})
    if (run.has(key) && !(disorder > 0) && !varies)
      run.refuse(key,
                 fmt::format("no such key without start_disorder > 0 or vary_inputs: there is "
                             "nothing to vary (1e-6 {} is enough in a chaotic flow)",
                             &rule == &a_disorder ? "particle spacings" : "heights of a cell"));
  return {disorder, run.find("start_seed", at_least(0)).value_or(0)};
}

// Throws for a lattice that could not be turned or would not come to rest.
double read_start_rotation(const TomlTable& run, const CaseDefinition& definition) {
  const double angle = run.find("start_rotation_deg", a_rotation).value_or(0);
  if (angle == 0) return angle;
  if (run.find("initial_state", an_initial_state) != "settled")
    run.refuse("start_rotation_deg",
               "initial_state = \"settled\" beside it: rotated rows do not fit the walls");
  if (!is_rectangle(definition.tank) || !definition.obstacles.empty())
    run.refuse("start_rotation_deg",
               "no such key in a tank with an obstacle or another shape than a rectangle");
  if (run.has("surface_particle_spacing_m"))
    run.refuse("start_rotation_deg", "no such key beside surface_particle_spacing_m");
  return angle;
}

SphRun read_sph(const TomlTable& run, const CaseDefinition& definition) {
  const double spacing = run.get("particle_spacing_m", a_particle_spacing(definition));
  const double finest = finest_spacing(definition);
  const auto surface_spacing = run.find<double>(
      "surface_particle_spacing_m",
      {fmt::format(
           "a number > 0 and <= particle_spacing_m ({}), in m, and >= {:.3g}, the spacing of "
           "a hundred million particles",
           spacing, finest),
       [=](double value) { return value >= finest && value <= spacing; }});
  const DisturbedStart start = read_start(run, a_disorder);
  return {.scheme = run.get("scheme", any_text()),
          .particle_spacing = spacing,
          .surface_particle_spacing = surface_spacing.value_or(spacing),
          .variant = run.find("variant", any_text()).value_or(""),
          .initial_state = run.find("initial_state", an_initial_state).value_or(""),
          .numbers = read_numbers(run),
          .start_disorder = start.disorder,
          .start_seed = start.seed,
          .start_rotation_deg = read_start_rotation(run, definition),
          .energy_budget = run.flag("energy_budget"),
          .speed_from_coarse_run = read_speed_from_coarse_run(run, definition)};
}

const Rule<double> a_courant_number{"a number > 0 and <= 1",
                                    [](double number) { return number > 0 && number <= 1; }, 0.5};

// The thickness of the cells beside the walls is that of the thinner ones of a uniform mesh at
// most.
Rule<double> a_wall_cell(const CaseDefinition& definition, int cells_x, int cells_z) {
  const double uniform =
      std::min(definition.tank.length / cells_x, definition.tank.height / cells_z);
  return {fmt::format("a number > 0 and <= {:.4g}, the width and the height of uniform cells, in m",
                      uniform),
          [uniform](double value) { return value > 0 && value <= uniform; }, uniform};
}

// Throws unless the tank is a narrow rectangle whose walls the liquid sticks to.
std::optional<int> read_cells_y(const TomlTable& run, const CaseDefinition& definition,
                                bool no_slip) {
  const auto cells = run.find("cells_y", integer_between(4, 1000));
  if (!cells) return cells;
  if (!definition.tank.breadth)
    run.refuse("cells_y",
               "no such key in a tank without breadth_m in [tank]: it divides half of that");
  if (!is_rectangle(definition.tank) || !definition.obstacles.empty())
    run.refuse("cells_y",
               "no such key in a tank with an obstacle or another shape than a rectangle, which is "
               "solved in two dimensions");
  if (!no_slip)
    run.refuse("cells_y", "no_slip = true beside it: the liquid sticks to the walls of the gap");
  return cells;
}

// Throws for a solver without friction, of a tank whose front and back wall cause it.
void refuse_breadth(const TomlTable& run, const CaseDefinition& definition) {
  if (definition.tank.breadth)
    run.refuse("solver",
               "a solver that counts the friction of the front and the back wall, one of sph, "
               "interfoam and interisofoam, and with cells_y compressible_interfoam, where [tank] "
               "has breadth_m");
}

InterFoamRun read_interfoam(const TomlTable& run, const CaseDefinition& definition,
                            FoamProgram program) {
  if (program == FoamProgram::compressible_inter_foam && !run.has("cells_y"))
    refuse_breadth(run, definition);
  const int cells_x = run.get("cells_x", integer_between(2, most_cells));
  const int cells_z = run.get("cells_z", integer_between(2, most_cells));
  const auto processes = run.find("processes", integer_up_to("cells_x", cells_x));
  const auto wall_cell = run.find("wall_cell_m", a_wall_cell(definition, cells_x, cells_z));
  if (wall_cell && (!is_rectangle(definition.tank) || !definition.obstacles.empty()))
    run.refuse("wall_cell_m",
               "no such key in a tank with an obstacle or another shape than a rectangle, whose "
               "cells are uniform");
  const bool no_slip = run.flag("no_slip");
  if (no_slip && !(definition.liquid.kinematic_viscosity > 0))
    run.refuse("no_slip", "no such key for a liquid without viscosity, which slips");
  const double courant_number =
      run.find("courant_number", a_courant_number).value_or(InterFoamRun().courant_number);
  const DisturbedStart start = read_start(run, a_disturbed_level);
  if (start.disorder > 0 &&
      (definition.initial_wave || definition.liquid.column_width || !definition.obstacles.empty()))
    run.refuse("start_disorder",
               "no such key for a mesh with [initial_wave], column_width_m or an obstacle: only "
               "a plain level can be disturbed");
  return {.cells_x = cells_x,
          .cells_z = cells_z,
          .processes = processes.value_or(1),
          .start_disorder = start.disorder,
          .start_seed = start.seed,
          .program = program,
          .courant_number = courant_number,
          .interface_courant_number =
              run.find("interface_courant_number", a_courant_number).value_or(courant_number),
          .outer_corrections = run.find("outer_corrections", integer_between(1, 10))
                                   .value_or(InterFoamRun().outer_corrections),
          .no_slip = no_slip,
          .wall_cell = wall_cell,
          .cells_y = read_cells_y(run, definition, no_slip)};
}

// Where the surface departs by a depth it bares the bottom, and no theory of small waves holds.
double read_valid_elevation(const TomlTable& run) {
  const Rule<double> rule{"a number > 0 and < 1, in fill depths: a trough of one bares the bottom",
                          [](double depths) { return depths > 0 && depths < 1; }, 0.1};
  return run.get("valid_elevation_over_depth", rule);
}

LinearRun read_linear(const TomlTable& run, const CaseDefinition& definition) {
  refuse_breadth(run, definition);
  const bool wave_alone = definition.motion.still() && definition.initial_wave;
  if (wave_alone && run.has("modes"))
    run.refuse("modes", "no such key for a still tank: its initial wave is a single mode");
  const bool rectangle = is_rectangle(definition.tank);
  if (!rectangle && run.has("two_layer"))
    run.refuse("two_layer", "no such key for a tank that is no rectangle: its theory has no gas");
  return {.modes = wave_alone ? 0
                              : run.get("modes", rectangle ? integer_between(1, most_modes)
                                                           : modes_of_outline(definition)),
          .two_layer = run.flag("two_layer"),
          .valid_elevation_over_depth = read_valid_elevation(run)};
}

ViscousWaveRun read_viscous_wave(const TomlTable& run, const CaseDefinition& definition) {
  refuse_breadth(run, definition);
  return {.valid_elevation_over_depth = read_valid_elevation(run)};
}

PotentialRun read_potential(const TomlTable& run, const CaseDefinition& definition) {
  refuse_breadth(run, definition);
  PotentialRun potential;
  const Rule<int> enough_nodes = integer_between(16, 128);
  potential.nodes_x = run.find("nodes_x", enough_nodes).value_or(potential.nodes_x);
  potential.nodes_z = run.find("nodes_z", enough_nodes).value_or(potential.nodes_z);
  return potential;
}

RecordRun read_shipped_record(const TomlTable& run, const CaseDefinition& definition) {
  const std::filesystem::path file = definition.file.parent_path() / run.get("file", any_text());
  require_data_file(run, "file", file, definition.file);
  std::vector<std::string> columns;
  for (const std::string& quantity : compared_quantities(definition))
    columns.push_back(quantity + "_" + unit_of(quantity));
  TimeTable table = read_time_table(file, columns);
  for (const double offset = read_time_offset(run); double& time : table.time) time += offset;
  const std::string quantity = table.column.substr(0, table.column.find_last_of('_'));
  return {.file = file,
          .quantity = quantity,
          .unit = unit_of(quantity),
          .time = std::move(table.time),
          .value = std::move(table.value),
          .uncertainty = run.find("uncertainty", positive(unit_of(quantity))),
          .earlier_run = run.flag("earlier_run")};
}

// The columns of the quantiles of the experiment's repeats.
std::optional<std::pair<std::string, std::string>> band_columns(const TomlTable& run) {
  if (!run.has("lower_column") && !run.has("upper_column")) return std::nullopt;
  return std::pair{run.get("lower_column", any_text()), run.get("upper_column", any_text())};
}

std::vector<double> read_column(const RecordRun& record, TimeColumns columns,
                                const std::string& value, double factor) {
  columns.value = value;
  std::vector<double> values = read_time_columns(record.file, columns).value;
  for (double& one : values) one *= factor;
  return values;
}

void read_band(const TomlTable& run, const TimeColumns& columns,
               const std::pair<std::string, std::string>& edges, double factor, RecordRun& record) {
  record.lower = read_column(record, columns, edges.first, factor);
  record.upper = read_column(record, columns, edges.second, factor);
  for (std::size_t i = 0; i < record.time.size(); ++i)
    if (!(record.lower[i] <= record.upper[i]))
      run.refuse("upper_column",
                 fmt::format("a column whose values are nowhere below those of lower_column; at "
                             "{:.6g} s they are",
                             record.time[i]));
}

// Checks the keys even if the record is absent.
RecordRun read_experiment(const TomlTable& run, const CaseDefinition& definition,
                          const std::filesystem::path& experiments) {
  const std::string quantity =
      run.choice("quantity", "a compared quantity", compared_quantities(definition));
  const std::string unit =
      run.choice("unit", "a unit of " + quantity, unit_names(unit_of(quantity)));
  const double si = si_value(unit, unit_of(quantity));
  const TimeColumns columns{run.get("time_column", any_text()),
                            run.get("value_column", any_text()),
                            {"unit", unit, quantity, unit_of(quantity)}};
  const double factor = si * run.find("scale", positive("1")).value_or(1);
  const double time_offset = read_time_offset(run);
  const auto edges = band_columns(run);
  const bool named = !experiments.empty();
  RecordRun record{
      .file = (named ? experiments : "SLOSH_EXPERIMENTS") /
              std::filesystem::path(run.get("experiment", path_below_experiments("a CSV file's"))),
      .quantity = quantity,
      .unit = unit_of(quantity),
      .time = {},
      .value = {},
      .uncertainty = run.find("uncertainty", positive(unit)),
      .has_band = edges.has_value()};
  if (record.uncertainty) *record.uncertainty *= si;
  record.supplied = named && is_record_in(experiments, run, "experiment", record.file);
  if (!record.supplied) return record;
  TimeTable table = read_time_columns(record.file, columns);
  record.time = std::move(table.time);
  for (double& time : record.time) time += time_offset;
  record.value = std::move(table.value);
  for (double& value : record.value) value *= factor;
  if (edges) read_band(run, columns, *edges, factor, record);
  return record;
}

using Solver = decltype(RunDefinition::solver);

// A solver, or one form of its runs, and the function that reads these.
struct SolverSection {
  std::string name;
  std::function<Solver(const TomlTable& run, const CaseDefinition& definition,
                       const std::filesystem::path& experiments)>
      read;
  std::string form = {};        // the key by which this form is recognised
  const char* table = nullptr;  // of the keys, where another solver's counts

  // The keys beside those that all solvers have.
  Keys keys() const { return keys_of("run." + (table ? table : form.empty() ? name : form)); }
};

// OpenFOAM's programs have the keys of interFoam.
SolverSection section_of_openfoam(const char* name, FoamProgram program) {
  return {.name = name,
          .read = [program](const TomlTable& run, const CaseDefinition& definition,
                            const auto&) { return read_interfoam(run, definition, program); },
          .table = "interfoam"};
}

const std::vector<SolverSection> solver_sections{
    {"sph", [](const auto& run, const auto& definition,
               const auto&) { return read_sph(run, definition); }},
    section_of_openfoam("interfoam", FoamProgram::inter_foam),
    section_of_openfoam("interisofoam", FoamProgram::inter_iso_foam),
    section_of_openfoam("compressible_interfoam", FoamProgram::compressible_inter_foam),
    {"linear", [](const auto& run, const auto& definition,
                  const auto&) { return read_linear(run, definition); }},
    {"viscous_wave", [](const auto& run, const auto& definition,
                        const auto&) { return read_viscous_wave(run, definition); }},
    {"potential", [](const auto& run, const auto& definition,
                     const auto&) { return read_potential(run, definition); }},
    {"record", [](const auto& run, const auto& definition,
                  const auto&) { return read_shipped_record(run, definition); }},
    {"record",
     [](const auto& run, const auto& definition, const auto& experiments) {
       return read_experiment(run, definition, experiments);
     },
     "experiment"},
    {"external", [](const auto& run, const auto& definition,
                    const auto&) { return read_external_run(run, definition); }},
    {"stored", [](const auto& run, const auto& definition,
                  const auto&) { return read_stored_run(run, definition); }},
    {"pysph", [](const auto& run, const auto& definition, const auto&) {
       return read_pysph_run(run, definition);
     }}};

Keys solver_names() {
  Keys names;
  for (const SolverSection& section : solver_sections)
    if (section.form.empty()) names.push_back(section.name);
  return names;
}

Keys keys_of_any_solver() {
  Keys all = keys_of("run");
  for (const SolverSection& section : solver_sections) all = together(all, section.keys());
  return all;
}

// Returns the keys of all forms of the solver's runs: the key that identifies the form may be
// misspelt.
Keys keys_of_solver(const std::string& name) {
  Keys all = keys_of("run");
  for (const SolverSection& section : solver_sections)
    if (section.name == name) all = together(all, section.keys());
  return all;
}

const SolverSection& section_of(const TomlTable& run) {
  if (!run.has("solver")) run.allow_only(keys_of_any_solver());  // it may be misspelt
  const std::string name = run.choice("solver", "a solver", solver_names());
  run.allow_only(keys_of_solver(name));
  const SolverSection* found = nullptr;
  for (const SolverSection& section : solver_sections)
    if (section.name == name && (section.form.empty() || run.has(section.form))) found = &section;
  return *found;
}

RunDefinition read_run(const TomlTable& run, const CaseDefinition& definition,
                       const std::filesystem::path& experiments) {
  const SolverSection& section = section_of(run);
  run.allow_only(together(keys_of("run"), section.keys()));
  return {.name = run.get("name", file_safe_name()),
          .solver = section.read(run, definition, experiments),
          .quick = run.flag("quick"),
          .where = run.where(),
          .varies_inputs = run.flag("vary_inputs")};
}

}  // namespace

Rule<double> a_particle_spacing(const CaseDefinition& definition) {
  const double least = finest_spacing(definition), most = definition.liquid.fill_depth;
  return {
      fmt::format("a number > 0 and <= the fill depth ({:.4g}), in m, and >= {:.3g}, the spacing "
                  "of a hundred million particles",
                  most, least),
      [=](double value) { return value >= least && value <= most; }, most};
}

std::vector<RunDefinition> read_runs(const TomlTable& run, const CaseDefinition& definition,
                                     const std::filesystem::path& experiments) {
  const RunDefinition read = read_run(run, definition, experiments);
  refuse_shared_method(run, read, definition);
  const auto repeats = run.find("repeats", integer_between(2, most_repeats));
  if (run.has("quick_repeats") && !(repeats && read.quick))
    run.refuse("quick_repeats",
               "no such key without repeats and quick: it says how many repeats are quick");
  if (!repeats) return {read};
  const auto quick_repeats = run.find("quick_repeats", integer_up_to("repeats", *repeats));
  return ensemble_of(read, *repeats, quick_repeats.value_or(*repeats));
}

}  // namespace slosh
