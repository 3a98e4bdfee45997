#include "verification/case/changed_input.hpp"

#include <gtest/gtest.h>

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
