// What may stand at the end of a command line that is being typed, from the tree of subcommands and
// options that parses it.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace slosh {

struct Completion {
  std::string word, description;
};

// Gives the known names of a type of value (command_tree.hpp's campaign_type, ...); `before` are
// the positional values that stand before it, such as the case of a run.
using KnownNames = std::function<std::vector<std::string>(const std::string& type,
                                                          const std::vector<std::string>& before)>;

// `words` after the program's name, the last one as far as it is typed. Nothing where a file, a
// directory, a number or a free text is expected.
std::vector<Completion> completions(const CLI::App& app, const std::vector<std::string>& words,
                                    const KnownNames& known_names);

}  // namespace slosh
