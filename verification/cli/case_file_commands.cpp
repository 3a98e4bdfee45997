// The subcommand explain: says all that is wrong with a case file and all that is doubtful about
// it, before anything runs, and describes the case in words, with the known costs of its runs; or
// lists the keys of case files.
//
// The subcommand new: writes a case file for the user to edit, with each key explained.
//
// The subcommand case: writes a case for another code, with the run that takes its output back.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include "reports/figures/case_figures.hpp"
#include "reports/model/report_files.hpp"
#include "reports/pages/report_documents.hpp"
#include "verification/assessment/doubts/case_doubts.hpp"
#include "verification/assessment/doubts/motion_noise.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/case_file/made_cases.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/texts/case_explanation.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"
#include "verification/peers/peer_codes.hpp"
#include "verification/peers/written_files.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/fitting_spacing.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// The theories that are sums of known functions, at most `most_samples` of each and ten times as
// many at all gauges together, without the estimates of what they leave out: they tell whether a
// theory leaves its range.
CaseRuns closed_forms(CaseDefinition definition) {
  constexpr double most_samples = 20'000;
  const auto gauges =
      static_cast<double>(definition.gauges.size() + definition.pressure_gauges.size());
  definition.sample_interval = std::max(
      definition.sample_interval, definition.duration * std::max(1.0, gauges / 10) / most_samples);
  RunSettings settings;
  settings.with_left_out = false;
  CaseRuns runs;
  for (const RunDefinition& run : definition.runs)
    if (std::holds_alternative<LinearRun>(run.solver) ||
        std::holds_alternative<ViscousWaveRun>(run.solver))
      runs.results[run.name] = execute(definition, run, settings, [](double, double) {});
  return runs;
}

void print_doubts(const CaseDefinition& definition) {
  const std::vector<std::string> doubts = case_doubts(definition, closed_forms(definition));
  std::string text = fmt::format("\n{}: nothing is wrong{}\n", definition.name,
                                 doubts.empty() ? " or doubtful" : "");
  for (const std::string& doubt : doubts) text += "doubtful: " + doubt + "\n";
  print_lines(text);
}

struct NewOptions {
  std::string name, like;  // like or minimal
  bool minimal = false;
  fs::path output;  // empty: NAME.toml
};

// 25 lines, without a sentence that belongs to another case.
constexpr const char* minimal_case =
    R"(# Next: ./slosh explain {0}.toml, ./slosh campaign {0}.toml. All keys: ./slosh explain --keys
schema_version = 1
name = "{0}"
title = "{0}"
source = "own"
tank = {{ length_m = 2.0, height_m = 1.0 }}        # or a polygon of corners, or a cylinder
liquid.fill_depth_m = 0.5                         # of water
motion.surge = {{ type = "sine", amplitude_m = 0.01, frequency_Hz = 0.35 }}  # or roll; measured: docs/tutorial.md
time = {{ start = "tank", duration_s = 12.0, sample_interval_s = 0.02 }}
comparison = {{ window_begin_s = 2.0, natural_modes = 1 }}       # docs/concepts.md
gauge = [{{ name = "right", x_m = 1.95 }}]          # of the surface; pressures and forces: docs/results.md
[[run]]
name = "theory"
solver = "linear"
modes = 100
valid_elevation_over_depth = 0.1
[[run]]                                           # your code or its file: docs/other_solvers.md
name = "sph_20mm"
solver = "sph"
scheme = "recommended"
particle_spacing_m = 0.02
[[gate]]                                          # other limits, as of loads: docs/gating.md
candidate = "sph_20mm"
reference = "theory"
limits.amplitude_error = {{ limit = 0.05, reason = "to be chosen", source = "own" }}
)";

std::string minimal_text(const std::string& name) {
  if (!file_safe_name().holds(name))
    throw CaseFileError("name = \"" + name + "\": expected " + file_safe_name().expected);
  return fmt::format(minimal_case, name);
}

int leave_case(const NewOptions& options, const Installation& installation) {
  if (options.like.empty() && !options.minimal)
    throw CaseFileError("new: expected --minimal, or --like and the case to begin with");
  const fs::path file = options.output.empty() ? fs::path(options.name + ".toml") : options.output;
  const std::string text =
      options.minimal
          ? minimal_text(options.name)
          : commented_case(read_case(find_case(options.like, installation.cases)), options.name);
  if (fs::exists(file))
    throw CaseFileError("--output: " + file.string() +
                        ": expected a file that is not there yet, as it is not to be lost");
  replace_file(file, text, Durability::process_crash);
  std::cout << "case: " << file.string() << "\n";
  return exit_pass;
}

KnownRun known_run(const CaseDefinition& definition, const RunDefinition& run,
                   const Installation& installation) {
  const std::string key =
      run_key(definition, run, installation.builds, installation.openfoam_templates);
  KnownRun known{.cost =
                     expected_cost(definition, run, key, ResultStore(usual_store(installation)))};
  if (solver_kind(run).has_particles) known.start = sph_outline(definition, run);
  known.step = sph_step(definition, run);
  return known;
}

// The tank and its motion, on a page.
void leave_drawings(const CaseDefinition& definition, const Installation& installation) try {
  std::vector<reports::Figure> figures = motion_figures(definition);
  figures.insert(figures.begin(), tank_figure(definition));
  // No case's name has a dot.
  const fs::path page = shown_page(installation, definition.name + ".tank");
  const reports::TemporaryDirectory scratch((page.parent_path() / ".drawing-").string());
  replace_own(page, reports::figure_page(definition.title, figures, {}, scratch.path()));
  std::cout << "\ndrawings: " << page.string() << "\n";
} catch (const reports::ReportError& error) {
  std::cerr << "no drawings: " << error.what() << "\n";
}

struct ExplainOptions {
  std::string name, schema;
  bool keys = false;
  fs::path experiments;
};

int explain_case(const ExplainOptions& options, const Installation& installation) {
  const CaseDefinition definition =
      read_case(find_case(options.name, installation.cases), whole(options.experiments));
  require_runnable(std::vector<CaseDefinition>{definition});
  std::map<std::string, KnownRun> known;
  for (const RunDefinition& run : definition.runs)
    known[run.name] = known_run(definition, run, installation);
  std::cout << explanation(definition, known);
  print_doubts(definition);
  leave_drawings(definition, installation);
  return exit_pass;
}

int explain(const ExplainOptions& options, const Installation& installation) {
  if (!options.keys && options.schema.empty()) return explain_case(options, installation);
  std::cout << (options.keys               ? key_reference()
                : options.schema == "case" ? case_schema()
                                           : campaign_schema());
  return exit_pass;
}

struct CaseOptions {
  std::string case_name, code;
  std::optional<double> spacing;
  fs::path output;
};

// The coarsest of the case's SPH runs, or a twentieth of the depth.
double usual_spacing(const CaseDefinition& definition) {
  double coarsest = 0;
  for (const RunDefinition& run : definition.runs)
    if (const auto* sph = std::get_if<SphRun>(&run.solver))
      coarsest = std::max(coarsest, sph->particle_spacing);
  return coarsest > 0 ? coarsest : definition.liquid.fill_depth / 20;
}

// Returns the spacing nearest to this one, or finer, that divides the liquid; this one itself where
// there is none of a sixty-fourth of it or more.
double dividing_spacing(const CaseDefinition& definition, double spacing) {
  for (double near = spacing; near > spacing / 64; near /= 2) {
    const std::optional<double> found = nearest_fitting_spacing(definition, near);
    if (found && is_whole_multiple(definition.liquid.fill_depth, *found)) return *found;
  }
  return spacing;
}

// The cells of a spacing, those of the case's first interFoam run, or those of the usual spacing.
std::pair<int, int> cells_of(const CaseDefinition& definition, const CaseOptions& options) {
  if (!options.spacing)
    for (const RunDefinition& run : definition.runs)
      if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
        return {mesh->cells_x, mesh->cells_z};
  const double size = options.spacing.value_or(usual_spacing(definition));
  const auto cells = [&](double length) {
    return std::max(2, static_cast<int>(std::lround(length / size)));
  };
  return {cells(definition.tank.length), cells(definition.tank.height)};
}

// Throws for a spacing of more rows than any code computes: their number would overflow.
void require_usual_size(const CaseDefinition& definition, const std::optional<double>& spacing) {
  constexpr double most_rows = 10000;
  const double depth = definition.liquid.fill_depth;
  if (spacing && !(*spacing <= depth && depth / *spacing <= most_rows))
    throw CaseFileError(fmt::format(
        "--spacing: {:g}: expected a spacing of at most the fill depth, {:g} m, and of at least a "
        "ten-thousandth of it",
        *spacing, depth));
}

int leave_case_for_code(const CaseOptions& options, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  require_usual_size(definition, options.spacing);
  const auto [cells_x, cells_z] = cells_of(definition, options);
  const double spacing =
      options.spacing.value_or(dividing_spacing(definition, usual_spacing(definition)));
  try {
    write_for_code(options.code, {.definition = definition,
                                  .spacing = spacing,
                                  .cells_x = cells_x,
                                  .cells_z = cells_z,
                                  .place = whole(options.output),
                                  .openfoam_templates = installation.openfoam_templates});
  } catch (const fs::filesystem_error& error) {
    throw CaseFileError(std::string("--output: ") + error.what());
  }
  std::cout << "case: " << options.output.string() << "\n" << doubtful_motion(definition);
  return exit_pass;
}

}  // namespace

void add_new_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<NewOptions>(
      tree,
      {"new",
       "Writes a case file to edit, like another case, with each key explained",
       {"./slosh new my_tank --minimal",
        "./slosh new my_wave --like li2010_small_amplitude -o my_wave.toml"}},
      leave_case);
  add_option(command, "name", options.name, "NAME", "The name of the new case")->required();
  CLI::Option* like =
      add_option(command, "--like", options.like, case_type,
                 "The case to begin with: one of `slosh list`, or the path of a case file");
  command.add_flag("--minimal", options.minimal, "Begin with a small tank in surge, in 25 lines")
      ->excludes(like);
  add_option(command, "-o,--output", options.output, file_type,
             "The new case file (default: NAME.toml)");
}

void add_explain_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<ExplainOptions>(
      tree,
      {"explain",
       "Says what is wrong with a case file (exit status 2), or explains the case: its flow, its "
       "solvers and their costs, its gate rows, and what is doubtful about it",
       {"./slosh explain li2010_small_amplitude", "./slosh explain --keys",
        "./slosh explain --schema case"}},
      explain);
  CLI::Option* name = add_case_argument(command, options.name);
  add_experiments_option(command, options.experiments);
  CLI::Option* keys =
      command.add_flag("--keys", options.keys,
                       "Instead of a case: all keys of case and campaign files, as Markdown");
  add_option(command, "--schema", options.schema, "KIND",
             "Instead of a case: the JSON Schema of case or campaign files, for editors")
      ->check(one_of("a kind of file", {"case", "campaign"}))
      ->excludes(name)
      ->excludes(keys);
  keys->excludes(name);
  command.require_option();
}

void add_case_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<CaseOptions>(
      tree,
      {"case",
       "Writes a case for another code, with the run that takes its output back",
       {"./slosh case li2010_small_amplitude --for dualsphysics -o li2010_dualsphysics",
        "./slosh case zhao2021_mild_roll --for csv -o zhao2021_tables"}},
      leave_case_for_code);
  add_case_argument(command, options.case_name)->required();
  add_option(command, "--for", options.code, "CODE", "The code")
      ->check(one_of("a code", peer_code_names()))
      ->required();
  add_option(command, "--spacing", options.spacing, "DP",
             "Spacing of particles or size of cells, in m (default: the nearest to that of the "
             "case's coarsest SPH run that divides the liquid; the cells of its first "
             "interFoam run)")
      ->check(keeps(positive("m")));
  add_option(command, "-o,--output", options.output, directory_type,
             "The directory to write, which is not there yet or empty")
      ->required();
}

}  // namespace slosh
