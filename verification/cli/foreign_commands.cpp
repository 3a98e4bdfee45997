// The options of import and compare, which take what other programs left.

#include <memory>

#include "verification/cli/command_tree.hpp"
#include "verification/cli/compare_command.hpp"
#include "verification/cli/import_command.hpp"
#include "verification/import/import_series.hpp"

namespace slosh {
namespace {

void add_import_options(CLI::App& command, ImportOptions& options) {
  command.add_option("file", options.file, "A file that another program wrote")
      ->type_name(file_type)
      ->required();
  command.add_option("--format", options.format, "What wrote it")
      ->required()
      ->check(one_of("a format", import_formats()));
  command
      .add_option("--series", options.series,
                  "QUANTITY=COLUMN, as in elevation@right=swlz; may be given again")
      ->allow_extra_args(false)
      ->required();
  command.add_option("--unit", options.unit, "The columns' unit, where the file does not say it");
  command.add_option("--time", options.time_column, "The column of times, of csv and hdf5");
  command.add_option("--time-unit", options.time_unit, "Its unit, where the file does not say it");
  command.add_option("--scale", options.scale, "Multiplies the values, as 2 does for half a tank")
      ->check(keeps(not_zero("1")));
  command
      .add_option("--offset", options.offset,
                  "Is added to them in the quantity's SI unit, as -0.35 to a surface's height "
                  "above the bottom of a tank filled to 0.35 m")
      ->check(keeps(any_number("the quantity's SI unit")));
  command.add_option("-o,--output", options.output, "Result file")
      ->type_name(file_type)
      ->required();
}

void add_compare_options(CLI::App& command, CompareOptions& options) {
  command.add_option("candidate", options.candidate, "A result file")
      ->type_name(file_type)
      ->required();
  command.add_option("reference", options.reference, "A result file")
      ->type_name(file_type)
      ->required();
  CLI::Option* gauge = command.add_option("--gauge", options.gauge, "Compares elevation@GAUGE");
  command.add_option("--quantity", options.quantity, "Compares this series")->excludes(gauge);
  CLI::Option* of_case = command
                             .add_option("--case", options.case_name,
                                         "A case whose window, forcing and natural modes are taken")
                             ->type_name(case_type);
  command
      .add_option("--frequency", options.frequencies,
                  "Frequency of a mode to fit [Hz]; may be given again")
      ->allow_extra_args(false)
      ->check(keeps(positive("Hz")))
      ->excludes(of_case);
  command
      .add_option("--window", options.window,
                  "Begin and end [s] (default: the case's window, or what both series cover)")
      ->expected(2);
  command
      .add_option("--limit", options.limits,
                  "METRIC=VALUE or MODE:METRIC=VALUE, judged as a gate row is; may be given again")
      ->allow_extra_args(false);
  command.add_option("--json", options.json, "Leaves the comparison and the verdicts here")
      ->type_name(file_type);
}

}  // namespace

void add_foreign_commands(const CommandTree& tree) {
  const auto imported = std::make_shared<ImportOptions>();
  add_import_options(
      add_command(tree,
                  {"import",
                   "Leaves a result file of series that another program wrote",
                   {"./slosh run li2010_small_amplitude linear",
                    "./slosh import linear.h5 --format hdf5 --time /series/elevation@right/time "
                    "--series elevation@right=/series/elevation@right/value -o imported.h5"}},
                  [imported] { return import_file(*imported); }),
      *imported);
  const auto compared = std::make_shared<CompareOptions>();
  add_compare_options(
      add_command(tree,
                  {"compare",
                   "Compares two result files on a quantity, and judges",
                   {"./slosh run li2010_small_amplitude recommended_25mm",
                    "./slosh run li2010_small_amplitude linear",
                    "./slosh compare recommended_25mm.h5 linear.h5 --case li2010_small_amplitude "
                    "--gauge right --limit amplitude_error=0.05"}},
                  [compared, &installation = tree.installation] {
                    return compare_results(*compared, installation);
                  }),
      *compared);
}

}  // namespace slosh
