#include "sph/scheme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "sph/schemes.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::scheme_test {
namespace {

constexpr double dp = 0.025;

TEST(ExpectedSpeed, IsTheLongWavesPlusTheTanksLargest) {
  const double wave = std::sqrt(9.81 * 0.35);
  EXPECT_NEAR(expected_speed(still_scene(dp, 2)), wave, 1e-12);
  EXPECT_NEAR(expected_speed(surging_scene(dp, 2)), wave + 0.02 * surge_frequency, 1e-12);
}

TEST(ExpectedSpeed, IsThatOfStillWaterWhereTheTankAndTheLiquidMoveTogether) {
  const double wave = std::sqrt(9.81 * 0.35);
  Scene scene = carried_scene(dp, 2, -15);
  EXPECT_NEAR(expected_speed(scene), wave, 1e-12);
  scene.velocity = [](double t) { return t > 1 ? -13.0 : -15.0; };
  EXPECT_NEAR(expected_speed(scene), wave + 2, 1e-12) << "as much as it brakes";
  scene.start = Start::earth;
  EXPECT_NEAR(expected_speed(scene), wave + 15, 1e-12) << "the walls strike liquid at rest";
}

TEST(ExpectedSpeed, IsTwiceTheLongWavesWhereADamBreaks) {
  Scene dam = still_scene(dp, 2);
  dam.column_width = 0.2;
  EXPECT_NEAR(expected_speed(dam), 2 * std::sqrt(9.81 * 0.35), 1e-12);
}

TEST(ExpectedSpeed, CountsASpeedThatTheTankReachesOnlyAtTheEnd) {
  Scene scene = still_scene(dp, 2);
  scene.velocity = [](double t) { return t > 1.985 ? -3.0 : 0.0; };
  EXPECT_NEAR(expected_speed(scene), std::sqrt(9.81 * 0.35) + 3, 1e-12);
}

// The mean pressure of the still liquid is rho g h / 2, and compresses it by g h / (2 c0^2).
TEST(SettingOf, LowersTheDensityWithoutPressureByTheMeanCompression) {
  const Scene scene = still_scene(dp, 1);
  const double sound = 10 * std::sqrt(9.81 * 0.35);
  EXPECT_NEAR(setting_of(scene, Recommended::numbers).rest_density,
              1000 / (1 + 9.81 * 0.175 / (sound * sound)), 1e-9);
  Scene weightless = still_scene(dp, 1);
  weightless.gravity = 0;
  EXPECT_EQ(setting_of(weightless, Recommended::numbers).rest_density, 1000);
}

TEST(SettingOf, TakesTheSchemesOwnNumbersWhereTheRunChangesNone) {
  const Scene scene = still_scene(dp, 1);
  const Setting recommended = setting_of(scene, Recommended::numbers);
  EXPECT_EQ(recommended.smoothing_length_ratio, 1.5);
  EXPECT_NEAR(recommended.smoothing_length(), 1.5 * dp, 1e-15);
  EXPECT_NEAR(recommended.speed_of_sound, 10 * expected_speed(scene), 1e-12);
  EXPECT_EQ(recommended.courant_number, 0.8);
  EXPECT_EQ(recommended.artificial_viscosity, 0.0005);
  EXPECT_EQ(recommended.density_diffusion, 0.05);
  const Setting delta_sph = setting_of(scene, DeltaSph::numbers);
  EXPECT_EQ(delta_sph.smoothing_length_ratio, 2);
  EXPECT_EQ(delta_sph.artificial_viscosity, 0.02);
  EXPECT_EQ(delta_sph.density_diffusion, 0.1);
  EXPECT_EQ(setting_of(scene, Li2010::numbers).artificial_viscosity, 1);
}

TEST(SettingOf, TakesEachNumberThatTheRunChanges) {
  Scene scene = still_scene(dp, 1);
  scene.numbers = {.smoothing_length_ratio = 1.7,
                   .sound_speed_ratio = 15,
                   .courant_number = 0.3,
                   .artificial_viscosity = 0,
                   .density_diffusion = 0.2};
  const Setting setting = setting_of(scene, Recommended::numbers);
  EXPECT_EQ(setting.smoothing_length_ratio, 1.7);
  EXPECT_NEAR(setting.speed_of_sound, 15 * expected_speed(scene), 1e-12);
  EXPECT_EQ(setting.courant_number, 0.3);
  EXPECT_EQ(setting.artificial_viscosity, 0);
  EXPECT_EQ(setting.density_diffusion, 0.2);
}

TEST(SettingOf, TakesTheScenesConstants) {
  Scene scene = still_scene(0.02, 1);
  scene.gravity = 3.7;
  scene.rest_density = 850;
  scene.kinematic_viscosity = 2e-6;
  const Setting setting = setting_of(scene, Recommended::numbers);
  EXPECT_EQ(setting.gravity, 3.7);
  EXPECT_EQ(setting.fill_depth, 0.35);
  EXPECT_NEAR(setting.rest_density, 850 / 1.005, 1e-9);  // c0^2 = 100 g h
  EXPECT_EQ(setting.kinematic_viscosity, 2e-6);
  EXPECT_EQ(setting.particle_spacing, 0.02);
  EXPECT_NEAR(setting.flattest_cell, 17.5 / 18, 1e-12);
}

struct Unwanted {
  const char* name;
  std::optional<double> SchemeNumbers::*number;
  std::string scheme, variant;
};

class NumberThatTheSchemeLacks : public testing::TestWithParam<Unwanted> {};
INSTANTIATE_TEST_SUITE_P(
    Of, NumberThatTheSchemeLacks,
    testing::Values(Unwanted{"courant_number", &SchemeNumbers::courant_number, "li2010", ""},
                    Unwanted{"density_diffusion", &SchemeNumbers::density_diffusion, "li2010", ""},
                    Unwanted{"artificial_viscosity", &SchemeNumbers::artificial_viscosity,
                             "recommended", "no_viscosity"},
                    Unwanted{"artificial_viscosity", &SchemeNumbers::artificial_viscosity,
                             "recommended", "laminar_viscosity"},
                    Unwanted{"density_diffusion", &SchemeNumbers::density_diffusion, "recommended",
                             "no_diffusion"}),
    [](const auto& unwanted) {
      return unwanted.param.scheme + "_" + unwanted.param.variant + "_" + unwanted.param.name;
    });

TEST_P(NumberThatTheSchemeLacks, IsRefusedWithItsNameAndValue) {
  Scene scene = still_scene(dp, 0.02);
  scene.variant = GetParam().variant;
  scene.numbers.*GetParam().number = 0.125;
  const std::string what =
      message_of<std::invalid_argument>([&] { run(GetParam().scheme, scene, {}); });
  EXPECT_TRUE(slosh::holds(what, std::string(GetParam().name) + " = 0.125"));
  EXPECT_TRUE(slosh::holds(what, "expected none"));
}

TEST(Scheme, ListsTheTermsThatItComputesAndNoOthers) {
  const auto count = [](const std::vector<std::string>& terms) {
    return std::set<std::string>(terms.begin(), terms.end()).size();
  };
  // Kernel, smoothing, formulation, viscosity, diffusion, state, mirror, solids, contact,
  // integrator.
  EXPECT_EQ(count(active_terms<Recommended>()), 11);
  EXPECT_EQ(count(active_terms<WithoutViscosity>()), 10);
  EXPECT_EQ(count(active_terms<WithoutDiffusion>()), 10);
  EXPECT_EQ(count(active_terms<WithGhostWalls>()), 10);
  EXPECT_EQ(count(active_terms<Li2010>()), 9);
}

std::string refusal(const std::string& scheme, const std::string& variant) {
  Scene scene = still_scene(dp, 0.02);
  scene.variant = variant;
  return message_of<std::invalid_argument>([&] { run(scheme, scene, {}); });
}

TEST(Simulation, RefusesAVariantThatItDoesNotHave) {
  const std::string what = refusal("recommended", "wendland_c3");
  EXPECT_TRUE(slosh::holds(what, "variant = \"wendland_c3\": expected one of"));
  for (const std::string& name : variant_names())
    EXPECT_TRUE(slosh::holds(what, name)) << name << " is not in " << what;
}

TEST(Simulation, RefusesAVariantOfASchemeThatHasNone) {
  for (const char* scheme : {"li2010", "delta_sph"}) {
    const std::string what = refusal(scheme, "wendland_c2");
    EXPECT_TRUE(slosh::holds(what, "variant = \"wendland_c2\": expected none"));
  }
}

TEST(Simulation, NamesTheVariantsThatRollWhereItRefusesAnother) {
  Scene scene = still_scene(0.05, 0);
  scene.roll = no_roll();
  const auto refusal_of = [&](const std::string& variant) -> std::string {
    scene.variant = variant;
    return message_of<std::invalid_argument>([&] { run("recommended", scene, {}); });
  };
  const std::string what = refusal_of("verlet");
  EXPECT_TRUE(begins(what, "motion.roll: expected none with this variant"));
  const std::string names = what.substr(what.rfind(" with "));
  for (const std::string& variant : variant_names())
    EXPECT_EQ(names.find(" " + variant) == std::string::npos, !refusal_of(variant).empty())
        << variant;
}

TEST(Simulation, HasTwentySixVariantsOfTheRecommendedScheme) {
  EXPECT_EQ(variant_names().size(), 26);
  EXPECT_EQ(scheme_names().size(), 5);
}

}  // namespace
}  // namespace slosh::sph::scheme_test
