#include "sph/recording/wall_pressure_gauge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/recording/near_particles.hpp"

namespace slosh::sph {
namespace {

constexpr double least_filling = 0.2;  // of the half disc

Vector2 place_on_wall(Wall wall, double along, double tank_length) {
  if (wall == Wall::bottom) return {along, 0};
  return {wall == Wall::left ? 0 : tank_length, along};
}

double pressure_at_place(const Particles& p, Vector2 place, Vector2 gravity,
                         const std::function<double(double)>& pressure_at, double spacing) {
  double sum = 0, weights = 0;
  for_each_near(p, place, spacing, [&](std::size_t i, double share, double dx, double dz) {
    const double rise = p.density[i] * (gravity.x * dx + gravity.z * dz);
    sum += share * (pressure_at(p.density[i]) + rise);
    weights += share;
  });
  return weights >= least_filling * 0.5 ? sum / weights : 0;
}

}  // namespace

template <class Motion>
double wall_pressure(const Particles& p, const PressureGauge& gauge, const Scene& scene,
                     const Motion& motion, const std::function<double(double)>& pressure_at) {
  const double dp = scene.particle_spacing;
  const int places = 1 + static_cast<int>(std::ceil(gauge.width / dp - 1e-9));
  double sum = 0;
  for (int k = 0; k < places; ++k) {
    // The points are the middles of equal parts of the sensor.
    const double along = gauge.position + gauge.width * ((k + 0.5) / places - 0.5);
    const Vector2 place = place_on_wall(gauge.wall, along, scene.tank_length);
    const Vector2 gravity =
        motion.in_tank().apparent_gravity(scene.gravity, place.x, place.z, 0, 0);
    sum += pressure_at_place(p, place, gravity, pressure_at, dp);
  }
  return sum / places;
}
template double wall_pressure(const Particles&, const PressureGauge&, const Scene&,
                              const SurgeMotion&, const std::function<double(double)>&);
template double wall_pressure(const Particles&, const PressureGauge&, const Scene&,
                              const TankMotion&, const std::function<double(double)>&);

void require_on_wall(const PressureGauge& gauge, const Scene& scene) {
  const double length = gauge.wall == Wall::bottom ? scene.tank_length : scene.tank_height;
  const double half = 0.5 * gauge.width;
  if (!(half >= 0 && gauge.position - half >= 0 && gauge.position + half <= length))
    throw std::invalid_argument(
        fmt::format("pressure gauge {}: position {} m and width {} m: expected a sensor between 0 "
                    "and {} m along its wall",
                    gauge.name, gauge.position, gauge.width, length));
}

}  // namespace slosh::sph
