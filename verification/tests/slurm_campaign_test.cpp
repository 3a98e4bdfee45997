// A campaign on Slurm: the same results to the last bit as on this machine.
#include <gtest/gtest.h>

#include "verification/results/result_file.hpp"
#include "verification/tests/slurm_cluster.hpp"

namespace slosh::slurm_campaign_test {
namespace {

namespace fs = std::filesystem;

TEST_F(SlurmCampaign, GivesTheSameBitsAsThisMachine) {
  const Ended slurm = tool(on_slurm(), environment());
  ASSERT_EQ(slurm.status, 0) << slurm.err;
  EXPECT_EQ(files_of_store(".h5").size(), all_runs);
  const Ended local =
      tool({"campaign", "./surges.toml", "--output", "local", "--store", "local/store"});
  ASSERT_EQ(local.status, 0) << local.err;
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(directory() / "local/runs/small")) {
    if (entry.path().extension() != ".h5") continue;
    const RunResult here = read_result(entry.path()),
                    there = read_result(result(entry.path().stem().string()));
    ASSERT_EQ(here.series.size(), there.series.size());
    for (const TimeSeries& series : here.series) {
      EXPECT_EQ(series.time, there.at(series.name).time) << entry.path() << series.name;
      EXPECT_EQ(series.value, there.at(series.name).value) << entry.path() << series.name;
    }
    ++compared;
  }
  EXPECT_EQ(compared, all_runs);
  EXPECT_EQ(tool(on_slurm(), environment()).err, "") << "and nothing is computed twice";
}

}  // namespace
}  // namespace slosh::slurm_campaign_test
