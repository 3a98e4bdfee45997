// A campaign of more than sixty runs and a real Slurm of one node, as root.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "verification/tests/comes_true.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh {

// 4 x 4 x 4 runs of a twentieth of a second each and more, beside the case's own two.
inline const std::string sixty_four_runs = R"([[sweep]]
cases = ["small"]
name = "{scheme}_{variant}_{courant_number}_{artificial_viscosity}"
solver = "sph"
scheme = "recommended"
variant = ["wendland_c2", "linear_state", "gamma_3", "gamma_5"]
particle_spacing_m = 0.05
courant_number = [0.2, 0.25, 0.3, 0.35]
artificial_viscosity = [0.001, 0.002, 0.004, 0.008]
)";
inline constexpr std::size_t all_runs = 4 * 4 * 4 + 2;

inline bool has_slurm() {
  const auto there = [](const char* program) {
    return !boost::process::search_path(program).empty() ||
           std::filesystem::exists(std::string("/usr/sbin/") + program);
  };
  return geteuid() == 0 && there("sbatch") && there("slurmctld") && there("slurmd") &&
         there("munged") && there("setpriv");
}

class SlurmCampaign : public SmallCampaign {
 protected:
  void SetUp() override {
    if (!has_slurm()) GTEST_SKIP() << "needs root, slurm-wlm and munge";
    std::filesystem::permissions(
        node_, std::filesystem::perms(0755));  // munge's user reads its key below it
    ASSERT_EQ(node({"start", node_.string(), "2"}), 0);
    write_campaign(particles_case);
    write("surges.toml", read("surges.toml") + sixty_four_runs);
  }
  ~SlurmCampaign() override {
    if (has_slurm()) node({"stop", node_.string()});
    std::filesystem::remove_all(node_);
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
  std::map<std::filesystem::path, std::filesystem::file_time_type> written() const {
    std::map<std::filesystem::path, std::filesystem::file_time_type> times;
    for (const std::filesystem::path& file : files_of_store(".h5"))
      times[file] = std::filesystem::last_write_time(file);
    return times;
  }
  // The last in the queue, as a running one may end by itself before it is cancelled.
  bool cancel_one_task() const {
    boost::process::ipstream output;
    boost::process::environment slurm = boost::this_process::environment();
    for (const auto& [name, value] : environment()) slurm[name] = value;
    const auto squeue = boost::process::search_path("squeue");
    boost::process::system(
        boost::process::exe = squeue,
        boost::process::args = {"-h", "--array", "--states=PENDING,RUNNING", "--format=%i"}, slurm,
        boost::process::std_out > output);
    std::string task;
    for (std::string next; output >> next;) task = next;
    if (task.empty()) return false;
    return boost::process::system(boost::process::exe = boost::process::search_path("scancel"),
                                  boost::process::args = {task}, slurm) == 0;
  }

  // Short: a socket's path has at most 107 letters.
  const std::filesystem::path node_ = [] {
    char name[] = "/tmp/slosh_slurm_XXXXXX";
    return std::filesystem::path(mkdtemp(name));
  }();
};

}  // namespace slosh
