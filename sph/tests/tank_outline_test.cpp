#include "sph/walls/tank_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sph/neighbours/particles.hpp"
#include "sph/tests/outlined_tanks.hpp"
#include "sph/walls/wall_contact.hpp"

namespace slosh::sph::tank_outline_test {
namespace {

const TankWalls still_walls{0, 1, 0, 0.7, 0, 0};

TEST(TankOutline, KnowsTheExtentAtEveryHeight) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_NEAR(outline.at(0.05).left, 0.1, 1e-12);
  EXPECT_NEAR(outline.at(0.05).right, 0.9, 1e-12);
  EXPECT_NEAR(outline.at(0.3).width(), 1, 1e-12);
  EXPECT_NEAR(outline.at(0.65).left, 0.1, 1e-12);
}

TEST(TankOutline, GivesTheAreaBetweenTwoHeights) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_NEAR(outline.mean_between(0, 0.35).width() * 0.35, 0.35 - 0.15 * 0.15, 1e-12);
  const TankOutline circle(cylinder_outline());
  EXPECT_NEAR(circle.mean_between(0, circle.top()).width() * circle.top(), 0.25 * std::numbers::pi,
              1e-12);
}

TEST(TankOutline, ContainsWhatIsWithinItsSides) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_TRUE(outline.contains(0.5, 0.01));
  EXPECT_TRUE(outline.contains(0.08, 0.08));
  EXPECT_FALSE(outline.contains(0.07, 0.07));
  EXPECT_FALSE(outline.contains(0.5, -0.01));
  EXPECT_FALSE(outline.contains(0.5, 0.71));
  EXPECT_FALSE(outline.contains(std::nan(""), 0.3));
}

TEST(TankOutline, FindsItsNearestPointWithTheWayIntoTheTank) {
  const TankOutline outline(chamfered_outline(0.15));
  const OutlinePoint chamfer = outline.nearest(0.05, 0.05);
  EXPECT_NEAR(chamfer.at.x, 0.075, 1e-12);
  EXPECT_NEAR(chamfer.at.z, 0.075, 1e-12);
  EXPECT_NEAR(chamfer.inward.x, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(chamfer.inward.z, std::sqrt(0.5), 1e-12);
  const OutlinePoint corner = outline.nearest(0.16, -0.1);
  EXPECT_NEAR(corner.inward.z, 1, 1e-12);
}

bool refused(std::vector<Corner> corners) {
  try {
    TankOutline outline(corners);
  } catch (const std::invalid_argument&) {
    return true;
  }
  return false;
}

TEST(TankOutline, RefusesWhatIsNoTank) {
  EXPECT_TRUE(refused({{0, 0}, {1, 0}}));
  EXPECT_TRUE(refused({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));              // clockwise
  EXPECT_TRUE(refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));              // sides that cross
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.3}, {0, 1}}));  // two basins
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}));      // a corner twice
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {std::nan(""), 1}, {0, 1}}));
  EXPECT_FALSE(refused(chamfered_outline(0.1)));
}

TEST(OutlineOf, RefusesAnOutlineThatDoesNotTouchTheTanksSides) {
  Scene scene = chamfered_scene(0.05, 0);
  EXPECT_TRUE(outline_of(scene));
  scene.tank_length = 1.2;
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
}

TEST(OutlineOf, RefusesWhatOnlyRectanglesTake) {
  Scene scene = chamfered_scene(0.05, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.1}};
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
  scene = chamfered_scene(0.05, 0);
  scene.initial_wave = InitialWave{1, 0.01};
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
}

TEST(ConfineTo, ReflectsAParticleThatHasCrossedAnInclinedSide) {
  const TankOutline outline(chamfered_outline(0.15));
  Particles p;
  p.x = {0.07};
  p.z = {0.07};
  p.velocity_x = {-1};
  p.velocity_z = {0};
  EXPECT_EQ(confine_to(outline, p, still_walls), 1);
  EXPECT_NEAR(p.x[0], 0.08, 1e-12);
  EXPECT_NEAR(p.z[0], 0.08, 1e-12);
  // The component along (1, 1) is turned.
  EXPECT_NEAR(p.velocity_x[0], 0, 1e-12);
  EXPECT_NEAR(p.velocity_z[0], 1, 1e-12);
  EXPECT_EQ(confine_to(outline, p, still_walls), 0);
}

// From anywhere near the walls, corners included.
TEST(ConfineTo, LeavesNoParticleOutside) {
  for (const auto& corners : {chamfered_outline(0.15), cylinder_outline(),
                              std::vector<Corner>{{0, 0}, {0.3, 0}, {1, 0.7}, {0, 0.7}}}) {
    const TankOutline outline(corners);
    Particles p;
    for (double x = -0.02; x < 1.02; x += 0.007)
      for (double z = -0.02; z < outline.top() + 0.02; z += 0.007) {
        const OutlinePoint wall = outline.nearest(x, z);
        if (std::hypot(wall.at.x - x, wall.at.z - z) > 0.02) continue;
        p.x.push_back(x);
        p.z.push_back(z);
        p.velocity_x.push_back(0);
        p.velocity_z.push_back(0);
      }
    confine_to(outline, p, still_walls);
    for (std::size_t i = 0; i < p.size(); ++i)
      EXPECT_TRUE(outline.contains(p.x[i], p.z[i])) << p.x[i] << ' ' << p.z[i];
  }
}

}  // namespace
}  // namespace slosh::sph::tank_outline_test
