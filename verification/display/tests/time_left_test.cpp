#include "verification/display/time_left.hpp"

#include <gtest/gtest.h>

namespace slosh::time_left_test {
namespace {

JobState job(JobPhase phase, double expected, double wall = 0) {
  JobState state;
  state.phase = phase;
  state.job.expected_time = expected;
  state.wall_time = wall;
  return state;
}

TEST(TimeLeft, SharesTheCoresAmongTheJobsThatWait) {
  const std::vector<JobState> states(8, job(JobPhase::waiting, 30));
  EXPECT_DOUBLE_EQ(time_left(states, 2).value(), 120);
  EXPECT_DOUBLE_EQ(time_left(states, 100).value(), 30) << "no less than the longest";
}

TEST(TimeLeft, LearnsFromWhatEndedJobsTook) {
  std::vector<JobState> states(11, job(JobPhase::exited, 100, 200));
  states.push_back(job(JobPhase::waiting, 50));
  EXPECT_NEAR(time_left(states, 2).value(), 100, 1);
}

TEST(TimeLeft, LearnsNothingFromAJobThatFailed) {
  JobState failed = job(JobPhase::exited, 100, 1);
  failed.status = 3;
  EXPECT_DOUBLE_EQ(time_left({failed, job(JobPhase::waiting, 50)}, 1).value(), 50);
}

TEST(TimeLeft, BelievesARunningJobsOwnForecastOnceItIsUnderWay) {
  JobState running = job(JobPhase::running, 10, 30);
  running.progress = RunProgress{.time = 5, .end_time = 20, .steps = 1};
  EXPECT_DOUBLE_EQ(time_left({running}, 1).value(), 90);
  running.progress->time = 0.01;
  EXPECT_DOUBLE_EQ(time_left({running}, 1).value(), 0) << "three times its time has gone by";
}

TEST(TimeLeft, AddsTheJobsThatRunAlone) {
  JobState timing = job(JobPhase::waiting, 40);
  timing.job.alone = true;
  EXPECT_DOUBLE_EQ(time_left({job(JobPhase::waiting, 30), timing, timing}, 4).value(), 110);
}

TEST(TimeLeft, CountsAJobOfManyCoresAsThatMany) {
  JobState wide = job(JobPhase::waiting, 60);
  wide.job.cores = 4;
  EXPECT_DOUBLE_EQ(time_left({wide, wide}, 8).value(), 60);
  EXPECT_DOUBLE_EQ(time_left({wide, wide}, 4).value(), 120);
}

TEST(TimeLeft, IsUnknownWhereNothingIsKnownOfAJob) {
  EXPECT_FALSE(time_left({job(JobPhase::waiting, 0)}, 1));
  EXPECT_TRUE(time_left({job(JobPhase::exited, 0)}, 1));
}

TEST(TimeLeft, IsToldInTheUnitThatItHas) {
  EXPECT_EQ(rough_time(41.7), "42 s");
  EXPECT_EQ(rough_time(185), "3 min");
  EXPECT_EQ(rough_time(9000), "2.5 h");
  EXPECT_EQ(clock_time(3750), "1:02:30");
}

}  // namespace
}  // namespace slosh::time_left_test
