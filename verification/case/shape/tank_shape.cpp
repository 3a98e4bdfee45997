#include "verification/case/shape/tank_shape.hpp"

namespace slosh {

Outline corners_of(const TankDefinition& tank) {
  if (!is_rectangle(tank)) return tank.outline;
  return {{0, 0}, {tank.length, 0}, {tank.length, tank.height}, {0, tank.height}};
}

Extent still_surface(const CaseDefinition& definition) {
  if (is_rectangle(definition.tank)) return {0, definition.tank.length};
  return extent_at(definition.tank.outline, definition.liquid.fill_depth);
}

double liquid_area(const CaseDefinition& definition) {
  const double depth = definition.liquid.fill_depth;
  if (!is_rectangle(definition.tank)) return area_below(definition.tank.outline, depth);
  return definition.liquid.column_width.value_or(definition.tank.length) * depth;
}

int excited_mode_step(const TankDefinition& tank) {
  return is_rectangle(tank) || is_symmetric(tank.outline) ? 2 : 1;
}

}  // namespace slosh
