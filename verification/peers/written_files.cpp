#include "verification/peers/written_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "verification/case/quantities.hpp"
#include "verification/files/atomic_file.hpp"

namespace slosh {
namespace {

// A text of JSON is one of TOML.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string line(const char* key, const std::string& text) {
  return text.empty() ? "" : fmt::format("{} = {}\n", key, quoted(text));
}

template <class Texts>
std::string list(const char* key, const Texts& texts) {
  if (texts.empty()) return "";
  std::string items;
  for (const std::string& text : texts) items += (items.empty() ? "" : ", ") + quoted(text);
  return fmt::format("{} = [{}]\n", key, items);
}

std::string series_table(const SeriesSource& source) {
  std::string table = "[[run.series]]\n" + line("quantity", source.quantity) +
                      line("file", source.file.generic_string()) + line("format", source.format) +
                      line("column", source.column) + line("unit", source.unit) +
                      line("time_column", source.time_column) + line("time_unit", source.time_unit);
  if (source.scale != 1) table += fmt::format("scale = {}\n", source.scale);
  if (source.offset != 0) table += fmt::format("offset = {}\n", source.offset);
  if (source.time_offset != 0) table += fmt::format("time_offset_s = {}\n", source.time_offset);
  if (source.first_is_zero) table += "datum = \"first\"\n";
  if (source.whole_tank) table += "whole_tank = true\n";
  return table;
}

std::vector<std::string> texts_of(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> texts;
  for (const auto& path : paths) texts.push_back(path.string());
  return texts;
}

namespace fs = std::filesystem;

bool begins_with_key(const std::string& line, const std::string& key) {
  const std::size_t begin = line.find_first_not_of(" \t[");
  if (begin == line.npos || line.compare(begin, key.size(), key) != 0) return false;
  const std::size_t end = begin + key.size();
  return end == line.size() || std::string(" \t].=").find(line[end]) != std::string::npos;
}

struct Place {
  int line = 0;       // 0 where the file writes the key in another form
  std::string value;  // " = 0"; empty for a table
};

// The line of a table, or of a key under the name after its last dot, which no other table has.
Place place_of(const CaseDefinition& definition, const std::string& key) {
  std::istringstream stream(definition.text);
  const std::string last = key.substr(key.rfind('.') + 1);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!begins_with_key(line, key) && !begins_with_key(line, last)) continue;
    const std::size_t equals = line.find('='), begin = line.find_first_not_of(" =", equals);
    if (begin >= line.size()) return {number, ""};
    std::string value = line.substr(begin, line.find('#') - begin);
    value.erase(value.find_last_not_of(" \t") + 1);
    return {number, " = " + value};
  }
  return {};
}

}  // namespace

std::string run_block(const std::string& name, const ExternalRun& external,
                      const CaseDefinition& definition, const std::string& comment) {
  std::string block = "# " + comment + "\n[[run]]\n" + line("name", name) +
                      "solver = \"external\"\n" + list("command", external.command) +
                      list("inputs", texts_of(external.inputs)) + line("method", external.method);
  if (external.particle_spacing)
    block += fmt::format("particle_spacing_m = {}\n", *external.particle_spacing);
  block += list("fail_on", external.fail_on);
  if (external.cores) block += fmt::format("cores = {}\n", *external.cores);
  const std::vector<std::string> compared = compared_quantities(definition);
  std::string series;
  for (const SeriesSource& source : external.series)
    if (std::find(compared.begin(), compared.end(), source.quantity) != compared.end())
      series += series_table(source);
  if (series.empty())
    throw std::invalid_argument(name + ": expected a series that the case compares");
  return block + series;
}

void write_text(const fs::path& file, const std::string& text) {
  replace_file(file, text, Durability::process_crash);
}

void write_script(const fs::path& file, const std::string& text) {
  write_text(file, text);
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add);
}

std::string exact(double value) { return fmt::format("{}", value + 0.0); }

std::string number_table(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& rows) {
  std::string table = fmt::format("{}\n", fmt::join(names, ","));
  for (std::vector<double> row : rows) {
    for (double& value : row) value += 0.0;  // no -0
    table += fmt::format("{}\n", fmt::join(row, ","));
  }
  return table;
}

void refuse_for_code(const CaseDefinition& definition, const std::string& key,
                     const std::string& expected) {
  const Place place = place_of(definition, key);
  throw CaseFileError(fmt::format("{}{}: {}{}: expected {}", definition.file.string(),
                                  place.line > 0 ? fmt::format(":{}", place.line) : "", key,
                                  place.value, expected));
}

std::string readme_head(const HandedCase& handed, const std::string& code) {
  const CaseDefinition& definition = handed.definition;
  return fmt::format(
      "# {} for {}\n\n{}. Source: {}.\n\n"
      "All numbers are in SI units. The frame is the tank's: x counts from the tank's left wall "
      "and "
      "z from its bottom, and both turn with a tank that rolls. Angles are positive "
      "counter-clockwise. The computation is two-dimensional; forces are per metre of width.\n\n",
      definition.name, code, definition.title, definition.source);
}

std::string readme_end(const HandedCase& handed, const std::string& run) {
  return fmt::format(
      "\n## Taking the result back\n\n"
      "Paste `run.toml` into the case file of {0}. `./slosh run CASE {1}`, or a campaign, then "
      "starts this directory's program and compares its series. The block names this directory by "
      "its path, {2}: change it where the directory moves.\n",
      handed.definition.name, run, handed.place.string());
}

std::vector<fs::path> inputs_in(const HandedCase& handed, const fs::path& directory) {
  std::vector<fs::path> inputs;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file())
      inputs.push_back(handed.place / fs::relative(entry.path(), directory));
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

std::string run_name(const std::string& code, double spacing) {
  std::string name = fmt::format("{}_{:g}mm", code, 1000 * spacing);
  std::replace(name.begin(), name.end(), '.', 'p');
  return name;
}

bool is_whole_multiple(double length, double spacing) {
  return std::abs(length / spacing - std::round(length / spacing)) <= 1e-6;
}

}  // namespace slosh
