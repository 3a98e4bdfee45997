// The subcommand reference: leaves the theories of a case in one file, for people who want the
// truth for plots of their own. It starts neither SPH nor interFoam.

#include <unistd.h>

#include <iostream>
#include <memory>

#include "verification/assessment/references/case_theories.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/display/progress_display.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/texts/result_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct ReferenceOptions {
  std::string case_name;
  fs::path output, store;
};

bool is_table(const fs::path& file) {
  if (file.extension() == ".csv") return true;
  if (file.extension() == ".h5") return false;
  throw CaseFileError("--output: " + file.string() + ": expected a name that ends in .csv or .h5");
}

RunResult computed(const CaseDefinition& definition, const RunDefinition& run,
                   const RunSettings& settings, const ExpectedCost& expected) {
  RunDisplay display(std::cerr, style_now_of(STDERR_FILENO), definition.name + "/" + run.name,
                     expected.wall_time);
  return execute(definition, run, settings, [&](double time, double steps) {
    display.tell({time, definition.duration, steps});
  });
}

// Returns the result of the store, or computes it and keeps it there.
RunResult theory_result(const CaseDefinition& definition, const RunDefinition& run,
                        const ResultStore& store, const Installation& installation) {
  const std::string key =
      run_key(definition, run, installation.builds, installation.openfoam_templates);
  if (std::optional<RunResult> kept = kept_run(store, key)) return *std::move(kept);
  const std::string command = "./slosh run " + name_or_path(definition.file, installation.cases) +
                              " " + run.name + " --output " + run.name + ".h5";
  const RunResult result = computed(definition, run,
                                    {.work_directory = {},
                                     .openfoam_templates = installation.openfoam_templates,
                                     .key = key,
                                     .command = command},
                                    expected_cost(definition, run, key, store));
  keep_copy(store, key, result);
  return result;
}

int leave_references(const ReferenceOptions& options, const Installation& installation) {
  const bool table = is_table(options.output);
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  const OpenOutputs output(options.output, "reference");
  const ResultStore store(whole(options.store));
  CaseRuns runs;
  for (const RunDefinition& run : definition.runs)
    if (is_theory(run))
      runs.results[run.name] = theory_result(definition, run, store, installation);
  if (runs.results.empty())
    throw ResultError(definition.file.string() +
                      ": run: expected one whose solver is a theory (linear, viscous_wave or "
                      "potential); the case has no such reference");
  CaseTheories theories = case_theories(definition, runs);
  theories.result.provenance.merge(provenance("./slosh reference " +
                                              name_or_path(definition.file, installation.cases) +
                                              " --output " + options.output.filename().string()));
  output.make_room();
  if (table)
    replace_file(options.output, theory_csv(definition, theories), Durability::process_crash);
  else
    write_result(theories.result, options.output);
  bool all_inside = true;
  for (const TheoryRemarks& remarks : theories.remarks) {
    (remarks.outside ? std::cerr << "slosh: " : std::cout) << theory_line(remarks) << "\n";
    all_inside &= !remarks.outside;
  }
  std::cout << "references: " << options.output.string() << "\n";
  return all_inside ? exit_pass : exit_not_compared;
}

}  // namespace

void add_reference_command(const CommandTree& tree) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App& command = add_command(
      tree,
      {"reference",
       "The theories of a case as a table or a result file, each with its range and uncertainty",
       {"./slosh reference standing_wave_re50 -o truth.csv",
        "./slosh reference standing_wave_re50 -o truth.h5"}},
      [options, &installation = tree.installation] {
        return leave_references(*options, installation);
      });
  command
      .add_option("case", options->case_name, "A case of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
  command
      .add_option("-o,--output", options->output,
                  "The file: a table, .csv, with the remarks in lines that begin with a #, or a "
                  "result file, .h5, with the remarks in its provenance")
      ->type_name(file_type)
      ->required();
  add_shared_store_option(command, options->store, tree.installation);
}

}  // namespace slosh
