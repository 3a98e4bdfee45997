// Problem: Galileo's invariance. A liquid that is torn about in a closed box at rest, and the same
// in a box that moves with the velocity U, as does all that is in it: seen from the box there is no
// difference but the round-off of adding U to every velocity and U t to every place,
//   eps U / v  and  eps U t / dp  (eps = 2^-52),
// which unsteady particles part by in time. Source: Monaghan 2005, Rep. Prog. Phys. 68:1703.
// c0 = 10 m/s; the eddies' speed is 1 m/s, U is 3 m/s.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
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

ProblemOutcome run(bool) {
  ProblemOutcome outcome{{{"place", {}}, {"velocity", {}}}, {}};
  for (const int cells : {20, 28, 40}) {
    Box box{.length = 1, .height = 1, .spacing = 1.0 / cells, .speed_of_sound = 10};
    const sph::Particles rest = particles_after<sph::Recommended>(box);
    box.velocity = carried;
    const Difference found = largest_difference(rest, particles_after<sph::Recommended>(box));
    outcome.measures[0].errors.push_back({box.spacing, found.place / box.spacing});
    outcome.measures[1].errors.push_back({box.spacing, found.velocity});
  }
  return outcome;
}

}  // namespace

Problem uniform_translation_problem() {
  return {"uniform_translation",
          "Uniform translation: Galileo's invariance",
          "Eddies of 1 m/s among scattered particles in a closed box for 0.3 s, in a box at rest "
          "and in one that moves with 3 m/s: `recommended`.",
          "Monaghan 2005, Rep. Prog. Phys. 68:1703",
          "No difference, seen from the box, but that of round-off.",
          {{"place", "1", "dp / L", "largest difference of places, over dp"},
           {"velocity", "m/s", "dp / L", "largest difference of velocities"}},
          &run,
          1};
}

}  // namespace slosh
