#include "verification/peers/run_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/case/quantities.hpp"

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

}  // namespace slosh
