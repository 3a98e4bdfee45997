// A case for SPHinXsys, whose cases are C++ programs: its numbers as a header, in the style of the
// constants at the top of SPHinXsys's own two-dimensional examples.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "verification/peers/motion_table.hpp"
#include "verification/peers/run_block.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

void require_for_sphinxsys(const HandedCase& handed) {
  const CaseDefinition& definition = handed.definition;
  if (definition.initial_wave)
    refuse_for_code(definition, "initial_wave",
                    "a liquid that starts under a level surface, for SPHinXsys");
  if (definition.tank.breadth)
    refuse_for_code(definition, "tank.breadth_m",
                    "a tank whose front and back walls do not count, for SPHinXsys");
  if (starts_against_roll(definition))
    refuse_for_code(definition, "time.start",
                    "\"tank\" where the roll begins at a rate, for SPHinXsys");
}

std::string number(const char* name, double value, const char* comment) {
  return fmt::format("constexpr double {} = {};  // {}\n", name, exact(value), comment);
}

std::string boxes(const CaseDefinition& definition) {
  std::string text = fmt::format(
      "struct Box {{ const char* name; double left, right, bottom, top; }};  // [m]\n"
      "constexpr Box water_block{{\"water_block\", 0, {}, 0, {}}};\n",
      exact(definition.liquid.column_width.value_or(definition.tank.length)),
      exact(definition.liquid.fill_depth));
  text += fmt::format("constexpr std::array<Box, {}> obstacles{{{{", definition.obstacles.size());
  for (const ObstacleDefinition& one : definition.obstacles)
    text += fmt::format("\n    {{{}, {}, {}, {}, {}}},", nlohmann::json(one.name).dump(),
                        exact(one.left), exact(one.right), exact(one.bottom), exact(one.top));
  return text + "}};\n";
}

std::string gauges(const CaseDefinition& definition) {
  std::string text = fmt::format(
      "struct WaveGauge {{ const char* name; double x; }};  // [m]\n"
      "constexpr std::array<WaveGauge, {}> wave_gauges{{{{",
      definition.gauges.size());
  for (const GaugeDefinition& gauge : definition.gauges)
    text += fmt::format("\n    {{{}, {}}},", nlohmann::json(gauge.name).dump(), exact(gauge.x));
  return text + "}};\n";
}

std::string header(const HandedCase& handed) {
  const CaseDefinition& definition = handed.definition;
  const auto& roll = definition.motion.roll;
  return "// The tank of " + definition.name +
         ", in SI units and in the tank's frame: x from its left wall, y up from its bottom.\n"
         "#pragma once\n\n#include <array>\n\nnamespace tank_case {\n\n" +
         number("DL", definition.tank.length, "length of the tank [m]") +
         number("DH", definition.tank.height, "height of the tank [m]") +
         number("particle_spacing_ref", handed.spacing, "[m]") +
         number("rho0_f", definition.liquid.density, "density of the liquid [kg/m3]") +
         number("nu_f", definition.liquid.kinematic_viscosity, "kinematic viscosity [m2/s]") +
         number("gravity_g", definition.gravity, "[m/s2]") +
         number("initial_velocity_x", initial_velocity_x(definition),
                "of the liquid in the tank's frame [m/s]") +
         number("roll_axis_x", roll ? roll->axis_x : 0, "[m]") +
         number("roll_axis_y", roll ? roll->axis_z : 0, "[m]") +
         number("end_time", definition.duration, "[s]") +
         number("output_interval", definition.sample_interval, "[s]") + "\n" + boxes(definition) +
         gauges(definition) + "\n}  // namespace tank_case\n";
}

std::string gravity_csv(const CaseDefinition& definition) {
  std::vector<std::vector<double>> rows;
  for (const MotionPoint& at : motion_table(definition)) {
    const TankGravity felt = tank_gravity(at, definition.gravity);
    rows.push_back({at.time, felt.x, felt.z, at.rate, at.angular_acceleration});
  }
  return number_table(
      {"time_s", "gravity_x_m_s2", "gravity_y_m_s2", "omega_rad_s", "omega_derivative_rad_s2"},
      rows);
}

std::string block(const HandedCase& handed, const fs::path& directory, const std::string& run) {
  ExternalRun external{.command = {(handed.place / "sloshing_tank").string()},
                       .inputs = inputs_in(handed, directory),
                       .method = "sphinxsys",
                       .particle_spacing = handed.spacing};
  for (const GaugeDefinition& gauge : handed.definition.gauges)
    external.series.push_back({.quantity = "elevation@" + gauge.name,
                               .file = "output/" + gauge.name + "_Position.dat",
                               .format = "sphinxsys",
                               .column = "Position[0][1]",
                               .unit = "m",
                               .first_is_zero = !handed.definition.liquid.column_width});
  if (handed.definition.liquid.column_width)
    for (SeriesSource& source : external.series)
      source.offset = -handed.definition.liquid.fill_depth;
  return run_block(run, external, handed.definition,
                   "Your program sloshing_tank, which writes the observed position of the surface "
                   "at each gauge to output/GAUGE_Position.dat.");
}

std::string readme(const HandedCase& handed, const std::string& run) {
  return readme_head(handed, "SPHinXsys") +
         "SPHinXsys has no case files: a case is a C++ program, which you have to write. These are "
         "its numbers. SPHinXsys calls the vertical axis y.\n\n"
         "| file | holds |\n|---|---|\n"
         "| `tank_case.h` | the geometry, the liquid, the start, the times and the gauges, as "
         "constants |\n"
         "| `gravity.csv` | gravity less the acceleration of the roll's axis, along the tank's "
         "axes, and the roll's rate and its derivative |\n\n"
         "## What you have to write\n\n"
         "- The shapes: the water block and the walls around the box from 0 to `DL` and `DH`, and "
         "the obstacles.\n"
         "- A gravity that depends on time: the first three columns of `gravity.csv`. A straight "
         "line between two rows is exact to (omega dt)^2 / 8.\n"
         "- Where the tank rolls, what it adds at the place (x, y) from the axis with the velocity "
         "(u, v): omega' y + omega^2 x + 2 omega v along x and -omega' x + omega^2 y - 2 omega u "
         "along y.\n"
         "- The first velocity of the liquid, `initial_velocity_x`.\n"
         "- An observer of the surface at each gauge.\n"
         "- The choice of the scheme and of its speed of sound.\n\n"
         "This was not run: nothing but its reading is tested.\n" +
         readme_end(handed, run);
}

}  // namespace

void write_sphinxsys_case(const HandedCase& handed, const fs::path& directory) {
  require_for_sphinxsys(handed);
  if (handed.definition.gauges.empty())
    throw CaseFileError(handed.definition.file.string() +
                        ": gauge: expected at least one [[gauge]], for SPHinXsys");
  write_text(directory / "tank_case.h", header(handed));
  write_text(directory / "gravity.csv", gravity_csv(handed.definition));
  const std::string run = run_name("sphinxsys", handed.spacing);
  write_text(directory / "run.toml", block(handed, directory, run));
  write_text(directory / "README.md", readme(handed, run));
}

}  // namespace slosh
