#include "sph/recording/wall_pressure_gauge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/recording/near_particles.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {
namespace {

constexpr double least_filling = 0.2;  // of the half disc

// Returns the point of a sensor that lies `off` its middle along the wall [m].
Vector2 place_on_wall(const PressureGauge& gauge, double off, const Scene& scene) {
  if (gauge.at) {
    const TankOutline outline(scene.outline);
    const OutlineSide& side = outline.sides()[outline.nearest(gauge.at->x, gauge.at->z).side];
    return {gauge.at->x + off * side.along.x, gauge.at->z + off * side.along.z};
  }
  const double along = gauge.position + off;
  if (gauge.wall == Wall::bottom) return {along, 0};
  if (gauge.wall == Wall::roof) return {along, scene.tank_height};
  return {gauge.wall == Wall::left ? 0 : scene.tank_length, along};
}

double pressure_at_place(const Particles& p, Vector2 place, Vector2 gravity,
                         const std::function<double(double)>& pressure_at, double spacing,
                         const LineOfSight& sight) {
  double sum = 0, weights = 0;
  for_each_near(p, place, spacing, sight, [&](std::size_t i, double share, double dx, double dz) {
    const double rise = p.density[i] * (gravity.x * dx + gravity.z * dz);
    sum += share * (pressure_at(p.density[i]) + rise);
    weights += share;
  });
  return weights >= least_filling * 0.5 ? sum / weights : 0;
}

}  // namespace

double wall_pressure(const Particles& p, const PressureGauge& gauge, const Scene& scene,
                     const TankMotion& motion, const std::function<double(double)>& pressure_at) {
  const double dp = scene.particle_spacing;
  const int places = 1 + static_cast<int>(std::ceil(gauge.width / dp - 1e-9));
  const LineOfSight sight = sight_of_instruments(scene);
  double sum = 0;
  for (int k = 0; k < places; ++k) {
    // The points are the middles of equal parts of the sensor.
    const Vector2 place = place_on_wall(gauge, gauge.width * ((k + 0.5) / places - 0.5), scene);
    const Vector2 gravity =
        motion.in_tank().apparent_gravity(scene.gravity, place.x, place.z, 0, 0);
    sum += pressure_at_place(p, place, gravity, pressure_at, dp, sight);
  }
  return sum / places;
}

void require_on_outline(const PressureGauge& gauge, const TankOutline& outline) {
  const Vector2 at{gauge.at->x, gauge.at->z};
  const OutlinePoint wall = outline.nearest(at.x, at.z);
  const OutlineSide& side = outline.sides()[wall.side];
  const double rounding = 1e-6 * (outline.top() - outline.bottom()),
               position = side.position_of(at), half = 0.5 * gauge.width;
  if (!(std::hypot(wall.at.x - at.x, wall.at.z - at.z) <= rounding && half >= 0 &&
        position - half >= -rounding && position + half <= side.length + rounding))
    throw std::invalid_argument(
        fmt::format("pressure gauge {}: ({}, {}) m and width {} m: expected a sensor on one side "
                    "of the tank's outline",
                    gauge.name, at.x, at.z, gauge.width));
}

void require_on_wall(const PressureGauge& gauge, const Scene& scene) {
  if (const auto outline = outline_of(scene); outline.has_value() != gauge.at.has_value())
    throw std::invalid_argument(fmt::format(
        "pressure gauge {}: expected a wall and a position in a rectangular tank, and a point of "
        "the outline in any other",
        gauge.name));
  else if (outline)
    return require_on_outline(gauge, *outline);
  const bool along_x = gauge.wall == Wall::bottom || gauge.wall == Wall::roof;
  const double length = along_x ? scene.tank_length : scene.tank_height;
  const double half = 0.5 * gauge.width;
  if (!(half >= 0 && gauge.position - half >= 0 && gauge.position + half <= length))
    throw std::invalid_argument(
        fmt::format("pressure gauge {}: position {} m and width {} m: expected a sensor between 0 "
                    "and {} m along its wall",
                    gauge.name, gauge.position, gauge.width, length));
}

}  // namespace slosh::sph
