// Surge and roll under a gas against Galerkin's method (two_layer_galerkin.hpp), which has neither
// modes nor couplings. Air changes little; the heavy gas moves the first frequency by half.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"
#include "reference/tests/li_tank.hpp"
#include "reference/tests/two_layer_galerkin.hpp"
#include "reference/tests/zhao_tank.hpp"

namespace slosh::reference::two_layer_test {
namespace {

constexpr Gas gases[] = {{1.2, 0.65}, {600, 0.155}, {870, 0.3}};
constexpr double instants[] = {0.4, 1.3, 2.9};
constexpr int degree = 26;

// What the finite degree and the finite number of modes leave, as shares of the largest value. Set
// off from rest in the earth's frame, both leave high modes near the surface.
struct Left {
  double elevation, pressure, load;
};
Left left(Start start) {
  return start == Start::earth ? Left{0.04, 8e-5, 5e-3} : Left{1.5e-3, 5e-7, 9e-5};
}

struct Largest {
  double value = 0, difference = 0;
  void add(double theory, double galerkin) {
    value = std::max(value, std::abs(galerkin));
    difference = std::max(difference, std::abs(theory - galerkin));
  }
  double share() const { return difference / value; }
};

std::string named(const Gas& gas, Start start) {
  return fmt::format("{} kg/m3, at rest in the {}", gas.density,
                     start == Start::earth ? "earth's frame" : "tank");
}

TEST(TwoLayer, SurgeIsThatOfTwoLayersInContact) {
  const AnySurge any = sampled(li_surge, 3, 1);
  for (const Gas& gas : gases)
    for (const Start start : {Start::earth, Start::tank}) {
      TwoLayerGalerkin galerkin(li_tank, gas, start,
                                {.rolls = false,
                                 .place = [](double) { return 0; },
                                 .rate = [&](double) { return any.initial_velocity; },
                                 .acceleration = any.acceleration},
                                degree);
      const LinearSurge surge(li_tank, gas, start, li_surge, 2000);
      Largest elevation, pressure, force;
      const double depth = 0.2, still = 9810 * depth;
      for (const double t : instants) {
        galerkin.advance(t);
        for (const double x : {-0.4, 0.17, 0.45})
          elevation.add(surge.elevation(x, t), galerkin.elevation(x));
        for (const double x : {-0.5, 0.2, 0.5})
          pressure.add(surge.pressure(x, -depth, t) - still, galerkin.pressure(x, -depth) - still);
        force.add(surge.horizontal_force(t), galerkin.force_x());
      }
      EXPECT_LT(elevation.share(), left(start).elevation) << named(gas, start);
      EXPECT_LT(pressure.share(), left(start).pressure) << named(gas, start);
      EXPECT_LT(force.share(), left(start).load) << named(gas, start);
    }
}

TEST(TwoLayer, RollIsThatOfTwoLayersInContact) {
  const RollMotion motion = sine_roll({0.1, zhao_axis_z}, 3, 5e-4);
  for (const Gas& gas : gases)
    for (const Start start : {Start::earth, Start::tank}) {
      TwoLayerGalerkin galerkin(zhao_tank, gas, start,
                                {.rolls = true,
                                 .place = motion.angle,
                                 .rate = motion.rate,
                                 .acceleration = motion.acceleration,
                                 .axis_x = motion.axis_x,
                                 .axis_z = motion.axis_z},
                                degree);
      const LinearRoll roll(zhao_tank, gas, start, motion, 1000);
      Largest elevation, pressure, force, lift, moment;
      const double depth = 0.25, still = 9810 * depth;
      const double weight =
          9.81 * zhao_tank.length * (1000 * zhao_tank.fill_depth + gas.density * gas.height);
      const double at_rest = weight * motion.axis_x;
      for (const double t : instants) {
        galerkin.advance(t);
        for (const double x : {-0.4, 0.17, 0.45})
          elevation.add(roll.elevation(x, t), galerkin.elevation(x));
        for (const double x : {-0.46, 0.2, 0.46})
          pressure.add(roll.pressure(x, -depth, t) - still, galerkin.pressure(x, -depth) - still);
        force.add(roll.force(t).x, galerkin.force_x());
        lift.add(roll.force(t).z + weight, galerkin.force_z() + weight);
        moment.add(roll.moment(t) - at_rest, galerkin.moment() - at_rest);
      }
      EXPECT_LT(elevation.share(), left(start).elevation) << named(gas, start);
      EXPECT_LT(pressure.share(), left(start).pressure) << named(gas, start);
      EXPECT_LT(force.share(), left(start).load) << named(gas, start);
      EXPECT_LT(lift.share(), 1e-8) << named(gas, start);
      EXPECT_LT(moment.share(), left(start).load) << named(gas, start);
    }
}

// A tank whose acceleration hardly changes tilts the surface by X''/g, whatever lies above it: the
// remainder is of the order of (omega/omega_1)^2. Surges start gently, with X'' = 0.
TEST(TwoLayer, ASteadyAccelerationTiltsTheSurfaceAlikeUnderAnyGas) {
  const AnySurge slow{.initial_velocity = 0,
                      .acceleration = [](double t) { return 0.05 * (1 - std::cos(0.01 * t)); },
                      .duration = 200,
                      .step = 0.1};
  for (const Gas& gas : gases) {
    const LinearSurge surge(li_tank, gas, Start::earth, slow, 300);
    for (const double x : {-0.4, 0.1, 0.3})
      EXPECT_NEAR(surge.elevation(x, 150) / (-x * slow.acceleration(150) / 9.81), 1, 1e-3)
          << gas.density << " " << x;
  }
}

}  // namespace
}  // namespace slosh::reference::two_layer_test
