#include "sph/terms/gap_friction.hpp"

#include <cmath>

namespace slosh::sph {
namespace {

Vector2 relative_velocity(const Particles& p, const Tank& tank, std::size_t i) {
  const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
  return tank.along_tank(p.velocity_x[i] - wall.x, p.velocity_z[i] - wall.z);
}

}  // namespace

void GapFriction::add(double share, const Particles& p, const Tank& tank, Rates& rates) const {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 v = relative_velocity(p, tank, i);
    Vector2 force{gap_.steady_friction * v.x, gap_.steady_friction * v.z};
    for (std::size_t n = 0; n < gap_.layers.size(); ++n) {
      const double friction = gap_.layers[n].friction;
      force.x += friction * (v.x - p.layer_velocity[2 * n][i]);
      force.z += friction * (v.z - p.layer_velocity[2 * n + 1][i]);
    }
    const Vector2 seen = tank.along_frame(share * force.x, share * force.z);
    rates.acceleration_x[i] -= seen.x;
    rates.acceleration_z[i] -= seen.z;
  }
}

void GapFriction::advance(Particles& p, const Tank& tank, double dt) const {
  Array<double> approach(gap_.layers.size());
  for (std::size_t n = 0; n < approach.size(); ++n)
    approach[n] = -std::expm1(-gap_.layers[n].rate * dt);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 v = relative_velocity(p, tank, i);
    for (std::size_t n = 0; n < approach.size(); ++n) {
      double &x = p.layer_velocity[2 * n][i], &z = p.layer_velocity[2 * n + 1][i];
      x += approach[n] * (v.x - x);
      z += approach[n] * (v.z - z);
    }
  }
}

}  // namespace slosh::sph
