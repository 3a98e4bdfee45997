// Galileo's invariance. A liquid with eddies in a closed box at rest, and the same in a box that
// moves with the velocity U, as does all that is in it. Seen from the box they differ by the
// round-off of adding U to every velocity and U t to every position,
//   eps U / v  and  eps U t / dp  (eps = 2^-52),
// which grows in time where the particles' motion is unsteady. c0 = 10 m/s, the eddies' speed is
// 1 m/s, U is 3 m/s. Source: Monaghan 2005, Rep. Prog. Phys. 68:1703.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"

namespace slosh::momentum_test {
namespace {

constexpr double carried = 3, duration = 0.3;  // [m/s], [s]

template <class Choice>
sph::Particles particles_after(const Box& box) {
  constexpr double k = 2 * std::numbers::pi;
  const sph::Scheme<Choice> scheme = scheme_of<Choice>(box);
  sph::Particles p = full_lattice(box);
  sph::perturb_randomly(p, 0.1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i], z = p.z[i];
    p.velocity_x[i] = box.velocity + std::sin(k * x) * std::cos(k * z);
    p.velocity_z[i] = -std::cos(k * x) * std::sin(k * z);
    set_pressure(scheme, p, i, box.rest_density);
  }
  Flow<Choice> flow(box, p);
  flow.advance_to(duration);
  return flow.liquid.particles;
}

struct Difference {
  double place, velocity;
};

// Of each particle from that of the other box which is nearest to it: steps renumber them.
Difference largest_difference(const sph::Particles& rest, const sph::Particles& moving) {
  Difference largest{0, 0};
  for (std::size_t i = 0; i < moving.size(); ++i) {
    double nearest2 = std::numeric_limits<double>::infinity();
    std::size_t twin = 0;
    for (std::size_t j = 0; j < rest.size(); ++j) {
      const double dx = moving.x[i] - carried * duration - rest.x[j], dz = moving.z[i] - rest.z[j];
      if (!(dx * dx + dz * dz < nearest2)) continue;
      nearest2 = dx * dx + dz * dz;
      twin = j;
    }
    largest.place = std::max(largest.place, std::sqrt(nearest2));
    largest.velocity = std::max(largest.velocity,
                                std::hypot(moving.velocity_x[i] - carried - rest.velocity_x[twin],
                                           moving.velocity_z[i] - rest.velocity_z[twin]));
  }
  return largest;
}

// Measured: 1.2e-11 spacings and 5.6e-12 m/s.
TEST(UniformTranslation, OfTheBoxChangesNothingInIt) {
  for (const int cells : {20, 28, 40}) {
    Box box{.length = 1, .height = 1, .spacing = 1.0 / cells, .speed_of_sound = 10};
    const sph::Particles rest = particles_after<sph::Recommended>(box);
    box.velocity = carried;
    const Difference found = largest_difference(rest, particles_after<sph::Recommended>(box));
    EXPECT_LE(found.place, 1e-9 * box.spacing) << cells;
    EXPECT_LE(found.velocity, 1e-9) << cells;
  }
}

// The balance of momentum. The forces between the particles of a liquid cancel in pairs, so that
// its momentum changes by the weight and by the force of its walls,
//   M(t) - M(0) = sum over steps of dt (m g + sum_a m_a f_a),
// with the walls' force f_a summed here over all mirror images, by the formulas of the scheme's
// policies but without its neighbour lists, clusters and vectors: for an image b of a particle
//   f_a = -rho_0/rho_a sum_b V_b ((p_a + p_b) / rho_0 + Pi_ab) grad_a W_ab.
// Source: Monaghan 2005, Rep. Prog. Phys. 68:1703; the images' pressure as in
// sph/walls/mirror_particles.hpp, p_b = p_owner + rho_owner g . (r_b - r_owner).

using Choice = sph::Recommended;
using Scheme = sph::Scheme<Choice>;

Box box_of(int cells) {
  return {.length = 1, .height = 1, .spacing = 1.0 / cells, .speed_of_sound = 20, .gravity = 9.81};
}

// Returns a liquid that fills half the box, with scattered particles that move towards a corner.
sph::Particles start(const Box& box) {
  const Scheme scheme = scheme_of<Choice>(box);
  sph::Particles p = lattice(box, [](double, double z) { return z < 0.5; });
  sph::perturb_randomly(p, 0.1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = std::cos(3 * p.z[i]);
    p.velocity_z[i] = std::sin(5 * p.x[i]) * p.z[i];
    set_pressure(scheme, p, i, box.rest_density * box.gravity * (0.5 - p.z[i]));
  }
  return p;
}

struct Image {
  double x, z, u, w;
};

// Returns the image of a particle in its nearest side wall, its nearest floor or roof, or the
// corner of the two.
Image image_of(const sph::Particles& p, std::size_t i, bool side, bool level) {
  const double wall = p.x[i] < 0.5 ? 0 : 1, floor = p.z[i] < 0.5 ? 0 : 1;
  return {side ? 2 * wall - p.x[i] : p.x[i], level ? 2 * floor - p.z[i] : p.z[i],
          side ? -p.velocity_x[i] : p.velocity_x[i], level ? -p.velocity_z[i] : p.velocity_z[i]};
}

// Returns the force of the image b of the particle `owner` on the particle a [N/m].
sph::Vector2 push(const Scheme& s, const sph::Particles& p, std::size_t a, const Image& b,
                  std::size_t owner) {
  using Kernel = Choice::Kernel;
  const double dx = p.x[a] - b.x, dz = p.z[a] - b.z, r2 = dx * dx + dz * dz;
  const double h = s.setting.smoothing_length(), rho_0 = s.setting.rest_density;
  const double rise = p.density[owner] * s.setting.gravity * (p.z[owner] - b.z);
  const double pressure =
      s.state.pressure(p.density[a]) + s.state.pressure(p.density[owner]) + rise;
  const double approach = (p.velocity_x[a] - b.u) * dx + (p.velocity_z[a] - b.w) * dz;
  const double viscous = s.viscosity.pair(approach, r2, h);
  const double volume = p.mass[owner] / p.density[owner];
  const double slope =
      Kernel::normalisation / (h * h * h * h) * Kernel::gradient_shape(std::sqrt(r2) / h);
  const double f =
      -p.mass[a] * rho_0 / p.density[a] * volume * (pressure / rho_0 + viscous) * slope;
  return {f * dx, f * dz};
}

sph::Vector2 push_of_walls(const Scheme& scheme, const sph::Particles& p) {
  const double reach = sph::kernel_support * scheme.setting.smoothing_length();
  sph::Vector2 sum{0, 0};
  for (std::size_t j = 0; j < p.size(); ++j)
    for (const auto& [side, level] : {std::pair{true, false}, {false, true}, {true, true}}) {
      const Image b = image_of(p, j, side, level);
      if (b.x < -reach || b.x > 1 + reach || b.z < -reach || b.z > 1 + reach) continue;
      for (std::size_t a = 0; a < p.size(); ++a) {
        if (std::abs(p.x[a] - b.x) > reach || std::abs(p.z[a] - b.z) > reach) continue;
        const sph::Vector2 one = push(scheme, p, a, b, j);
        sum.x += one.x;
        sum.z += one.z;
      }
    }
  return sum;
}

sph::Vector2 momentum(const sph::Particles& p) {
  sph::Vector2 sum{0, 0};
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum.x += p.mass[i] * p.velocity_x[i];
    sum.z += p.mass[i] * p.velocity_z[i];
  }
  return sum;
}

// Returns the largest imbalance over the largest change of momentum.
double imbalance(int cells) {
  const Box box = box_of(cells);
  Flow<Choice> flow(box, start(box));
  const sph::Particles& p = flow.liquid.particles;
  const Scheme scheme = scheme_of<Choice>(box);
  const sph::Vector2 before = momentum(p);
  double mass = 0;
  for (const double one : p.mass) mass += one;
  sph::Vector2 impulse{0, 0};
  double found = 0, largest = 0;
  const double dt = 0.5 * scheme.time_step.longest_step;
  while (flow.liquid.time < 0.1) {
    // The staggered leapfrog's kick has the force at the step's start; the first is half as long.
    const double kick = flow.steps == 0 ? 0.5 * dt : dt;
    const sph::Vector2 walls = push_of_walls(scheme, p);
    impulse.x += kick * walls.x;
    impulse.z += kick * (walls.z - mass * box.gravity);
    flow.step(dt);
    const sph::Vector2 now = momentum(p);
    found = std::max(found, std::hypot(now.x - before.x - impulse.x, now.z - before.z - impulse.z));
    largest = std::max(largest, std::hypot(now.x - before.x, now.z - before.z));
  }
  // A particle that a wall has put back got a force that is not in the sums.
  EXPECT_EQ(flow.liquid.exchanged_at_walls(), 0);
  return found / largest;
}

// Measured: 3.1e-15.
TEST(WallImpulse, AndTheWeightsChangeTheMomentumAlone) {
  for (const int cells : {20, 28, 40}) EXPECT_LE(imbalance(cells), 1e-10) << cells;
}

}  // namespace
}  // namespace slosh::momentum_test
