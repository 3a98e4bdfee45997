// The tree of subcommands (CLI11). Each subcommand has a file in this folder and one function that
// adds it to the tree; parsing the command line selects the action that main.cpp executes. Actions
// throw CaseFileError, SolverError, ResultError and ReportError, which main.cpp turns into messages
// and exit statuses.
//
// Where the tool's data lies, and how command lines name paths.
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verification/input/rules.hpp"

namespace slosh {

struct Installation {
  std::filesystem::path executable, builds, source, cases, campaigns, baselines, openfoam_templates,
      build;
};

inline constexpr const char* store_variable = "SLOSH_STORE";

// Returns the directory of the results that campaigns share: SLOSH_STORE of the environment, or
// build/store.
std::filesystem::path usual_store(const Installation& installation);

// Returns where `show` and `explain` leave a page of this name. Throws CaseFileError where its
// directory is a link or a file.
std::filesystem::path shown_page(const Installation& installation, const std::string& name);

// Returns how a command line names the file: a shipped one by its name, any other by its path.
std::string name_or_path(const std::filesystem::path& file, const std::filesystem::path& shipped);

// Returns the absolute path without dots and links. An empty path stays empty.
std::filesystem::path whole(const std::filesystem::path& path);

// Returns the option by which a command finds the user's records; empty if no directory is named.
std::string experiments_option(const std::filesystem::path& experiments);

inline constexpr const char* not_printed =
    "standard output: expected a place that takes all that is printed";

// What the tool says where nothing is asked of it.
inline constexpr const char* first_steps =
    "./slosh new my_tank --minimal                  writes a case file of a tank to edit\n"
    "./slosh explain my_tank.toml                   says what it computes, and what is wrong or "
    "doubtful\n"
    "./slosh campaign my_tank.toml                  runs, compares and judges it, with a report\n"
    "./slosh compare mine.csv --case my_tank.toml   sets a series of your own against its theory\n"
    "./slosh --help                                 lists all commands\n";

// Returns the exit status.
using Action = std::function<int()>;

struct CommandTree {
  CLI::App& app;  // the tool, or a subcommand with subcommands of its own
  const Installation& installation;
  const std::atomic<bool>& stop;
  void (*stop_on_signals)();  // after this call SIGINT and SIGTERM set `stop`
  Action& action;
};

void add_campaign_command(const CommandTree& tree);
void add_gate_command(const CommandTree& tree);
void add_baseline_commands(const CommandTree& tree);  // baseline diff, propose, approve
void add_run_command(const CommandTree& tree);
void add_job_command(const CommandTree& tree);
void add_import_command(const CommandTree& tree);
void add_compare_command(const CommandTree& tree);
void add_export_command(const CommandTree& tree);
void add_show_command(const CommandTree& tree);
void add_store_command(const CommandTree& tree);
void add_new_command(const CommandTree& tree);
void add_case_command(const CommandTree& tree);
void add_list_command(const CommandTree& tree);
void add_explain_command(const CommandTree& tree);
void add_converge_command(const CommandTree& tree);

// Adds all of them, and the end of --help.
void add_all_commands(const CommandTree& tree);

struct CommandText {
  const char *name, *description;
  // Lines "./slosh ..." at the end of the command's --help, and "printf ..." where one needs a
  // file. A test runs them one after another in a scratch directory.
  std::vector<std::string> examples;
};

CLI::App& add_command(const CommandTree& tree, const CommandText& text, Action action);

// Adds a command that does `act(options, installation)` with options of its own: the environment
// fills in the options of every command, whether the command is called or not.
template <class Options>
struct AddedCommand {
  CLI::App& command;
  Options& options;
};
template <class Options, class Act>
AddedCommand<Options> add_command_with(const CommandTree& tree, const CommandText& text, Act act) {
  const auto options = std::make_shared<Options>();
  return {add_command(tree, text, [=, &data = tree.installation] { return act(*options, data); }),
          *options};
}
void give_examples(CLI::App& command, const std::vector<std::string>& examples);

// Options that several commands have. The type of a value says what it names.
inline constexpr const char *campaign_type = "CAMPAIGN", *case_type = "CASE", *run_type = "RUN",
                            *pattern_type = "PATTERN", *tag_type = "TAG", *file_type = "FILE",
                            *directory_type = "DIR";
// Adds an option whose value is of this type.
template <class Value>
CLI::Option* add_option(CLI::App& command, const std::string& names, Value& value, const char* type,
                        const std::string& text) {
  return command.add_option(names, value, text)->type_name(type);
}
// Returns the validator without its description, which --help would show beside the type.
CLI::Validator unnamed(CLI::Validator validator);
// Checks a number by a rule for case files: it must be finite, and is refused in the same words.
template <class T>
CLI::Validator keeps(const Rule<T>& rule) {
  return unnamed(CLI::Validator(
      [rule](const std::string& text) {
        T value{};
        const bool is_number =
            CLI::detail::lexical_cast(text, value) && std::isfinite(static_cast<double>(value));
        return is_number && rule.holds(value) ? "" : text + ": expected " + rule.expected;
      },
      ""));
}
// Accepts one of these names, which --help lists. `expected` says what they name: "a shell".
CLI::Validator one_of(const std::string& expected, const std::vector<std::string>& names);
CLI::Option* add_case_argument(
    CLI::App& command, std::string& name,
    const char* what = "A case of `slosh list`, or the path of a case file");
void add_experiments_option(CLI::App& command, std::filesystem::path& experiments);
// The directory of the results that campaigns share: the option, SLOSH_STORE or build/store.
void add_shared_store_option(CLI::App& command, std::filesystem::path& store,
                             const Installation& installation);
void add_jobs_option(CLI::App& command, int& at_once, const char* what);

// The commands of the launcher ./slosh itself.
struct LauncherCommand {
  const char *name, *description;
};
inline constexpr LauncherCommand launcher_commands[] = {
    {"test", "builds and runs the tests"},
    {"bench", "measures the speed of the SPH solver"},
    {"doctor", "tells what is installed, and what a missing part disables"}};

// Returns a sentence on what the first unknown word of the command line may have meant, or an empty
// text if every word is known. Called after parsing has failed.
std::string suggestion(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace slosh
