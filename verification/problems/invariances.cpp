// Problems: motions under which the equations do not change, so that two runs differ by round-off
// alone.
//   uniform_translation  Galilean invariance. A liquid with eddies in a closed box at rest, and the
//                        same in a box that moves with the velocity U, as does all that is in it.
//                        Seen from the box they differ by the round-off of adding U to every
//                        velocity and U t to every position,
//                          eps U / v  and  eps U t / dp  (eps = 2^-52),
//                        which grows in time where the particles' motion is unsteady. c0 = 10 m/s,
//                        the eddies' speed is 1 m/s, U is 3 m/s. Source: Monaghan 2005, Rep. Prog.
//                        Phys. 68:1703.
//   mirror_symmetry      Invariance under x -> -x. One tank is set off to the right and one to the
//                        left, X(t) = +-b sin(omega t): the elevations at mirrored gauges are equal
//                        and the forces force_x opposite. The sums over neighbours run in another
//                        order there, so the difference is round-off, which grows likewise.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sph/schemes.hpp"
#include "sph/simulation.hpp"
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

ProblemOutcome run_translation(bool) {
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

// Li et al. 2010, section 4.1, at a spacing.
sph::Scene surging(double spacing, double amplitude) {
  const double omega = 4.94488;  // [rad/s]
  return {
      .tank_length = 1,
      .tank_height = 1,
      .fill_depth = 0.35,
      .gravity = 9.81,
      .rest_density = 1000,
      .displacement = [=](double t) { return amplitude * std::sin(omega * t); },
      .velocity = [=](double t) { return amplitude * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); },
      .duration = 0.5,
      .sample_interval = 0.01,
      .particle_spacing = spacing,
      .surface_particle_spacing = spacing,
      .initial_state = sph::InitialState::lattice,
      .gauges = {{"left", 0.05}, {"right", 0.95}},
      .record_snapshot = {}};
}

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

double largest_difference(const sph::History& a, const sph::History& b, double sign) {
  double found = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i)
    found = std::max(found, std::abs(a.value[i] - sign * b.value[i]));
  return found;
}

ProblemOutcome run_mirrored(bool) {
  ProblemOutcome outcome{{{"elevation", {}}, {"force", {}}}, {}};
  reports::Figure figure;
  figure.id = "mirror_symmetry-elevation";
  figure.title = "Elevation at mirrored gauges";
  figure.caption = "At the finest spacing.";
  figure.x_label = "t (s)";
  figure.y_label = "elevation (m)";

  for (const double spacing : {0.05, 0.025, 0.0125}) {
    const sph::RunOutput one = sph::run("recommended", surging(spacing, 0.02), {}),
                         other = sph::run("recommended", surging(spacing, -0.02), {});
    const sph::History &here = one.elevation.at("right"), &there = other.elevation.at("left");
    outcome.measures[0].errors.push_back(
        {spacing, largest_difference(here, there, 1) / largest(here.value)});
    outcome.measures[1].errors.push_back(
        {spacing, largest_difference(one.force_x, other.force_x, -1) / largest(one.force_x.value)});
    figure.curves = {{"set off to the right, gauge at x = 0.95 m", here.time, here.value, {}},
                     {"set off to the left, gauge at x = 0.05 m",
                      there.time,
                      there.value,
                      {},
                      reports::Curve::Style::dashed}};
  }
  outcome.figures.push_back(std::move(figure));
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
          &run_translation,
          1};
}

Problem mirror_symmetry_problem() {
  return {"mirror_symmetry",
          "Mirror symmetry of a surging tank",
          "The tank of Li et al. 2010 (1 m, 0.35 m of water, X = 0.02 m sin(4.94 t)) for 0.5 s, "
          "and the same set off to the other side: `recommended`.",
          "The Euler equations' invariance under x -> -x",
          "Equal elevations at mirrored gauges and opposite forces, but for round-off.",
          {{"elevation", "1", "dp / L", "largest difference of elevations over the largest"},
           {"force", "1", "dp / L", "largest difference of forces over the largest"}},
          &run_mirrored,
          2};
}

}  // namespace slosh
