#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "reference/tests/nonlinear_cases.hpp"

namespace slosh::reference::nonlinear_range_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

NonlinearSloshing on_grid(NonlinearSloshing sloshing, int nodes_x, int nodes_z) {
  sloshing.nodes_x = nodes_x;
  sloshing.nodes_z = nodes_z;
  return sloshing;
}

NonlinearSloshing shape(std::function<double(double)> elevation) {
  return {.tank = li_tank, .initial_elevation = std::move(elevation)};
}

// Two seconds of a run that must end before that; no series is longer than the valid part.
NonlinearRecord cut_short(const NonlinearSloshing& sloshing) {
  const auto times = instants_up_to(2, 0.05);
  const auto record = run_nonlinear_potential_flow(
      sloshing, {.times = times, .gauges = {0.5}, .places = {{0.5, -0.02}}});
  EXPECT_NE(record.left_range_because, "");
  EXPECT_LT(record.valid_until, 2);
  EXPECT_LT(record.times.size(), times.size());
  EXPECT_TRUE(record.times.empty() || record.times.back() <= record.valid_until);
  EXPECT_EQ(record.elevation[0].size(), record.times.size());
  EXPECT_EQ(record.pressure[0].size(), record.times.size());
  EXPECT_EQ(record.load.size(), record.times.size());
  EXPECT_EQ(record.energy_error.size(), record.times.size());
  return record;
}

std::string beginning(const std::string& text, std::string_view expected) {
  return text.substr(0, expected.size());
}

TEST(NonlinearRange, EndsWhereTheLiquidReachesTheRoof) {
  NonlinearSloshing wave = on_grid(standing_wave(li_tank, 0.04), 20, 12);
  wave.roof = 0.041;
  const auto record = cut_short(wave);
  EXPECT_EQ(record.left_range_because, "the liquid reaches the roof at x = 0.5 m");
  EXPECT_GT(record.valid_until, 0.4);
  EXPECT_LT(largest(record.elevation[0]), 0.041);
}

TEST(NonlinearRange, EndsWhereTheSurfaceIsAboutToBreak) {
  const auto moved =
      cut_short(on_grid({.tank = li_tank, .motion = smooth_surge(0.1, {5, 0.3})}, 48, 16));
  const std::string expected = "the surface is about to break: its slope is ";
  EXPECT_EQ(beginning(moved.left_range_because, expected), expected);
  EXPECT_GT(moved.valid_until, 0.1);
  const auto steep = cut_short(
      on_grid(shape([](double x) { return 0.2 * std::cos(12.566 * (x + 0.5)); }), 48, 12));
  EXPECT_EQ(beginning(steep.left_range_because, expected), expected);
  EXPECT_TRUE(steep.times.empty());
}

TEST(NonlinearRange, EndsWhereTheBottomFallsDry) {
  const auto dry = cut_short(on_grid(standing_wave(li_tank, 0.345), 24, 12));
  EXPECT_EQ(dry.left_range_because, "the bottom falls dry: 0.005 m of liquid are left");
  const auto below = cut_short(on_grid(standing_wave(li_tank, 0.36), 24, 12));
  EXPECT_EQ(below.left_range_because, "the depth falls to -0.01 m");
}

TEST(NonlinearRange, EndsWhereTheGridDoesNotResolveTheSurface) {
  const std::string expected = " nodes along x do not resolve the surface: its last coefficients";
  const auto ripples =
      cut_short(on_grid(shape([](double x) { return 0.01 * std::cos(38 * (x + 0.5)); }), 16, 12));
  EXPECT_EQ(beginning(ripples.left_range_because, "16" + expected), "16" + expected);
  EXPECT_TRUE(ripples.times.empty());
  // A shallow wave that steepens into a bore.
  const Tank shallow{.length = 1, .fill_depth = 0.05, .gravity = 9.81, .density = 1000};
  const auto bore = cut_short(on_grid(standing_wave(shallow, 0.03), 24, 12));
  EXPECT_EQ(beginning(bore.left_range_because, "24" + expected), "24" + expected);
  EXPECT_GT(bore.valid_until, 0.5);
}

// A motion whose acceleration is not the rate of its velocity does other work than the energy
// balance assumes.
TEST(NonlinearRange, EndsWhereTheEnergyDoesNotBalanceTheWallsWork) {
  NonlinearSloshing wrong =
      on_grid({.tank = li_tank, .motion = smooth_surge(0.02, {4, 1.2})}, 32, 14);
  wrong.motion.surge_acceleration = [](double) { return 0.0; };
  const auto record = cut_short(wrong);
  const std::string expected = "the energy does not balance the walls' work:";
  EXPECT_EQ(beginning(record.left_range_because, expected), expected);
}

TEST(NonlinearRange, RefusesAMotionThatIsNotFinite) {
  NonlinearSloshing lost = on_grid({.tank = li_tank}, 16, 10);
  lost.motion.surge_velocity = [](double t) { return t < 0.1 ? 0 : nan; };
  lost.motion.surge_acceleration = [](double) { return 0.0; };
  try {
    run_nonlinear_potential_flow(lost, {.times = {1}});
    FAIL() << "a NaN velocity was accepted";
  } catch (const std::invalid_argument& error) {
    const std::string expected = "TankMotion: surge velocity at 0.1";
    EXPECT_EQ(beginning(error.what(), expected), expected);
  }
}

TEST(NonlinearRange, RefusesImpossibleInput) {
  const auto refused = [](auto change) {
    NonlinearSloshing sloshing = on_grid({.tank = li_tank}, 12, 8);
    Observation observation{.times = {0}};
    change(sloshing, observation);
    EXPECT_THROW(run_nonlinear_potential_flow(sloshing, observation), std::invalid_argument);
  };
  EXPECT_NO_THROW(run_nonlinear_potential_flow(on_grid({.tank = li_tank}, 12, 8), {.times = {0}}));
  refused([](auto& s, auto&) { s.tank.length = nan; });
  refused([](auto& s, auto&) { s.tank.density = 0; });
  refused([](auto& s, auto&) { s.roof = nan; });
  refused([](auto& s, auto&) { s.nodes_x = 7; });
  refused([](auto& s, auto&) { s.nodes_z = 7; });
  refused([](auto& s, auto&) { s.initial_elevation = [](double) { return nan; }; });
  refused([](auto& s, auto&) {
    s.motion = smooth_roll(0.1, {1, 1});
    s.motion.angle = [](double) { return 1.6; };
  });
  refused([](auto&, auto& o) { o.times = {1, 0.5}; });
  refused([](auto&, auto& o) { o.times = {nan}; });
  refused([](auto&, auto& o) { o.gauges = {0.51}; });
  refused([](auto&, auto& o) { o.places = {{0, -0.36}}; });
  refused([](auto&, auto& o) { o.places = {{nan, -0.1}}; });
}

// Starts with a step of the tank's acceleration: the liquid is at rest, and X'' is not 0 at 0 s.

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
}  // namespace slosh::reference::nonlinear_range_test
