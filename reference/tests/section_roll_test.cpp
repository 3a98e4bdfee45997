// The rolling tank of any section against the rectangle's series, about an axis off the centre, and
// its force and moment against its pressure.
#include "reference/section/section_roll.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/linear_roll.hpp"
#include "reference/tests/sections.hpp"
#include "reference/tests/zhao_tank.hpp"

namespace slosh::reference::section_roll_test {
namespace {

constexpr double a = zhao_tank.length / 2, h = zhao_tank.fill_depth;
constexpr RollAxis axis{0.11, zhao_axis_z};

SectionRollMotion about(const Corner& place, const RollMotion& motion) {
  return {motion.angle, motion.rate, motion.acceleration, place, motion.duration, motion.step};
}

TEST(SectionRoll, OfARectangleIsTheSeries) {
  const SectionModes modes(rectangle(zhao_tank), 40);
  const RollMotion motion = ramped_roll(axis, 3, 5, 5e-3);
  const SectionRoll section(modes, Start::tank, about({axis.x + a, axis.z + h}, motion));
  const LinearRoll series(zhao_tank, Start::tank, motion, 1000);
  for (const double t : {0.0, 0.9, 3.3, 5.0}) {
    for (const double x : {-a, -0.2, 0.13, a}) {
      EXPECT_NEAR(section.elevation(x + a, t), series.elevation(x, t), 3e-6);
      for (const double z : {-h, -0.3, -0.1}) {
        const auto [u, w] = section.velocity(x + a, z + h, t);
        const auto wanted = series.velocity(x, z, t);
        // In the corners Psi's gradient is r log r and its series falls as n^-2.
        const bool corner = std::abs(x) == a && z == -h;
        EXPECT_NEAR(section.pressure(x + a, z + h, t), series.pressure(x, z, t), 3e-4);
        EXPECT_NEAR(u, wanted.x, corner ? 1e-3 : 2e-6);
        EXPECT_NEAR(w, wanted.z, corner ? 1e-3 : z == -h ? 3e-5 : 2e-6);
      }
    }
    EXPECT_NEAR(section.force(t).x, series.force(t).x, 3e-3);
    EXPECT_NEAR(section.force(t).z, series.force(t).z, 1e-6);
    EXPECT_NEAR(section.moment(t), series.moment(t), 3e-3);
  }
}

TEST(SectionRoll, StartsAtRestInTheFrameThatIsNamed) {
  const SectionModes modes(vee(0.4), 20);
  const RollMotion motion = sine_roll(axis, 1, 1e-3);
  const SectionRollMotion roll = about({0.6, 0.1}, motion);
  const SectionRoll tank(modes, Start::tank, roll), earth(modes, Start::earth, roll);
  // A surface at rest in the tank has no normal velocity, under which an ideal liquid cannot but
  // turn against the walls.
  for (const double x : {0.5, 0.7, 0.9, 1.1}) EXPECT_NEAR(tank.velocity(x, 0.4, 0).z, 0, 1e-4);
  EXPECT_GT(std::abs(tank.velocity(0.8, 0.2, 0).x), 1e-3);
  // In the earth's frame the walls push the liquid; the surface, on which no impulse acts, keeps
  // its tangential velocity: relative to the tank it moves by -theta' times that of the tank.
  const double turning = motion.rate(0);
  EXPECT_NEAR(earth.velocity(0.8, 0.4, 0).x, turning * (0.4 - 0.1), 0.05 * turning * 0.3);
  // The flow follows the wall: along it alone.
  const auto [u, w] = earth.velocity(1.0, 0.2, 0);
  EXPECT_NEAR(u, w, 2e-4);
  EXPECT_NEAR(earth.elevation(0.6, 0), 0, 1e-12);
}

// The pressure along the wetted walls gives the force and the moment.
TEST(SectionRoll, PressesOnTheWallsAsItsForceAndMomentSay) {
  const SectionModes modes(skewed(), 40);
  const Corner place{0.4, 0.25};
  const SectionRoll roll(modes, Start::tank, about(place, ramped_roll(axis, 2, 4, 5e-3)));
  const std::vector<Corner> wetted{{0.05, 0.6}, {0.1, 0.3}, {0.3, 0},
                                   {0.9, 0.1},  {1.2, 0.4}, {1.15, 0.6}};
  for (const double t : {0.7, 2.9}) {
    double x = 0, z = 0, moment = 0;
    for (std::size_t i = 0; i + 1 < wetted.size(); ++i) {
      const auto &from = wetted[i], &to = wetted[i + 1];
      const int points = 400;
      for (int k = 0; k < points; ++k) {
        const double share = (k + 0.5) / points, at_x = from.x + share * (to.x - from.x),
                     at_z = from.z + share * (to.z - from.z);
        const double p = roll.pressure(at_x, at_z, t) / points;
        x += p * (to.z - from.z);
        z -= p * (to.x - from.x);
        moment -= p * ((at_x - place.x) * (to.x - from.x) + (at_z - place.z) * (to.z - from.z));
      }
    }
    EXPECT_NEAR(x, roll.force(t).x, 0.05);
    EXPECT_NEAR(z, roll.force(t).z, 0.05);
    EXPECT_NEAR(moment, roll.moment(t), 0.05);
  }
}

}  // namespace
}  // namespace slosh::reference::section_roll_test
