// The subcommand new: writes a case file for the user to edit, with each key explained.

#include <iostream>
#include <memory>

#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/from_keys/commented_case.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

struct NewOptions {
  std::string name, like;
  std::filesystem::path output;  // empty: NAME.toml
};

int leave_case(const NewOptions& options, const Installation& installation) {
  const std::filesystem::path file =
      options.output.empty() ? std::filesystem::path(options.name + ".toml") : options.output;
  const std::string text =
      commented_case(read_case(find_case(options.like, installation.cases)), options.name);
  if (std::filesystem::exists(file))
    throw CaseFileError("--output: " + file.string() +
                        ": expected a file that is not there yet, as it is not to be lost");
  replace_file(file, text, Durability::process_crash);
  std::cout << "case: " << file.string() << "\n";
  return exit_pass;
}

}  // namespace

void add_new_command(const CommandTree& tree) {
  auto options = std::make_shared<NewOptions>();
  CLI::App& command = add_command(
      tree,
      {"new",
       "Writes a case file to edit, like another case, with each key explained",
       {"./slosh new my_tank --like li2010_small_amplitude -o my_tank.toml"}},
      [options, &installation = tree.installation] { return leave_case(*options, installation); });
  command.add_option("name", options->name, "The name of the new case")
      ->type_name("NAME")
      ->required();
  command
      .add_option("--like", options->like,
                  "The case to begin with: one of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
  command.add_option("-o,--output", options->output, "The new case file (default: NAME.toml)")
      ->type_name(file_type);
}

}  // namespace slosh
