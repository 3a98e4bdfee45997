// The subcommands as CLI11 holds them. Each states its options in a file of this folder, and is
// added to the tree by one function; parsing chooses the action that main.cpp then takes.
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/cli/command_line.hpp"
#include "verification/input/rules.hpp"

namespace slosh {

// Returns the exit status.
using Action = std::function<int()>;

struct CommandTree {
  CLI::App& app;  // the tool, or a subcommand that has some of its own
  const Installation& installation;
  const std::atomic<bool>& stop;
  void (*stop_on_signals)();  // from here on SIGINT and SIGTERM set `stop`
  Action& action;
};

void add_campaign_commands(const CommandTree& tree);    // campaign, report, gate, selftest
void add_baseline_commands(const CommandTree& tree);    // baseline diff, propose, approve
void add_execution_commands(const CommandTree& tree);   // run, problem, job
void add_foreign_commands(const CommandTree& tree);     // import, compare
void add_store_command(const CommandTree& tree);        // store
void add_export_command(const CommandTree& tree);       // export
void add_show_command(const CommandTree& tree);         // show
void add_list_command(const CommandTree& tree);         // list
void add_explain_command(const CommandTree& tree);      // explain
void add_converge_command(const CommandTree& tree);     // converge
void add_completion_commands(const CommandTree& tree);  // completion, and what its scripts call

// All of them, and what --help ends with.
void add_all_commands(const CommandTree& tree);

struct CommandText {
  const char *name, *description;
  // Each a line "./slosh ..." at the end of the command's --help, that a test runs in a scratch
  // directory, one after another.
  std::vector<std::string> examples;
};

CLI::App& add_command(const CommandTree& tree, const CommandText& text, Action action);
void give_examples(CLI::App& command, const std::vector<std::string>& examples);

// Options that several commands have. What a value names is its type: completion goes by it.
inline constexpr const char *campaign_type = "CAMPAIGN", *case_type = "CASE", *run_type = "RUN",
                            *problem_type = "PROBLEM", *pattern_type = "PATTERN", *tag_type = "TAG",
                            *file_type = "FILE", *directory_type = "DIR";
// The validator, not told of in --help beside the value's type.
CLI::Validator unnamed(CLI::Validator validator);
// A number that keeps a rule as one of a case file does: finite, and refused in the same words.
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
// One of these names, which --help lists; `expected` says what they name: "a shell".
CLI::Validator one_of(const std::string& expected, const std::vector<std::string>& names);
void add_experiments_option(CLI::App& command, std::filesystem::path& experiments);
// Of the results that campaigns share: build/store unless the option or SLOSH_STORE says otherwise.
void add_shared_store_option(CLI::App& command, std::filesystem::path& store,
                             const Installation& installation);
void add_jobs_option(CLI::App& command, int& at_once, const char* what);

// What the launcher ./slosh does itself.
struct LauncherCommand {
  const char *name, *description;
};
inline constexpr LauncherCommand launcher_commands[] = {
    {"test", "builds and runs the tests"},
    {"bench", "measures the speed of the SPH solver"},
    {"doctor", "tells what is installed, and what a missing part disables"}};

// What may have been meant by the first word that the command line of `app` does not know, as a
// sentence; empty where every word is known. To be asked after parsing has failed.
std::string suggestion(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace slosh
