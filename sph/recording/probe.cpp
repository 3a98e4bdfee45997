#include "sph/recording/probe.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "sph/recording/near_particles.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {
namespace {

constexpr double least_filling = 0.5;
// Of the fourth power of the kernel's radius. Particles on a line have a smaller determinant of
// their second moments; no slope across the line can be fitted to them.
constexpr double least_determinant = 1e-6;

// Returns the part of the kernel at the place that lies within the tank's outline, or in which
// is_within(place) holds, by the midpoint rule.
template <class IsWithin>
double share_within(const IsWithin& is_within, Vector2 place, const WeightsAbout& weights) {
  constexpr int steps = 24;
  const double step = 2 * weights.radius() / steps;
  double within = 0, whole = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double dx = (i + 0.5) * step - weights.radius(),
                   dz = (k + 0.5) * step - weights.radius(), weight = weights.at(dx, dz);
      whole += weight;
      if (is_within(Vector2{place.x + dx, place.z + dz})) within += weight;
    }
  return within / whole;
}

// Returns the part of the kernel at the place that particles and their images in the walls fill. In
// an outline, and beside a thin obstacle, it is the part that particles fill of what lies within or
// is seen.
double filling(const Particles& p, Vector2 place, const Scene& scene, const LineOfSight& sight) {
  const WeightsAbout weights(scene.particle_spacing);
  if (const auto outline = outline_of(scene)) {
    double filled = 0;
    for_each_near(p, place, scene.particle_spacing, sight,
                  [&](std::size_t, double share, double, double) { filled += share; });
    return filled /
           share_within([&](Vector2 at) { return outline->contains(at.x, at.z); }, place, weights);
  }
  double filled = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::array<double, 3> along{p.x[i], -p.x[i], 2 * scene.tank_length - p.x[i]},
        up{p.z[i], -p.z[i], 2 * scene.tank_height - p.z[i]};
    for (const double x : along)
      if (std::abs(place.x - x) < weights.radius())
        for (const double z : up)
          if (const double weight = weights.at(place.x - x, place.z - z);
              weight > 0 && sight.sees(place, {x, z}))
            filled += p.mass[i] / p.density[i] * weight;
  }
  if (!sight.exists()) return filled;
  const double seen =
      share_within([&](Vector2 at) { return sight.sees(place, at); }, place, weights);
  return seen > 0 ? filled / seen : 0;
}

// The weighted sums that determine the linear function of best fit.
struct LinearFit {
  double weight = 0, x = 0, z = 0, xx = 0, xz = 0, zz = 0;
  Vector2 u{0, 0}, ux{0, 0}, uz{0, 0};

  void add(double share, double dx, double dz, Vector2 value) {
    weight += share;
    x += share * dx;
    z += share * dz;
    xx += share * dx * dx;
    xz += share * dx * dz;
    zz += share * dz * dz;
    u = {u.x + share * value.x, u.z + share * value.z};
    ux = {ux.x + share * dx * value.x, ux.z + share * dx * value.z};
    uz = {uz.x + share * dz * value.x, uz.z + share * dz * value.z};
  }

  Vector2 at_place(double radius) const {
    return {value(u.x, ux.x, uz.x, radius), value(u.z, ux.z, uz.z, radius)};
  }

 private:
  double value(double sum, double sum_x, double sum_z, double radius) const {
    const double mean = sum / weight, mean_x = x / weight, mean_z = z / weight;
    const double a = xx / weight - mean_x * mean_x, b = xz / weight - mean_x * mean_z,
                 c = zz / weight - mean_z * mean_z, determinant = a * c - b * b;
    if (!(determinant > least_determinant * std::pow(radius, 4))) return mean;
    const double with_x = sum_x / weight - mean_x * mean, with_z = sum_z / weight - mean_z * mean;
    return mean - mean_x * (c * with_x - b * with_z) / determinant -
           mean_z * (a * with_z - b * with_x) / determinant;
  }
};

}  // namespace

Probed probed(const Particles& p, const Probe& probe, const Scene& scene, const TankMotion& motion,
              const std::function<double(double)>& pressure_at) {
  const Vector2 place{probe.x, probe.z};
  const LineOfSight sight = sight_of_instruments(scene);
  if (!(filling(p, place, scene, sight) >= least_filling)) return {{0, 0}, 0};
  const Vector2 gravity = motion.in_tank().apparent_gravity(scene.gravity, place.x, place.z, 0, 0);
  LinearFit velocity;
  double pressure = 0;
  for_each_near(p, place, scene.particle_spacing, sight,
                [&](std::size_t i, double share, double dx, double dz) {
                  const Vector2 tank = motion.velocity(p.x[i], p.z[i]);
                  velocity.add(share, dx, dz, {p.velocity_x[i] - tank.x, p.velocity_z[i] - tank.z});
                  pressure += share * (pressure_at(p.density[i]) +
                                       p.density[i] * (gravity.x * dx + gravity.z * dz));
                });
  return {velocity.at_place(WeightsAbout(scene.particle_spacing).radius()),
          pressure / velocity.weight};
}

void require_in_tank(const Probe& probe, const Scene& scene) {
  if (const auto outline = outline_of(scene); outline && !outline->contains(probe.x, probe.z))
    throw std::invalid_argument(
        fmt::format("probe {}: ({}, {}) m: expected a place in the tank's outline", probe.name,
                    probe.x, probe.z));
  if (!(probe.x >= 0 && probe.x <= scene.tank_length && probe.z >= 0 &&
        probe.z <= scene.tank_height))
    throw std::invalid_argument(
        fmt::format("probe {}: ({}, {}) m: expected a place in the tank, which is {} m long and {} "
                    "m high",
                    probe.name, probe.x, probe.z, scene.tank_length, scene.tank_height));
}

}  // namespace slosh::sph
