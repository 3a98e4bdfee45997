// What a case file may leave out, and the three ways to give a frequency.
#include "verification/case/usual_values.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "verification/tests/trial_case.hpp"

namespace slosh::usual_values_test {
namespace {

const std::string liquid = "density_kg_m3 = 1000.0\nkinematic_viscosity_m2_s = 1e-6\n";
const std::string gas = "[gas]\ndensity_kg_m3 = 1.2\nkinematic_viscosity_m2_s = 1.5e-5\n";
const std::string frequency = "angular_frequency_rad_s = 1.5\n";

std::string without(std::string text, const std::string& part) {
  return text.replace(text.find(part), part.size(), "");
}

double surge_frequency(const std::string& given) {
  return std::get<SineMotion>(*read_text(edited({frequency, given})).motion.surge)
      .angular_frequency;
}

TEST(CaseFile, IsOfWaterUnderAirOnTheEarthUnlessItSaysOtherwise) {
  const std::string bare =
      without(without(without(valid_text, "gravity_m_s2 = 9.81\n"), liquid), gas);
  const CaseDefinition definition = read_text(bare), written = read_text(valid_text);
  EXPECT_EQ(definition.gravity, written.gravity);
  EXPECT_EQ(definition.liquid.density, written.liquid.density);
  EXPECT_EQ(definition.liquid.kinematic_viscosity, written.liquid.kinematic_viscosity);
  EXPECT_EQ(definition.gas.density, written.gas.density);
  EXPECT_EQ(definition.gas.kinematic_viscosity, written.gas.kinematic_viscosity);
}

TEST(CaseFile, NamesBothPropertiesOfALiquidThatIsNotWater) {
  EXPECT_EQ(complaint_about({"density_kg_m3 = 1000.0\n", ""}),
            "trial.toml:10: liquid.density_kg_m3 is missing: expected a number > 0, in kg/m3");
  EXPECT_NE(complaint_about({"kinematic_viscosity_m2_s = 1e-6\n", ""}).find("is missing"),
            std::string::npos);
}

TEST(CaseFile, NamesTheGasAboveALiquidThatIsLighterThanAir) {
  const Workspace workspace;
  std::string text = without(valid_text, gas);
  text.replace(text.find("1000.0"), 6, "1.1");
  EXPECT_NE(complaint(workspace.write("trial.toml", text)).find("gas is missing"),
            std::string::npos);
}

TEST(CaseFile, ComparesToTheEndOfTheRunUnlessItSaysOtherwise) {
  EXPECT_EQ(read_text(edited({"window_end_s = 20.0\n", ""})).window_end, 20);
}

TEST(CaseFile, NeedsNoTags) {
  EXPECT_TRUE(read_text(edited({"tags = [\"surge\"]\n", ""})).tags.empty());
}

TEST(CaseFile, GivesAFrequencyInAnyOfThreeWays) {
  EXPECT_EQ(surge_frequency("angular_frequency_rad_s = 1.5\n"), 1.5);
  EXPECT_DOUBLE_EQ(surge_frequency("period_s = 4\n"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(surge_frequency("frequency_Hz = 0.25\n"), std::numbers::pi / 2);
}

TEST(CaseFile, GivesAFrequencyOnce) {
  EXPECT_EQ(complaint_about({frequency, frequency + "period_s = 4\n"}),
            "trial.toml:21: motion.surge.period_s = 4: expected exactly one of "
            "angular_frequency_rad_s | frequency_Hz | period_s");
  EXPECT_EQ(complaint_about({frequency, "period_s = 0\n"}),
            "trial.toml:20: motion.surge.period_s = 0: expected a number > 0, in s");
  EXPECT_NE(complaint_about({frequency, ""}).find("angular_frequency_rad_s is missing"),
            std::string::npos);
  EXPECT_NE(complaint_about({"natural_modes = 2", "natural_modes = 2\nforcing_period_s = 4"})
                .find("forcing_period_s = 4: expected no such key without a motion table"),
            std::string::npos);
}

}  // namespace
}  // namespace slosh::usual_values_test
