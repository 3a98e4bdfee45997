// The subcommand export: writes the series of a result file as a table.

#include <iostream>
#include <memory>

#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"
#include "verification/texts/result_text.hpp"

namespace slosh {
namespace {

struct ExportOptions {
  std::filesystem::path result, output;  // no output: standard output
  bool csv = false;                      // whatever the name of the output
};

int export_result(const ExportOptions& options) {
  if (!options.csv && options.output.empty())
    throw CaseFileError("export: expected --output FILE.csv, or --csv for the standard output");
  if (!options.csv && options.output.extension() != ".csv")
    throw CaseFileError("--output: " + options.output.string() +
                        ": expected a name that ends in .csv, or --csv for any other");
  const std::string text = series_csv(named_result(options.result));
  if (options.output.empty())
    std::cout << text;
  else
    replace_named(options.output, text, "export");
  return exit_pass;
}

}  // namespace

void add_export_command(const CommandTree& tree) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App& command = add_command(
      tree,
      {"export",
       "All series of a result file as a table of CSV",
       {"./slosh run li2010_small_amplitude linear", "./slosh export linear.h5 -o linear.csv"}},
      [options] { return export_result(*options); });
  command.add_option("result", options->result, "A result file")->type_name(file_type)->required();
  command.add_flag("--csv", options->csv, "As comma-separated values, whatever the file's name");
  command
      .add_option("-o,--output", options->output,
                  "The table, .csv (default, with --csv: standard output)")
      ->type_name(file_type);
}

}  // namespace slosh
