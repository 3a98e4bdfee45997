// The subcommand completion prints a script for a shell. The script calls the hidden subcommand
// complete, which prints what may come next: a word and its description per line.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

struct Completion {
  std::string word, description;
};

// Returns the known names of a type of value (campaign_type, ... in command_tree.hpp). `before` are
// the positional values before it, such as the case of a run.
using KnownNames = std::function<std::vector<std::string>(const std::string& type,
                                                          const std::vector<std::string>& before)>;

// The place in the tree of commands to which the complete words lead.
struct Place {
  const CLI::App* app;
  std::vector<std::string> positionals;   // values that were given without an option's name
  const CLI::Option* awaiting = nullptr;  // the option whose value comes next
};

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

bool is_shown(const CLI::App& app) { return !app.get_group().empty(); }

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* one) { return is_shown(*one); });
}

const CLI::App* subcommand(const CLI::App& app, const std::string& name) {
  for (const CLI::App* one : subcommands(app))
    if (one->get_name() == name) return one;
  return nullptr;
}

void pass(Place& place, const std::string& word) {
  if (place.awaiting) {
    if (word != "=") place.awaiting = nullptr;  // bash splits --option=value into three words
  } else if (word.starts_with("-")) {
    const CLI::Option* option = place.app->get_option_no_throw(word);
    if (option && takes_value(*option)) place.awaiting = option;
  } else if (const CLI::App* below = subcommand(*place.app, word)) {
    place = {below, {}, nullptr};
  } else {
    place.positionals.push_back(word);
  }
}

// Returns the values that a check allows. CLI11 shows them in the type as "{a,b}".
std::vector<std::string> allowed_values(const std::string& type) {
  const auto begin = type.find('{'), end = type.find('}');
  std::vector<std::string> values;
  if (begin == std::string::npos || end == std::string::npos) return values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string one; std::getline(list, one, ',');) values.push_back(one);
  return values;
}

std::vector<Completion> values_of(const CLI::Option& option, const std::vector<std::string>& before,
                                  const KnownNames& known_names) {
  const std::string type = option.get_type_name();
  std::vector<std::string> names = allowed_values(type);
  if (names.empty()) names = known_names(type, before);
  std::vector<Completion> values;
  for (const std::string& name : names) values.push_back({name, ""});
  return values;
}

std::vector<Completion> options_of(const CLI::App& app) {
  std::vector<Completion> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back({"--" + name, option->get_description()});
  return names;
}

// Returns the next positional, or the last one if that takes any number of values; else null.
const CLI::Option* next_positional(const Place& place) {
  std::vector<const CLI::Option*> all;
  for (const CLI::Option* option : place.app->get_options())
    if (option->get_positional()) all.push_back(option);
  if (place.positionals.size() < all.size()) return all[place.positionals.size()];
  return !all.empty() && all.back()->get_expected_max() > 1 ? all.back() : nullptr;
}

std::vector<Completion> candidates(const Place& place, const std::string& begun,
                                   const KnownNames& known_names) {
  if (place.awaiting) return values_of(*place.awaiting, place.positionals, known_names);
  if (begun.starts_with("-")) return options_of(*place.app);
  std::vector<Completion> found;
  for (const CLI::App* one : subcommands(*place.app))
    if (place.positionals.empty()) found.push_back({one->get_name(), one->get_description()});
  if (const CLI::Option* positional = next_positional(place))
    for (Completion& one : values_of(*positional, place.positionals, known_names))
      found.push_back(std::move(one));
  return found;
}

// Returns what may complete the last of the words, which follow the program's name. There is no
// completion for a file, a directory, a number or a free text.
std::vector<Completion> completions(const CLI::App& app, const std::vector<std::string>& words,
                                    const KnownNames& known_names) {
  if (words.empty()) return {};
  Place place{&app, {}, nullptr};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) pass(place, words[i]);
  const std::string begun = words.back() == "=" ? "" : words.back();
  std::vector<Completion> found = candidates(place, begun, known_names);
  std::erase_if(found, [&](const Completion& one) { return !one.word.starts_with(begun); });
  return found;
}

constexpr const char* bash_script =
    R"END(# slosh, completion for bash: eval "$(./slosh completion bash)"
_slosh() {
  local word
  COMPREPLY=()
  while IFS=$'\t' read -r word _; do
    COMPREPLY+=("$word")
  done < <(TOOL complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -o default -F _slosh slosh
)END";

constexpr const char* zsh_script = R"END(#compdef slosh
# slosh, completion for zsh: eval "$(./slosh completion zsh)"
_slosh() {
  local -a found
  local word text
  while IFS=$'\t' read -r word text; do
    found+=("${word//:/\\:}:$text")
  done < <(TOOL complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)
  if (( $#found )); then _describe slosh found; else _files; fi
}
compdef _slosh slosh
)END";

constexpr const char* fish_script =
    R"END(# slosh, completion for fish: ./slosh completion fish | source
function __slosh_complete
  set -l words (commandline -opc) (commandline -ct)
  TOOL complete -- $words[2..-1] 2>/dev/null
end
complete -c slosh -a '(__slosh_complete)'
)END";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

int print_script(const std::string& shell, const Installation& installation) {
  const bool fish = shell == "fish";
  const std::string tool = installation.executable.string(),
                    quoted = fish ? replaced(replaced(tool, "\\", "\\\\"), "'", "\\'")
                                  : replaced(tool, "'", "'\\''");
  const char* script = fish ? fish_script : shell == "zsh" ? zsh_script : bash_script;
  std::cout << replaced(script, "TOOL", "'" + quoted + "'");
  return exit_pass;
}

std::vector<std::string> names_for(const std::string& type, const std::vector<std::string>& before,
                                   const Installation& installation) {
  if (type == campaign_type) return known_names("campaigns", installation);
  if (type == case_type) return known_names("cases", installation);
  if (type == problem_type) return known_names("problems", installation);
  if (type == tag_type) return known_names("tags", installation);
  std::vector<std::string> names;
  if (type == pattern_type)
    for (const char* kind : {"cases", "runs", "problems"})
      for (std::string& name : known_names(kind, installation)) names.push_back(std::move(name));
  if (type == run_type && !before.empty())
    for (const RunDefinition& run : read_case(find_case(before.back(), installation.cases)).runs)
      names.push_back(run.name);
  return names;
}

int complete(const CLI::App& app, const std::vector<std::string>& words,
             const Installation& installation) {
  const auto known = [&](const std::string& type, const std::vector<std::string>& before) {
    return names_for(type, before, installation);
  };
  std::vector<Completion> found = completions(app, words, known);
  if (words.size() == 1)
    for (const auto& [name, text] : launcher_commands)
      if (std::string(name).starts_with(words[0])) found.push_back({name, text});
  for (const Completion& one : found) std::cout << one.word << "\t" << one.description << "\n";
  return exit_pass;
}

}  // namespace

void add_completion_commands(const CommandTree& tree) {
  auto shell = std::make_shared<std::string>();
  CLI::App& script = add_command(
      tree,
      {"completion",
       "Prints a script that completes commands, options and names in a shell",
       {"./slosh completion bash"}},
      [shell, &installation = tree.installation] { return print_script(*shell, installation); });
  script.add_option("shell", *shell, "The shell: its start-up file evaluates the script")
      ->type_name("SHELL")
      ->required()
      ->check(one_of("a shell", {"bash", "zsh", "fish"}));
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App& asked =
      add_command(tree, {"complete", "Prints what may come next on a command line", {}},
                  [words, &app = tree.app, &installation = tree.installation] {
                    return complete(app, *words, installation);
                  });
  asked.group("");
  asked.add_option("words", *words, "After --, those after the program's name, the last one begun");
}

}  // namespace slosh
