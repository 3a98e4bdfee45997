// Runs of scenes with a breaking dam, with obstacles, and with both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/obstacle_contact.hpp"

namespace slosh::sph::dam_and_obstacle_test {
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

struct StillTank {
  std::string name;
  double particle_spacing;
  Rectangle obstacle;
};
void PrintTo(const StillTank& tank, std::ostream* stream) { *stream << tank.name; }

// Measured after 3 s: at most 2.1e-5. Solids whose velocity in the continuity equation is taken
// from the liquid drive the first of these to 1.3e-4; edges that are not the lattice's own drive
// the last one, of 18 rows in place of 17.5, to as much.
class StillWaterWithObstacle : public testing::TestWithParam<StillTank> {};
INSTANTIATE_TEST_SUITE_P(Standing, StillWaterWithObstacle,
                         testing::Values(StillTank{"on_the_bottom", dp, {0.45, 0.65, 0, 0.2}},
                                         StillTank{"through_the_surface", dp, {0.45, 0.65, 0, 0.5}},
                                         StillTank{"in_a_corner", dp, {0, 0.2, 0, 0.2}},
                                         StillTank{
                                             "in_a_stretched_lattice", 0.02, {0.44, 0.64, 0, 0.2}}),
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
    testing::Values(StillTank{"a_baffle_one_thick", dp, {0.5, 0.5 + dp, 0, 0.2}},
                    StillTank{"a_baffle_two_thick", dp, {0.5, 0.5 + 2 * dp, 0, 0.2}},
                    StillTank{"a_lying_plate", dp, {0.3, 0.6, 0.15, 0.15 + dp}},
                    StillTank{"a_full_plate", dp, {0.5, 0.5 + dp, 0, 1}}),
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

}  // namespace
}  // namespace slosh::sph::dam_and_obstacle_test
