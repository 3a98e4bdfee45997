// The subcommand explain: a case in words, with what its runs took where a campaign left a result.

#include <iostream>
#include <memory>

#include "verification/case_file/case_parser.hpp"
#include "verification/commands/case_explanation.hpp"
#include "verification/commands/command_tree.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Of the first result among those of all campaigns that answers what this run asks, by this build
// or another.
std::optional<RunCost> measured_cost(const CaseDefinition& definition, const RunDefinition& run,
                                     const Installation& installation) {
  const fs::path campaigns = installation.build / "campaigns";
  if (!fs::is_directory(campaigns)) return {};
  const std::string key =
      run_key(definition, run, installation.solver_build, installation.openfoam_templates);
  for (const auto& campaign : fs::directory_iterator(campaigns)) {
    const fs::path file = campaign.path() / "runs" / definition.name / (run.name + ".h5");
    if (!fs::exists(file)) continue;
    try {
      const RunResult result = read_result(file);
      if (asks_the_same(result.key, key)) return result.cost;
    } catch (const ResultError&) {
      continue;  // half a result tells no cost
    }
  }
  return {};
}

int explain(const std::string& name, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(name, installation.cases));
  std::map<std::string, KnownRun> known;
  for (const RunDefinition& run : definition.runs) {
    KnownRun& one = known[run.name];
    one.measured = measured_cost(definition, run, installation);
    if (std::holds_alternative<SphRun>(run.solver)) one.start = sph_outline(definition, run);
  }
  std::cout << explanation(definition, known);
  return exit_pass;
}

}  // namespace

void add_explain_command(const CommandTree& tree) {
  auto name = std::make_shared<std::string>();
  CLI::App& command = add_command(
      tree,
      {"explain",
       "What a case solves, by what, what gates it and what it costs",
       {"./slosh explain li2010_small_amplitude"}},
      [name, &installation = tree.installation] { return explain(*name, installation); });
  command.add_option("case", *name, "A case of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
}

}  // namespace slosh
