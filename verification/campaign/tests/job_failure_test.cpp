#include <gtest/gtest.h>

#include <fstream>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::job_failure_test {
namespace {

JobState ended(JobPhase phase) {
  JobState state;
  state.job.log_file = "/nowhere/run.log";
  state.phase = phase;
  state.message = "see ninja.log";
  return state;
}

TEST(JobFailure, IsNoneOfAJobThatNeverStarted) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "run.failure.json";
  const RunStatus status = status_without_result(ended(JobPhase::not_started), file);
  EXPECT_EQ(status.state, RunState::missing);
  EXPECT_EQ(status.message, "not started: see ninja.log");
  EXPECT_FALSE(status.failure);
  EXPECT_FALSE(std::filesystem::exists(file)) << "a later report would call it failed";
}

TEST(JobFailure, IsKeptOfAJobThatWasLost) {
  const TemporaryDirectory directory;
  CampaignSettings settings;
  settings.store = ResultStore(directory.path());
  const std::string key = "question-answer";
  const auto file = settings.store.file(key, failure_extension);
  const RunStatus status = status_without_result(ended(JobPhase::lost), file);
  EXPECT_EQ(status.state, RunState::failed);
  EXPECT_EQ(status.failure.value().kind, "lost");
  EXPECT_EQ(read_failure(file).value().kind, "lost");
  std::ofstream(settings.store.file(key, ".h5")) << "an older result of the key";
  std::ofstream(settings.store.file("question-other", ".h5")) << "another build's";
  const auto state = [&] { return standing_result(key, ".h5", settings).status.state; };
  EXPECT_EQ(state(), RunState::missing) << "tried again";
  settings.solve = false;
  EXPECT_EQ(state(), RunState::failed);
  std::ofstream(file) << "what it was cannot be read";
  EXPECT_EQ(state(), RunState::failed);
  std::filesystem::remove(file);
  EXPECT_EQ(state(), RunState::finished);
}

}  // namespace
}  // namespace slosh::job_failure_test
