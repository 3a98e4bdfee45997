// A campaign on Slurm of which a job, the tool and the controller are killed in the middle: nothing
// is lost or computed twice.
#include <gtest/gtest.h>

#include "verification/results/result_file.hpp"
#include "verification/tests/slurm_cluster.hpp"

namespace slosh::slurm_faults_test {
namespace {

TEST_F(SlurmCampaign, LosesAndRepeatsNothingWhereAJobTheToolAndTheControllerAreKilled) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  ASSERT_TRUE(comes_true([&] { return files_of_store(".h5").size() >= 5; }, patience));
  ASSERT_TRUE(comes_true([&] { return cancel_one_task(); }, patience));
  ASSERT_EQ(node({"kill-controller", node_.string()}), 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));  // the tool asks a controller that is dead
  EXPECT_TRUE(child.running());
  kill(child.id(), SIGKILL);
  end_of(std::move(child));
  const auto before = written();
  ASSERT_LT(before.size(), all_runs);
  ASSERT_EQ(node({"start-controller", node_.string()}), 0);

  std::vector<std::string> resumed = on_slurm();
  resumed.push_back("--resume");
  auto second = start(SLOSH_TOOL, resumed, environment());
  while (second.running()) {  // as the cluster's administrator would
    node({"resume-node", node_.string()});
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  const Ended again = end_of(std::move(second));
  EXPECT_EQ(again.status, 0) << again.err;
  const auto after = written();
  EXPECT_EQ(after.size(), all_runs);
  for (const auto& [file, time] : before) EXPECT_EQ(after.at(file), time) << file;
  EXPECT_TRUE(files_of_store(".partial").empty());
}

TEST_F(SlurmCampaign, EndsItsJobsWhereItIsInterrupted) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  ASSERT_TRUE(comes_true([&] { return files_of_store(".h5").size() >= 3; }, patience));
  kill(child.id(), SIGINT);
  const Ended ended = end_of(std::move(child));
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_TRUE(comes_true([&] { return !cancel_one_task(); }, patience))
      << "tasks are left in the queue";
  EXPECT_LT(files_of_store(".h5").size(), all_runs);
}

TEST_F(SlurmCampaign, SaysWhatSlurmDidToAJobThatWasCancelled) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  // The theory, without which nothing is compared, comes first.
  ASSERT_TRUE(
      comes_true([&] { return !files_of_store(".h5").empty() && cancel_one_task(); }, patience));
  const Ended ended = end_of(std::move(child));
  EXPECT_EQ(ended.status, 3) << ended.err;
  EXPECT_NE(ended.err.find("failed   small/"), std::string::npos) << ended.err;
  EXPECT_EQ(files_of_store(".h5").size(), all_runs - 1);
  const Ended again = tool(on_slurm(), environment());
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(files_of_store(".h5").size(), all_runs);
}

}  // namespace
}  // namespace slosh::slurm_faults_test
