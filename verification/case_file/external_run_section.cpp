#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <cmath>

#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/tables/plain_table.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/units.hpp"

namespace slosh {

using namespace key;
using namespace needed;

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
  series.allow_only(series_table.names());
  SeriesSource source;
  source.quantity =
      series.choice("quantity", "a compared quantity", compared_quantities(definition));
  const std::string unit = unit_of(source.quantity);
  source.file = files == Files::beside_case_file
                    ? stored_file(series, "file", definition)
                    : fs::path(series.get("file", path_below("a file's", work_directory)));
  series_table.read_into(series, definition, source);
  source.offset = series.find("offset", any_number(unit)).value_or(source.offset);
  if (series.has("unit"))
    source.unit = series.choice("unit", "a unit of " + source.quantity, unit_names(unit));
  if (series.has("time_unit"))
    source.time_unit = series.choice("time_unit", "a unit of time", unit_names("s"));
  if (series.has("datum")) {
    series.choice("datum", "a datum", {"first"});
    if (series.has("offset"))
      series.refuse("datum", "no datum beside an offset, or no offset beside a datum");
    source.first_is_zero = true;
  }
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
void refuse_half_a_method(const TomlTable& run) {
  if (run.has("particle_spacing_m") && !run.has("method"))
    run.refuse("method", "the name of the method, beside particle_spacing_m");
  if (run.has("method") && !run.has("particle_spacing_m"))
    run.refuse("particle_spacing_m", "the method's spacing in this run, in m, beside method");
}

}  // namespace

const FieldTable<ExternalRun> external_table{
    key_table("run.external", "[[run]] with solver = \"external\"", "no",
              "A program of yours, started without a shell: see [Other solvers](other_solvers.md).",
              {}, {"external"}),
    {{{"command", list("list of texts"), yes,
       "The program and its arguments. {case_file}, {case_directory}, {work_directory}, "
       "{tank_file}, {peers_directory}, {duration_s}, {sample_interval_s} and {particle_spacing_m} "
       "are filled in. A program with a / in its name is found relative to the case file, another "
       "on the PATH."}},
     field("method", &ExternalRun::method, name(), beside("particle_spacing_m").when({}),
           "What the program solves the case with. Runs of one method differ in their spacing "
           "alone, as those of an SPH scheme do: they have an order, a cost of an error and a "
           "curve in each figure. Their programs, and how their series are taken, are the same; "
           "settings and directories may differ. No run and no scheme of the case has this name."),
     field("particle_spacing_m", &ExternalRun::particle_spacing,
           number("m").above(0).at_most(fill_depth).by(a_particle_spacing),
           beside("method").when({}),
           "The spacing of the particles, another one in each run of the method."),
     {{"directory", text("path, relative to the case file"), no,
       "Where the program starts. Default: a fresh work directory."}},
     field("time_limit_s", &ExternalRun::time_limit, number("s").above(0), no,
           "The longest wall-clock time that the program may take."),
     {{"inputs", list("list of paths or patterns, relative to the case file"), no,
       "Files, directories with all below them, and patterns of either that count as part of the "
       "run: a change of one file makes the run be computed again."}},
     {{"fail_on", list("list of texts"), no,
       "Regular expressions (RE2). A line of the program's log that one of them matches makes the "
       "run fail."}},
     field("cores", &ExternalRun::cores, integer().at_least(1), no,
           "The number of cores to which the program is bound, and its OMP_NUM_THREADS. Default: "
           "it is not bound."),
     {{"version_command", list("list of texts"), no,
       "A program and its arguments, as in command, of which the first line of output is the "
       "version that the report names. It has a minute."}},
     {{"facts", text("path below the work directory"), no,
       "A JSON file in which the program tells its numbers of particles and steps and its costs: "
       "see [What the program tells of "
       "itself](other_solvers.md#what-the-program-tells-of-itself)."}},
     {{"series", tables("[[run.series]]"), yes, "One table or more, below."}}}};

const FieldTable<StoredRun> stored_table{
    key_table(
        "run.stored", "[[run]] with solver = \"stored\"", "no",
        "A result that another code left elsewhere: it is read, and no program is started. See "
        "[Stored results](other_solvers.md#stored-results).",
        {}, {"stored"}),
    {{{"file", text("path, relative to the case file"), where("without series"),
       "A plain table: its columns t and elevation@GAUGE, force_x, ..., or t and one more."}},
     field("method", &StoredRun::method, name(), beside("particle_spacing_m").when({}),
           "The same as for an external run."),
     field("particle_spacing_m", &StoredRun::particle_spacing,
           number("m").above(0).at_most(fill_depth).by(a_particle_spacing),
           beside("method").when({}),
           "The spacing of the particles, another one in each run of the method."),
     {{"facts", text("path, relative to the case file"), no,
       "A JSON file: which code, when and on which machine, and what the run took. Default: its "
       "cost is not known."}},
     {{"series", tables("[[run.series]]"), where("without file"), "One table or more, below."}}}};

const FieldTable<SeriesSource> series_table{
    {"run.series", "[[run.series]]", "with solver = \"external\" or \"stored\", one or more",
     "A series that the program leaves."},
    {{{"quantity", text("compared quantity"), yes, "Each quantity may appear once."}},
     {{"file", text("path"), yes,
       "The file that the program writes, below the work directory; of a stored run the file that "
       "is read, relative to the case file."}},
     field("format", &SeriesSource::format, text(), yes, "One of the formats of `./slosh import`."),
     field("column", &SeriesSource::column, text(), yes,
           "The column, or the path of an HDF5 data set."),
     {{"unit", text("unit of the quantity"), where("where the file does not say it"),
       "The unit of the column."}},
     field("time_column", &SeriesSource::time_column, text(), with("format", "csv").when({}),
           "The column of times of a csv or hdf5 file; other formats refuse it."),
     {{"time_unit", one_of({"s", "ms", "min"}), where("where a csv or hdf5 file does not say it"),
       "The unit of the times of such a file; other formats refuse it."}},
     field("time_offset_s", &SeriesSource::time_offset, number("s"), no,
           "Added to the file's times. Default: 0."),
     field("scale", &SeriesSource::scale, number().other_than_zero(), no,
           "The series is scale times the column plus offset. Default: 1."),
     {{"offset", number("the quantity's unit"), no, "Default: 0."}},
     {{"datum", one_of({"first"}), no,
       "With `first` the first value counts as zero, in place of an offset."}},
     field("whole_tank", &SeriesSource::whole_tank, flag(), no,
           "Whether the force of a gauge of DualSPHysics is that on the whole tank. Without it "
           "such a file gives the force on one wall, `force_x@WALL`.")}};

ExternalRun read_external_run(const TomlTable& run, const CaseDefinition& definition) {
  ExternalRun external{};
  external_table.read_into(run, definition, external);
  refuse_half_a_method(run);
  external.command = read_command(run, "command");
  if (run.has("version_command")) external.version_command = read_command(run, "version_command");
  if (const auto directory = run.find("directory", any_text())) {
    external.directory = beside_case(definition, *directory);
    if (std::error_code lost; !fs::is_directory(external.directory, lost))
      run.refuse("directory", "a directory relative to the case file; there is no " +
                                  external.directory.string());
  }
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
  if (run.has("facts")) external.facts = run.get("facts", path_below("a file's", work_directory));
  external.series = read_all_series(run, definition, Files::below_work_directory);
  return external;
}

StoredRun read_stored_run(const TomlTable& run, const CaseDefinition& definition) {
  StoredRun stored{};
  stored_table.read_into(run, definition, stored);
  refuse_half_a_method(run);
  if (run.has("file") && run.has("series"))
    run.refuse("file", "no file beside [[run.series]], or no [[run.series]] beside it");
  stored.series = run.has("file")
                      ? series_of_table(stored_file(run, "file", definition), definition)
                      : read_all_series(run, definition, Files::beside_case_file);
  if (run.has("facts")) stored.facts = stored_file(run, "facts", definition);
  return stored;
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

}  // namespace slosh
