// A case as tables, for any code: numbers, geometry, gauges, the tank's motion, and what the liquid
// feels in its frame.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/case/motion.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/peers/motion_table.hpp"
#include "verification/peers/tank_file.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::string numbers_csv(const CaseDefinition& definition) {
  std::string table = "name,value,unit\n";
  const auto add = [&](const char* name, double value, const char* unit) {
    table += fmt::format("{},{},{}\n", name, exact(value), unit);
  };
  add("tank_length", definition.tank.length, "m");
  add("tank_height", definition.tank.height, "m");
  if (definition.tank.breadth) add("tank_breadth", *definition.tank.breadth, "m");
  add("fill_depth", definition.liquid.fill_depth, "m");
  if (const auto width = definition.liquid.column_width) add("column_width", *width, "m");
  if (const auto& wave = definition.initial_wave) {
    add("initial_wave_mode", wave->mode, "1");
    add("initial_wave_amplitude", wave->amplitude, "m");
  }
  add("gravity", definition.gravity, "m/s2");
  add("liquid_density", definition.liquid.density, "kg/m3");
  add("liquid_kinematic_viscosity", definition.liquid.kinematic_viscosity, "m2/s");
  add("gas_density", definition.gas.density, "kg/m3");
  add("gas_kinematic_viscosity", definition.gas.kinematic_viscosity, "m2/s");
  if (const auto& roll = definition.motion.roll) {
    add("roll_axis_x", roll->axis_x, "m");
    add("roll_axis_z", roll->axis_z, "m");
  }
  const std::optional<RollMotion> roll = roll_motion(definition);
  add("initial_velocity_x", initial_velocity_x(definition), "m/s");
  add("initial_relative_rate", starts_against_roll(definition) ? -roll->rate(0) : 0, "rad/s");
  add("duration", definition.duration, "s");
  add("sample_interval", definition.sample_interval, "s");
  return table;
}

// Closed polygons, counter-clockwise: of the tank, of the liquid at the start, of each obstacle.
std::string geometry_csv(const CaseDefinition& definition) {
  std::string table = "part,x_m,z_m\n";
  const auto corner = [&](const std::string& part, double x, double z) {
    table += fmt::format("{},{},{}\n", part, exact(x), exact(z));
  };
  const auto box = [&](const std::string& part, double left, double right, double bottom,
                       double top) {
    corner(part, left, bottom);
    corner(part, right, bottom);
    corner(part, right, top);
    corner(part, left, top);
  };
  const auto polygon = [&](const std::string& part, const Outline& corners) {
    for (const auto& [x, z] : corners) corner(part, x, z);
  };
  const TankDefinition& tank = definition.tank;
  const double length = tank.length, depth = definition.liquid.fill_depth;
  polygon("tank", corners_of(tank));
  if (const auto& wave = definition.initial_wave) {
    constexpr int points = 200;
    corner("liquid", 0, 0);
    corner("liquid", length, 0);
    for (int i = points; i >= 0; --i)
      corner("liquid", length * i / points,
             depth + wave->amplitude * std::cos(wave->mode * std::numbers::pi * i / points));
  } else if (!is_rectangle(tank)) {
    polygon("liquid", part_below(tank.outline, depth));
  } else {
    box("liquid", 0, definition.liquid.column_width.value_or(length), 0, depth);
  }
  for (const ObstacleDefinition& one : definition.obstacles)
    box("obstacle_" + one.name, one.left, one.right, one.bottom, one.top);
  return table;
}

std::string gauges_csv(const CaseDefinition& definition) {
  std::string table = "kind,name,x_m,z_m,width_m\n";
  for (const GaugeDefinition& gauge : definition.gauges)
    table += fmt::format("surface,{},{},,\n", gauge.name, exact(gauge.x));
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    const auto [x, z] = sensor_middle(definition.tank, gauge);
    table += fmt::format("wall_pressure,{},{},{},{}\n", gauge.name, exact(x), exact(z),
                         exact(gauge.width));
  }
  for (const ProbeDefinition& probe : definition.probes)
    table += fmt::format("probe,{},{},{},\n", probe.name, exact(probe.x), exact(probe.z));
  return table;
}

void write_motion(const CaseDefinition& definition, const fs::path& directory) {
  std::vector<std::vector<double>> motion, felt;
  for (const MotionPoint& at : motion_table(definition)) {
    motion.push_back({at.time, at.surge, at.surge_velocity, at.surge_acceleration, at.angle,
                      at.rate, at.angular_acceleration});
    const TankGravity gravity = tank_gravity(at, definition.gravity);
    felt.push_back({at.time, gravity.x, gravity.z, at.rate, at.angular_acceleration});
  }
  write_text(directory / "motion.csv",
             number_table({"time_s", "surge_m", "surge_velocity_m_s", "surge_acceleration_m_s2",
                           "roll_rad", "roll_rate_rad_s", "roll_acceleration_rad_s2"},
                          motion));
  write_text(directory / "tank_frame.csv",
             number_table({"time_s", "gravity_x_m_s2", "gravity_z_m_s2", "roll_rate_rad_s",
                           "roll_acceleration_rad_s2"},
                          felt));
}

std::string block(const HandedCase& handed) {
  ExternalRun external{.command = {(handed.place / "my_program").string(), "{work_directory}"}};
  for (const GaugeDefinition& gauge : handed.definition.gauges)
    external.series.push_back({.quantity = "elevation@" + gauge.name,
                               .file = "series.csv",
                               .format = "csv",
                               .column = gauge.name,
                               .unit = "m",
                               .time_column = "time",
                               .time_unit = "s"});
  for (const char* force : {"force_x", "force_z"})
    external.series.push_back({.quantity = force,
                               .file = "series.csv",
                               .format = "csv",
                               .column = force,
                               .unit = "N/m",
                               .time_column = "time",
                               .time_unit = "s"});
  return run_block("my_program", external, handed.definition,
                   "Your program writes series.csv: the time in s, the elevation of each gauge "
                   "above the still level in m, forces in N/m. Remove what it does not write.");
}

std::string readme(const HandedCase& handed) {
  return readme_head(handed, "any code") +
         "| file | holds |\n|---|---|\n"
         "| `numbers.csv` | lengths, liquid, gas, gravity, start and times, each with its unit |\n"
         "| `geometry.csv` | the corners of the tank, of the liquid at the start and of each "
         "obstacle, counter-clockwise |\n"
         "| `gauges.csv` | where the surface, the pressure on a wall (the mean over `width_m`) and "
         "the flow are measured |\n"
         "| `motion.csv` | position, velocity and acceleration of the surge and of the roll about "
         "its axis, for a tank that moves |\n"
         "| `tank_frame.csv` | gravity less the acceleration of the roll's axis, along the tank's "
         "axes, for a tank at rest |\n" +
         (fits_tank_file(handed.definition) ? "| `tank.json` | the same for drivers in one file |\n"
                                            : "") +
         "\nIn the tank's frame a roll also acts on the liquid at the place (x, z) from its axis "
         "with the velocity (u, w), where th is the angle: th'' z + th'^2 x + 2 th' w along x and "
         "-th'' x + th'^2 z - 2 th' u along z. The liquid starts with the velocity "
         "`initial_velocity_x` in the tank's frame, and turns about the roll's axis with "
         "`initial_relative_rate`. A straight line between two rows of the motion is exact to "
         "(omega dt)^2 / 8.\n" +
         readme_end(handed, "my_program") +
         "The program of the block is `my_program` in this directory: put yours there, or name "
         "it.\n";
}

}  // namespace

void write_csv_case(const HandedCase& handed, const fs::path& directory) {
  const CaseDefinition& definition = handed.definition;
  write_text(directory / "numbers.csv", numbers_csv(definition));
  write_text(directory / "geometry.csv", geometry_csv(definition));
  write_text(directory / "gauges.csv", gauges_csv(definition));
  write_motion(definition, directory);
  if (fits_tank_file(definition)) write_text(directory / "tank.json", tank_file(definition));
  write_text(directory / "run.toml", block(handed));
  write_text(directory / "README.md", readme(handed));
}

}  // namespace slosh
