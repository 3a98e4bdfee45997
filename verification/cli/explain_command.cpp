// The subcommand explain: describes a case in words, with the known costs of its runs, or lists the
// keys of case files.

#include <iostream>
#include <memory>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/texts/case_explanation.hpp"

namespace slosh {
namespace {

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

int explain(const std::string& name, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(name, installation.cases));
  std::map<std::string, KnownRun> known;
  for (const RunDefinition& run : definition.runs)
    known[run.name] = known_run(definition, run, installation);
  std::cout << explanation(definition, known);
  return exit_pass;
}

int print_keys() {
  std::cout << key_reference();
  return exit_pass;
}

struct ExplainOptions {
  std::string name;
  bool keys = false;
};

}  // namespace

void add_explain_command(const CommandTree& tree) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App& command =
      add_command(tree,
                  {"explain",
                   "Explains a case: its flow, its solvers and their costs, and its gate rows",
                   {"./slosh explain li2010_small_amplitude", "./slosh explain --keys"}},
                  [options, &installation = tree.installation] {
                    return options->keys ? print_keys() : explain(options->name, installation);
                  });
  CLI::Option* name =
      command
          .add_option("case", options->name, "A case of `slosh list`, or the path of a case file")
          ->type_name(case_type);
  CLI::Option* keys =
      command.add_flag("--keys", options->keys,
                       "Instead of a case: all keys of case and campaign files, as Markdown");
  keys->excludes(name);
  command.require_option(1);
}

}  // namespace slosh
