#include "verification/assessment/doubts/gap_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/tests/found_limit.hpp"
#include "verification/case/gap_friction.hpp"

namespace slosh::gap_limits_test {
namespace {

using std::numbers::pi;

// A roll of the oil and of the water of SPHERIC's benchmark 10, in its tank 62 mm broad.
CaseDefinition rolling_tank(double viscosity, double frequency, const InterFoamRun& mesh) {
  CaseDefinition definition = case_with_runs({mesh});
  definition.tank = {.length = 0.9, .height = 0.508, .breadth = 0.062};
  definition.liquid = {0.093, 998, viscosity};
  definition.motion.surge.reset();
  definition.motion.roll = RollDefinition{SineMotion{0.07, frequency}, 0.45, 0};
  return definition;
}

const InterFoamRun plane_mesh{.cells_x = 90, .cells_z = 51};
const std::string added_mass = "the added mass of the layers on the gap walls";

TEST(GapLimits, SayThatACaseWithoutBreadthIsTakenToBeAsBroadAsLong) {
  CaseDefinition definition = case_with_runs({});
  const auto limit = found_limit(definition, "the friction of the gap walls");
  ASSERT_TRUE(limit);
  EXPECT_FALSE(limit->exceeded());
  EXPECT_EQ(limit->effect,
            "the friction of the gap walls, for which the breadth is taken to be the "
            "length, 1 m, as the case declares no breadth_m; a tank narrower than 0.18 m is beyond "
            "the limit and must declare it");
  definition.tank.length = 0.1;
  EXPECT_TRUE(found_limit(definition, "the friction of the gap walls")->exceeded());
  definition.tank.breadth = 0.1;
  EXPECT_FALSE(found_limit(definition, "the friction of the gap walls"));
}

TEST(GapLimits, TellTheAddedMassThatOpenFoamInTwoDimensionsLeavesOut) {
  const auto oil = found_limit(rolling_tank(5e-5, 4.0782, plane_mesh), added_mass);
  ASSERT_TRUE(oil);
  EXPECT_NEAR(oil->value, 0.0787, 0.0001);  // docs/walls.md: 8 %
  EXPECT_TRUE(oil->exceeded());
  EXPECT_NE(oil->effect.find("lowers a natural frequency by 3.9 %, in a_run"), std::string::npos)
      << oil->effect;
  // Thin layers have the added mass delta / b, whose limit is that on their friction, pi delta / b.
  const auto thin = found_limit(rolling_tank(1e-9, 4, plane_mesh), added_mass);
  EXPECT_NEAR(thin->value, std::sqrt(2 * 1e-9 / 4) / 0.062, 1e-6);
  EXPECT_NEAR(thin->limit, 0.02 / pi, 1e-12);
  EXPECT_FALSE(thin->exceeded());
}

TEST(GapLimits, HaveTheAddedMassOfPoiseuilleFlowInAThinGap) {
  EXPECT_NEAR(found_limit(rolling_tank(1, 4, plane_mesh), added_mass)->value, 0.2, 1e-4);
}

TEST(GapLimits, LeaveTheAddedMassToRunsThatHaveIt) {
  InterFoamRun mesh = plane_mesh;
  mesh.cells_y = 8;
  EXPECT_FALSE(found_limit(rolling_tank(5e-5, 4, mesh), added_mass));
  CaseDefinition particles = rolling_tank(5e-5, 4, plane_mesh);
  particles.runs = {sample_run(SphRun{"recommended", 0.01, 0.01})};
  EXPECT_FALSE(found_limit(particles, added_mass));
}

TEST(GapLimits, ShiftAWaveOfWaterByAsMuchAsTheFrictionTakesFromIt) {
  const auto limit = found_limit(rolling_tank(8.96e-7, 3.840445, plane_mesh), added_mass);
  ASSERT_TRUE(limit);
  const double friction = layers_between_walls(0.062, 8.96e-7, 3.840445).friction;
  EXPECT_NEAR(limit->value / (friction / 3.840445), 1, 0.03);
  EXPECT_TRUE(limit->exceeded());
}

}  // namespace
}  // namespace slosh::gap_limits_test
