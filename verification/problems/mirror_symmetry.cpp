// Problem: mirrored motion gives the mirrored flow. A tank set off to the right and one set off to
// the left, X(t) = +-b sin(omega t): at the mirrored gauge the same elevation, force_x of the other
// sign. The sums over neighbours run in another order there, so the difference is round-off, which
// unsteady particles part by in time. Source: the equations' invariance under x -> -x.
#include <algorithm>
#include <cmath>

#include "sph/simulation.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

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

ProblemOutcome run(bool) {
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

Problem mirror_symmetry_problem() {
  return {"mirror_symmetry",
          "Mirror symmetry of a surging tank",
          "The tank of Li et al. 2010 (1 m, 0.35 m of water, X = 0.02 m sin(4.94 t)) for 0.5 s, "
          "and the same set off to the other side: `recommended`.",
          "The Euler equations' invariance under x -> -x",
          "Equal elevations at mirrored gauges and opposite forces, but for round-off.",
          {{"elevation", "1", "dp / L", "largest difference of elevations over the largest"},
           {"force", "1", "dp / L", "largest difference of forces over the largest"}},
          &run,
          2};
}

}  // namespace slosh
