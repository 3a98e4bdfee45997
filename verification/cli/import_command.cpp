// The subcommand import: reads series from another program's file into a result file. Of positions
// of particles it measures the surface as that of our own runs is measured, so that codes are
// compared on one definition of it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/shell_word.hpp"
#include "verification/gate/gate.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/import/import_series.hpp"
#include "verification/import/particle_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/tables/series_files.hpp"
#include "verification/results/provenance.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/external_facts.hpp"
#include "verification/solvers/particles/particle_surface.hpp"
#include "verification/solvers/particles/particles_in_tank.hpp"

namespace slosh {
namespace {

// The format of positions of particles, which is none of a [[run.series]].
constexpr const char* particles = "particles";

struct ImportOptions {
  std::vector<std::filesystem::path> files;  // each goes on from the last
  std::filesystem::path output;
  std::string format;
  // Of particles.
  std::string case_name, frame = "tank";
  double spacing = 0;
  ParticleColumns columns;
  // Of series.
  std::vector<std::string> series;  // "QUANTITY=COLUMN" each
  std::string unit, time_column, time_unit;
  double scale = 1, offset = 0, time_offset = 0;  // offset in the quantity's unit, and in s
  std::string datum;
  bool whole_tank = false;
};

[[noreturn]] void refuse_series(const std::string& series, const std::string& expected) {
  throw CaseFileError(fmt::format("--series {}: expected {}", series, expected));
}

void require_quantity(const std::string& series, const std::string& quantity) {
  if (find_quantity(quantity) && !quantity.ends_with('@')) return;
  const std::vector<std::string> names = quantity_names();
  refuse_series(series,
                fmt::format("QUANTITY=COLUMN with one of {}; nearest: {}", fmt::join(names, ", "),
                            nearest_names(quantity, names, 1).front()));
}

SeriesSource source_of(const std::string& series, const ImportOptions& options) {
  const std::size_t equals = series.find('=');
  if (equals == series.npos || equals + 1 == series.size())
    refuse_series(series, "QUANTITY=COLUMN");
  SeriesSource source{.quantity = series.substr(0, equals),
                      .file = options.files.front(),
                      .format = options.format,
                      .column = series.substr(equals + 1),
                      .unit = options.unit,
                      .time_column = options.time_column,
                      .time_unit = options.time_unit,
                      .scale = options.scale,
                      .offset = options.offset,
                      .time_offset = options.time_offset,
                      .first_is_zero = !options.datum.empty(),
                      .whole_tank = options.whole_tank};
  require_quantity(series, source.quantity);
  return source;
}

// Checks all options before any file is read.
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
  std::string command = "./slosh import";
  for (const std::filesystem::path& file : options.files)
    command += " " + shell_word(file.string());
  command += " --format " + options.format;
  if (options.format == particles)
    command += fmt::format(" --case {} --spacing {} --frame {} --x {} --z {}", options.case_name,
                           options.spacing, options.frame, shell_word(options.columns.x),
                           shell_word(options.columns.z));
  for (const std::string& series : options.series) command += " --series " + shell_word(series);
  for (const auto& [name, value] :
       {std::pair{"--unit", &options.unit}, std::pair{"--time", &options.time_column},
        std::pair{"--time-unit", &options.time_unit},
        std::pair{"--volume", &options.columns.volume}})
    if (!value->empty()) command += fmt::format(" {} {}", name, shell_word(*value));
  if (options.scale != 1) command += fmt::format(" --scale {}", options.scale);
  if (options.offset != 0) command += fmt::format(" --offset {}", options.offset);
  if (options.time_offset != 0) command += fmt::format(" --time-offset {}", options.time_offset);
  if (!options.datum.empty()) command += " --datum " + options.datum;
  if (options.whole_tank) command += " --whole-tank";
  return command + " -o " + shell_word(options.output.string());
}

std::vector<std::filesystem::path> all_files(const ImportOptions& options) {
  std::vector<std::filesystem::path> all;
  for (const std::filesystem::path& file : options.files) {
    const std::vector<std::filesystem::path> parts = series_files(file);
    if (parts.empty())
      throw CaseFileError(
          fmt::format("file = {}: expected a file; {}", file.string(), no_file_at(file)));
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

// `measured_in` is the text of the case whose gauges tell what the series are.
void add_origin(const ImportOptions& options, const std::vector<std::filesystem::path>& files,
                const std::string& measured_in, RunResult& result) {
  const std::string command = command_of(options);
  std::string paths, contents;
  for (const std::filesystem::path& file : files) {
    paths += (paths.empty() ? "" : "; ") + std::filesystem::absolute(file).string();
    contents += read_input(file);
  }
  const std::string content = content_hash(contents);
  result.key = content_hash(content + measured_in + command);
  result.provenance = provenance(command);
  result.provenance["source_file"] = paths;
  result.provenance["source_hash"] = content;
  result.provenance["source_format"] = options.format;
}

RunResult series_in(const ImportOptions& options) {
  if (options.series.empty()) throw CaseFileError("--series is missing: expected QUANTITY=COLUMN");
  const std::vector<SeriesSource> sources = sources_of(options);
  const std::vector<std::filesystem::path> files = all_files(options);
  RunResult result;
  add_origin(options, files, "", result);
  for (const SeriesSource& source : sources) add_imported(import_series(source, files), result);
  result.case_name = "imported";
  result.active_terms = {"imported from " + options.format};
  return result;
}

RunResult surface_of_particles(const ImportOptions& options, const Installation& installation) {
  if (options.case_name.empty() || options.spacing == 0 || options.files.size() != 1)
    throw CaseFileError("--format particles: expected one file, --case and --spacing");
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  if (definition.gauges.empty())
    throw CaseFileError(definition.file.string() +
                        ": gauge: expected at least one [[gauge]], at which the surface is "
                        "measured");
  if (!is_rectangle(definition.tank))
    throw CaseFileError(definition.file.string() +
                        ": tank: expected a rectangle, length_m and height_m, over whose level "
                        "bottom the depth of liquid is measured");
  ParticleColumns columns = options.columns;
  if (!options.time_column.empty()) columns.time = options.time_column;
  RunResult result;
  const std::filesystem::path& file = options.files.front();
  const std::vector<ParticlesAt> moments =
      in_tank(read_particle_table(file, columns), value_of(options.frame, position_frame_names),
              definition);
  require_in_tank(moments, options.spacing, definition, file);
  result.series = surface_series(moments, options.spacing, definition);
  add_origin(options, options.files, definition.text, result);
  if (const auto doubts = doubts_of_liquid(moments, options.spacing, definition); !doubts.empty())
    result.provenance["doubts"] = fmt::format("{}", fmt::join(doubts, "\n"));
  result.case_name = definition.name;
  result.active_terms = {"surface of particles, measured as that of SPH runs"};
  return result;
}

// Throws CaseFileError for an option that says nothing of the format.
void refuse_other_options(const ImportOptions& options, const CLI::App& command) {
  const auto refuse = [&](std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (command.get_option(name)->count() > 0)
        throw CaseFileError(
            fmt::format("{}: expected no such option with --format {}", name, options.format));
  };
  if (options.format == particles)
    refuse({"--series", "--unit", "--time-unit", "--time-offset", "--scale", "--offset", "--datum",
            "--whole-tank"});
  else
    refuse({"--case", "--spacing", "--frame", "--x", "--z", "--volume"});
}

int import_files(const ImportOptions& options, const Installation& installation) {
  RunResult result = options.format == particles ? surface_of_particles(options, installation)
                                                 : series_in(options);
  result.run_name = options.files.front().stem().string();
  result.solver = "imported";
  const OpenOutputs output(options.output, "import");
  write_result(result, options.output);
  for (const TimeSeries& series : result.series) {
    std::cout << fmt::format("{}: {} samples from {} to {} s [{}], the first value is {:.4g}\n",
                             series.name, series.time.size(), series.time.front(),
                             series.time.back(), series.unit, series.value.front());
    if (const auto seams = result.provenance.find(seams_of + series.name);
        seams != result.provenance.end())
      std::cout << "  " << legible(seams->second) << "\n";
  }
  if (const auto doubts = result.provenance.find("doubts"); doubts != result.provenance.end())
    std::cerr << doubts->second << "\n";
  std::cout << "result: " << options.output.string() << "\n";
  return exit_pass;
}

// "csv and hdf5"
std::string formats_that_name_times() {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats())
    if (format.time_column != TimeColumn::known_by_format) names.push_back(format.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string formats_text() {
  std::string text = "Formats:\n";
  const auto add = [&](const std::string& name, const std::string& files,
                       const std::string& columns) {
    text += fmt::format("  {:<26}{}\n{:28}columns: {}\n", name, files, "", columns);
  };
  for (const FileFormat& format : file_formats()) add(format.name, format.files, format.columns);
  add(particles, "positions of particles of any program, whose surface is measured",
      "--time, --x, --z and --volume name them");
  return text;
}

void add_import_options(CLI::App& command, ImportOptions& options) {
  add_option(command, "file", options.files, file_type,
             "A file that another program wrote, or files each of which goes on from the last; "
             "a directory with the time folders of OpenFOAM")
      ->required();
  std::vector<std::string> formats = format_names();
  formats.push_back(particles);
  command.add_option("--format", options.format, "What wrote it")
      ->required()
      ->check(one_of("a format", formats));
  command
      .add_option("--series", options.series,
                  "QUANTITY=COLUMN, as in elevation@right=swlz; may be given again")
      ->allow_extra_args(false);
  command.add_option("--unit", options.unit, "The columns' unit, where the file does not say it");
  command.add_option("--time", options.time_column,
                     "The column of times, of " + formats_that_name_times() +
                         ", and of particles (default there: time)");
  command.add_option("--time-unit", options.time_unit, "Its unit, where the file does not say it");
  command.add_option("--time-offset", options.time_offset, "Added to the file's times [s]")
      ->check(keeps(any_number("s")));
  command.add_option("--scale", options.scale, "Multiplies the values, as 2 does for half a tank")
      ->check(keeps(not_zero("1")));
  CLI::Option* offset =
      command
          .add_option(
              "--offset", options.offset,
              "Added to the values, in the quantity's SI unit: -0.35 for a surface's height "
              "above the bottom of a tank filled to 0.35 m")
          ->check(keeps(any_number("the quantity's SI unit")));
  command.add_option("--datum", options.datum, "first: the first value counts as zero")
      ->check(one_of("a datum", {"first"}))
      ->excludes(offset);
  command.add_flag("--whole-tank", options.whole_tank,
                   "A gauge of forces of DualSPHysics is on the whole tank and not on one wall");
  add_option(command, "-o,--output", options.output, file_type, "Result file")->required();
}

void add_particle_options(CLI::App& command, ImportOptions& options) {
  add_option(command, "--case", options.case_name, case_type,
             "Of particles: the case of tank and gauges");
  command
      .add_option("--spacing", options.spacing, "The spacing of the particles at the start, in m")
      ->check(keeps(positive("m")));
  command
      .add_option("--frame", options.frame,
                  "The frame of the positions: that of the tank, or of the earth, from which the "
                  "case's motion is taken off (default: tank)")
      ->check(one_of("a frame", all_names(position_frame_names)));
  command.add_option("--x", options.columns.x,
                     "The column of positions along the bottom, from the left wall (default: x)");
  command.add_option("--z", options.columns.z,
                     "The column of heights above the bottom (default: z)");
  command.add_option("--volume", options.columns.volume,
                     "The column of volumes per metre of width, in m2 (default: that of a cell of "
                     "the lattice, for each particle)");
}

}  // namespace

void add_import_command(const CommandTree& tree) {
  const auto [command, imported] = add_command_with<ImportOptions>(
      tree,
      {"import",
       "Writes a result file with series from another program, or of the surface of its particles",
       {"./slosh run li2010_small_amplitude linear",
        "./slosh import linear.h5 --format hdf5 --time /series/elevation@right/time "
        "--series elevation@right=/series/elevation@right/value -o imported.h5",
        "printf 'time,x,z\\n0,0.5,0.1\\n0,0.6,0.1\\n' > particles.csv",
        "./slosh import particles.csv --format particles --case li2010_small_amplitude "
        "--spacing 0.1 -o surface.h5"}},
      [&app = tree.app](const ImportOptions& given, const Installation& installation) {
        refuse_other_options(given, *app.get_subcommand("import"));
        return import_files(given, installation);
      });
  add_import_options(command, imported);
  add_particle_options(command, imported);
  command.footer(formats_text() + "\n" + command.get_footer());
}

}  // namespace slosh
