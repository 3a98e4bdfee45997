#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/case/usual_values.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

Rule<double> between(const char* least_name, double least, const char* most_name, double most) {
  return {fmt::format("a number above {} ({}) and <= the tank's {} ({}), in m", least_name, least,
                      most_name, most),
          [least, most](double value) { return value > least && value <= most; }};
}

// A gauge has no surface to measure if an obstacle fills its column from the bottom to the still
// level.
void refuse_swallowed_gauges(const TomlTable& table, const ObstacleDefinition& obstacle,
                             const CaseDefinition& definition) {
  if (obstacle.bottom > 0 || obstacle.top < definition.liquid.fill_depth) return;
  for (const GaugeDefinition& gauge : definition.gauges) {
    if (gauge.x < obstacle.left || gauge.x > obstacle.right) continue;
    table.refuse("top_m", fmt::format("a number below the fill depth ({}), in m, or another place: "
                                      "the obstacle swallows the gauge {} at {} m",
                                      definition.liquid.fill_depth, gauge.name, gauge.x));
  }
}

bool touches(const ObstacleDefinition& obstacle, Wall wall, const TankDefinition& tank) {
  switch (wall) {
    case Wall::left:
      return obstacle.left == 0;
    case Wall::right:
      return obstacle.right == tank.length;
    case Wall::roof:
      return obstacle.top == tank.height;
    case Wall::bottom:
      break;
  }
  return obstacle.bottom == 0;
}

// A sensor that touches an obstacle at its wall measures the obstacle.
void refuse_covered_sensors(const TomlTable& table, const ObstacleDefinition& obstacle,
                            const CaseDefinition& definition) {
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    const bool is_level = gauge.wall == Wall::bottom || gauge.wall == Wall::roof;
    const double first = is_level ? obstacle.left : obstacle.bottom;
    const double last = is_level ? obstacle.right : obstacle.top;
    if (!touches(obstacle, gauge.wall, definition.tank) ||
        gauge.position + gauge.width / 2 < first || gauge.position - gauge.width / 2 > last)
      continue;
    table.refuse("name", fmt::format("an obstacle elsewhere: it covers the pressure gauge {} at {} "
                                     "m",
                                     gauge.name, gauge.position));
  }
}

void refuse_swallowed_probes(const TomlTable& table, const ObstacleDefinition& obstacle,
                             const CaseDefinition& definition) {
  for (const ProbeDefinition& probe : definition.probes)
    if (probe.x >= obstacle.left && probe.x <= obstacle.right && probe.z >= obstacle.bottom &&
        probe.z <= obstacle.top)
      table.refuse("name", fmt::format("an obstacle elsewhere: it holds the probe {} at ({}, {}) m",
                                       probe.name, probe.x, probe.z));
}

bool overlap(const ObstacleDefinition& a, const ObstacleDefinition& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

// Trough and crest have the same height: the trough must leave the bottom covered, and the crest
// must stay below the roof.
Rule<double> inside_tank(const TankDefinition& tank, double fill_depth) {
  const double most = std::min(fill_depth, tank.height - fill_depth);
  return {fmt::format("a number other than 0 of a magnitude below {:.6g}, in m: shallower than the "
                      "liquid ({}) and below the roof ({} above it)",
                      most, fill_depth, tank.height - fill_depth),
          [most](double amplitude) { return amplitude != 0 && std::abs(amplitude) < most; }};
}

// The density of one liquid beside the viscosity of another would be neither.
bool names_no_properties(const TomlTable& fluid) {
  return !fluid.has("density_kg_m3") && !fluid.has("kinematic_viscosity_m2_s");
}

}  // namespace

TankDefinition read_tank(const TomlTable& tank) {
  tank.allow_only(keys_of("tank"));
  TankDefinition read{};
  if (tells_outline(tank)) {
    read = read_outline(tank);
  } else {
    read.length = tank.get("length_m", positive("m"));
    read.height = tank.get("height_m", positive("m"));
  }
  read.breadth = tank.find("breadth_m", positive("m"));
  return read;
}

LiquidDefinition read_liquid(const TomlTable& liquid, const TankDefinition& tank) {
  liquid.allow_only(keys_of("liquid"));
  const Rule<double> inside_tank{
      fmt::format("a number > 0 and below the tank's height ({}), in m", tank.height),
      [height = tank.height](double depth) { return depth > 0 && depth < height; },
      tank.height / 2};
  const Rule<double> within_length{
      fmt::format("a number > 0 and below the tank's length ({}), in m", tank.length),
      [length = tank.length](double width) { return width > 0 && width < length; },
      tank.length / 2};
  const bool is_water = names_no_properties(liquid);
  return {.fill_depth = liquid.get("fill_depth_m", inside_tank),
          .density = is_water ? water_density : liquid.get("density_kg_m3", positive("kg/m3")),
          .kinematic_viscosity = is_water
                                     ? water_kinematic_viscosity
                                     : liquid.get("kinematic_viscosity_m2_s", not_negative("m2/s")),
          .column_width = liquid.find("column_width_m", within_length)};
}

GasDefinition read_gas(const TomlTable& gas, const LiquidDefinition& liquid) {
  gas.allow_only(keys_of("gas"));
  const Rule<double> lighter{
      fmt::format("a number > 0 and below the liquid's density ({}), in kg/m3", liquid.density),
      [most = liquid.density](double density) { return density > 0 && density < most; },
      liquid.density / 2};
  return {.density = gas.get("density_kg_m3", lighter),
          .kinematic_viscosity = gas.get("kinematic_viscosity_m2_s", not_negative("m2/s"))};
}

ObstacleDefinition read_obstacle(const TomlTable& table, const CaseDefinition& definition) {
  table.allow_only(keys_of("obstacle"));
  const TankDefinition& tank = definition.tank;
  ObstacleDefinition obstacle{};
  obstacle.name = table.get("name", file_safe_name());
  obstacle.left = table.get("left_m", not_negative("m"));
  obstacle.right = table.get("right_m", between("left_m", obstacle.left, "length", tank.length));
  obstacle.bottom = table.get("bottom_m", not_negative("m"));
  obstacle.top = table.get("top_m", between("bottom_m", obstacle.bottom, "height", tank.height));
  if (obstacle.left == 0 && obstacle.right == tank.length)
    table.refuse("right_m", fmt::format("a number below the tank's length ({}), in m, for an "
                                        "obstacle from the left wall: it must leave a way past it",
                                        tank.length));
  refuse_swallowed_gauges(table, obstacle, definition);
  refuse_covered_sensors(table, obstacle, definition);
  refuse_swallowed_probes(table, obstacle, definition);
  return obstacle;
}

void refuse_overlaps(const std::vector<TomlTable>& tables,
                     const std::vector<ObstacleDefinition>& obstacles) {
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(obstacles[i], obstacles[j]))
        tables[i].refuse("left_m", fmt::format("a rectangle that does not overlap that of the "
                                               "obstacle {}",
                                               obstacles[j].name));
}

InitialWaveDefinition read_initial_wave(const TomlTable& wave, const CaseDefinition& definition) {
  wave.allow_only(keys_of("initial_wave"));
  if (definition.liquid.column_width)
    wave.refuse_table("a wave on a dam about to break",
                      "liquid without column_width_m, which stands from wall to wall");
  if (!definition.obstacles.empty())
    wave.refuse_table("a wave over an [[obstacle]]",
                      "a tank without one, whose modes are cosines from wall to wall");
  return {.mode = wave.get("mode", at_least(1)),
          .amplitude =
              wave.get("amplitude_m", inside_tank(definition.tank, definition.liquid.fill_depth))};
}

}  // namespace slosh
