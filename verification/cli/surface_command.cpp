// The subcommand surface: measures the surface of the particles of any program as that of our own
// runs is measured, so that codes are compared on one definition of it.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/shell_word.hpp"
#include "verification/gate/gate.hpp"
#include "verification/import/particle_table.hpp"
#include "verification/results/provenance.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/particles/particle_surface.hpp"

namespace slosh {
namespace {

struct SurfaceOptions {
  std::filesystem::path file, output;
  std::string case_name, frame = "tank";
  double spacing = 0;
  ParticleColumns columns;
};

std::string command_of(const SurfaceOptions& options) {
  std::string command = fmt::format("./slosh surface {} --case {} --spacing {} --frame {}",
                                    shell_word(options.file.string()), options.case_name,
                                    options.spacing, options.frame);
  for (const auto& [name, column] :
       {std::pair{"--time", &options.columns.time}, std::pair{"--x", &options.columns.x},
        std::pair{"--z", &options.columns.z}, std::pair{"--volume", &options.columns.volume}})
    if (!column->empty()) command += fmt::format(" {} {}", name, shell_word(*column));
  return command + " -o " + shell_word(options.output.string());
}

int measure(const SurfaceOptions& options, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  if (definition.gauges.empty())
    throw CaseFileError(definition.file.string() +
                        ": gauge: expected at least one [[gauge]], at which the surface is "
                        "measured");
  if (!is_rectangle(definition.tank))
    throw CaseFileError(definition.file.string() +
                        ": tank: expected a rectangle, length_m and height_m, over whose level "
                        "bottom the depth of liquid is measured");
  RunResult result;
  result.series =
      surface_series(read_particle_table(options.file, options.columns),
                     {value_of(options.frame, position_frame_names), options.spacing}, definition);
  result.case_name = definition.name;
  result.run_name = options.file.stem().string();
  result.solver = "imported";
  result.active_terms = {"surface of particles, measured as that of SPH runs"};
  const std::string command = command_of(options);
  const std::string content = content_hash(read_bytes(options.file));
  result.key = content_hash(content + definition.text + command);
  result.provenance = provenance(command);
  result.provenance["source_file"] = std::filesystem::absolute(options.file).string();
  result.provenance["source_hash"] = content;
  const OpenOutputs output(options.output, "surface");
  write_result(result, options.output);
  for (const TimeSeries& series : result.series)
    std::cout << fmt::format("{}: {} samples from {} to {} s [{}], the first value is {:.4g}\n",
                             series.name, series.time.size(), series.time.front(),
                             series.time.back(), series.unit, series.value.front());
  std::cout << "result: " << options.output.string() << "\n";
  return exit_pass;
}

}  // namespace

void add_surface_command(const CommandTree& tree) {
  const auto options = std::make_shared<SurfaceOptions>();
  CLI::App& command = add_command(
      tree,
      {"surface",
       "Measures the surface from particle positions of any program, as in our own runs",
       {"printf 'time,x,z\\n0,0.5,0.1\\n0,0.6,0.1\\n' > particles.csv",
        "./slosh surface particles.csv --case li2010_small_amplitude --spacing 0.1 -o surface.h5"}},
      [options, &installation = tree.installation] { return measure(*options, installation); });
  command
      .add_option("file", options->file,
                  "A table with a row for each particle of the liquid at each time; its first line "
                  "has the names of the columns")
      ->type_name(file_type)
      ->required();
  command.add_option("--case", options->case_name, "The case, for its tank and its gauges")
      ->type_name(case_type)
      ->required();
  command
      .add_option("--spacing", options->spacing, "The spacing of the particles at the start, in m")
      ->required()
      ->check(keeps(positive("m")));
  command
      .add_option("--frame", options->frame,
                  "The frame of the positions: that of the tank, or of the earth, from which the "
                  "case's motion is taken off (default: tank)")
      ->check(one_of("a frame", all_names(position_frame_names)));
  command.add_option("--time", options->columns.time, "The column of times (default: time)");
  command.add_option("--x", options->columns.x,
                     "The column of positions along the bottom, from the left wall (default: x)");
  command.add_option("--z", options->columns.z,
                     "The column of heights above the bottom (default: z)");
  command.add_option("--volume", options->columns.volume,
                     "The column of volumes per metre of width, in m2 (default: that of a cell of "
                     "the lattice, for each particle)");
  command.add_option("-o,--output", options->output, "Result file")
      ->type_name(file_type)
      ->required();
}

}  // namespace slosh
