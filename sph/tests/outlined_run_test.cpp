// Runs in tanks that are not rectangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sph/simulation.hpp"
#include "sph/tests/outlined_tanks.hpp"

namespace slosh::sph::outlined_run_test {
namespace {

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

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
}  // namespace slosh::sph::outlined_run_test
