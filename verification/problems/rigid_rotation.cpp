// Problem: a circular drop that rotates as a rigid body under a central force -Omega^2 r.
//   omega = Omega       The force keeps every particle on its circle and p = 0: the pair sums must
//                       add nothing, and the path shows the integrator's order in the time step.
//   omega = Omega / 2   The pressure p = rho / 2 (Omega^2 - omega^2) (R^2 - r^2) balances the
//                       rest of the force; a viscous stress that is not symmetric would slow the
//                       rotation.
// The forces of a pair act along the line between its particles, so that the angular momentum is
// conserved to round-off. Source: Monaghan 2005, Rep. Prog. Phys. 68:1703 (conservation).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/problems/central_force.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

constexpr double middle = 2;  // of a box of 4 R
using Choice = FreeDrop<sph::Recommended>;

Box box_of(int cells) {
  return {.length = 2 * middle, .height = 2 * middle, .spacing = 1.0 / cells, .speed_of_sound = 20};
}

sph::Particles turning(const Box& box, double omega) {
  const sph::Scheme<Choice> scheme = scheme_of<Choice>(box);
  sph::Particles p =
      lattice(box, [](double x, double z) { return std::hypot(x - middle, z - middle) < 1; });
  const double left = angular_frequency * angular_frequency - omega * omega;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - middle, z = p.z[i] - middle;
    p.velocity_x[i] = -omega * z;
    p.velocity_z[i] = omega * x;
    set_pressure(scheme, p, i, 0.5 * box.rest_density * left * (1 - x * x - z * z));
  }
  return p;
}

double angular_momentum(const sph::Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += p.mass[i] * ((p.x[i] - middle) * p.velocity_z[i] - (p.z[i] - middle) * p.velocity_x[i]);
  return sum;
}

// Returns the largest distance of a particle from the nearest initial position, rotated by `angle`.
double distance_from_turned(const sph::Particles& p, const sph::Particles& start, double angle) {
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < start.size(); ++j) {
      const double x = start.x[j] - middle, z = start.z[j] - middle;
      const double dx = p.x[i] - middle - (std::cos(angle) * x - std::sin(angle) * z),
                   dz = p.z[i] - middle - (std::sin(angle) * x + std::cos(angle) * z);
      nearest2 = std::min(nearest2, dx * dx + dz * dz);
    }
    farthest = std::max(farthest, nearest2);
  }
  return std::sqrt(farthest);
}

// Returns the error of the path, that of the leapfrog's first step included.
double path_error(int steps) {
  const Box box = box_of(16);
  const sph::Particles start = turning(box, angular_frequency);
  Flow<Choice> flow(box, start);
  const double time = std::numbers::pi / 2 / angular_frequency;
  for (int i = 0; i < steps; ++i) flow.step(time / steps);
  return distance_from_turned(flow.liquid.particles, start, angular_frequency * time);
}

struct Turned {
  double velocity_error, momentum_error;
};

Turned half_turn(int cells) {
  const double omega = 0.5 * angular_frequency;
  const Box box = box_of(cells);
  Flow<Choice> flow(box, turning(box, omega));
  const sph::Particles& p = flow.liquid.particles;
  const double start = angular_momentum(p);
  flow.advance_to(std::numbers::pi / omega);
  // The leapfrog's velocities are those of half a step earlier.
  double error2 = 0, exact2 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double u = -omega * (p.z[i] - middle), w = omega * (p.x[i] - middle);
    error2 += std::pow(p.velocity_x[i] - u, 2) + std::pow(p.velocity_z[i] - w, 2);
    exact2 += u * u + w * w;
  }
  return {std::sqrt(error2 / exact2), angular_momentum(p) / start - 1};
}

ProblemOutcome run(bool quick) {
  ProblemOutcome outcome{{{"path", {}}, {"velocity", {}}, {"angular_momentum", {}}}, {}};
  for (const int steps : {400, 800, 1600})
    outcome.measures[0].errors.push_back({1.0 / steps, path_error(steps)});
  for (const int cells : quick ? std::vector<int>{16, 23, 32} : std::vector<int>{16, 23, 32, 45}) {
    const Turned found = half_turn(cells);
    outcome.measures[1].errors.push_back({1.0 / cells, found.velocity_error});
    outcome.measures[2].errors.push_back({1.0 / cells, found.momentum_error});
  }
  return outcome;
}

}  // namespace

Problem rigid_rotation_problem() {
  return {"rigid_rotation",
          "Rigid rotation under a central force",
          "A circular drop turning about its middle: at omega = Omega, where the force alone holds "
          "every particle on its circle, a quarter turn; at omega = Omega / 2, where pressure "
          "bears the rest, half a turn.",
          "Monaghan 2005, Rep. Prog. Phys. 68:1703; Hairer, Lubich & Wanner 2006, "
          "Geometric Numerical Integration, section I.1.4 (leapfrog)",
          "The start's places turned by omega t, second order in the time step; v = omega x r; the "
          "angular momentum of the start, which forces along the pairs' lines keep to round-off.",
          {{"path", "1", "dt / quarter turn",
            "largest distance of a particle from its exact place, over R, at omega = Omega"},
           {"velocity", "1", "dp / R", "rms velocity error over the rms, at omega = Omega / 2"},
           {"angular_momentum", "1", "dp / R",
            "relative change of the angular momentum, at omega = Omega / 2"}},
          &run,
          10};
}

}  // namespace slosh
