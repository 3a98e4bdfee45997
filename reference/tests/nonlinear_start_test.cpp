// Starts with a step of the tank's acceleration: the liquid is at rest, and X'' is not 0 at 0 s.
#include <gtest/gtest.h>

#include "reference/tests/nonlinear_cases.hpp"

namespace slosh::reference::nonlinear_start_test {
namespace {

NonlinearSloshing accelerated(double amplitude, int nodes_x, int nodes_z) {
  return {.tank = faltinsen_tank,
          .motion = cosine_surge(amplitude, faltinsen_frequency),
          .nodes_x = nodes_x,
          .nodes_z = nodes_z};
}

// The step excites the n-th mode by n^-2, which leaves the last coefficients at 4e-3 of the surface
// with 32 nodes. The surge of 0.32 mm raises a wave of 0.7 mm.
TEST(NonlinearStart, FollowsLinearTheoryFromAnAccelerationStep) {
  const double amplitude = 3.2e-4, wall = faltinsen_tank.length / 2, gauge = wall - 0.05;
  const auto surge = accelerated(amplitude, 32, 14);
  const Observation observation{.times = instants_up_to(1.2, 0.1), .gauges = {gauge, wall}};
  const auto record = run_nonlinear_potential_flow(surge, observation);
  ASSERT_EQ(record.left_range_because, "");
  EXPECT_GT(largest(record.unresolved), 1e-3);
  const LinearSurge linear(faltinsen_tank, Start::earth,
                           AnySurge{0, surge.motion.surge_acceleration, 1.2, 1e-3}, 1000);
  EXPECT_GT(largest(record.elevation[0]), 5e-4);
  EXPECT_LT(largest_difference(record.elevation[0], linear.elevation(gauge, observation.times)),
            3e-6);
  EXPECT_LT(largest_difference(record.elevation[1], linear.elevation(wall, observation.times)),
            6e-6);
}

// What is allowed to the step's waves is in proportion to the step.
TEST(NonlinearStart, StillEndsWhereTheGridDoesNotResolveTheSurface) {
  auto ripples = accelerated(3.2e-4, 16, 12);
  ripples.initial_elevation = [](double x) { return 0.01 * std::cos(22 * (x + 0.865)); };
  const auto record = run_nonlinear_potential_flow(ripples, {.times = {0, 0.1}});
  EXPECT_EQ(record.left_range_because.substr(0, 41), "16 nodes along x do not resolve the surfa");
  EXPECT_TRUE(record.times.empty());
}

// A surge with a phase of 90 degrees starts with a velocity of cos(pi / 2) = 6e-17 of its largest,
// which is 0 but for rounding.
TEST(NonlinearStart, OfAWaveInATankAtRestToRoundingIsThatOfOneAtRest) {
  const Tank tank{.length = 0.5, .fill_depth = 0.4, .gravity = 9.81, .density = 1000};
  std::vector<double> ends;
  for (const double rounding : {3.9e-19, 0.0}) {
    NonlinearSloshing surge{
        .tank = tank, .motion = cosine_surge(8.5e-4, 7.47), .nodes_x = 32, .nodes_z = 14};
    surge.start = Start::tank;
    surge.initial_elevation = [](double x) {
      return -0.012 * std::cos(std::numbers::pi * (x / 0.5 + 0.5));
    };
    const auto velocity = surge.motion.surge_velocity;
    surge.motion.surge_velocity = [=](double t) { return velocity(t) + rounding; };
    const auto record = run_nonlinear_potential_flow(surge, {.times = {0, 0.1}, .gauges = {0.25}});
    ASSERT_EQ(record.left_range_because, "");
    ends.push_back(record.elevation[0].back());
  }
  EXPECT_NEAR(ends[0], ends[1], 1e-12);
}

}  // namespace
}  // namespace slosh::reference::nonlinear_start_test
