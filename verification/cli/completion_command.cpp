// The subcommand completion prints a script for a shell, which asks the hidden subcommand complete,
// a word and its description a line, for what may come next.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/completions.hpp"
#include "verification/cli/known_names.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

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
  CLI::App& asked = add_command(tree, {"complete", "What may come next on a command line", {}},
                                [words, &app = tree.app, &installation = tree.installation] {
                                  return complete(app, *words, installation);
                                });
  asked.group("");
  asked.add_option("words", *words, "After --, those after the program's name, the last one begun");
}

}  // namespace slosh
