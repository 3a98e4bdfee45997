// What the models of a case leave out: the friction at walls and in gaps, surface tension, the gas
// and the compression of both.
#include "verification/assessment/doubts/model_limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "verification/assessment/doubts/case_doubts.hpp"
#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/assessment/tests/found_limit.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/solvers/particles/expected_speed.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::model_limits_test {
namespace {

using std::numbers::pi;

TEST(ModelLimits, SayNumberLimitAndSource) {
  const std::string text =
      limit_text({"something", 0.08, 0.02, "of the wave's amplitude in each period", "Someone"});
  EXPECT_EQ(text, "something: 8 % of the wave's amplitude in each period, limit 2 % (Someone)");
}

TEST(ModelLimits, HaveTheEffectsOfEveryPart) {
  const CaseDefinition definition = violent_case({InterFoamRun{.cells_x = 20, .cells_z = 20}});
  for (const char* effect : {"the friction at walls", "the gap walls", "surface tension",
                             "the compression of trapped air"})
    EXPECT_TRUE(found_limit(definition, effect)) << effect;
}

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

TEST(GapLimits, HaveTheAddedMassOfPoiseuilleFlowInAThinGapAndLeaveItToRunsThatHaveIt) {
  EXPECT_NEAR(found_limit(rolling_tank(1, 4, plane_mesh), added_mass)->value, 0.2, 1e-4);
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

TEST(SurfaceTensionLimits, HaveSurfaceTensionInSmallTanks) {
  CaseDefinition definition = case_with_runs({});
  EXPECT_FALSE(found_limit(definition, "surface tension")->exceeded());
  definition.tank.length = 0.1;
  EXPECT_TRUE(found_limit(definition, "surface tension")->exceeded());
  definition.gravity = 0;
  EXPECT_FALSE(found_limit(definition, "surface tension"));
}

TEST(SurfaceTensionLimits, CompareTheCapillaryPressureAcrossTheGapWithTheWave) {
  CaseDefinition definition = case_with_runs({});
  const std::string across = "the capillary pressure between the gap walls";
  EXPECT_FALSE(found_limit(definition, across)) << "the breadth is unknown";
  definition.tank.breadth = 0.05;
  definition.motion = {};
  EXPECT_FALSE(found_limit(definition, across)) << "nothing moves";
  definition.initial_wave = InitialWaveDefinition{.mode = 1, .amplitude = -0.05};
  const auto high = found_limit(definition, across);
  ASSERT_TRUE(high);
  EXPECT_NEAR(high->value, 2 * 0.073 / 0.05 / (1000 * 9.81 * 0.05), 1e-12);
  // A wave that loses 2 % in a period.
  EXPECT_NEAR(8 / pi * high->limit, 0.02, 1e-12);
  EXPECT_FALSE(high->exceeded());
  definition.initial_wave->amplitude = 0.005;
  EXPECT_TRUE(found_limit(definition, across)->exceeded());
}

TEST(SurfaceTensionLimits, KnowTheWavesThatTheMotionOfTheTankForces) {
  CaseDefinition definition = case_with_runs({});  // at 0.3 times the first natural frequency
  const double tilt = 0.02 * std::pow(0.3 * 4.94488, 2) / 9.81;
  EXPECT_NEAR(wave_height(definition), tilt / 2 / (1 - 0.09), 1e-5);
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 4.94488};
  const double speed = expected_speed(definition);
  EXPECT_NEAR(wave_height(definition), speed * speed / (2 * 9.81), 1e-12) << "it breaks";
  definition.gravity = 0;
  EXPECT_EQ(wave_height(definition), 0);
}

TEST(SurfaceTensionLimits, HaveTheWeberNumberOfTheSmallestDropsInAnImpact) {
  const std::string drops = "surface tension on the smallest drops";
  EXPECT_FALSE(found_limit(case_with_runs({SphRun{"recommended", 0.004, 0.004}}), drops));
  CaseDefinition definition = violent_case({SphRun{"recommended", 0.004, 0.004}});
  const double speed = expected_speed(definition);
  const auto coarse = found_limit(definition, drops);
  ASSERT_TRUE(coarse);
  EXPECT_NEAR(1 / coarse->value, 1000 * speed * speed * 0.004 / 0.073, 1e-9);
  EXPECT_FALSE(coarse->exceeded());
  definition.runs.push_back(sample_run(InterFoamRun{.cells_x = 10000, .cells_z = 5000}));
  definition.runs.back().name = "fine_mesh";
  const auto fine = found_limit(definition, drops);
  EXPECT_NEAR(fine->value / coarse->value, 0.004 / 0.0001, 1e-9);
  EXPECT_TRUE(fine->exceeded());
  EXPECT_NE(fine->effect.find("fine_mesh has, of 0.1 mm"), std::string::npos) << fine->effect;
}

constexpr const char* gas = "the gas above the liquid";

CaseDefinition under_gas(double density,
                         const std::vector<decltype(RunDefinition::solver)>& solvers) {
  CaseDefinition definition = case_with_runs(solvers);
  definition.gas = air;
  definition.gas.density = density;
  return definition;
}

// An oil of 870 kg/m3 above water: the inertia of both layers and the weight of the difference.
TEST(GasLimits, TellTheFrequencyUnderAHeavyGasFromThatUnderAir) {
  const SphRun sph{"recommended", 0.01, 0.01};
  const CaseDefinition oil = under_gas(870, {sph});
  const auto heavy = found_limit(oil, gas);
  ASSERT_TRUE(heavy);
  const double k = pi / oil.tank.length, h = oil.liquid.fill_depth, height = oil.tank.height - h;
  const double inertia = 1000 / std::tanh(k * h) + 870 / std::tanh(k * height);
  EXPECT_NEAR(heavy->value, 1 - std::sqrt(130 / inertia / std::tanh(k * h)), 1e-12);
  EXPECT_TRUE(heavy->exceeded());
  bool doubted = false;
  for (const std::string& doubt : case_doubts(oil, {}))
    doubted |= doubt.find(gas) != std::string::npos;
  EXPECT_TRUE(doubted);
  EXPECT_FALSE(found_limit(under_gas(1.2, {sph}), gas)->exceeded());
}

TEST(GasLimits, NameTheRunsThatKnowTheLiquidAloneAndNeedGravity) {
  const LinearRun one_layer{.modes = 10, .valid_elevation_over_depth = 0.1},
      two_layers{.modes = 10, .two_layer = true, .valid_elevation_over_depth = 0.1};
  EXPECT_TRUE(found_limit(under_gas(870, {PotentialRun{}}), gas));
  EXPECT_FALSE(
      found_limit(under_gas(870, {two_layers, InterFoamRun{.cells_x = 90, .cells_z = 51}}), gas));
  CaseDefinition definition = under_gas(870, {one_layer});
  EXPECT_TRUE(found_limit(definition, gas));
  definition.gravity = 0;
  EXPECT_FALSE(found_limit(definition, gas));
}

TEST(GasLimits, TellThatSphLeavesARoofAtOnceWhereItsLiquidComesThere) {
  const SphRun sph{"recommended", 0.01, 0.01};
  constexpr const char* roof = "the gas that must follow where the liquid leaves the roof";
  CaseDefinition definition = violent_case({sph, InterFoamRun{.cells_x = 90, .cells_z = 51}});
  definition.gauges = {{"right", 0.95}};
  definition.tank.height = definition.liquid.fill_depth + 0.05;
  const auto expected = found_limit(definition, roof);
  ASSERT_TRUE(expected);
  const double front = 0.542 * std::sqrt(9.81 * definition.tank.height);
  EXPECT_NEAR(expected->value, definition.tank.length / front * 4.94488 / (2 * pi), 1e-9);
  EXPECT_NE(expected->effect.find(fmt::format("at {:.3g} m/s", front)), std::string::npos);
  EXPECT_TRUE(expected->effect.ends_with("in " + definition.runs[0].name));
  CaseRuns runs;
  RunResult& result = runs.results[definition.runs[0].name];
  result.series = {{"highest_surface@right", "m", {0, 1}, {0, 0.03}}};
  EXPECT_FALSE(found_limit(definition, roof, runs)) << "it stays below";
  result.series[0].value[1] = 0.045;
  EXPECT_TRUE(found_limit(definition, roof, runs)->exceeded());
}

CaseDefinition with_gauge_on_roof() { return violent_case({SphRun{"recommended", 0.01, 0.01}}); }

TimeSeries pressures(const std::string& name, std::vector<double> values) {
  TimeSeries series{.name = name, .unit = "Pa", .time = {}, .value = std::move(values)};
  for (std::size_t i = 0; i < series.value.size(); ++i)
    series.time.push_back(0.02 * static_cast<double>(i));
  return series;
}

const std::string trapped = "the compression of trapped air";

TEST(CompressionLimits, HaveTheAirOfDeclaredImpacts) {
  CaseDefinition definition = case_with_runs({});
  EXPECT_FALSE(found_limit(definition, "trapped air"));
  definition.impacts.emplace();
  definition.impacts->peak_means = {3000, 5000};
  EXPECT_NEAR(found_limit(definition, "trapped air")->value, 5000 / 101325.0, 1e-12);
  EXPECT_FALSE(found_limit(definition, "trapped air")->exceeded());
  definition.impacts->peak_means = {30000};
  EXPECT_TRUE(found_limit(definition, "trapped air")->exceeded());
}

TEST(CompressionLimits, EstimateTheImpactsOfACaseThatDeclaresNone) {
  CaseDefinition definition = with_gauge_on_roof();
  const double speed = std::sqrt(9.81 * 0.35) + 0.02 * 4.94488;
  const auto limit = found_limit(definition, trapped);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->value, 4 * 1000 * speed * speed / 101325, 1e-9);
  EXPECT_TRUE(limit->exceeded());
  EXPECT_EQ(limit->effect,
            "the compression of trapped air by impacts of an assumed 4 rho V^2, the highest of "
            "SPHERIC's benchmark 10, at the expected speed V = 2 m/s, sqrt(g h) plus the tank's "
            "largest speed");
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 0.3 * 4.94488};
  EXPECT_FALSE(found_limit(definition, trapped)) << "the waves are 2 mm high";
  definition.liquid.fill_depth = definition.tank.height - 0.001;
  EXPECT_TRUE(found_limit(definition, trapped)) << "they reach the roof";
  definition = with_gauge_on_roof();
  definition.pressure_gauges = {{.name = "A", .wall = Wall::left, .position = 0.1}};
  EXPECT_FALSE(found_limit(definition, trapped)) << "the gauge is under the still level";
}

TEST(CompressionLimits, TakeTheHighestRecordedPressureThroughTheFilterInPlaceOfTheEstimate) {
  CaseDefinition definition = with_gauge_on_roof();
  CaseRuns runs;
  runs.results["calm"].series = {pressures("wall_pressure@R", {0, 500, 0})};
  runs.results["violent"].series = {pressures("wall_pressure@R", {0, 70000, 0}),
                                    pressures("wall_pressure@R/filtered", {0, 6000, 0})};
  const auto limit = found_limit(definition, trapped, runs);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->value, 70000 / 101325.0, 1e-12);
  EXPECT_TRUE(holds(limit->effect, "the highest wall_pressure@R recorded, 70 kPa of violent"));
  definition.pressure_gauges[0].filter_cutoff = 100;
  EXPECT_NEAR(found_limit(definition, trapped, runs)->value, 6000 / 101325.0, 1e-12);
  definition.impacts.emplace();
  definition.impacts->peak_means = {5000};
  EXPECT_NEAR(found_limit(definition, trapped, runs)->value, 5000 / 101325.0, 1e-12)
      << "the experiment knows better";
}

TEST(CompressionLimits, HaveTheCompressibilityOfRunsWithASlowSoundAndWithoutAResult) {
  SphRun soft{"recommended", 0.01, 0.01};
  EXPECT_FALSE(found_limit(case_with_runs({soft}), "compressibility"));
  soft.numbers.sound_speed_ratio = 10;
  EXPECT_FALSE(found_limit(case_with_runs({soft}), "compressibility")->exceeded());
  soft.numbers.sound_speed_ratio = 5;
  const CaseDefinition definition = case_with_runs({soft});
  EXPECT_TRUE(found_limit(definition, "compressibility")->exceeded());
  CaseRuns runs;
  runs.results[definition.runs.back().name] = {};
  EXPECT_FALSE(found_limit(definition, "compressibility", runs)) << "its soundness tells";
}

}  // namespace
}  // namespace slosh::model_limits_test
