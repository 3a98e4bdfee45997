// A case as interFoam solves it in our own runs, to be run by interFoam alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/tank_mesh.hpp"
#include "openfoam_cases/write_case.hpp"
#include "verification/peers/interfoam_tank.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// OpenFOAM takes its case's path from PWD and refuses one with a blank in it; under Linux
// /proc/self/cwd stands for any process's working directory.
constexpr const char* run_script = R"sh(#!/bin/sh
# Runs the case: ./Allrun [DIRECTORY]. With a directory it copies the case there and runs it in that
# place. Each program leaves its output in log.NAME; the first that fails ends the script.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
work=${1:-$here}
if [ $# -gt 0 ]; then
  mkdir -p "$work"
  cp -R "$here/0" "$here/constant" "$here/system" "$work"
fi
cd "$work"
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"
for program in blockMesh topoSet interFoam; do
  echo "$program"
  if ! env PWD=/proc/self/cwd "$program" > "log.$program" 2>&1; then
    tail -n 30 "log.$program"
    exit 1
  fi
  if ! grep -q '^End' "log.$program"; then
    echo "log.$program: expected the line End"
    exit 1
  fi
done
)sh";

// Which column of cells stands for a gauge, and how its filling becomes an elevation.
struct GaugeReading {
  SeriesSource source;
  double shift;  // [m], from the gauge to the middle of its column
};

// Obstacles on the bottom raise the surface by their height; one that hangs in the column makes the
// surface no linear function of its filling.
GaugeReading reading_of(const GaugeDefinition& gauge, const HandedCase& handed,
                        const openfoam::TankMesh& mesh) {
  const openfoam::GaugeColumns columns = openfoam::gauge_columns(mesh, gauge.x);
  const int column = columns.right_weight > 0.5 ? columns.right : columns.left;
  const double room = mesh.free_cells(column) * mesh.cell_height();
  const double ground = openfoam::surface_level(mesh, column, 0);
  if (std::abs(ground + room - handed.definition.tank.height) > 1e-6 * mesh.cell_height())
    refuse_for_code(handed.definition, "gauge",
                    fmt::format("gauges in whose column no obstacle hangs, as {} has one: the "
                                "filling of its column is then no measure of its surface",
                                gauge.name));
  return {{.quantity = "elevation@" + gauge.name,
           .file = "postProcessing/" + openfoam::column_name(column) + "/0/volFieldValue.dat",
           .format = "openfoam_field_value",
           .column = "volAverage(alpha.liquid)",
           .unit = "m",
           .scale = room,
           .offset = ground - handed.definition.liquid.fill_depth},
          mesh.centre_x(column) - gauge.x};
}

SeriesSource load(const char* quantity, const char* file, const char* column, double scale,
                  const char* unit) {
  return {.quantity = quantity,
          .file = std::string("postProcessing/wall_force/0/") + file,
          .format = "openfoam_forces",
          .column = column,
          .unit = unit,
          .scale = scale};
}

std::string block(const HandedCase& handed, const std::string& name, const fs::path& directory,
                  const std::vector<GaugeReading>& readings) {
  ExternalRun external{.command = {(handed.place / "Allrun").string(), "{work_directory}"},
                       .inputs = inputs_in(handed, directory),
                       .fail_on = {"FOAM FATAL"},
                       .cores = 1};
  for (const GaugeReading& reading : readings) external.series.push_back(reading.source);
  external.series.push_back(load("force_x", "force.dat", "total_x", 1, "N/m"));
  external.series.push_back(load("force_z", "force.dat", "total_z", 1, "N/m"));
  // y points away from the viewer, so that a clockwise moment is positive there.
  external.series.push_back(load("moment", "moment.dat", "total_y", -1, "N"));
  return run_block(
      name, external, handed.definition,
      "interFoam by its own script. The first samples of the loads hold the impulse of "
      "the start.");
}

std::string shifts_text(const std::vector<GaugeReading>& readings, double cell_width) {
  std::string text;
  for (const GaugeReading& reading : readings)
    if (std::abs(reading.shift) > 1e-6 * cell_width)
      text += fmt::format(
          "- `{}` is read {:.4g} m {} its place: a file holds one column of cells, "
          "and the gauge is not in the middle of one. Slosh's own runs interpolate "
          "between two.\n",
          reading.source.quantity, std::abs(reading.shift),
          reading.shift > 0 ? "to the right of" : "to the left of");
  return text;
}

std::string readme(const HandedCase& handed, const std::string& name,
                   const std::vector<GaugeReading>& readings) {
  const CaseDefinition& definition = handed.definition;
  const double cell_width = definition.tank.length / handed.cells_x;
  return readme_head(handed, "interFoam") +
         fmt::format(
             "`./Allrun` runs blockMesh, topoSet and interFoam here, `./Allrun DIRECTORY` in a "
             "copy. "
             "It is the case of Slosh's own runs, for OpenFOAM v1912 of Debian and later versions "
             "with the same output: {} x {} cells, slip walls, the acceleration of the tank as "
             "`constant/acceleration`. A rolling tank's mesh has its origin in the roll's axis.\n\n"
             "## What differs from a run of Slosh\n\n"
             "{}"
             "- Pressures at gauges and probes are written to `postProcessing`, and not taken "
             "back: "
             "a gauge reads several faces less the mean pressure of the gas.\n",
             handed.cells_x, handed.cells_z, shifts_text(readings, cell_width)) +
         readme_end(handed, name);
}

}  // namespace

void write_openfoam_case(const HandedCase& handed, const fs::path& directory) {
  const openfoam::SloshingTank tank =
      interfoam_tank({.cells_x = handed.cells_x, .cells_z = handed.cells_z}, handed.definition);
  try {
    openfoam::write_case(tank, handed.openfoam_templates, directory);
  } catch (const std::invalid_argument& error) {
    throw CaseFileError(handed.definition.file.string() + ": " + error.what());
  }
  write_script(directory / "Allrun", run_script);
  const openfoam::TankMesh mesh(tank);
  std::vector<GaugeReading> readings;
  for (const GaugeDefinition& gauge : handed.definition.gauges)
    readings.push_back(reading_of(gauge, handed, mesh));
  const std::string name = fmt::format("openfoam_{}x{}", handed.cells_x, handed.cells_z);
  write_text(directory / "run.toml", block(handed, name, directory, readings));
  write_text(directory / "README.md", readme(handed, name, readings));
}

}  // namespace slosh
