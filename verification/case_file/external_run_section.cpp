#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <cmath>

#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/definition_file.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* work_directory = "the run's work directory";

fs::path beside_case(const CaseDefinition& definition, const std::string& path) {
  return plain_path(fs::absolute(definition.file).parent_path() / path);
}

// Data that must be there, relative to the case file.
fs::path stored_file(const TomlTable& table, const char* key, const CaseDefinition& definition) {
  const fs::path file = beside_case(definition, table.get(key, any_text()));
  require_data_file(table, key, file, definition.file);
  return file;
}

// Where the files of a run's series lie.
enum class Files { below_work_directory, beside_case_file };

SeriesSource read_series(const TomlTable& series, const CaseDefinition& definition, Files files) {
  series.allow_only(keys_of("run.series"));
  SeriesSource source;
  source.quantity =
      series.choice("quantity", "a compared quantity", compared_quantities(definition));
  const std::string unit = unit_of(source.quantity);
  source.file = files == Files::beside_case_file
                    ? stored_file(series, "file", definition)
                    : fs::path(series.get("file", path_below("a file's", work_directory)));
  source.format = series.get("format", any_text());
  source.column = series.get("column", any_text());
  if (series.has("unit"))
    source.unit = series.choice("unit", "a unit of " + source.quantity, unit_names(unit));
  source.time_column = series.find("time_column", any_text()).value_or("");
  if (series.has("time_unit"))
    source.time_unit = series.choice("time_unit", "a unit of time", unit_names("s"));
  source.scale = series.find("scale", not_zero("1")).value_or(source.scale);
  source.offset = series.find("offset", any_number(unit)).value_or(source.offset);
  source.time_offset = read_time_offset(series);
  if (series.has("datum")) {
    series.choice("datum", "a datum", {"first"});
    if (series.has("offset"))
      series.refuse("datum", "no datum beside an offset, or no offset beside a datum");
    source.first_is_zero = true;
  }
  source.whole_tank = series.flag("whole_tank");
  return source;
}

std::vector<SeriesSource> read_all_series(const TomlTable& run, const CaseDefinition& definition,
                                          Files files) {
  std::vector<SeriesSource> all;
  for (const TomlTable& table : run.tables("series")) {
    SeriesSource source = read_series(table, definition, files);
    if (std::any_of(all.begin(), all.end(),
                    [&](const SeriesSource& other) { return other.quantity == source.quantity; }))
      table.refuse("quantity", "a quantity that no other series of the run has");
    all.push_back(std::move(source));
  }
  if (all.empty()) run.refuse("series", "at least one [[run.series]]");
  return all;
}

const Rule<std::string> a_pattern{
    "a regular expression of RE2, which takes the time of its text's length alone and so has "
    "neither back-references nor look-around",
    [](const std::string& text) { return !text.empty() && RE2(text, RE2::Quiet).ok(); }};

std::vector<std::string> read_command(const TomlTable& run, const char* key) {
  std::vector<std::string> command;
  for (const PlacedText& argument : run.texts(key, {"a text", [](const auto&) { return true; }}))
    command.push_back(argument.text);
  if (command.empty() || command.front().empty())
    run.refuse(key, "a list of texts that begins with a program");
  return command;
}

// A method's runs are told apart by their spacings, and a spacing alone is of no use.
void read_method(const TomlTable& run, const CaseDefinition& definition, ExternalRun& external) {
  external.method = run.find("method", file_safe_name()).value_or("");
  external.particle_spacing = run.find("particle_spacing_m", a_particle_spacing(definition));
  if (external.particle_spacing && external.method.empty())
    run.refuse("method", "the name of the method, beside particle_spacing_m");
  if (!external.method.empty() && !external.particle_spacing)
    run.refuse("particle_spacing_m", "the method's spacing in this run, in m, beside method");
}

}  // namespace

ExternalRun read_external_run(const TomlTable& run, const CaseDefinition& definition) {
  ExternalRun external;
  external.command = read_command(run, "command");
  if (run.has("version_command")) external.version_command = read_command(run, "version_command");
  if (const auto directory = run.find("directory", any_text())) {
    external.directory = beside_case(definition, *directory);
    if (std::error_code lost; !fs::is_directory(external.directory, lost))
      run.refuse("directory", "a directory relative to the case file; there is no " +
                                  external.directory.string());
  }
  external.time_limit = run.find("time_limit_s", positive("s"));
  if (run.has("inputs"))
    for (const PlacedText& input : run.texts("inputs", any_text())) {
      external.inputs.push_back(beside_case(definition, input.text));
      if (input_files(external.inputs.back()).empty())
        run.refuse("inputs",
                   "files, directories or patterns of them, relative to the case file; there is no "
                   "file in " +
                       external.inputs.back().string());
    }
  if (run.has("fail_on"))
    for (const PlacedText& pattern : run.texts("fail_on", a_pattern))
      external.fail_on.push_back(pattern.text);
  external.cores = run.find("cores", at_least(1));
  read_method(run, definition, external);
  if (run.has("facts")) external.facts = run.get("facts", path_below("a file's", work_directory));
  external.series = read_all_series(run, definition, Files::below_work_directory);
  return external;
}

StoredRun read_stored_run(const TomlTable& run, const CaseDefinition& definition) {
  return {.series = read_all_series(run, definition, Files::beside_case_file),
          .method = run.get("method", file_safe_name()),
          .particle_spacing = run.get("particle_spacing_m", a_particle_spacing(definition)),
          .facts = stored_file(run, "facts", definition)};
}

ExternalRun read_pysph_run(const TomlTable& run, const CaseDefinition& definition) {
  if (definition.motion.roll || definition.liquid.column_width || !definition.obstacles.empty() ||
      definition.tank.breadth || definition.gauges.empty())
    run.refuse("solver",
               "another solver: pysph takes a tank with a [[gauge]], filled from wall to wall, "
               "that does not roll and has neither an obstacle nor breadth_m");
  const std::string driver = "{peers_directory}/pysph_tank.py";
  const std::string scheme =
      run.choice("scheme", "a scheme of PySPH's driver", {"delta_sph", "edac", "adami"});
  ExternalRun external{
      .command = {driver, "{tank_file}", "{work_directory}", scheme, "{particle_spacing_m}"},
      .method = "pysph_" + scheme,
      .facts = "cost.json",
      .version_command = {driver, "--version"},
      .cores = 1};
  external.particle_spacing = run.get("particle_spacing_m", a_particle_spacing(definition));
  for (const double size : {definition.tank.length, definition.liquid.fill_depth}) {
    const double rows = size / *external.particle_spacing;
    if (std::abs(rows - std::round(rows)) > 1e-6)
      run.refuse("particle_spacing_m",
                 fmt::format("a whole fraction of the tank's length and of the fill depth, "
                             "{:.4g} and {:.4g} m, for pysph",
                             definition.tank.length, definition.liquid.fill_depth));
  }
  for (const GaugeDefinition& gauge : definition.gauges)
    external.series.push_back({.quantity = "elevation@" + gauge.name,
                               .file = "elevation.csv",
                               .format = "csv",
                               .column = gauge.name,
                               .unit = "m",
                               .time_column = "t",
                               .time_unit = "s"});
  return external;
}

void refuse_shared_method(const TomlTable& table, const RunDefinition& run,
                          const CaseDefinition& definition) {
  const std::string method = method_of(run);
  for (const RunDefinition& other : definition.runs) {
    if (family(other) != family(run) || (method.empty() && method_of(other).empty())) continue;
    if (method != method_of(other))
      table.refuse(table.has("scheme") ? "scheme"
                   : !method.empty()   ? "method"
                                       : "name",
                   fmt::format("a name that does not stand for the run {} too", other.name));
    if (particle_spacing(other) == particle_spacing(run))
      table.refuse("particle_spacing_m",
                   fmt::format("a spacing that no other run of the method has; {} has this one",
                               other.name));
  }
}

}  // namespace slosh
