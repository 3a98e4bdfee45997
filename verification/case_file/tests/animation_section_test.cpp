// [animation] of a case file: its times, and what is refused.
#include <gtest/gtest.h>

#include "verification/case/field_times.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::animation_section_test {
namespace {

std::string animated(const std::string& begin, const std::string& end,
                     const std::string& interval) {
  return valid_text + "[animation]\nbegin_s = " + begin + "\nend_s = " + end +
         "\ninterval_s = " + interval + "\n";
}

TEST(AnimationSection, IsEvenlySpacedMomentsWithBothEnds) {
  const CaseDefinition definition = read_text(animated("18.7", "20", "0.05"));
  ASSERT_EQ(definition.animation_times.size(), 27u);
  EXPECT_NEAR(definition.animation_times.front(), 18.7, 1e-12);
  EXPECT_NEAR(definition.animation_times[1], 18.75, 1e-12);
  EXPECT_NEAR(definition.animation_times.back(), 20, 1e-12);
  EXPECT_TRUE(read_text(valid_text).animation_times.empty());
}

TEST(AnimationSection, Is3To60MultiplesOfTheSampleIntervalInsideTheCase) {
  EXPECT_EQ(read_text(animated("1", "2.18", "0.02")).animation_times.size(), 60u);
  expect_refusals(animated("18", "20", "0.1"), R"(
animation.begin_s = 18.705: expected a number > 0 and <= the duration (20), a multiple of
  sample_interval_s (0.01), in s
animation.end_s = 20.1: expected
animation.interval_s = 0: expected
animation.interval_s = nan: expected
animation.every = 2: expected
animation.interval_s = 0.02: expected a number that gives 3 to 60 times
animation.begin_s = 19.5 & animation.interval_s = 0.3: expected a number that gives 3 to 60 times
animation.end_s = 17 -> animation.interval_s = 0.1: expected a number that gives 3 to 60 times
)");
}

TEST(FieldTimes, AreSnapshotsAndMomentsEachOnce) {
  CaseDefinition definition{};
  definition.sample_interval = 0.01;
  definition.snapshot_times = {0.5, 0.95, 2};
  definition.animation_times = {0.9, 0.95 + 1e-12, 1};
  EXPECT_EQ(field_times(definition), (std::vector<double>{0.5, 0.9, 0.95, 1, 2}));
}

}  // namespace
}  // namespace slosh::animation_section_test
