#include "verification/case/changed_input.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "verification/case/motion.hpp"

namespace slosh::changed_input_test {
namespace {

CaseDefinition of_two_sines() {
  CaseDefinition definition{};
  definition.motion.surge = SumOfSines{{SineMotion{0.03, 2, 0, 0.5}, SineMotion{0.01, 5, 1}}};
  return definition;
}

TEST(ChangedInput, RaisesTheAmplitudeOfASumAndKeepsTheSharesOfItsSines) {
  const CaseDefinition raised = with_input(of_two_sines(), Input::amplitude, 0.004);
  const std::vector<SineMotion> sines = sines_of(*raised.motion.surge);
  EXPECT_DOUBLE_EQ(sines.at(0).amplitude, 0.033);
  EXPECT_DOUBLE_EQ(sines.at(1).amplitude, 0.011);
  EXPECT_EQ(sines.at(0).phase, 0.5);
}

TEST(ChangedInput, RaisesEveryValueOfATableByTheShareOfItsLargest) {
  CaseDefinition definition{};
  definition.motion.surge = TableMotion{"a.csv", {0, 1, 2, 3}, {0, 0.1, -0.2, 0}};
  const CaseDefinition raised = with_input(definition, Input::amplitude, 0.02);
  EXPECT_DOUBLE_EQ(std::get<TableMotion>(*raised.motion.surge).value[1], 0.11);
  EXPECT_DOUBLE_EQ(std::get<TableMotion>(*raised.motion.surge).value[2], -0.22);
}

TEST(ChangedInput, StartsEverySineElsewhereInItsPeriod) {
  const CaseDefinition later = with_input(of_two_sines(), Input::start_phase, 90);
  const std::vector<SineMotion> sines = sines_of(*later.motion.surge);
  EXPECT_DOUBLE_EQ(sines.at(0).phase, 0.5 + std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(sines.at(1).phase, std::numbers::pi / 2);
  CaseDefinition rolling{};
  rolling.motion.roll = RollDefinition{SineMotion{0.07, 3.8}, 0.45, 0};
  const RollMotion roll = *roll_motion(with_input(rolling, Input::start_phase, 90));
  EXPECT_NEAR(roll.angle(0), 0.07, 1e-15);
  EXPECT_NEAR(roll.rate(0), 0, 1e-15);
  rolling.motion.roll->angle = TableMotion{};
  EXPECT_THROW(with_input(rolling, Input::start_phase, 1), std::logic_error);
}

TEST(ChangedInput, StretchesEverySineThatSharesThePeriod) {
  CaseDefinition definition{};
  definition.motion.surge = SumOfSines{{SineMotion{0.03, 2}, SineMotion{0.01, 2, 0, 1.5}}};
  const CaseDefinition slower = with_input(definition, Input::period, 0.1);
  const double stretched = 2 / (1 + 0.1 / 3.14159265358979);
  for (const SineMotion& sine : sines_of(*slower.motion.surge))
    EXPECT_NEAR(sine.angular_frequency, stretched, 1e-12);
}

}  // namespace
}  // namespace slosh::changed_input_test
