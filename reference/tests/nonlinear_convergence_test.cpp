// How fast the nonlinear potential flow converges, and the paper's case over its whole length.
#include <gtest/gtest.h>

#include "reference/forced_mode.hpp"
#include "reference/tank_mode.hpp"
#include "reference/tests/nonlinear_cases.hpp"

namespace slosh::reference {
namespace {

NonlinearRecord run(NonlinearSloshing sloshing, int nodes_x, int nodes_z,
                    const Observation& observation) {
  sloshing.nodes_x = nodes_x;
  sloshing.nodes_z = nodes_z;
  auto record = run_nonlinear_potential_flow(sloshing, observation);
  EXPECT_EQ(record.left_range_because, "");
  return record;
}

TEST(NonlinearConvergence, ReachesRoundingWithAStandingWave) {
  const Observation observation{.times = instants_up_to(5, 0.1), .gauges = {0.45, 0.5}};
  const auto wave = standing_wave(li_tank, 0.02);
  const auto fine = run(wave, 48, 24, observation);
  const auto c1 = run(wave, 16, 10, observation), c2 = run(wave, 24, 14, observation),
             c3 = run(wave, 32, 18, observation);
  for (auto* c : {&c1, &c2, &c3})
    printf("W %g %g\n", largest_difference(c->elevation[0], fine.elevation[0]),
           largest_difference(c->elevation[1], fine.elevation[1]));
  printf("W en %g vol %g\n", largest(fine.energy_error), largest(fine.volume_error));
}

TEST(NonlinearConvergence, ReachesTenToTheMinusTenWithAForcedWave) {
  const Observation observation{
      .times = instants_up_to(5, 0.25), .gauges = {0.45, 0.5}, .pressure_places = {{0.5, -0.1}}};
  const NonlinearSloshing surge{
      .tank = li_tank, .motion = smooth_surge(li_surge.amplitude, {li_surge.angular_frequency, 3})};
  const auto fine = run(surge, 80, 28, observation);
  const auto c1 = run(surge, 24, 14, observation), c2 = run(surge, 48, 20, observation),
             c3 = run(surge, 64, 24, observation);
  for (auto* c : {&c1, &c2, &c3})
    printf("F %g %g p %g\n", largest_difference(c->elevation[0], fine.elevation[0]),
           largest_difference(c->elevation[1], fine.elevation[1]),
           largest_difference(c->pressure[0], fine.pressure[0]));
  printf("F en %g vol %g\n", largest(fine.energy_error), largest(fine.volume_error));
}

// The paper's motion over 20 s, set off at once. Linear theory with its modes set off as the run's
// are: what remains is the wave's nonlinearity.
TEST(NonlinearConvergence, FollowsThePapersCaseForTwentySeconds) {
  NonlinearSloshing paper{.tank = li_tank, .roof = 0.65};
  const auto [b, omega] = li_surge;
  paper.motion.surge_velocity = [=](double t) { return b * omega * std::cos(omega * t); };
  paper.motion.surge_acceleration = [=](double t) {
    return -b * omega * omega * std::sin(omega * t);
  };
  const Observation observation{.times = instants_up_to(20, 0.02), .gauges = {li_gauge}};
  const auto record = run(paper, 64, 24, observation);
  auto modes = surge_modes(li_tank, {}, b * omega, 500);
  for (std::size_t n = 0; n < modes.size(); ++n) {
    modes[n].initial_rate *= std::exp(-36 * std::pow(2.5 * (2 * n + 1) / 64, 8));
  }
  const auto shapes = surface_shapes(modes, li_gauge);
  std::vector<double> linear;
  for (const double t : observation.times) {
    double elevation = 0;
    for (std::size_t n = 0; n < modes.size(); ++n)
      elevation += shapes[n] * forced_mode(modes[n], li_surge, t).elevation;
    linear.push_back(elevation);
  }
  const auto pure =
      LinearSurge(li_tank, Start::earth, li_surge, 2000).elevation(li_gauge, observation.times);
  double sq = 0, sq2 = 0, sp = 0;
  for (size_t i = 0; i < linear.size(); i++) {
    sq += std::pow(record.elevation[0][i] - linear[i], 2);
    sq2 += std::pow(record.elevation[0][i] - pure[i], 2);
    sp += pure[i] * pure[i];
  }
  printf("P max diff same start %g, pure %g of %g; rms %g %g of %g; energy %g vol %g unres %g\n",
         largest_difference(record.elevation[0], linear),
         largest_difference(record.elevation[0], pure), largest(pure), sqrt(sq / 1001),
         sqrt(sq2 / 1001), sqrt(sp / 1001), largest(record.energy_error),
         largest(record.volume_error), largest(record.unresolved));
}

}  // namespace
}  // namespace slosh::reference
