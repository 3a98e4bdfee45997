// The subcommand converge: compares an SPH scheme of a case, or an external program's method, at
// several spacings with a reference.
// It writes a case file for this study, and runs and compares it as a campaign does.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "verification/campaign/campaign_run.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/made_cases.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/texts/result_text.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct ConvergeOptions {
  std::string case_name, quantity;
  SpacingStudy study;
  fs::path output, experiments, store;
  int at_once = 1;
  bool as_json = false;
};

// SPH has no gas, so two-layer theory is no reference for it.
bool can_refer(const RunDefinition& run) {
  if (const auto* record = std::get_if<RecordRun>(&run.solver)) return record->supplied;
  return solver_kind(run).can_refer && !(is_theory(run) && sees_gas(run));
}

// Returns the first theory or record that the case declares, or else its last interFoam run: case
// files list meshes from coarse to fine.
std::string default_reference(const CaseDefinition& definition) {
  std::string mesh;
  for (const RunDefinition& run : definition.runs) {
    if (!can_refer(run)) continue;
    if (!is_simulation(run)) return run.name;
    mesh = run.name;
  }
  if (mesh.empty())
    throw CaseFileError(definition.file.string() +
                        ": expected a run that the scheme can be compared with, of any solver but "
                        "SPH");
  return mesh;
}

std::string asked_quantity(const CaseDefinition& definition, const std::string& asked) {
  const std::vector<std::string> known = compared_quantities(definition);
  if (asked.empty()) return known.front();
  if (std::find(known.begin(), known.end(), asked) != known.end()) return asked;
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  throw CaseFileError(fmt::format("quantity = {}: expected one of {}", asked, names));
}

// Writes the case file and reads it, so that its mistakes are reported before anything runs.
CaseDefinition made_case(const CaseDefinition& definition, const SpacingStudy& study,
                         const fs::path& file, const fs::path& experiments) {
  const StudyText text = spacing_study_text(definition, study);
  for (const auto& [source, place] : text.tables) {
    const fs::path copy = file.parent_path() / place;
    if (std::error_code absent; fs::equivalent(source, copy, absent)) continue;
    replace_own(copy, read_input(source));
  }
  replace_own(file, text.text);
  CaseDefinition made = read_case(file, experiments);
  for (const RunDefinition& run : made.runs) require_runnable(made, run);
  return made;
}

// The order is that of a campaign: a failed solver comes before a reference out of its range.
int status_of(const ConvergenceStudy& study) {
  const auto& states = study.assessment.runs.status;
  for (const auto& [run, status] : states)
    if (status.state == RunState::failed) return exit_solver_failed;
  const bool may_judge = states.at(study.question.reference).state == RunState::finished;
  return may_judge && !study.found.metrics.empty() ? exit_pass : exit_not_compared;
}

int converge(const ConvergeOptions& options, const CommandTree& tree) {
  if (options.study.candidate.empty() && options.study.family.empty())
    throw CaseFileError("expected --candidate RUN or --family NAME");
  tree.stop_on_signals();
  const fs::path experiments = whole(options.experiments);
  const CaseDefinition definition =
      read_case(find_case(options.case_name, tree.installation.cases), experiments);
  SpacingStudy study = options.study;
  if (study.reference.empty()) study.reference = default_reference(definition);
  const std::string quantity = asked_quantity(definition, options.quantity);
  const std::string scheme = study.candidate.empty() ? study.family : study.candidate;
  const fs::path output = whole(options.output.empty() ? tree.installation.build / "converge" /
                                                             (definition.name + "-" + scheme)
                                                       : options.output);
  const fs::path file = output / (definition.name + ".toml");
  for (const RunDefinition& run : definition.runs) protect_inputs(definition, run);
  const CaseDefinition made = made_case(definition, study, file, experiments);
  const CampaignSettings settings{.output = output,
                                  .store = ResultStore(whole(options.store)),
                                  .campaign_file = {},
                                  .executable = tree.installation.executable,
                                  .builds = tree.installation.builds,
                                  .openfoam_templates = tree.installation.openfoam_templates,
                                  .experiments = experiments,
                                  .at_once = options.at_once};
  const double finest = *std::min_element(study.spacings.begin(), study.spacings.end());
  const auto lock = lock_output(output, tree.stop);
  ConvergenceStudy done{
      assess(made, run_campaign_jobs({made}, {}, settings, tree.stop).cases.front()),
      {study_run_name(study, finest), study.reference, quantity},
      {}};
  done.found = convergence_of(done.assessment, done.question);
  std::cout << (options.as_json ? json_of(done) : text_of(done));
  return status_of(done);
}

}  // namespace

void add_converge_command(const CommandTree& tree) {
  const std::string example =
      "./slosh converge li2010_small_amplitude --family recommended --spacings 0.05,0.035,0.025 "
      "-o orders";
  const auto [command, options] = add_command_with<ConvergeOptions>(
      tree,
      {"converge",
       "Runs an SPH scheme, or your program, at several spacings and tells the order of its errors",
       {example, example + " --json"}},
      [tree](const ConvergeOptions& given, const Installation&) { return converge(given, tree); });
  add_case_argument(command, options.case_name)->required();
  CLI::Option* candidate =
      add_option(command, "--candidate", options.study.candidate, run_type,
                 "A run of the case, all of whose settings but the spacing are kept");
  add_option(command, "--family", options.study.family, "NAME",
             "Or a scheme as it is, or the method of an external run of the case")
      ->excludes(candidate);
  add_option(command, "--spacings", options.study.spacings, "M,M,M",
             "Three or more particle spacings [m]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  add_option(command, "--reference", options.study.reference, run_type,
             "The run of the case to compare with (default: its first theory or record)");
  add_option(command, "--quantity", options.quantity, "QUANTITY",
             "What is compared (default: what the case is about)");
  add_option(command, "-o,--output", options.output, directory_type,
             "Directory of the case file that is made and its results (default: "
             "build/converge/CASE-SCHEME)");
  command.add_flag("--json", options.as_json, "As JSON");
  add_jobs_option(command, options.at_once, "Runs side by side");
  add_experiments_option(command, options.experiments);
  add_shared_store_option(command, options.store, tree.installation);
}

}  // namespace slosh
