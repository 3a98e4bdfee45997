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

#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"

namespace slosh::uniform_translation_test {
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

}  // namespace
}  // namespace slosh::uniform_translation_test
