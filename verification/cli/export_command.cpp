// The subcommand export: writes series as a table, for people who want them for plots of their own:
// those of a result file, or the theories of a case. It starts neither SPH nor interFoam.

#include <unistd.h>

#include <iostream>
#include <memory>

#include "verification/assessment/references/case_theories.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/cli/texts/result_text.hpp"
#include "verification/engine/progress_display.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  fs::path source;  // a result file; or a case, by its name or its path
  fs::path output;  // empty: standard output
  fs::path store;
  bool csv = false;  // whatever the name of the output
};

bool is_case(const fs::path& source) {
  return source.extension() == ".toml" || !(source.has_extension() || fs::exists(source));
}

int export_result(const ExportOptions& options) {
  if (!options.csv && options.output.empty())
    throw CaseFileError("export: expected --output FILE.csv, or --csv for the standard output");
  if (!options.csv && options.output.extension() != ".csv")
    throw CaseFileError("--output: " + options.output.string() +
                        ": expected a name that ends in .csv, or --csv for any other");
  const std::string text = series_csv(named_result(options.source));
  if (options.output.empty())
    std::cout << text;
  else
    replace_named(options.output, text, "export");
  return exit_pass;
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

int export_theories(const ExportOptions& options, const Installation& installation) {
  const bool table = options.csv || options.output.extension() == ".csv";
  if (options.output.empty() || !(table || options.output.extension() == ".h5"))
    throw CaseFileError("--output: " + options.output.string() +
                        ": expected a name that ends in .csv or .h5");
  const CaseDefinition definition =
      read_case(find_case(options.source.string(), installation.cases));
  const OpenOutputs output(options.output, "export");
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
  theories.result.provenance.merge(provenance("./slosh export " +
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

void add_export_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<ExportOptions>(
      tree,
      {"export",
       "The series of a result file, or the theories of a case, as a table of CSV",
       {"./slosh run li2010_small_amplitude linear", "./slosh export linear.h5 -o linear.csv",
        "./slosh export standing_wave_re50 -o truth.csv",
        "./slosh export standing_wave_re50 -o truth.h5"}},
      [](const ExportOptions& given, const Installation& installation) {
        return is_case(given.source) ? export_theories(given, installation) : export_result(given);
      });
  add_option(command, "source", options.source, file_type,
             "A result file; or a case of `slosh list` or the path of a case file, whose "
             "theories are computed, each with its range and its uncertainty")
      ->required();
  command.add_flag("--csv", options.csv, "As comma-separated values, whatever the file's name");
  add_option(command, "-o,--output", options.output, file_type,
             "The table, .csv (default of a result, with --csv: standard output), with "
             "remarks on theories in lines that begin with a #; theories also as a result "
             "file, .h5, with the remarks in its provenance");
  add_shared_store_option(command, options.store, tree.installation);
}

}  // namespace slosh
