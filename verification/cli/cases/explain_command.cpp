// The subcommand explain: describes a case in words, with the known costs of its runs, or lists the
// keys of case files.

#include <iostream>
#include <memory>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/from_keys/key_schema.hpp"
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

int print_schema(const std::string& kind) {
  std::cout << (kind == "case" ? case_schema() : campaign_schema());
  return exit_pass;
}

struct ExplainOptions {
  std::string name, schema;
  bool keys = false;
};

int explain(const ExplainOptions& options, const Installation& installation) {
  if (options.keys) return print_keys();
  return options.schema.empty() ? explain(options.name, installation)
                                : print_schema(options.schema);
}

}  // namespace

void add_explain_command(const CommandTree& tree) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App& command = add_command(
      tree,
      {"explain",
       "Explains a case: its flow, its solvers and their costs, and its gate rows",
       {"./slosh explain li2010_small_amplitude", "./slosh explain --keys",
        "./slosh explain --schema case"}},
      [options, &installation = tree.installation] { return explain(*options, installation); });
  CLI::Option* name =
      command
          .add_option("case", options->name, "A case of `slosh list`, or the path of a case file")
          ->type_name(case_type);
  CLI::Option* keys =
      command.add_flag("--keys", options->keys,
                       "Instead of a case: all keys of case and campaign files, as Markdown");
  command
      .add_option("--schema", options->schema,
                  "Instead of a case: the JSON Schema of case or campaign files, for editors")
      ->type_name("KIND")
      ->check(one_of("a kind of file", {"case", "campaign"}))
      ->excludes(name)
      ->excludes(keys);
  keys->excludes(name);
  command.require_option(1);
}

}  // namespace slosh
