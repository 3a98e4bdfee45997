// A lattice of particles under a wave of known shape, eta(x) = A cos(m pi x / length): the still
// lattice carried by maps that keep every area exactly, so that the liquid under the surface is
// the still liquid's and the surface is exactly the wave.
//   1. The vertical and horizontal displacement of a wave's flow below the surface, beyond that of
//      step 3: a stream function that vanishes on the walls, the bottom and the still surface,
//      (A / k) sin kx (sinh kz / sinh kh - z / h), followed over a unit of time.
//   2. Disorder: the same with a random stream function of wave lengths of a few particles.
//   3. Columns: x + A sin(kx) / (k h) = X, z = Z (1 + eta(x) / h), of which dx dz = dX dZ.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {

struct Wave {
  int mode;
  double amplitude;   // [m]
  double length = 1;  // of the tank [m]
  double fill_depth = 0.35;

  double wave_number() const { return mode * std::numbers::pi / length; }
  double elevation(double x) const { return amplitude * std::cos(wave_number() * x); }
};

struct Place {
  double x, z;
};

// Follows the velocity (-d psi/dz, d psi/dx) for a unit of time, by Runge and Kutta's method.
template <class Velocity>
Place follow(Place p, const Velocity& velocity) {
  const int steps = 4;
  const double dt = 1.0 / steps;
  const auto moved = [](Place from, double t, Place v) {
    return Place{from.x + t * v.x, from.z + t * v.z};
  };
  for (int step = 0; step < steps; ++step) {
    const Place a = velocity(p), b = velocity(moved(p, dt / 2, a)),
                c = velocity(moved(p, dt / 2, b)), d = velocity(moved(p, dt, c));
    p.x += dt / 6 * (a.x + 2 * b.x + 2 * c.x + d.x);
    p.z += dt / 6 * (a.z + 2 * b.z + 2 * c.z + d.z);
  }
  return p;
}

inline Place wave_flow(const Wave& wave, Place p) {
  const double k = wave.wave_number(), h = wave.fill_depth, a = wave.amplitude;
  return follow(p, [=](Place at) {
    const double profile = std::sinh(k * at.z) / std::sinh(k * h) - at.z / h;
    const double slope = k * std::cosh(k * at.z) / std::sinh(k * h) - 1 / h;
    return Place{-a / k * std::sin(k * at.x) * slope, a * std::cos(k * at.x) * profile};
  });
}

inline Place columns(const Wave& wave, Place p) {
  const double k = wave.wave_number(), h = wave.fill_depth;
  double x = p.x;
  for (int newton = 0; newton < 50; ++newton)
    x -= (x + wave.amplitude * std::sin(k * x) / (k * h) - p.x) / (1 + wave.elevation(x) / h);
  return {x, p.z * (1 + wave.elevation(x) / h)};
}

// Displacements of `rms` [m] in wave lengths of 3 to 10 spacings that leave walls, bottom and still
// surface where they are. Fixed seed.
class Disorder {
 public:
  Disorder(const Wave& wave, double spacing, double rms) {
    std::mt19937 random(2010);
    std::uniform_real_distribution<double> wave_length(3 * spacing, 10 * spacing);
    std::normal_distribution<double> strength;
    const int eddies = 20;
    for (int i = 0; i < eddies; ++i) {
      const double kx = std::round(2 * wave.length / wave_length(random)) / wave.length,
                   kz = std::round(2 * wave.fill_depth / wave_length(random)) / wave.fill_depth;
      // A product of two sines and its derivative have a mean square of 1/4 each.
      const double speed = 2 * rms * strength(random) / std::sqrt(eddies);
      eddies_.push_back({kx * std::numbers::pi, kz * std::numbers::pi,
                         speed / (std::numbers::pi * std::hypot(kx, kz) / std::sqrt(2))});
    }
  }

  Place operator()(Place p) const {
    return follow(p, [this](Place at) {
      Place v{0, 0};
      for (const Eddy& eddy : eddies_) {
        v.x -= eddy.strength * eddy.kz * std::sin(eddy.kx * at.x) * std::cos(eddy.kz * at.z);
        v.z += eddy.strength * eddy.kx * std::cos(eddy.kx * at.x) * std::sin(eddy.kz * at.z);
      }
      return v;
    });
  }

 private:
  struct Eddy {
    double kx, kz, strength;
  };
  std::vector<Eddy> eddies_;
};

inline Particles waved_lattice(const Wave& wave, double spacing, double surface_spacing,
                               double disorder_rms) {
  Scene scene = still_scene(spacing, 0);
  scene.surface_particle_spacing = surface_spacing;
  Particles particles = initial_lattice(
      scene, [&](double pressure) { return Tait(scene.rest_density, 18.8).density(pressure); });
  const Disorder disorder(wave, spacing, disorder_rms);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Place place = wave_flow(wave, {particles.x[i], particles.z[i]});
    if (disorder_rms > 0) place = disorder(place);
    place = columns(wave, place);
    particles.x[i] = place.x;
    particles.z[i] = place.z;
  }
  return particles;
}

}  // namespace slosh::sph
