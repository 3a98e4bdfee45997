// What the tool leaves when it, or a solver under it, is ended.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "verification/results/result_file.hpp"
#include "verification/tests/comes_true.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_interrupt_test {
namespace {

namespace fs = std::filesystem;

struct Process {
  int id;
  std::string name;
};

// Those that work in the directory or are told of it on their command line.
std::vector<Process> processes_of(const fs::path& directory) {
  const auto content = [](const fs::path& file) {
    std::ifstream stream(file);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  std::vector<Process> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (!std::all_of(name.begin(), name.end(), ::isdigit)) continue;
    std::error_code gone;
    const std::string place = fs::read_symlink(entry.path() / "cwd", gone).string();
    if (!place.starts_with(directory.string()) &&
        content(entry.path() / "cmdline").find(directory.string()) == std::string::npos)
      continue;
    std::string program = content(entry.path() / "comm");
    if (!program.empty()) program.pop_back();
    found.push_back({std::stoi(name), program});
  }
  return found;
}

bool works_in_its_case(int process) {
  std::error_code gone;
  return fs::read_symlink("/proc/" + std::to_string(process) + "/cwd", gone)
      .filename()
      .string()
      .ends_with(".openfoam");
}

class ToolInterrupted : public SmallCampaign {
 protected:
  // The interFoam of this campaign, once it runs; 0 where it does not come.
  int running_interfoam() const {
    int id = 0;
    comes_true(
        [&] {
          // Not those that are asked for their version at the start.
          for (const Process& one : processes_of(directory() / "out"))
            if (one.name == "interFoam" && works_in_its_case(one.id)) id = one.id;
          return id != 0;
        },
        patience);
    return id;
  }
  boost::process::child start_campaign() const {
    return start_tool({"campaign", "./surges.toml", "--output", "out", "--jobs", "2"});
  }
};

TEST_F(ToolInterrupted, EndsItsRunsKeepsWhatIsFinishedAndGoesOnFromThere) {
  // Theory is done long before the particles are.
  write_campaign(with(
      with(with(particles_case, "duration_s = 8.0", "duration_s = 20.0"), "= 0.025", "= 0.0125"),
      "modes = 500", "modes = 20"));
  auto child = start_campaign();
  const auto progress = directory() / "out/jobs/small.particles.progress";
  const auto theory = [&] { return files_of_store(".h5").size() == 1; };
  ASSERT_TRUE(comes_true([&] { return theory() && fs::exists(progress); }, patience));
  kill(child.id(), SIGINT);
  const Ended interrupted = end_of(std::move(child));
  EXPECT_EQ(interrupted.status, 130);
  EXPECT_NE(interrupted.err.find("interrupted: what is finished is kept in "), std::string::npos)
      << interrupted.err;
  EXPECT_TRUE(processes_of(directory()).empty());
  EXPECT_TRUE(theory()) << "and nothing else";
  EXPECT_NO_THROW(read_result(files_of_store(".h5").at(0)));
  EXPECT_FALSE(fs::exists(report()));

  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.err.find("small/theory"), std::string::npos) << again.err;
  EXPECT_NE(again.err.find("finished small/particles"), std::string::npos) << again.err;
}

// Long enough not to end before it is ended.
const std::string long_mesh_case = with(mesh_case, "duration_s = 8.0", "duration_s = 100.0");

TEST_F(ToolInterrupted, EndsWhatItsRunsHaveStartedToo) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  write_campaign(long_mesh_case);
  auto child = start_campaign();
  ASSERT_NE(running_interfoam(), 0);
  kill(child.id(), SIGTERM);
  EXPECT_EQ(end_of(std::move(child)).status, 130);
  EXPECT_TRUE(processes_of(directory()).empty());
}

TEST_F(ToolInterrupted, SaysWhichSolverWasKilledAndByWhat) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  write_campaign(long_mesh_case);
  auto child = start_campaign();
  const int interfoam = running_interfoam();
  ASSERT_NE(interfoam, 0);
  kill(interfoam, SIGKILL);
  const Ended run = end_of(std::move(child));
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("interFoam: killed by signal 9 (Killed)"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("0 of 1 gate rows hold, 1 run failed."), std::string::npos) << run.out;
  EXPECT_TRUE(holds(report_words(), "killed by signal 9"));
  EXPECT_FALSE(fs::exists(result("mesh")));
  EXPECT_NO_THROW(read_result(result("theory")));
  EXPECT_TRUE(processes_of(directory()).empty());
}

}  // namespace
}  // namespace slosh::tool_interrupt_test
