#include <fmt/format.h>
#include <fmt/ranges.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <tuple>

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

void finish_series(const TomlTable& series, const CaseDefinition&, SeriesSource& source) {
  const std::string unit = unit_of(source.quantity);
  source.offset = series.find("offset", any_number(unit)).value_or(source.offset);
  if (series.has("unit"))
    source.unit = series.choice("unit", "a unit of " + source.quantity, unit_names(unit));
  if (!series.has("datum")) return;
  series.choice("datum", "a datum", {"first"});
  if (series.has("offset"))
    series.refuse("datum", "no datum beside an offset, or no offset beside a datum");
  source.first_is_zero = true;
}

SeriesSource read_series(const TomlTable& series, const CaseDefinition& definition, Files files) {
  SeriesSource source = series_keys(series, definition);
  source.file = files == Files::beside_case_file
                    ? stored_file(series, "file", definition)
                    : fs::path(series.get("file", path_below("a file's", work_directory)));
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

KeyValue command_line() {
  return list("list of texts", {"a text", [](const auto&) { return true; }});
}

void refuse_no_program(const TomlTable& run, const char* key,
                       const std::vector<std::string>& command) {
  if (run.has(key) && (command.empty() || command.front().empty()))
    run.refuse(key, "a list of texts that begins with a program");
}

// A method's runs are told apart by their spacings, and a spacing alone is of no use.
void refuse_half_a_method(const TomlTable& run) {
  if (run.has("particle_spacing_m") && !run.has("method"))
    run.refuse("method", "the name of the method, beside particle_spacing_m");
  if (run.has("method") && !run.has("particle_spacing_m"))
    run.refuse("particle_spacing_m", "the method's spacing in this run, in m, beside method");
}

// By its suffix, or by how it begins. The bit of a file that can be executed tells nothing where a
// disk gives it to all files.
bool is_program(const fs::path& file) {
  static constexpr std::array<std::string_view, 11> suffixes{
      ".py", ".sh", ".R", ".jl", ".m", ".pl", ".rb", ".lua", ".js", ".jar", ".exe"};
  if (std::ranges::count(suffixes, file.extension().string()) > 0) return true;
  std::error_code lost;
  if (!fs::is_regular_file(file, lost)) return false;
  std::string head(4, ' ');
  std::ifstream(file, std::ios::binary).read(head.data(), std::ssize(head));
  return head.starts_with("#!") || head ==
                                       "\x7f"
                                       "ELF";
}

// The names of the programs and scripts in a command: each spacing may have a directory of its own.
std::vector<std::string> programs_of(const ExternalRun& external,
                                     const CaseDefinition& definition) {
  const std::string here = "{case_directory}/";
  std::vector<std::string> names{fs::path(external.command.front()).filename().string()};
  for (auto word = external.command.begin() + 1; word != external.command.end(); ++word) {
    const fs::path file = word->starts_with(here) ? word->substr(here.size()) : *word;
    if (is_program(definition.file.parent_path() / file) ||
        (!external.directory.empty() && is_program(external.directory / file)))
      names.push_back(file.filename().string());
  }
  return names;
}

bool takes_alike(const SeriesSource& one, const SeriesSource& other) {
  const auto how = [](const SeriesSource& source) {
    return std::tie(source.format, source.column, source.unit, source.time_column, source.time_unit,
                    source.scale, source.offset, source.time_offset, source.first_is_zero,
                    source.whole_tank);
  };
  return how(one) == how(other);
}

// What two runs of a method take in different ways; empty where that is nothing.
template <class Run>
std::string taken_otherwise(const Run& run, const Run& other) {
  for (const SeriesSource& one : run.series)
    for (const SeriesSource& same : other.series)
      if (one.quantity == same.quantity && !takes_alike(one, same))
        return fmt::format("takes {} with the same format, column, unit, scale, offset and datum",
                           one.quantity);
  return "";
}

// What else than the spacing differs between two runs of a method; empty where that is nothing.
// Their settings may differ, which can be how a program gets its spacing.
std::string other_difference(const RunDefinition& run, const RunDefinition& other,
                             const CaseDefinition& definition) {
  if (const auto* a = std::get_if<StoredRun>(&run.solver),
      *b = std::get_if<StoredRun>(&other.solver);
      a && b)
    return taken_otherwise(*a, *b);
  const auto *a = std::get_if<ExternalRun>(&run.solver),
             *b = std::get_if<ExternalRun>(&other.solver);
  if (!a || !b) return "";
  const std::vector<std::string> programs = programs_of(*b, definition);
  if (programs_of(*a, definition) != programs)
    return fmt::format("starts the same programs, {}", fmt::join(programs, " "));
  const bool names_spacing =
      fmt::format("{}", fmt::join(a->command, " ")).find("{particle_spacing_m}") !=
      std::string::npos;
  if (a->command == b->command && a->directory == b->directory && !names_spacing)
    return "has another command or directory, as by {particle_spacing_m}";
  return taken_otherwise(*a, *b);
}

void finish_external(const TomlTable& run, const CaseDefinition& definition,
                     ExternalRun& external) {
  refuse_half_a_method(run);
  refuse_no_program(run, "command", external.command);
  refuse_no_program(run, "version_command", external.version_command);
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
  if (run.has("facts")) external.facts = run.get("facts", path_below("a file's", work_directory));
  external.series = read_all_series(run, definition, Files::below_work_directory);
}

void finish_stored(const TomlTable& run, const CaseDefinition& definition, StoredRun& stored) {
  refuse_half_a_method(run);
  if (run.has("file") && run.has("series"))
    run.refuse("file", "no file beside [[run.series]], or no [[run.series]] beside it");
  stored.series = run.has("file")
                      ? series_of_table(stored_file(run, "file", definition), definition)
                      : read_all_series(run, definition, Files::beside_case_file);
  if (run.has("facts")) stored.facts = stored_file(run, "facts", definition);
}

// The external run of the driver that Slosh ships. So far its method is the scheme.
void finish_pysph(const TomlTable& run, const CaseDefinition& definition, ExternalRun& external) {
  if (definition.motion.roll || definition.liquid.column_width || !definition.obstacles.empty() ||
      definition.tank.breadth || definition.gauges.empty())
    run.refuse("solver",
               "another solver: pysph takes a tank with a [[gauge]], filled from wall to wall, "
               "that does not roll and has neither an obstacle nor breadth_m");
  for (const double size : {definition.tank.length, definition.liquid.fill_depth}) {
    const double rows = size / *external.particle_spacing;
    if (std::abs(rows - std::round(rows)) > 1e-6)
      run.refuse("particle_spacing_m",
                 fmt::format("a whole fraction of the tank's length and of the fill depth, "
                             "{:.4g} and {:.4g} m, for pysph",
                             definition.tank.length, definition.liquid.fill_depth));
  }
  const std::string driver = "{peers_directory}/pysph_tank.py";
  external.command = {driver, "{tank_file}", "{work_directory}", external.method,
                      "{particle_spacing_m}"};
  external.method = "pysph_" + external.method;
  external.facts = "cost.json";
  external.version_command = {driver, "--version"};
  external.cores = 1;
  for (const GaugeDefinition& gauge : definition.gauges)
    external.series.push_back({.quantity = "elevation@" + gauge.name,
                               .file = "elevation.csv",
                               .format = "csv",
                               .column = gauge.name,
                               .unit = "m",
                               .time_column = "t",
                               .time_unit = "s"});
}

}  // namespace

const FieldTable<ExternalRun> external_keys{
    key_table("run.external", "[[run]] with solver = \"external\"", "no",
              "A program of yours, started without a shell: see [Other solvers](other_solvers.md).",
              {}, {"external"}),
    {field("command", &ExternalRun::command, command_line(), yes,
           "The program and its arguments. {case_file}, {case_directory}, {work_directory}, "
           "{tank_file}, {peers_directory}, {duration_s}, {sample_interval_s} and "
           "{particle_spacing_m} are filled in. A program with a / in its name is found relative "
           "to the case file, another on the PATH."),
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
     field("fail_on", &ExternalRun::fail_on, list("list of texts", a_pattern), no,
           "Regular expressions (RE2). A line of the program's log that one of them matches makes "
           "the run fail."),
     field("cores", &ExternalRun::cores, integer().at_least(1), no,
           "The number of cores to which the program is bound, and its OMP_NUM_THREADS. Default: "
           "it is not bound."),
     field("version_command", &ExternalRun::version_command, command_line(), no,
           "A program and its arguments, as in command, of which the first line of output is the "
           "version that the report names. It has a minute."),
     {{"facts", text("path below the work directory"), no,
       "A JSON file in which the program tells its numbers of particles and steps and its costs: "
       "see [What the program tells of "
       "itself](other_solvers.md#what-the-program-tells-of-itself)."}},
     {{"series", tables("[[run.series]]"), yes, "One table or more, below."}}},
    finish_external};

const FieldTable<StoredRun> stored_keys{
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
     {{"series", tables("[[run.series]]"), where("without file"), "One table or more, below."}}},
    finish_stored};

const FieldTable<SeriesSource> series_keys{
    {"run.series", "[[run.series]]", "with solver = \"external\" or \"stored\", one or more",
     "A series that the program leaves."},
    {field("quantity", &SeriesSource::quantity,
           known("compared quantity", "a compared quantity", compared_quantities), yes,
           "Each quantity may appear once."),
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
     field("time_unit", &SeriesSource::time_unit, one_of({"s", "ms", "min"}, "a unit of time"),
           where("where a csv or hdf5 file does not say it"),
           "The unit of the times of such a file; other formats refuse it."),
     field("time_offset_s", &SeriesSource::time_offset, number("s"), no,
           "Added to the file's times. Default: 0."),
     field("scale", &SeriesSource::scale, number().other_than_zero(), no,
           "The series is scale times the column plus offset. Default: 1."),
     {{"offset", number("the quantity's unit"), no, "Default: 0."}},
     {{"datum", one_of({"first"}), no,
       "With `first` the first value counts as zero, in place of an offset."}},
     field("whole_tank", &SeriesSource::whole_tank, flag(), no,
           "Whether the force of a gauge of DualSPHysics is that on the whole tank. Without it "
           "such a file gives the force on one wall, `force_x@WALL`.")},
    finish_series};

const FieldTable<ExternalRun> pysph_keys{
    key_table("run.pysph", "[[run]] with solver = \"pysph\"", "no",
              "PySPH, from Debian's package python3-pysph, by the driver that Slosh ships: see "
              "[PySPH](other_solvers.md#pysph). It is an external run of the method pysph_SCHEME. "
              "The tank surges or stands still, with or without an initial wave, and has no "
              "obstacle.",
              {}, {"pysph"}),
    {field("scheme", &ExternalRun::method,
           one_of({"delta_sph", "edac", "adami"}, "a scheme of PySPH's driver"), yes,
           "One of PySPH's own schemes."),
     field("particle_spacing_m", &ExternalRun::particle_spacing,
           number("m").above(0).by(a_particle_spacing), yes,
           "A whole fraction of the tank's length and of the fill depth, another one in each run "
           "of the scheme.")},
    finish_pysph};

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
    if (const std::string same = other_difference(run, other, definition); !same.empty())
      table.refuse("method", fmt::format("a run that differs from {} in the spacing alone, and {}",
                                         other.name, same));
  }
}

}  // namespace slosh
