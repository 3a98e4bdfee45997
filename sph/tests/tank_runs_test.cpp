// Runs with a breaking dam, with obstacles, and in tanks that are not rectangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sph/simulation.hpp"
#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/obstacle_contact.hpp"

namespace slosh::sph::tank_runs_test {
namespace {

constexpr double dp = 0.025;

TEST(Dam, CollapsesToTheRightUntilItsFrontReachesTheWall) {
  const RunOutput output = run("recommended", dam_scene(dp, 0.6), {});
  const std::vector<double>& front = output.front_position.value;
  ASSERT_EQ(front.size(), 61);
  EXPECT_EQ(output.front_position.time, output.kinetic_energy.time);
  EXPECT_NEAR(front.front(), 0.2, 1e-12);
  const auto at_wall = std::find_if(front.begin(), front.end(), [](double x) { return x > 0.97; });
  ASSERT_NE(at_wall, front.end());
  EXPECT_TRUE(std::is_sorted(front.begin(), at_wall));
  for (const double x : front) EXPECT_LE(x, 1 + dp);
  // Neither faster than Ritter's front, 2 sqrt(g h), nor slower than half of it.
  const double time = output.front_position.time[at_wall - front.begin()];
  const double ritter = 2 * std::sqrt(9.81 * 0.4);
  EXPECT_GT(time, 0.77 / ritter);
  EXPECT_LT(time, 0.77 / (0.5 * ritter));
}

TEST(Dam, TurnsPotentialIntoKineticEnergyAndNoMore) {
  const RunOutput output = run("recommended", dam_scene(dp, 0.3), {});
  const double start = 0.5 * 1000 * 9.81 * 0.2 * 0.4 * 0.4;  // [J/m]
  for (std::size_t i = 0; i < output.kinetic_energy.value.size(); ++i)
    EXPECT_LE(output.kinetic_energy.value[i] + output.potential_energy.value[i], 0.01 * start);
  EXPECT_GT(output.kinetic_energy.value.back(), 0.3 * start);
}

class TankWithObstacle : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, TankWithObstacle,
                         testing::Values("recommended", "ghost_walls", "no_slip_ghost_walls",
                                         "dynamic_walls", "delta_sph"),
                         [](const auto& name) { return name.param; });

TEST_P(TankWithObstacle, MirroredGivesTheMirroredFlow) {
  Scene ahead = with_obstacle(surging_scene(dp, 0.3), {0.2, 0.4, 0, 0.2});
  Scene back = with_obstacle(surging_scene(dp, 0.3, -0.02), {0.6, 0.8, 0, 0.2});
  // A projection is the mirrored one's image to its solver's tolerance alone.
  ahead.initial_state = back.initial_state = InitialState::lattice;
  const auto right = run_named(GetParam(), ahead).elevation.at("right").value,
             left = run_named(GetParam(), back).elevation.at("left").value;
  ASSERT_EQ(right.size(), left.size());
  double largest = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_NEAR(right[i], left[i], 1e-9);
    largest = std::max(largest, std::abs(right[i]));
  }
  EXPECT_GT(largest, 1e-3);
}

struct StandingTank {
  std::string name;
  double particle_spacing;
  Rectangle obstacle;
};
void PrintTo(const StandingTank& tank, std::ostream* stream) { *stream << tank.name; }

// Measured after 3 s: at most 2.1e-5. Solids whose velocity in the continuity equation is taken
// from the liquid drive the first of these to 1.3e-4; edges that are not the lattice's own drive
// the last one, of 18 rows in place of 17.5, to as much.
class StillWaterWithObstacle : public testing::TestWithParam<StandingTank> {};
INSTANTIATE_TEST_SUITE_P(
    Standing, StillWaterWithObstacle,
    testing::Values(StandingTank{"on_the_bottom", dp, {0.45, 0.65, 0, 0.2}},
                    StandingTank{"through_the_surface", dp, {0.45, 0.65, 0, 0.5}},
                    StandingTank{"in_a_corner", dp, {0, 0.2, 0, 0.2}},
                    StandingTank{"in_a_stretched_lattice", 0.02, {0.44, 0.64, 0, 0.2}}),
    [](const auto& tank) { return tank.param.name; });

TEST_P(StillWaterWithObstacle, StaysStill) {
  Scene scene = with_obstacle(still_scene(GetParam().particle_spacing, 3), GetParam().obstacle);
  scene.record_still_water = true;
  scene.sample_interval = 0.1;
  const std::vector<RecordedSeries> recorded = run("recommended", scene, {}).still_water;
  const auto energy = std::find_if(recorded.begin(), recorded.end(), [](const RecordedSeries& one) {
    return one.name == "kinetic_over_potential_energy";
  });
  ASSERT_NE(energy, recorded.end());
  ASSERT_EQ(energy->history.value.size(), 31);
  EXPECT_LE(energy->history.value.back(), 5e-5);
}

// Measured as far as 5 s: 1.2e-10 at most two spacings thick, as with four, and 3.7e-5 one spacing
// thick, whose edge lets the lattice around it give way (10 mm).
INSTANTIATE_TEST_SUITE_P(
    Thin, StillWaterWithObstacle,
    testing::Values(StandingTank{"a_baffle_one_thick", dp, {0.5, 0.5 + dp, 0, 0.2}},
                    StandingTank{"a_baffle_two_thick", dp, {0.5, 0.5 + 2 * dp, 0, 0.2}},
                    StandingTank{"a_lying_plate", dp, {0.3, 0.6, 0.15, 0.15 + dp}},
                    StandingTank{"a_full_plate", dp, {0.5, 0.5 + dp, 0, 1}}),
    [](const auto& tank) { return tank.param.name; });

// The plate is as thin as the lattice allows, and the liquid runs at it with several m/s.
TEST(DamOntoThinWall, LetsNoParticleThrough) {
  for (const std::string variant : {"", "dynamic_walls"}) {
    Scene scene = with_obstacle(dam_scene(dp, 0.8), {0.5, 0.5 + dp, 0, 1});
    scene.variant = variant;
    scene.snapshot_interval = scene.sample_interval;
    int particles = 0;
    double farthest = 0;
    scene.record_snapshot = [&](const Snapshot& s) {
      for (const double x : s.x) {
        // Brought back at the start of each step: no deeper than one step goes.
        EXPECT_LT(x, 0.5 + 0.2 * dp) << s.time;
        farthest = std::max(farthest, x);
        ++particles;
      }
    };
    run("recommended", scene, {});
    EXPECT_EQ(particles, 81 * 8 * 16);
    EXPECT_GT(farthest, 0.48);  // it did reach the plate
  }
}

// Each half is a tank of its own: omega^2 = g k tanh(k h), k = pi over its length (Lamb, section
// 228), measured to within 0.2 % at 10 mm.
TEST(PlateFromBottomToRoof, MakesTwoTanksOfOne) {
  Scene scene = with_obstacle(still_scene(dp, 4), {0.5, 0.5 + dp, 0, 1});
  scene.velocity = [](double t) { return t > 0 ? 0.0 : 0.03; };
  scene.start = Start::tank;
  const RunOutput output = run("recommended", scene, {});
  for (const auto& [gauge, length] : {std::pair{"left", 0.5}, {"right", 0.5 - dp}}) {
    const History& eta = output.elevation.at(gauge);
    std::vector<double> crossings;
    for (std::size_t k = 20; k + 1 < eta.time.size(); ++k)
      if (eta.value[k] * eta.value[k + 1] < 0)
        crossings.push_back(eta.time[k] - eta.value[k] * (eta.time[k + 1] - eta.time[k]) /
                                              (eta.value[k + 1] - eta.value[k]));
    ASSERT_GE(crossings.size(), 4);
    const double omega = std::numbers::pi * static_cast<double>(crossings.size() - 1) /
                         (crossings.back() - crossings.front());
    const double k = std::numbers::pi / length;
    EXPECT_NEAR(omega / std::sqrt(9.81 * k * std::tanh(k * 0.35)), 1, 0.02) << gauge;
  }
}

TEST(DamOntoObstacle, LeavesNoParticleInTheObstacle) {
  const Rectangle obstacle{0.5, 0.6, 0, 0.1};
  for (const std::string variant : {"", "dynamic_walls"}) {
    Scene scene = with_obstacle(dam_scene(dp, 0.8), obstacle);
    scene.variant = variant;
    scene.snapshot_interval = scene.sample_interval;
    int particles = 0;
    double farthest = 0;
    scene.record_snapshot = [&](const Snapshot& s) {
      for (std::size_t i = 0; i < s.x.size(); ++i) {
        // Brought out at the start of each step: no deeper than one step goes.
        EXPECT_FALSE(holds({0.5 + 0.1 * dp, 0.6 - 0.1 * dp, 0, 0.1 - 0.1 * dp}, s.x[i], s.z[i]))
            << s.time;
        farthest = std::max(farthest, s.x[i]);
        ++particles;
      }
    };
    run("recommended", scene, {});
    EXPECT_EQ(particles, 81 * 8 * 16);
    EXPECT_GT(farthest, 0.8);  // it did reach and pass the obstacle
  }
}

// Runs in tanks that are not rectangles.

class StillTank : public testing::TestWithParam<Scene (*)(double, double)> {};
INSTANTIATE_TEST_SUITE_P(OfAnOutline, StillTank,
                         testing::Values(&chamfered_scene, &cylinder_scene));

TEST_P(StillTank, StaysAtRest) {
  const Scene scene = GetParam()(0.025, 2);
  const RunOutput output = run("recommended", scene, {});
  const double energy = 0.5 * scene.rest_density * scene.gravity * scene.fill_depth *
                        scene.fill_depth * scene.tank_length;
  EXPECT_LT(output.kinetic_energy.value.back(), 2e-4 * energy);
  EXPECT_LT(largest(output.elevation.at("left").value), 0.05 * scene.particle_spacing);
}

TEST_P(StillTank, CarriesTheWeightOfItsLiquid) {
  const Scene scene = GetParam()(0.025, 2);
  const std::vector<double> force = run("recommended", scene, {}).force_z.value;
  const double mean = std::accumulate(force.begin() + 50, force.end(), 0.0) /
                      static_cast<double>(force.size() - 50);
  const double volume =
      TankOutline(scene.outline).mean_between(0, scene.fill_depth).width() * scene.fill_depth;
  const double weight = scene.rest_density * scene.gravity * volume;
  EXPECT_NEAR(mean, -weight, 0.005 * weight);
}

TEST_P(StillTank, RunsWithEverySchemeOfSolidWalls) {
  Scene scene = GetParam()(0.05, 0.05);
  for (const char* scheme : {"delta_sph", "zhao2021_moving", "zhao2021_fixed"})
    EXPECT_NO_THROW(run(scheme, scene, {})) << scheme;
  for (const char* variant : {"ghost_walls", "no_slip_ghost_walls", "dynamic_walls",
                              "laminar_viscosity", "no_slip_laminar"}) {
    scene.variant = variant;
    scene.kinematic_viscosity = 1e-6;
    EXPECT_NO_THROW(run("recommended", scene, {})) << variant;
  }
}

TEST(OutlinedTank, RefusesSchemesWhoseWallsAreMirrorsAlone) {
  Scene scene = chamfered_scene(0.05, 0.05);
  EXPECT_THROW(run("li2010", scene, {}), std::invalid_argument);
  scene.variant = "repulsive_mirror";
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

// A gauge on the lower left chamfer reads the hydrostatic pressure, to a quarter of a spacing's.
TEST(OutlinedTank, MeasuresThePressureOnAnInclinedWall) {
  Scene scene = chamfered_scene(0.0125, 0.01);
  scene.pressure_gauges = {{"C", Wall::left, 0, 0.02, Corner{0.075, 0.075}}};
  const RunOutput output = run("recommended", scene, {});
  const double expected = scene.rest_density * scene.gravity * (0.35 - 0.075);
  EXPECT_NEAR(output.wall_pressure.at("C").value[0], expected, 0.02 * expected);
  scene.pressure_gauges[0].at = Corner{0.1, 0.1};
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
  scene.pressure_gauges[0].at.reset();
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

// The tank moves off at a constant speed. In the half-filled circle omega^2 R / g = 1.3557 for the
// first antisymmetric mode (Budiansky 1960; McIver 1989).
TEST(OutlinedTank, HasTheNaturalFrequencyOfAHalfFilledCylinder) {
  Scene scene = cylinder_scene(0.025, 5);
  scene.displacement = [](double t) { return 0.03 * t; };
  scene.velocity = [](double) { return 0.03; };
  const History elevation = run("recommended", scene, {}).elevation.at("left");
  std::vector<double> rises;
  for (std::size_t i = 1; i < elevation.time.size(); ++i) {
    const double a = elevation.value[i - 1], b = elevation.value[i];
    if (a < 0 && b >= 0)
      rises.push_back(elevation.time[i - 1] +
                      a / (a - b) * (elevation.time[i] - elevation.time[i - 1]));
  }
  ASSERT_GE(rises.size(), 4);
  const double period = (rises.back() - rises.front()) / static_cast<double>(rises.size() - 1);
  const double exact = 2 * std::numbers::pi / std::sqrt(1.3557 * scene.gravity / 0.5);
  EXPECT_NEAR(period, exact, 0.01 * exact);
}

TEST(OutlinedTank, RollsAboutItsMiddleWithoutAForceOnAHalfFilledCylinder) {
  Scene scene = cylinder_scene(0.05, 1);
  const double axis = 0.5 * scene.tank_height;
  scene.roll = Roll{[](double t) { return 0.2 * std::sin(3 * t); },
                    [](double t) { return 0.6 * std::cos(3 * t); },
                    [](double t) { return -1.8 * std::sin(3 * t); }, axis, axis};
  const RunOutput output = run("recommended", scene, {});
  // A circle that slips about its axis leaves the liquid at rest; the polygon nearly does.
  EXPECT_LT(output.kinetic_energy.value.back(), 1.0);
}

}  // namespace
}  // namespace slosh::sph::tank_runs_test
