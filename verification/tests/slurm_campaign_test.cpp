// A campaign on Slurm: the same results to the last bit as on this machine.
#include <gtest/gtest.h>

#include "verification/results/result_file.hpp"
#include "verification/tests/slurm_cluster.hpp"

namespace slosh::slurm_campaign_test {
namespace {

namespace fs = std::filesystem;

// Of the sweep's runs eight are enough: Slurm takes a second to start one.
TEST_F(SlurmCampaign, GivesTheSameBitsAsThisMachine) {
  const std::string all = read("surges.toml");
  write("surges.toml", with(with(all, R"(["wendland_c2", "linear_state", "gamma_3", "gamma_5"])",
                                 R"(["wendland_c2"])"),
                            "[0.2, 0.25, 0.3, 0.35]", "[0.2, 0.35]"));
  constexpr std::size_t runs = 2 * 4 + 2;
  const Ended slurm = tool(on_slurm(), environment());
  ASSERT_EQ(slurm.status, 0) << slurm.err;
  EXPECT_EQ(files_of_store(".h5").size(), runs);
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
  EXPECT_EQ(compared, runs);
  EXPECT_EQ(tool(on_slurm(), environment()).err, "") << "and nothing is computed twice";
}

}  // namespace
}  // namespace slosh::slurm_campaign_test
