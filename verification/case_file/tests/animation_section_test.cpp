// [animation] of a case file: its times, and what is refused.
#include <gtest/gtest.h>

#include "verification/case/field_times.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::animation_section_test {
namespace {

std::string animated(const std::string& begin, const std::string& end,
                     const std::string& interval) {
  return valid_text + "[animation]\nbegin_s = " + begin + "\nend_s = " + end +
         "\ninterval_s = " + interval + "\n";
}

CaseDefinition read(const std::string& text) {
  const Workspace workspace;
  return read_case(workspace.write("trial.toml", text));
}

std::string complaint_about(const std::string& text) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text));
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(AnimationSection, IsEvenlySpacedMomentsWithBothEnds) {
  const CaseDefinition definition = read(animated("18.7", "20", "0.05"));
  ASSERT_EQ(definition.animation_times.size(), 27u);
  EXPECT_NEAR(definition.animation_times.front(), 18.7, 1e-12);
  EXPECT_NEAR(definition.animation_times[1], 18.75, 1e-12);
  EXPECT_NEAR(definition.animation_times.back(), 20, 1e-12);
  EXPECT_TRUE(read(valid_text).animation_times.empty());
}

TEST(AnimationSection, NeedsMultiplesOfTheSampleIntervalInsideTheCase) {
  EXPECT_TRUE(holds(complaint_about(animated("18.705", "20", "0.05")),
                    "animation.begin_s = 18.705: expected a number > 0 and <= the duration (20), a "
                    "multiple of sample_interval_s (0.01), in s"));
  EXPECT_TRUE(holds(complaint_about(animated("18", "20.1", "0.05")), "animation.end_s = 20.1:"));
  EXPECT_TRUE(holds(complaint_about(animated("18", "20", "0")), "animation.interval_s = 0:"));
  EXPECT_TRUE(holds(complaint_about(animated("18", "20", "nan")), "animation.interval_s = nan:"));
  EXPECT_TRUE(holds(complaint_about(animated("18", "20", "0.1") + "every = 2\n"), "every"));
}

TEST(AnimationSection, Is3To60Times) {
  EXPECT_EQ(read(animated("1", "2.18", "0.02")).animation_times.size(), 60u);
  const std::string many = complaint_about(animated("1", "2.2", "0.02")),
                    few = complaint_about(animated("1", "1.5", "0.3")),
                    backwards = complaint_about(animated("2", "1", "0.1"));
  for (const std::string& text : {many, few, backwards})
    EXPECT_TRUE(holds(text, "expected a number that gives 3 to 60 times")) << text;
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
