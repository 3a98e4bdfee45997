#include <gtest/gtest.h>

#include "verification/engine/job_list.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::watch_test {
namespace {

// The states of two jobs of which the first has begun, after their engine has ended.
std::vector<JobState> after_the_engine(bool stopped) {
  const TemporaryDirectory directory;
  const auto job = [](const char* name) {
    return Job{.name = name, .command = {}, .log_file = {}};
  };
  const JobList list = JobList::create(directory.path(), {job("begun"), job("waiting")});
  const ObserveJobs observe = [](const std::vector<JobState>&) {};
  Watch watch(list, observe);
  list.mark_started(0);
  return watch.finish(stopped, "see ninja.log");
}

TEST(Watch, TellsAJobThatWasLostFromOneThatNeverStarted) {
  const std::vector<JobState> states = after_the_engine(false);
  EXPECT_EQ(states[0].phase, JobPhase::lost);
  EXPECT_EQ(description(states[0]), "left no word of its end: see ninja.log");
  EXPECT_EQ(states[1].phase, JobPhase::not_started);
  EXPECT_EQ(description(states[1]), "not started: see ninja.log");
}

TEST(Watch, CallsAllJobsInterruptedWhereTheUserStoppedThem) {
  for (const JobState& state : after_the_engine(true))
    EXPECT_EQ(state.phase, JobPhase::interrupted) << state.job.name;
}

}  // namespace
}  // namespace slosh::watch_test
