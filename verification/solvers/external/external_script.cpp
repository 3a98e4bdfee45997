#include "verification/solvers/external/external_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "verification/solvers/external_command.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Names, and what versions follow: python3.11.
bool is_interpreter(const std::string& word) {
  static constexpr std::array<std::string_view, 17> names{
      "python", "pypy", "bash", "sh",  "dash",  "zsh",    "ksh",     "perl",  "ruby",
      "julia",  "node", "java", "lua", "tclsh", "octave", "Rscript", "matlab"};
  std::string name = fs::path(word).filename().string();
  name.erase(std::find_if(name.begin(), name.end(),
                          [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; }),
             name.end());
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool begins_as_script(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return false;
  char head[2] = {};
  return std::ifstream(file, std::ios::binary).read(head, 2) && head[0] == '#' && head[1] == '!';
}

// Whether `inputs` names a file below this directory.
bool has_input(const ExternalRun& external, const fs::path& directory) {
  const fs::path whole = fs::weakly_canonical(directory);
  const auto is_below = [&](const InputFile& input) {
    const fs::path file = fs::weakly_canonical(input.file);
    return std::mismatch(whole.begin(), whole.end(), file.begin(), file.end()).first == whole.end();
  };
  return std::any_of(external.inputs.begin(), external.inputs.end(), [&](const fs::path& input) {
    const std::vector<InputFile> files = input_files(input);
    return std::any_of(files.begin(), files.end(), is_below);
  });
}

// Whether another run of its method has another spacing and the same command, which does not name
// it. The placeholders are still in the command.
bool ignores_spacing(const ExternalRun& external, const CaseDefinition& definition) {
  if (!external.particle_spacing ||
      fmt::format("{}", fmt::join(external.command, " ")).find("{particle_spacing_m}") !=
          std::string::npos)
    return false;
  return std::any_of(definition.runs.begin(), definition.runs.end(), [&](const auto& run) {
    const auto* other = std::get_if<ExternalRun>(&run.solver);
    return other && other->method == external.method &&
           other->particle_spacing != external.particle_spacing &&
           other->command == external.command;
  });
}

}  // namespace

std::string unlisted_script(const ExternalRun& external, const CaseDefinition& definition) {
  if (external.command.front().starts_with("{peers_directory}")) return "";
  if (external.inputs.empty()) {
    for (const std::string& word : external.command)
      if (is_interpreter(word)) return word;
    std::vector<fs::path> files{external_program(external, definition)};
    for (InputFile& input : external_inputs(external, definition)) files.push_back(input.file);
    for (const fs::path& file : files)
      if (begins_as_script(file)) return file.filename().string();
  }
  std::vector<fs::path> directories = argument_paths(external, definition);
  if (!external.directory.empty()) directories.insert(directories.begin(), external.directory);
  for (const fs::path& directory : directories)
    if (std::error_code none; fs::is_directory(directory, none) && !has_input(external, directory))
      return directory.lexically_normal().string();
  return "";
}

std::string script_doubt(const RunDefinition& run, const CaseDefinition& definition) {
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  const bool has_place = external && !definition.file.empty();  // from which its files are found
  if (external && ignores_spacing(*external, definition))
    return fmt::format(
        "run {}: its command has no {{particle_spacing_m}}, so that the runs of {} may be one and "
        "the same",
        run.name, external->method);
  const std::string script = has_place ? unlisted_script(*external, definition) : "";
  if (script.empty()) return "";
  return fmt::format(
      "run {}: what {} loads or holds is no part of its key: its result is kept when that changes; "
      "`inputs` would name it",
      run.name, script);
}

}  // namespace slosh
