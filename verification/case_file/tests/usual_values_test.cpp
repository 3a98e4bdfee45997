// What a case file may leave out, and the three ways to give a frequency.
#include "verification/case/usual_values.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "verification/case_file/tests/refusals.hpp"
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

TEST(CaseFile, NamesBothPropertiesOfALiquidThatIsNotWaterAndTheGasAboveALighterOne) {
  expect_refusals(valid_text, R"(
liquid.density_kg_m3 is missing: expected a number > 0, in kg/m3
liquid.kinematic_viscosity_m2_s is missing: expected
)");
  expect_refusals(without(valid_text, gas),
                  R"(liquid.density_kg_m3 = 1.1 -> gas is missing: expected)");
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
  expect_refusals(valid_text, R"(
motion.surge.period_s = 4: expected exactly one of angular_frequency_rad_s | frequency_Hz | period_s
motion.surge.angular_frequency_rad_s is missing & motion.surge.period_s = 0: expected a number > 0, in
  s
motion.surge.angular_frequency_rad_s is missing: expected
comparison.forcing_period_s = 4: expected no such key without a motion table
)");
}

}  // namespace
}  // namespace slosh::usual_values_test
