#include "verification/cli/command_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "sph/threads.hpp"
#include "verification/files/shell_word.hpp"
#include "verification/gate/gate.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/results/provenance.hpp"

namespace slosh {
namespace fs = std::filesystem;

fs::path usual_store(const Installation& installation) {
  const char* named = std::getenv(store_variable);
  return named && *named ? whole(named) : installation.build / "store";
}

fs::path shown_page(const Installation& installation, const std::string& name) {
  const fs::path directory = installation.build / "shown";
  const fs::file_status status = fs::symlink_status(directory);
  if (fs::exists(status) && !fs::is_directory(status))
    throw CaseFileError(directory.string() + ": expected a directory, and there is " +
                        (fs::is_symlink(status) ? "a link" : "a file") +
                        "; remove it, or name another place with --output");
  fs::create_directories(directory);
  return directory / (name + ".html");
}

std::string name_or_path(const fs::path& file, const fs::path& shipped) {
  if (fs::equivalent(fs::absolute(file).parent_path(), shipped)) return file.stem().string();
  return shell_word(fs::absolute(file).lexically_normal().string());
}

fs::path whole(const fs::path& path) {
  if (path.empty()) return path;
  std::error_code circle;
  const fs::path named = fs::absolute(path), real = fs::weakly_canonical(named, circle);
  return circle ? named.lexically_normal() : real;
}

std::string experiments_option(const fs::path& experiments) {
  return experiments.empty() ? "" : " --experiments " + shell_word(experiments.string());
}

namespace {

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!one->get_group().empty()) names.push_back(one->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Commands that others have taken in, and the command lines that do what they did.
constexpr std::pair<const char*, const char*> earlier_commands[] = {
    {"report", "campaign NAME --report-only"},
    {"selftest", "gate NAME --selftest"},
    {"problem", "run PROBLEM"},
    {"check", "explain CASE"}};

std::string not_known_text(const std::string& wrong, const std::vector<std::string>& known,
                           const char* what) {
  constexpr std::size_t suggestions = 2;
  return fmt::format("{} '{}' is not known; did you mean '{}'?", what, wrong,
                     fmt::join(nearest_names(wrong, known, suggestions), "' or '"));
}

}  // namespace

CLI::App& add_command(const CommandTree& tree, const CommandText& text, Action action) {
  CLI::App& added = *tree.app.add_subcommand(text.name, text.description);
  added.callback([&chosen = tree.action, action = std::move(action)] { chosen = action; });
  give_examples(added, text.examples);
  return added;
}

void give_examples(CLI::App& command, const std::vector<std::string>& examples) {
  if (!examples.empty())
    command.footer(fmt::format("Examples:\n  {}", fmt::join(examples, "\n  ")));
}

CLI::Validator unnamed(CLI::Validator validator) { return validator.description(""); }

CLI::Validator one_of(const std::string& expected, const std::vector<std::string>& names) {
  return {[=](const std::string& text) {
            const bool is_known = std::find(names.begin(), names.end(), text) != names.end();
            return is_known ? ""
                            : fmt::format("{}: expected {}{}", text, one_of_text(expected, names),
                                          nearest_text(text, names));
          },
          fmt::format("{{{}}}", fmt::join(names, ","))};
}

CLI::Option* add_case_argument(CLI::App& command, std::string& name, const char* what) {
  return add_option(command, "case", name, case_type, what);
}

void add_experiments_option(CLI::App& command, std::filesystem::path& experiments) {
  add_option(command, "--experiments", experiments, directory_type,
             "Directory of your experimental records; without it the runs that need one are "
             "reported as not supplied")
      ->envname("SLOSH_EXPERIMENTS")
      ->check(unnamed(CLI::ExistingDirectory));
}

void add_shared_store_option(CLI::App& command, std::filesystem::path& store,
                             const Installation& installation) {
  store = usual_store(installation);
  add_option(command, "--store", store, directory_type,
             "Directory of the results, which campaigns share (default: build/store)")
      ->envname(store_variable);
}

void add_jobs_option(CLI::App& command, int& at_once, const char* what) {
  at_once = sph::usable_cores();
  add_option(command, "-j,--jobs", at_once, "N", fmt::format("{} (default: one a core)", what))
      ->check(keeps(at_least(1)));
}

namespace {

std::string launcher_text() {
  std::string text = "The launcher ./slosh also knows:\n";
  for (const auto& [name, description] : launcher_commands)
    text += fmt::format("  {:<26}  {}\n", name, description);
  return text;
}

std::string exit_status_text() {
  std::string text = "Exit status:\n";
  for (const auto& [status, meaning] : exit_meanings)
    text += fmt::format("  {:>3}  {}\n", status, meaning);
  return text;
}

// Where an option names a path and has none, the command would do as if it were not given, or take
// the current directory.
void refuse_empty_paths(CLI::App& command) {
  const auto names_path = [](const CLI::Option& option) {
    for (const char* type : {file_type, directory_type, case_type, campaign_type})
      if (option.get_type_name() == type) return true;
    return false;
  };
  for (CLI::Option* option : command.get_options())
    if (names_path(*option))
      option->check(unnamed(CLI::Validator(
          [](const std::string& path) { return path.empty() ? "expected a path, not ''" : ""; },
          "")));
  for (CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    refuse_empty_paths(*below);
}

}  // namespace

void add_all_commands(const CommandTree& tree) {
  tree.app.require_subcommand(1);
  tree.app.set_version_flag("--version", "Slosh " + provenance("").at("slosh_version"));
  add_campaign_command(tree);
  add_gate_command(tree);
  add_baseline_commands(tree);
  add_run_command(tree);
  add_job_command(tree);
  add_import_command(tree);
  add_compare_command(tree);
  add_export_command(tree);
  add_show_command(tree);
  add_store_command(tree);
  add_new_command(tree);
  add_case_command(tree);
  add_list_command(tree);
  add_explain_command(tree);
  add_converge_command(tree);
  refuse_empty_paths(tree.app);
  tree.app.footer(launcher_text() + "\n" + exit_status_text() +
                  "\nExamples:\n"
                  "  ./slosh list 'li2010_*'\n"
                  "  ./slosh run li2010_small_amplitude linear --output linear.h5\n"
                  "  ./slosh run rigid_rotation --quick --output rigid_rotation.json");
}

std::string suggestion(const CLI::App& app, const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    const std::vector<std::string> options = option_names(app), commands = subcommand_names(app);
    const auto is_in = [&](const std::vector<std::string>& known) {
      return std::find(known.begin(), known.end(), name) != known.end();
    };
    if (name.starts_with("--") && !is_in(options)) return not_known_text(name, options, "option");
    if (name.starts_with("-") || commands.empty()) continue;
    for (const auto& [old, form] : earlier_commands)
      if (name == old && !is_in(commands))
        return fmt::format("command '{}' is not known; use `./slosh {}`", old, form);
    if (!is_in(commands)) return not_known_text(name, commands, "command");
    return suggestion(*app.get_subcommand(name),
                      {words.begin() + static_cast<long>(i) + 1, words.end()});
  }
  return "";
}

}  // namespace slosh
