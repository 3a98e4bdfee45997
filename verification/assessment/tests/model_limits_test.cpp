#include "verification/assessment/doubts/model_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "verification/tests/sample_case.hpp"

namespace slosh::model_limits_test {
namespace {

using std::numbers::pi;

CaseDefinition with_runs(std::vector<decltype(RunDefinition::solver)> solvers) {
  CaseDefinition definition = sample_case();
  for (const auto& solver : solvers) definition.runs.push_back(sample_run(solver));
  return definition;
}

std::optional<ModelLimit> found(const CaseDefinition& definition, const std::string& effect) {
  for (const ModelLimit& limit : model_limits(definition))
    if (limit.effect.find(effect) != std::string::npos) return limit;
  return std::nullopt;
}

// The oil of SPHERIC's benchmark 10 in a depth of 93 mm, and water.
TEST(ModelLimits, TellTheFrictionAtWallsOfAnOilFromThatOfWater) {
  CaseDefinition definition = with_runs({InterFoamRun{.cells_x = 90, .cells_z = 51}});
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 4.0782};
  definition.liquid = {0.093, 990, 5e-5};
  const auto oil = found(definition, "the friction at walls");
  ASSERT_TRUE(oil);
  EXPECT_NEAR(oil->value, pi / 2 * std::sqrt(2 * 5e-5 / 4.0782) / 0.093, 1e-12);
  EXPECT_TRUE(oil->exceeded());
  definition.liquid.kinematic_viscosity = 9e-7;
  EXPECT_FALSE(found(definition, "the friction at walls")->exceeded());
}

TEST(ModelLimits, KnowWhichMeshesSlipOrAreTooCoarseToStick) {
  InterFoamRun mesh{.cells_x = 90, .cells_z = 51};
  EXPECT_TRUE(found(with_runs({mesh}), "slips in"));
  mesh.no_slip = true;
  EXPECT_FALSE(found(with_runs({mesh}), "slips in"));
  EXPECT_TRUE(found(with_runs({mesh}), "less than three cells"));
  mesh.wall_cell = 0.0003;
  EXPECT_FALSE(found(with_runs({mesh}), "less than three cells"));
}

TEST(ModelLimits, KnowWhichRunsSlip) {
  SphRun sticking{"recommended", 0.01, 0.01};
  sticking.variant = "no_slip_laminar";
  EXPECT_FALSE(found(with_runs({sticking}), "slips in"));
  EXPECT_FALSE(found(with_runs({SphRun{"li2010", 0.01, 0.01}}), "slips in"));
  EXPECT_TRUE(found(with_runs({SphRun{"recommended", 0.01, 0.01}}), "slips in"));
  // The Stokes layer of water at 1.48 rad/s is 1.2 mm thick.
  EXPECT_TRUE(found(with_runs({sticking}), "less than three particles"));
  sticking.particle_spacing = sticking.surface_particle_spacing = 0.0003;
  EXPECT_FALSE(found(with_runs({sticking}), "less than three particles"));
}

TEST(ModelLimits, LeaveTheFrontAndTheBackWallToACaseThatGivesItsBreadth) {
  CaseDefinition definition = with_runs({});
  const auto limit = found(definition, "the front and the back wall");
  ASSERT_TRUE(limit);
  EXPECT_FALSE(limit->exceeded());
  EXPECT_NE(limit->effect.find("narrower than 0.18 m"), std::string::npos) << limit->effect;
  definition.tank.length = 0.1;
  EXPECT_TRUE(found(definition, "the front and the back wall")->exceeded());
  definition.tank.breadth = 0.1;
  EXPECT_FALSE(found(definition, "the front and the back wall"));
}

TEST(ModelLimits, JudgeAnArtificialViscosityByWhatItTakesFromAWave) {
  SphRun viscous{"recommended", 0.01, 0.01};
  EXPECT_FALSE(found(with_runs({viscous}), "the artificial viscosity"));
  viscous.numbers.artificial_viscosity = 0.1;
  const auto strong = found(with_runs({viscous}), "the artificial viscosity");
  ASSERT_TRUE(strong);
  EXPECT_TRUE(strong->exceeded());
  viscous.numbers.artificial_viscosity = 0.001;
  const auto weak = found(with_runs({viscous}), "the artificial viscosity");
  EXPECT_FALSE(weak->exceeded());
  EXPECT_NEAR(strong->value / weak->value, 100, 1e-9);
}

TEST(ModelLimits, HaveSurfaceTensionInSmallTanks) {
  CaseDefinition definition = with_runs({});
  EXPECT_FALSE(found(definition, "surface tension")->exceeded());
  definition.tank.length = 0.1;
  EXPECT_TRUE(found(definition, "surface tension")->exceeded());
  definition.gravity = 0;
  EXPECT_FALSE(found(definition, "surface tension"));
}

TEST(ModelLimits, HaveTheAirOfDeclaredImpacts) {
  CaseDefinition definition = with_runs({});
  EXPECT_FALSE(found(definition, "trapped air"));
  definition.impacts.emplace();
  definition.impacts->peak_means = {3000, 5000};
  EXPECT_NEAR(found(definition, "trapped air")->value, 5000 / 101325.0, 1e-12);
  EXPECT_FALSE(found(definition, "trapped air")->exceeded());
  definition.impacts->peak_means = {30000};
  EXPECT_TRUE(found(definition, "trapped air")->exceeded());
}

TEST(ModelLimits, HaveTheCompressibilityOfRunsWithASlowSound) {
  SphRun soft{"recommended", 0.01, 0.01};
  EXPECT_FALSE(found(with_runs({soft}), "compressibility"));
  soft.numbers.sound_speed_ratio = 10;
  EXPECT_FALSE(found(with_runs({soft}), "compressibility")->exceeded());
  soft.numbers.sound_speed_ratio = 5;
  EXPECT_TRUE(found(with_runs({soft}), "compressibility")->exceeded());
}

TEST(ModelLimits, SayNumberLimitAndSource) {
  const std::string text =
      limit_text({"something", 0.08, 0.02, "of the wave's amplitude in each period", "Someone"});
  EXPECT_EQ(text, "something: 8 % of the wave's amplitude in each period, limit 2 % (Someone)");
}

}  // namespace
}  // namespace slosh::model_limits_test
