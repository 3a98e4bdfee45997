#include "verification/assessment/doubts/damping_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/tests/found_limit.hpp"

namespace slosh::damping_limits_test {
namespace {

using std::numbers::pi;

// The oil of SPHERIC's benchmark 10 in a depth of 93 mm, and water.
TEST(DampingLimits, TellTheFrictionAtWallsOfAnOilFromThatOfWater) {
  CaseDefinition definition = case_with_runs({InterFoamRun{.cells_x = 90, .cells_z = 51}});
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 4.0782};
  definition.liquid = {0.093, 990, 5e-5};
  const auto oil = found_limit(definition, "the friction at walls");
  ASSERT_TRUE(oil);
  EXPECT_NEAR(oil->value, pi / 2 * std::sqrt(2 * 5e-5 / 4.0782) / 0.093, 1e-12);
  EXPECT_TRUE(oil->exceeded());
  definition.liquid.kinematic_viscosity = 9e-7;
  EXPECT_FALSE(found_limit(definition, "the friction at walls")->exceeded());
}

TEST(DampingLimits, KnowWhichMeshesSlipOrAreTooCoarseToStick) {
  InterFoamRun mesh{.cells_x = 90, .cells_z = 51};
  EXPECT_TRUE(found_limit(case_with_runs({mesh}), "slips in"));
  mesh.no_slip = true;
  EXPECT_FALSE(found_limit(case_with_runs({mesh}), "slips in"));
  EXPECT_TRUE(found_limit(case_with_runs({mesh}), "less than three cells"));
  mesh.wall_cell = 0.0003;
  EXPECT_FALSE(found_limit(case_with_runs({mesh}), "less than three cells"));
}

TEST(DampingLimits, KnowWhichRunsSlip) {
  SphRun sticking{"recommended", 0.01, 0.01};
  sticking.variant = "no_slip_laminar";
  EXPECT_FALSE(found_limit(case_with_runs({sticking}), "slips in"));
  EXPECT_FALSE(found_limit(case_with_runs({SphRun{"li2010", 0.01, 0.01}}), "slips in"));
  EXPECT_TRUE(found_limit(case_with_runs({SphRun{"recommended", 0.01, 0.01}}), "slips in"));
  // The Stokes layer of water at 1.48 rad/s is 1.2 mm thick.
  EXPECT_TRUE(found_limit(case_with_runs({sticking}), "less than three particles"));
  sticking.particle_spacing = sticking.surface_particle_spacing = 0.0003;
  EXPECT_FALSE(found_limit(case_with_runs({sticking}), "less than three particles"));
}

TEST(DampingLimits, JudgeAnArtificialViscosityByWhatItTakesFromAWave) {
  SphRun viscous{"recommended", 0.01, 0.01};
  EXPECT_FALSE(found_limit(case_with_runs({viscous}), "the artificial viscosity"));
  viscous.numbers.artificial_viscosity = 0.1;
  const auto strong = found_limit(case_with_runs({viscous}), "the artificial viscosity");
  ASSERT_TRUE(strong);
  EXPECT_TRUE(strong->exceeded());
  viscous.numbers.artificial_viscosity = 0.001;
  const auto weak = found_limit(case_with_runs({viscous}), "the artificial viscosity");
  EXPECT_FALSE(weak->exceeded());
  EXPECT_NEAR(strong->value / weak->value, 100, 1e-9);
}

}  // namespace
}  // namespace slosh::damping_limits_test
