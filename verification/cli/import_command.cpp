#include "verification/cli/import_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "verification/case/quantities.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/shell_word.hpp"
#include "verification/gate/gate.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/results/provenance.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {
namespace {

[[noreturn]] void refuse_series(const std::string& series, const std::string& expected) {
  throw CaseFileError(fmt::format("--series {}: expected {}", series, expected));
}

void require_quantity(const std::string& series, const std::string& quantity) {
  const std::vector<std::string> names = quantity_names();
  try {
    unit_of(quantity);
    if (!quantity.ends_with('@')) return;
  } catch (const std::invalid_argument&) {
  }
  refuse_series(series,
                fmt::format("QUANTITY=COLUMN with one of {}; nearest: {}", fmt::join(names, ", "),
                            nearest_names(quantity, names, 1).front()));
}

SeriesSource source_of(const std::string& series, const ImportOptions& options) {
  const std::size_t equals = series.find('=');
  if (equals == series.npos || equals + 1 == series.size())
    refuse_series(series, "QUANTITY=COLUMN");
  SeriesSource source{.quantity = series.substr(0, equals),
                      .file = options.file,
                      .format = options.format,
                      .column = series.substr(equals + 1),
                      .unit = options.unit,
                      .time_column = options.time_column,
                      .time_unit = options.time_unit,
                      .scale = options.scale,
                      .offset = options.offset};
  require_quantity(series, source.quantity);
  return source;
}

// All are known to be possible before any file is read.
std::vector<SeriesSource> sources_of(const ImportOptions& options) {
  std::vector<SeriesSource> sources;
  for (const std::string& series : options.series) {
    SeriesSource source = source_of(series, options);
    if (std::any_of(sources.begin(), sources.end(),
                    [&](const SeriesSource& other) { return other.quantity == source.quantity; }))
      refuse_series(series, "a quantity that no other --series has");
    sources.push_back(std::move(source));
  }
  return sources;
}

std::string command_of(const ImportOptions& options) {
  std::string command = fmt::format("./slosh import {} --format {}",
                                    shell_word(options.file.string()), options.format);
  for (const std::string& series : options.series) command += " --series " + shell_word(series);
  for (const auto& [name, value] :
       {std::pair{"--unit", &options.unit}, std::pair{"--time", &options.time_column},
        std::pair{"--time-unit", &options.time_unit}})
    if (!value->empty()) command += fmt::format(" {} {}", name, shell_word(*value));
  if (options.scale != 1) command += fmt::format(" --scale {}", options.scale);
  if (options.offset != 0) command += fmt::format(" --offset {}", options.offset);
  return command + " -o " + shell_word(options.output.string());
}

}  // namespace

int import_file(const ImportOptions& options) {
  RunResult result;
  for (const SeriesSource& source : sources_of(options))
    result.series.push_back(import_series(source));
  result.case_name = "imported";
  result.run_name = options.file.stem().string();
  result.solver = "imported";
  result.active_terms = {"imported from " + options.format};
  const std::string command = command_of(options);
  const std::string content = content_hash(read_bytes(options.file));
  result.key = content_hash(content + command);
  result.provenance = provenance(command);
  result.provenance["source_file"] = std::filesystem::absolute(options.file).string();
  result.provenance["source_hash"] = content;
  result.provenance["source_format"] = options.format;
  write_result(result, options.output);
  for (const TimeSeries& series : result.series)
    std::cout << fmt::format("{}: {} samples from {} to {} s [{}]\n", series.name,
                             series.time.size(), series.time.front(), series.time.back(),
                             series.unit);
  std::cout << "result: " << options.output.string() << "\n";
  return exit_pass;
}

}  // namespace slosh
