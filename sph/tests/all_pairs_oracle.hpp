// The right-hand sides of the papers' equations, summed over every particle and every one of its
// mirror images, without a neighbour search, and written out from the papers on their own.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// dW/dr [1/m3] at a distance r for a smoothing length h; the support is 2 h.
using KernelSlope = std::function<double(double r, double h)>;

inline double cubic_slope(double r, double h) {
  const double q = r / h, factor = 10 / (7 * std::numbers::pi * h * h * h);
  if (q < 1) return factor * (-3 * q + 2.25 * q * q);
  return q < 2 ? -0.75 * factor * (2 - q) * (2 - q) : 0;
}

inline double wendland_slope(double r, double h) {
  const double q = r / h, factor = 7 / (4 * std::numbers::pi * h * h * h);
  return q < 2 ? -5 * factor * q * std::pow(1 - q / 2, 3) : 0;
}

// Morris, Fox & Zhu 1997, whose smoothing length is a third of the support.
inline double quintic_slope(double r, double h) {
  const double morris_h = 2 * h / 3, s = r / morris_h;
  double slope = 0;
  if (s < 3) slope -= 5 * std::pow(3 - s, 4);
  if (s < 2) slope += 30 * std::pow(2 - s, 4);
  if (s < 1) slope -= 75 * std::pow(1 - s, 4);
  return slope * 7 / (478 * std::numbers::pi * std::pow(morris_h, 3));
}

struct Medium {
  double gravity, fill_depth, rest_density, speed_of_sound;
};

// A particle or an image of it.
struct PairSource {
  double x, z, u, w, density, mass, pressure, spacing;
  double dynamic_density;  // [kg/m3] above the hydrostatic one
};

inline PairSource reflected_sideways(PairSource s, double wall_x, const TankWalls& walls,
                                     Slip slip) {
  const double owner_x = s.x;
  s.x = 2 * wall_x - owner_x;
  s.u = 2 * walls.velocity - s.u;
  if (slip == Slip::none) s.w = -s.w;
  if (slip == Slip::free) s.pressure -= s.density * walls.acceleration * (s.x - owner_x);
  return s;
}

inline PairSource reflected_vertically(PairSource s, double wall_z, const TankWalls& walls,
                                       Slip slip, double gravity) {
  const double owner_z = s.z;
  s.z = 2 * wall_z - owner_z;
  s.w = -s.w;
  if (slip == Slip::none) s.u = 2 * walls.velocity - s.u;
  if (slip == Slip::free) s.pressure -= s.density * gravity * (s.z - owner_z);
  return s;
}

// The particles first, in their order, then all images: eight of each particle.
inline std::vector<PairSource> with_all_images(const Particles& p, const TankWalls& walls,
                                               const Medium& medium, Slip slip) {
  const double stiffness = medium.rest_density * medium.speed_of_sound * medium.speed_of_sound / 7;
  std::vector<PairSource> sources;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double pressure = stiffness * (std::pow(p.density[i] / medium.rest_density, 7) - 1);
    const double still = medium.rest_density * medium.gravity * (medium.fill_depth - p.z[i]);
    sources.push_back({p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i], p.density[i], p.mass[i],
                       pressure, p.spacing[i],
                       (pressure - still) / (medium.speed_of_sound * medium.speed_of_sound)});
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const PairSource own = sources[i];
    for (double wall_x : {walls.left, walls.right})
      sources.push_back(reflected_sideways(own, wall_x, walls, slip));
    for (double wall_z : {walls.bottom, walls.roof}) {
      const PairSource image = reflected_vertically(own, wall_z, walls, slip, medium.gravity);
      sources.push_back(image);
      for (double wall_x : {walls.left, walls.right})
        sources.push_back(reflected_sideways(image, wall_x, walls, slip));
    }
  }
  return sources;
}

// Calls pair(i, a, b, dx, dz, grad_x, grad_z, h) for all pairs within the kernel's support,
// h = 1.5 times the pair's mean spacing.
template <class Pair>
void for_each_pair(const std::vector<PairSource>& sources, std::size_t particles,
                   const KernelSlope& slope, const Pair& pair) {
  for (std::size_t i = 0; i < particles; ++i)
    for (const PairSource& b : sources) {
      const PairSource& a = sources[i];
      const double dx = a.x - b.x, dz = a.z - b.z, r = std::hypot(dx, dz);
      const double h = 1.5 * (a.spacing + b.spacing) / 2;
      if (r == 0 || r >= 2 * h) continue;
      const double gradient = slope(r, h) / r;
      pair(i, a, b, dx, dz, gradient * dx, gradient * dz, h);
    }
}

inline Rates still_rates(std::size_t particles, double gravity) {
  Rates rates;
  rates.resize(particles);
  for (double& acceleration : rates.acceleration_z) acceleration = -gravity;
  return rates;
}

// Li et al. 2010, eqs 6-8, with gravity and with the artificial viscosity of Monaghan 1992,
// eqs 4.1-4.2, alpha = beta = 1.
inline Rates li2010_by_all_pairs(const Particles& p, const TankWalls& walls, const Medium& medium) {
  const auto sources = with_all_images(p, walls, medium, Slip::none);
  Rates rates = still_rates(p.size(), medium.gravity);
  for_each_pair(sources, p.size(), cubic_slope,
                [&](std::size_t i, const PairSource& a, const PairSource& b, double dx, double dz,
                    double grad_x, double grad_z, double h) {
                  const double du = a.u - b.u, dw = a.w - b.w, approach = du * dx + dw * dz;
                  double viscous = 0;
                  if (approach < 0) {
                    const double mu = h * approach / (dx * dx + dz * dz + 0.01 * h * h);
                    viscous =
                        (-medium.speed_of_sound * mu + mu * mu) / ((a.density + b.density) / 2);
                  }
                  const double stress = a.pressure / (a.density * a.density) +
                                        b.pressure / (b.density * b.density) + viscous;
                  rates.acceleration_x[i] -= b.mass * stress * grad_x;
                  rates.acceleration_z[i] -= b.mass * stress * grad_z;
                  rates.density_rate[i] += b.mass * (du * grad_x + dw * grad_z);
                });
  return rates;
}

// Antuono et al. 2010, eq. 1, with alpha = 0.003, delta = 0.1, and the diffusion of Molteni &
// Colagrossi 2009 acting on the dynamic density (Fourtakas et al. 2019, eq. 13).
inline Rates recommended_by_all_pairs(const Particles& p, const TankWalls& walls,
                                      const Medium& medium, const KernelSlope& slope) {
  const auto sources = with_all_images(p, walls, medium, Slip::free);
  Rates rates = still_rates(p.size(), medium.gravity);
  const double c0 = medium.speed_of_sound;
  for_each_pair(sources, p.size(), slope,
                [&](std::size_t i, const PairSource& a, const PairSource& b, double dx, double dz,
                    double grad_x, double grad_z, double h) {
                  const double volume = b.mass / b.density, r2 = dx * dx + dz * dz;
                  const double du = a.u - b.u, dw = a.w - b.w;
                  const double viscous = 0.003 * h * c0 * medium.rest_density *
                                         (du * dx + dw * dz) / (r2 + 0.01 * h * h);
                  const double stress = (a.pressure + b.pressure - viscous) / a.density;
                  rates.acceleration_x[i] -= volume * stress * grad_x;
                  rates.acceleration_z[i] -= volume * stress * grad_z;
                  const double psi = 2 * (b.dynamic_density - a.dynamic_density) / r2;
                  rates.density_rate[i] +=
                      a.density * volume * (du * grad_x + dw * grad_z) -
                      0.1 * h * c0 * volume * psi * (dx * grad_x + dz * grad_z);
                });
  return rates;
}

}  // namespace slosh::sph
