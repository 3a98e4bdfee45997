#include "verification/case/shape/sensor_place.hpp"

#include "verification/case/shape/outline.hpp"

namespace slosh {
namespace {

// The place that lies this far from the sensor's middle along its wall.
Corner along_wall(const TankDefinition& tank, const PressureGaugeDefinition& gauge, double along) {
  if (gauge.at) {
    const PlaceOnOutline middle = nearest_on(tank.outline, *gauge.at);
    const Corner from = tank.outline[middle.side],
                 to = tank.outline[(middle.side + 1) % tank.outline.size()];
    const double share = along / side_length(tank.outline, middle.side);
    return {gauge.at->x + share * (to.x - from.x), gauge.at->z + share * (to.z - from.z)};
  }
  switch (gauge.wall) {
    case Wall::left:
      return {0, gauge.position + along};
    case Wall::right:
      return {tank.length, gauge.position + along};
    case Wall::roof:
      return {gauge.position + along, tank.height};
    case Wall::bottom:
      break;
  }
  return {gauge.position + along, 0};
}

}  // namespace

Corner sensor_middle(const TankDefinition& tank, const PressureGaugeDefinition& gauge) {
  return along_wall(tank, gauge, 0);
}

std::pair<Corner, Corner> sensor_ends(const TankDefinition& tank,
                                      const PressureGaugeDefinition& gauge) {
  return {along_wall(tank, gauge, -gauge.width / 2), along_wall(tank, gauge, gauge.width / 2)};
}

bool is_under_still_water(const CaseDefinition& definition, const PressureGaugeDefinition& gauge) {
  const auto [first, last] = sensor_ends(definition.tank, gauge);
  return first.z < definition.liquid.fill_depth && last.z < definition.liquid.fill_depth;
}

}  // namespace slosh
