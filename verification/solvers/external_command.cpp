#include "verification/solvers/external_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "verification/files/child_process.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/peers/tank_file.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* spacing_name = "particle_spacing_m";

using Placeholders = std::vector<std::pair<std::string, std::string>>;

// Without a particle spacing there is no such placeholder.
Placeholders placeholders(const ExternalRun& external, const CaseDefinition& definition,
                          const fs::path& work_directory) {
  const fs::path file = fs::absolute(definition.file).lexically_normal();
  Placeholders known{{"case_file", file.string()},
                     {"case_directory", file.parent_path().string()},
                     {"work_directory", work_directory.string()},
                     {"tank_file", (work_directory / tank_file_name).string()},
                     {"peers_directory", peers_directory().string()},
                     {"duration_s", fmt::format("{}", definition.duration)},
                     {"sample_interval_s", fmt::format("{}", definition.sample_interval)}};
  if (external.particle_spacing)
    known.emplace_back(spacing_name, fmt::format("{}", *external.particle_spacing));
  return known;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == text.npos;
}

// Fills in the placeholders; braces around anything but a name stay. Throws std::invalid_argument
// for a name that is no placeholder.
std::string filled_in(const char* key, const std::string& argument, const Placeholders& known) {
  std::string filled;
  for (std::size_t at = 0; at < argument.size();) {
    const std::size_t open = argument.find('{', at), close = argument.find('}', open);
    if (close == argument.npos) return filled + argument.substr(at);
    const std::string name = argument.substr(open + 1, close - open - 1);
    filled += argument.substr(at, open - at);
    at = is_name(name) ? close + 1 : open + 1;
    if (!is_name(name)) {
      filled += '{';
      continue;
    }
    std::vector<std::string> names;
    const std::string* value = nullptr;
    for (const auto& [one, text] : known) {
      names.push_back(one);
      if (one == name) value = &text;
    }
    if (!value && name == spacing_name)
      throw std::invalid_argument(
          fmt::format("{}: {}: {{{}}} is filled in only where the run has method and "
                      "particle_spacing_m",
                      key, argument, name));
    if (!value)
      throw std::invalid_argument(fmt::format(
          "{}: {}: {{{}}} is no placeholder, expected one of {}; nearest: {}", key, argument, name,
          fmt::join(names, ", "), nearest_names(name, names, 1).front()));
    filled += *value;
  }
  return filled;
}

// Returns the argument, also its value where it has the form "--name=value", and both without an
// "@" before them.
std::vector<std::string> texts_of(const std::string& argument) {
  std::vector<std::string> texts{argument};
  if (const std::size_t equals = argument.find('='); equals != argument.npos)
    texts.push_back(argument.substr(equals + 1));
  for (std::size_t i = texts.size(); i-- > 0;)
    if (texts[i].starts_with('@')) texts.push_back(texts[i].substr(1));
  return texts;
}

// Returns the file of a command's first word.
fs::path program_of(const std::string& name, const ExternalRun& external,
                    const CaseDefinition& definition) {
  if (name.find('/') == name.npos) return program_on_path(name);
  const fs::path directory = fs::absolute(definition.file).parent_path();
  const fs::path file =
      directory / filled_in("command", name, placeholders(external, definition, ""));
  return fs::is_regular_file(file) ? file.lexically_normal() : fs::path();
}

std::vector<std::string> with_placeholders(const char* key, const std::vector<std::string>& command,
                                           const ExternalRun& external,
                                           const CaseDefinition& definition,
                                           const fs::path& work_directory) {
  if (command.empty()) return {};
  const Placeholders known = placeholders(external, definition, work_directory);
  std::vector<std::string> filled;
  for (const std::string& argument : command) filled.push_back(filled_in(key, argument, known));
  filled.front() = program_of(command.front(), external, definition).string();
  return filled;
}

}  // namespace

fs::path external_program(const ExternalRun& external, const CaseDefinition& definition) {
  return program_of(external.command.front(), external, definition);
}

std::vector<std::string> external_command(const ExternalRun& external,
                                          const CaseDefinition& definition,
                                          const fs::path& work_directory) {
  return with_placeholders("command", external.command, external, definition, work_directory);
}

std::vector<std::string> version_command(const ExternalRun& external,
                                         const CaseDefinition& definition,
                                         const fs::path& work_directory) {
  return with_placeholders("version_command", external.version_command, external, definition,
                           work_directory);
}

bool asks_for_tank_file(const ExternalRun& external) {
  return std::any_of(
      external.command.begin(), external.command.end(),
      [](const std::string& argument) { return argument.find("{tank_file}") != argument.npos; });
}

std::vector<fs::path> argument_paths(const ExternalRun& external,
                                     const CaseDefinition& definition) {
  std::vector<fs::path> paths;
  // What is in the work directory is made by the run, so nothing may be found: /dev/null has none.
  const std::vector<std::string> command = external_command(external, definition, "/dev/null");
  for (auto argument = command.begin() + 1; argument != command.end(); ++argument)
    for (const std::string& text : texts_of(*argument)) {
      if (text.empty()) continue;
      paths.push_back(fs::absolute(definition.file).parent_path() / text);
      if (!external.directory.empty()) paths.push_back(external.directory / text);
    }
  return paths;
}

std::vector<InputFile> external_inputs(const ExternalRun& external,
                                       const CaseDefinition& definition) {
  const fs::path case_file = fs::absolute(definition.file).lexically_normal();
  std::vector<InputFile> files;
  const auto add = [&](const InputFile& input) {
    const fs::path normal = input.file.lexically_normal();
    const bool is_known = std::any_of(files.begin(), files.end(),
                                      [&](const InputFile& one) { return one.file == normal; });
    if (!is_known && normal != case_file) files.push_back({input.name, normal});
  };
  for (const fs::path& input : external.inputs)
    for (const InputFile& file : input_files(input)) add(file);
  for (const fs::path& file : argument_paths(external, definition))
    if (std::error_code none; fs::is_regular_file(file, none))
      add({file.filename().string(), file});
  return files;
}

}  // namespace slosh
