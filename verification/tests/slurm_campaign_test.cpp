// A campaign of more than sixty runs on a real Slurm of one node, as root: the same results to the
// last bit as on this machine, and nothing lost or computed twice where a job, the tool and the
// controller are killed in the middle.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "verification/runs/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// 4 x 4 x 4 runs of a twentieth of a second each and more, beside the case's own two.
const std::string sweep = R"([[sweep]]
cases = ["small"]
name = "{scheme}_{variant}_{courant_number}_{artificial_viscosity}"
solver = "sph"
scheme = "recommended"
variant = ["wendland_c2", "linear_state", "gamma_3", "gamma_5"]
particle_spacing_m = 0.05
courant_number = [0.2, 0.25, 0.3, 0.35]
artificial_viscosity = [0.001, 0.002, 0.004, 0.008]
)";
constexpr std::size_t runs = 4 * 4 * 4 + 2;

bool has_slurm() {
  const auto there = [](const char* program) {
    return !boost::process::search_path(program).empty() ||
           fs::exists(std::string("/usr/sbin/") + program);
  };
  return geteuid() == 0 && there("sbatch") && there("slurmctld") && there("slurmd") &&
         there("munged") && there("setpriv");
}

bool comes_true(const std::function<bool()>& condition) {
  const auto begin = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(60)) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

class SlurmCampaign : public SmallCampaign {
 protected:
  void SetUp() override {
    if (!has_slurm()) GTEST_SKIP() << "needs root, slurm-wlm and munge";
    fs::permissions(node_, fs::perms(0755));  // munge's user reads its key below it
    ASSERT_EQ(node({"start", node_.string(), "2"}), 0);
    write_campaign(particles_case);
    write("surges.toml", read("surges.toml") + sweep);
  }
  ~SlurmCampaign() override {
    if (has_slurm()) node({"stop", node_.string()});
    fs::remove_all(node_);
  }

  int node(const std::vector<std::string>& arguments) const {
    return boost::process::system(
        boost::process::exe = SLOSH_SOURCE_DIR "/verification/tests/slurm_node.sh",
        boost::process::args = arguments, boost::process::std_out > boost::process::null);
  }
  Environment environment() const { return {{"SLURM_CONF", (node_ / "slurm.conf").string()}}; }
  std::vector<std::string> on_slurm() const {
    return {"campaign", "./surges.toml", "--output", "out", "--launcher", "slurm"};
  }
  std::map<fs::path, fs::file_time_type> written() const {
    std::map<fs::path, fs::file_time_type> times;
    for (const fs::path& file : files_of_store(".h5")) times[file] = fs::last_write_time(file);
    return times;
  }
  bool cancel_one_task() const {
    boost::process::ipstream output;
    boost::process::environment slurm = boost::this_process::environment();
    for (const auto& [name, value] : environment()) slurm[name] = value;
    const auto squeue = boost::process::search_path("squeue");
    boost::process::system(
        boost::process::exe = squeue,
        boost::process::args = {"-h", "--array", "--states=RUNNING", "--format=%i"}, slurm,
        boost::process::std_out > output);
    std::string task;
    if (!(output >> task)) return false;
    return boost::process::system(boost::process::exe = boost::process::search_path("scancel"),
                                  boost::process::args = {task}, slurm) == 0;
  }

  // Short: a socket's path has at most 107 letters.
  const fs::path node_ = [] {
    char name[] = "/tmp/slosh_slurm_XXXXXX";
    return fs::path(mkdtemp(name));
  }();
};

TEST_F(SlurmCampaign, GivesTheSameBitsAsThisMachine) {
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

TEST_F(SlurmCampaign, LosesAndRepeatsNothingWhereAJobTheToolAndTheControllerAreKilled) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  ASSERT_TRUE(comes_true([&] { return files_of_store(".h5").size() >= 5; }));
  ASSERT_TRUE(comes_true([&] { return cancel_one_task(); }));
  ASSERT_EQ(node({"kill-controller", node_.string()}), 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));  // the tool asks a controller that is dead
  EXPECT_TRUE(child.running());
  kill(child.id(), SIGKILL);
  end_of(std::move(child));
  const auto before = written();
  ASSERT_LT(before.size(), runs);
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
  EXPECT_EQ(after.size(), runs);
  for (const auto& [file, time] : before) EXPECT_EQ(after.at(file), time) << file;
  EXPECT_TRUE(files_of_store(".partial").empty());
}

TEST_F(SlurmCampaign, EndsItsJobsWhereItIsInterrupted) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  ASSERT_TRUE(comes_true([&] { return files_of_store(".h5").size() >= 3; }));
  kill(child.id(), SIGINT);
  const Ended ended = end_of(std::move(child));
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_TRUE(comes_true([&] { return !cancel_one_task(); })) << "tasks are left in the queue";
  EXPECT_LT(files_of_store(".h5").size(), runs);
}

TEST_F(SlurmCampaign, SaysWhatSlurmDidToAJobThatWasCancelled) {
  auto child = start(SLOSH_TOOL, on_slurm(), environment());
  ASSERT_TRUE(comes_true([&] { return cancel_one_task(); }));
  const Ended ended = end_of(std::move(child));
  EXPECT_EQ(ended.status, 3) << ended.err;
  EXPECT_NE(ended.err.find("failed   small/"), std::string::npos) << ended.err;
  EXPECT_EQ(files_of_store(".h5").size(), runs - 1);
  const Ended again = tool(on_slurm(), environment());
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(files_of_store(".h5").size(), runs);
}

}  // namespace
}  // namespace slosh
