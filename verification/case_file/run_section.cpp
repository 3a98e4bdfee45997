#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/tables/time_table.hpp"
#include "verification/input/units.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

using Keys = std::vector<std::string>;

// More would not fit the memory, which is then exhausted without a word.
constexpr double most_particles = 1e8;
constexpr int most_modes = 100000;

double finest_spacing(const CaseDefinition& definition) {
  return std::sqrt(liquid_area(definition) / most_particles);
}

// Throws for a coarse run of liquid at rest in a tank at rest.
void read_expected_speed(const KeyEntry& key, const TomlTable& run,
                         const CaseDefinition& definition, SphRun& sph) {
  if (!run.has(key.name)) return;
  sph.speed_from_coarse_run =
      read_value<std::string>(key.value, run, key.name, definition) == "coarse_run";
  if (sph.speed_from_coarse_run && definition.motion.still() && !definition.initial_wave &&
      !definition.liquid.column_width)
    run.refuse(key.name,
               "\"estimate\" in a case without motion, initial wave or dam: nothing flows whose "
               "speed a coarse run could measure");
}

void refuse_idle_seeds(const TomlTable& run, double disorder, const char* unit) {
  const bool varies = run.flag("vary_inputs");
  if (varies && !run.has("repeats"))
    run.refuse("vary_inputs", "no such key without repeats, whose inputs it draws");
  for (const char* key : {"start_seed", "repeats"})
    if (run.has(key) && !(disorder > 0) && !varies)
      run.refuse(key, fmt::format("no such key without start_disorder > 0 or vary_inputs: there is "
                                  "nothing to vary (1e-6 {} is enough in a chaotic flow)",
                                  unit));
}

// Throws for a lattice that could not be turned or would not come to rest.
void refuse_rotation(const TomlTable& run, const CaseDefinition& definition, const SphRun& sph) {
  if (sph.start_rotation_deg == 0) return;
  if (sph.initial_state != "settled")
    run.refuse("start_rotation_deg",
               "initial_state = \"settled\" beside it: rotated rows do not fit the walls");
  if (!is_rectangle(definition.tank) || !definition.obstacles.empty())
    run.refuse("start_rotation_deg",
               "no such key in a tank with an obstacle or another shape than a rectangle");
  if (run.has("surface_particle_spacing_m"))
    run.refuse("start_rotation_deg", "no such key beside surface_particle_spacing_m");
}

// A member of the scheme's numbers.
auto number_of(std::optional<double> SphNumbers::*member) {
  return [member](SphRun & run) -> auto& { return run.numbers.*member; };
}

void finish_sph(const TomlTable& run, const CaseDefinition& definition, SphRun& sph) {
  const double spacing = sph.particle_spacing, finest = finest_spacing(definition);
  const Rule<double> finer{
      fmt::format(
          "a number > 0 and <= particle_spacing_m ({}), in m, and >= {:.3g}, the spacing of "
          "a hundred million particles",
          spacing, finest),
      [=](double value) { return value >= finest && value <= spacing; }};
  sph.surface_particle_spacing = run.find("surface_particle_spacing_m", finer).value_or(spacing);
  refuse_idle_seeds(run, sph.start_disorder, "particle spacings");
  refuse_rotation(run, definition, sph);
}

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
void refuse_cells_y(const TomlTable& run, const CaseDefinition& definition, bool no_slip) {
  if (!run.has("cells_y")) return;
  if (!definition.tank.breadth)
    run.refuse("cells_y",
               "no such key in a tank without breadth_m in [tank]: it divides half of that");
  if (!is_rectangle(definition.tank) || !definition.obstacles.empty())
    run.refuse("cells_y",
               "no such key in a tank with an obstacle or another shape than a rectangle, which is "
               "solved in two dimensions");
  if (!no_slip)
    run.refuse("cells_y", "no_slip = true beside it: the liquid sticks to the walls of the gap");
}

// Throws for a solver without friction, of a tank whose gap walls cause it.
template <class Run>
void refuse_breadth(const TomlTable& run, const CaseDefinition& definition, Run&) {
  if (definition.tank.breadth)
    run.refuse("solver",
               "a solver that counts the friction of the gap walls, one of sph, "
               "interfoam and interisofoam, and with cells_y compressible_interfoam, where [tank] "
               "has breadth_m");
}

// The names of OpenFOAM's programs in case files.
constexpr EnumName<FoamProgram> foam_solver_names[] = {
    {FoamProgram::inter_foam, "interfoam"},
    {FoamProgram::inter_iso_foam, "interisofoam"},
    {FoamProgram::compressible_inter_foam, "compressible_interfoam"}};

void finish_interfoam(const TomlTable& run, const CaseDefinition& definition, InterFoamRun& mesh) {
  mesh.program = value_of(run.written("solver"), foam_solver_names);
  if (mesh.program == FoamProgram::compressible_inter_foam && !run.has("cells_y"))
    refuse_breadth(run, definition, mesh);
  if (!run.has("interface_courant_number")) mesh.interface_courant_number = mesh.courant_number;
  mesh.wall_cell = run.find("wall_cell_m", a_wall_cell(definition, mesh.cells_x, mesh.cells_z));
  const bool is_plain = is_rectangle(definition.tank) && definition.obstacles.empty();
  if (mesh.wall_cell && !is_plain)
    run.refuse("wall_cell_m",
               "no such key in a tank with an obstacle or another shape than a rectangle, whose "
               "cells are uniform");
  if (mesh.no_slip && !(definition.liquid.kinematic_viscosity > 0))
    run.refuse("no_slip", "no such key for a liquid without viscosity, which slips");
  refuse_idle_seeds(run, mesh.start_disorder, "heights of a cell");
  if (mesh.start_disorder > 0 &&
      (definition.initial_wave || definition.liquid.column_width || !definition.obstacles.empty()))
    run.refuse("start_disorder",
               "no such key for a mesh with [initial_wave], column_width_m or an obstacle: only "
               "a plain level can be disturbed");
  refuse_cells_y(run, definition, mesh.no_slip);
}

void finish_linear(const TomlTable& run, const CaseDefinition& definition, LinearRun& linear) {
  refuse_breadth(run, definition, linear);
  const bool wave_alone = definition.motion.still() && definition.initial_wave;
  if (wave_alone && run.has("modes"))
    run.refuse("modes", "no such key for a still tank: its initial wave is a single mode");
  const bool rectangle = is_rectangle(definition.tank);
  if (!rectangle && run.has("two_layer"))
    run.refuse("two_layer", "no such key for a tank that is no rectangle: its theory has no gas");
  if (!wave_alone)
    linear.modes =
        run.get("modes", rectangle ? integer_between(1, most_modes) : modes_of_outline(definition));
}

double time_offset(const TomlTable& run) {
  return run.find("time_offset_s", any_number("s")).value_or(0);
}

void finish_record(const TomlTable& run, const CaseDefinition& definition, RecordRun& record) {
  const std::filesystem::path file = definition.file.parent_path() / run.get("file", any_text());
  require_data_file(run, "file", file, definition.file);
  std::vector<std::string> columns;
  for (const std::string& quantity : compared_quantities(definition))
    columns.push_back(quantity + "_" + unit_of(quantity));
  TimeTable table = read_time_table(file, columns);
  for (const double offset = time_offset(run); double& time : table.time) time += offset;
  record.file = file;
  record.quantity = table.column.substr(0, table.column.find_last_of('_'));
  record.unit = unit_of(record.quantity);
  record.time = std::move(table.time);
  record.value = std::move(table.value);
  record.uncertainty = run.find("uncertainty", positive(record.unit));
}

// Checks the keys even if the record is absent.
void finish_experiment(const TomlTable& run, const CaseDefinition& definition, RecordRun& record) {
  record.unit = unit_of(record.quantity);
  const std::string unit =
      run.choice("unit", "a unit of " + record.quantity, unit_names(record.unit));
  const double si = si_value(unit, record.unit);
  TimeColumns columns{run.get("time_column", any_text()),
                      run.get("value_column", any_text()),
                      {"unit", unit, record.quantity, record.unit}};
  const double factor = si * run.find("scale", positive("1")).value_or(1);
  const double offset = time_offset(run);
  record.has_band = run.has("lower_column") || run.has("upper_column");
  const std::string lower = record.has_band ? run.get("lower_column", any_text()) : "",
                    upper = record.has_band ? run.get("upper_column", any_text()) : "";
  const std::filesystem::path& experiments = definition.experiments;
  const bool named = !experiments.empty();
  record.file =
      (named ? experiments : "SLOSH_EXPERIMENTS") /
      std::filesystem::path(run.get("experiment", path_below_experiments("a CSV file's")));
  record.uncertainty = run.find("uncertainty", positive(unit));
  if (record.uncertainty) *record.uncertainty *= si;
  record.supplied = named && is_record_in(experiments, run, "experiment", record.file);
  if (!record.supplied) return;
  const auto read = [&](const std::string& column) {
    columns.value = column;
    TimeTable table = read_time_columns(record.file, columns);
    for (double& value : table.value) value *= factor;
    return table;
  };
  TimeTable table = read(columns.value);
  record.time = std::move(table.time);
  for (double& time : record.time) time += offset;
  record.value = std::move(table.value);
  if (!record.has_band) return;
  record.lower = read(lower).value;
  record.upper = read(upper).value;
  for (std::size_t i = 0; i < record.time.size(); ++i)
    if (!(record.lower[i] <= record.upper[i]))
      run.refuse("upper_column",
                 fmt::format("a column whose values are nowhere below those of lower_column; at "
                             "{:.6g} s they are",
                             record.time[i]));
}

using Solver = decltype(RunDefinition::solver);

// The keys of a solver's runs, or of one form of them, and what reads these.
struct SolverSection {
  template <class Run>
  SolverSection(const FieldTable<Run>& table)
      : keys(table), read([&](const auto& run, const auto& definition) -> Solver {
          return table(run, definition);
        }) {}

  const KeyTable& keys;
  std::function<Solver(const TomlTable&, const CaseDefinition&)> read;

  bool is_of(const std::string& solver) const {
    return std::ranges::count(keys.solvers, solver) > 0;
  }
};

const SolverSection solver_sections[] = {
    sph_keys,    interfoam_keys,  linear_keys,   viscous_wave_keys, potential_keys,
    record_keys, experiment_keys, external_keys, stored_keys,       pysph_keys};

Keys solver_names() {
  Keys names;
  for (const SolverSection& section : solver_sections)
    for (const std::string& solver : section.keys.solvers)
      if (std::ranges::count(names, solver) == 0) names.push_back(solver);
  return names;
}

// Returns the keys of all forms of the solver's runs, as the key that identifies the form may be
// misspelt; of all solvers where none is named.
Keys keys_of_solver(const std::string& solver) {
  Keys all = keys_of("run");
  for (const SolverSection& section : solver_sections)
    if (solver.empty() || section.is_of(solver))
      for (const KeyEntry& key : section.keys.keys) all.push_back(key.name);
  return all;
}

// A record that the user supplies has the key `experiment`.
const SolverSection& section_of(const TomlTable& run) {
  if (!run.has("solver")) run.allow_only(keys_of_solver(""));  // it may be misspelt
  const std::string name = run.choice("solver", "a solver", solver_names());
  run.allow_only(keys_of_solver(name));
  const std::string form = run.has("experiment") ? "run.experiment" : "";
  return *std::ranges::find_if(solver_sections, [&](const SolverSection& section) {
    return section.is_of(name) && (form.empty() || section.keys.id == form);
  });
}

RunDefinition read_run(const TomlTable& run, const CaseDefinition& definition) {
  const SolverSection& section = section_of(run);
  return {.name = run.get("name", file_safe_name()),
          .solver = section.read(run, definition),
          .quick = run.flag("quick"),
          .where = run.where(),
          .varies_inputs = run.flag("vary_inputs")};
}

}  // namespace

const FieldTable<SphRun> sph_keys{
    key_table("run.sph", "[[run]] with solver = \"sph\"", "no",
              "An SPH run. [SPH schemes](schemes.md) lists the schemes and their variants.", {},
              {"sph"}),
    {field("scheme", &SphRun::scheme, text(), yes,
           "The scheme: kernel, integrator, walls and terms under one name."),
     field("particle_spacing_m", &SphRun::particle_spacing,
           number("m").above(0).at_most(fill_depth).by(a_particle_spacing), yes,
           "The spacing dp of the particles, a hundred million at most."),
     {{"surface_particle_spacing_m", number("m").above(0).at_most(Bound("particle_spacing_m")), no,
       "A finer spacing at the surface, for li2010 in a tank that does not roll. Default: "
       "particle_spacing_m."}},
     field("variant", &SphRun::variant, text(), no,
           "One part of `recommended` that is exchanged or left out."),
     field("initial_state", &SphRun::initial_state,
           one_of({"lattice", "settled", "projected"}, "how the particles start"), no,
           "How the particles start: on a lattice, after they have settled, or with the impulsive "
           "start's velocity projected onto a divergence-free one. Default: the scheme's."),
     field_of_part<SphRun>("smoothing_length_ratio", number_of(&SphNumbers::smoothing_length_ratio),
                           number().from(0.5, 10), no,
                           "h / dp, the smoothing length over the spacing. Default: the scheme's."),
     field_of_part<SphRun>(
         "sound_speed_ratio", number_of(&SphNumbers::sound_speed_ratio), number().from(1, 1000), no,
         "c0 / V_max, the speed of sound over the expected largest speed. Default: the scheme's."),
     {{"expected_speed",
       one_of({"estimate", "coarse_run"}, "where the expected largest speed comes from"), no,
       "Where V_max comes from: sqrt(g h) plus the tank's largest speed, or a first run of the "
       "same flow at a coarser spacing: see [The speed of "
       "sound](schemes.md#the-speed-of-sound). A coarse run is refused where tank and "
       "liquid are at rest. Default: estimate."},
      read_expected_speed},
     field_of_part<SphRun>("courant_number", number_of(&SphNumbers::courant_number),
                           number().from(0.001, 10), no, "Default: the scheme's."),
     field_of_part<SphRun>(
         "artificial_viscosity", number_of(&SphNumbers::artificial_viscosity), number().at_least(0),
         no, "The coefficient alpha of the artificial viscosity. Default: the scheme's."),
     field_of_part<SphRun>(
         "density_diffusion", number_of(&SphNumbers::density_diffusion), number().at_least(0), no,
         "The coefficient delta of the density diffusion. Default: the scheme's."),
     field("start_disorder", &SphRun::start_disorder, number("particle spacings").from(0, 0.2), no,
           "Each particle's start is shifted at random by up to this much."),
     field(
         "start_seed", &SphRun::start_seed, integer().at_least(0), no,
         "The seed of the shifts and of drawn inputs. It needs start_disorder > 0 or vary_inputs."),
     field("start_rotation_deg", &SphRun::start_rotation_deg, number("degrees").from(0, 45), no,
           "The angle by which the initial lattice is turned, in a rectangular tank without "
           "obstacles. It needs initial_state = \"settled\". Default: 0."),
     {{"repeats", integer().from(2, 1000), no,
       "The number of runs of an ensemble, which differ only in their seed. It needs "
       "start_disorder > 0 or vary_inputs."}},
     {{"quick_repeats", integer().from(1, Bound("repeats")), no,
       "How many of the repeats belong to the quick form of campaigns. It needs repeats and quick. "
       "Default: all."}},
     {{"vary_inputs", flag(), no,
       "Whether each repeat draws every [[input]] of the case anew, from the normal distribution "
       "with the declared 95 % interval, by its seed. It needs repeats. Default: false."}},
     field("energy_budget", &SphRun::energy_budget, flag(), no,
           "Whether the run records where the liquid's energy goes.")},
    finish_sph};

const FieldTable<InterFoamRun> interfoam_keys{
    key_table(
        "run.interfoam",
        "[[run]] with solver = \"interfoam\", \"interisofoam\" or \"compressible_interfoam\"", "no",
        "A run of the same tank by volume of fluid with a program of OpenFOAM: interFoam keeps the "
        "interface sharp by MULES, interIsoFoam by isoAdvector, and compressibleInterFoam is "
        "interFoam for a compressible liquid (sound at 1482 m/s) and a gas that is compressed at "
        "constant temperature, 20 °C, from 101325 Pa. SPH is compared with the finest mesh of "
        "interFoam.",
        {}, all_names(foam_solver_names)),
    {field("cells_x", &InterFoamRun::cells_x, integer().from(2, 10000), yes,
           "The number of cells along the tank."),
     field("cells_z", &InterFoamRun::cells_z, integer().from(2, 10000), yes,
           "The number of cells over the tank's height."),
     field("processes", &InterFoamRun::processes, integer().from(1, Bound("cells_x")), no,
           "The number of MPI processes. Default: 1."),
     field("courant_number", &InterFoamRun::courant_number, number().above(0).at_most(1), no,
           "The largest Courant number of any cell, which shortens the time step of violent flow. "
           "Default: 0.5."),
     field("interface_courant_number", &InterFoamRun::interface_courant_number,
           number().above(0).at_most(1), no,
           "The largest Courant number of the cells that the interface cuts. Default: "
           "courant_number."),
     field("outer_corrections", &InterFoamRun::outer_corrections, integer().from(1, 10), no,
           "How often a time step solves all equations (nOuterCorrectors). With 3, "
           "compressible_interfoam keeps the liquid's volume in breaking waves; the steps then "
           "damp a wave at the rate omega^2 dt / 2. Default: 1."),
     field("no_slip", &InterFoamRun::no_slip, flag(), no,
           "Whether the liquid sticks to the walls, which cells much thinner than the Stokes layer "
           "resolve: see wall_cell_m. Default: it slips."),
     {{"wall_cell_m", number("m").above(0), no,
       "The thickness of the cells beside all walls, three to five of them in a Stokes layer. From "
       "there each cell is thicker by a fifth at most, up to uniform ones in the middle; cells_x "
       "and cells_z stay the numbers of cells. Refused with an obstacle, outline_m or diameter_m. "
       "Default: uniform cells."}},
     field(
         "cells_y", &InterFoamRun::cells_y, integer().from(4, 1000), no,
         "Solves a narrow tank in three dimensions: the number of cells across half of breadth_m, "
         "from a gap wall to a plane of symmetry. They grow from wall_cell_m at the wall, each "
         "at most twice as thick as the one before; without that the last is seven times as thick "
         "as the first. It needs breadth_m and no_slip = true. Elevations are means over the gap, "
         "pressures, probes and fields are those in its middle, and loads stay per metre of "
         "breadth. Refused with an obstacle, outline_m or diameter_m. Default: two dimensions, "
         "with the friction of the gap walls as that of a porous medium."),
     field("start_disorder", &InterFoamRun::start_disorder, number("cell heights").from(0, 0.2), no,
           "The still level is disturbed by up to this much. Only a plain level can be disturbed: "
           "not a dam, an initial wave or a tank with obstacles."),
     field("start_seed", &InterFoamRun::start_seed, integer().at_least(0), no,
           "The same as for SPH."),
     {{"repeats", integer().from(2, 1000), no, "The same as for SPH."}},
     {{"quick_repeats", integer().from(1, Bound("repeats")), no, "The same as for SPH."}},
     {{"vary_inputs", flag(), no, "The same as for SPH."}}},
    finish_interfoam};

const FieldTable<LinearRun> linear_keys{
    key_table(
        "run.linear", "[[run]] with solver = \"linear\"", "no",
        "Linear potential theory, in closed form, or in a tank that is no rectangle by spectral "
        "elements. A dam, an obstacle, and a still tank without an initial wave are refused.",
        {}, {"linear"}),
    {{{"modes", integer().from(1, 100000),
       where("yes, but refused for a still tank's initial wave"),
       "The number of natural modes that are summed; at most 150 in a tank that is no rectangle, "
       "whose modes are computed."}},
     field("two_layer", &LinearRun::two_layer, flag(), no,
           "Whether the gas above the liquid takes part: the form to compare interFoam with. "
           "Refused in a tank that is no rectangle."),
     field("valid_elevation_over_depth", &LinearRun::valid_elevation_over_depth,
           number("fill depths").above(0).below(1).noting(": a trough of one bares the bottom"),
           yes,
           "The elevation up to which the solution may judge. Beyond it the curve is drawn and "
           "never gates.")},
    finish_linear};

const FieldTable<ViscousWaveRun> viscous_wave_keys{
    key_table(
        "run.viscous_wave", "[[run]] with solver = \"viscous_wave\"", "no",
        "The exact linear wave of a viscous liquid (Prosperetti 1976), of a still tank's initial "
        "wave.",
        {}, {"viscous_wave"}),
    {field("valid_elevation_over_depth", &ViscousWaveRun::valid_elevation_over_depth,
           number("fill depths").above(0).below(1).noting(": a trough of one bares the bottom"),
           yes, "The same as for linear theory.")},
    refuse_breadth<ViscousWaveRun>};

const FieldTable<PotentialRun> potential_keys{
    key_table("run.potential", "[[run]] with solver = \"potential\"", "no",
              "Fully nonlinear potential flow, spectral. The run ends where the solution leaves "
              "its range. "
              "A dam and an obstacle are refused.",
              {}, {"potential"}),
    {field("nodes_x", &PotentialRun::nodes_x, integer().from(16, 128), no,
           "The number of nodes along the tank. Default: 64."),
     field("nodes_z", &PotentialRun::nodes_z, integer().from(16, 128), no,
           "The number of nodes over the depth. Default: 24.")},
    refuse_breadth<PotentialRun>};

const FieldTable<RecordRun> record_keys{
    key_table("run.record", "[[run]] with solver = \"record\", shipped", "no",
              "A published series that lies beside the case file. It serves only as a reference.",
              {}, {"record"}),
    {{{"file", text("path, relative to the case file"), yes,
       "A CSV file: time_s and a compared quantity with its unit, as in front_position_m."}},
     {{"time_offset_s", number("s"), no, "Added to the file's times. Default: 0."}},
     field("earlier_run", &RecordRun::earlier_run, flag(), no,
           "Whether the series is an earlier run of this harness. Only rows of kind = "
           "\"regression\" may then rest on it."),
     {{"uncertainty", number("the record's unit").above(0), no,
       "Half the width of the record's 95 % interval."}}},
    finish_record};

const FieldTable<RecordRun> experiment_keys{
    key_table("run.experiment", "[[run]] with solver = \"record\", supplied by the user", "no",
              "A published series below the directory that `--experiments` or "
              "`SLOSH_EXPERIMENTS` names. Rows that need it are not compared where it is absent.",
              {}, {"record"}),
    {{{"experiment", text("path below that directory"), yes, "A CSV file."}},
     {{"time_column", text(), yes,
       "The name of the column of times, in s where the file does not say it."}},
     {{"value_column", text(), yes, "The name of the column of values."}},
     field("quantity", &RecordRun::quantity,
           known("compared quantity", "a compared quantity", compared_quantities), yes,
           "What the record measures."),
     {{"unit", text("unit of the quantity"), yes, "The unit of the values."}},
     {{"time_offset_s", number("s"), no, "The same as for a shipped record."}},
     {{"scale", number().above(0), no,
       "The values, and those of the band, are scale times their column. Default: 1."}},
     {{"lower_column", text(), beside("upper_column"),
       "The name of the column of a lower quantile of the experiment's repeats. The two make a "
       "band about the values, for outside_band."}},
     {{"upper_column", text(), beside("lower_column"), "The same of an upper quantile."}},
     {{"uncertainty", number("the record's unit").above(0), no,
       "The same as for a shipped record."}}},
    finish_experiment};

Rule<double> a_particle_spacing(const CaseDefinition& definition) {
  const double least = finest_spacing(definition), most = definition.liquid.fill_depth;
  return {
      fmt::format("a number > 0 and <= the fill depth ({:.4g}), in m, and >= {:.3g}, the spacing "
                  "of a hundred million particles",
                  most, least),
      [=](double value) { return value >= least && value <= most; }, most};
}

std::vector<RunDefinition> read_runs(const TomlTable& run, const CaseDefinition& definition) {
  const RunDefinition read = read_run(run, definition);
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
