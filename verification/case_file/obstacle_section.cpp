#include <fmt/format.h>

#include <algorithm>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

Rule<double> between(const char* least_name, double least, const char* most_name, double most) {
  return {fmt::format("a number above {} ({}) and <= the tank's {} ({}), in m", least_name, least,
                      most_name, most),
          [least, most](double value) { return value > least && value <= most; }};
}

// A gauge's column that is solid from the bottom to the still level has no surface to measure.
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

// A sensor that touches an obstacle at its wall measures the obstacle.
void refuse_covered_sensors(const TomlTable& table, const ObstacleDefinition& obstacle,
                            const CaseDefinition& definition) {
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    const bool along_bottom = gauge.wall == Wall::bottom;
    const bool at_wall = along_bottom               ? obstacle.bottom == 0
                         : gauge.wall == Wall::left ? obstacle.left == 0
                                                    : obstacle.right == definition.tank.length;
    const double first = along_bottom ? obstacle.left : obstacle.bottom;
    const double last = along_bottom ? obstacle.right : obstacle.top;
    if (!at_wall || gauge.position + gauge.width / 2 < first ||
        gauge.position - gauge.width / 2 > last)
      continue;
    table.refuse("name", fmt::format("an obstacle elsewhere: it covers the pressure gauge {} at {} "
                                     "m",
                                     gauge.name, gauge.position));
  }
}

bool overlap(const ObstacleDefinition& a, const ObstacleDefinition& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

}  // namespace

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

}  // namespace slosh
