// The subcommand check: says all that is wrong with a case file, and all that is doubtful about it,
// before anything runs.

#include <algorithm>
#include <iostream>
#include <memory>

#include "verification/assessment/doubts/case_doubts.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

struct CheckOptions {
  std::string case_name;
  std::filesystem::path experiments;
};

// The theories that are sums of known functions, at most `most_samples` of each, without the
// estimates of what they leave out: they tell whether a theory leaves its range.
CaseRuns closed_forms(CaseDefinition definition) {
  constexpr double most_samples = 20'000;
  definition.sample_interval =
      std::max(definition.sample_interval, definition.duration / most_samples);
  RunSettings settings;
  settings.with_left_out = false;
  CaseRuns runs;
  for (const RunDefinition& run : definition.runs)
    if (std::holds_alternative<LinearRun>(run.solver) ||
        std::holds_alternative<ViscousWaveRun>(run.solver))
      runs.results[run.name] = execute(definition, run, settings, [](double, double) {});
  return runs;
}

int check(const CheckOptions& options, const Installation& installation) {
  const CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), whole(options.experiments));
  require_runnable(std::vector<CaseDefinition>{definition});
  const std::vector<std::string> doubts = case_doubts(definition, closed_forms(definition));
  std::cout << definition.name << ": nothing is wrong";
  if (doubts.empty()) std::cout << " or doubtful";
  std::cout << "\n";
  for (const std::string& doubt : doubts) std::cout << "doubtful: " << doubt << "\n";
  return exit_pass;
}

}  // namespace

void add_check_command(const CommandTree& tree) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App& command = add_command(
      tree,
      {"check",
       "Says what is wrong with a case file (exit status 2), and what is doubtful about it",
       {"./slosh check li2010_small_amplitude"}},
      [options, &installation = tree.installation] { return check(*options, installation); });
  command
      .add_option("case", options->case_name, "A case of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
  add_experiments_option(command, options->experiments);
}

}  // namespace slosh
