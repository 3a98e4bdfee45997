// Stages that do not end, simulated by scripts with the names of OpenFOAM's programs.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <iterator>

#include "openfoam_cases/child_program.hpp"
#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/run_case.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::run_limits_test {
namespace {

namespace fs = std::filesystem;

// Counts processes with this text in their command lines, a sleep of a distinctive length.
int processes_with(const std::string& text) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc"))
    count += contents(entry.path() / "cmdline").find(text) != std::string::npos;
  return count;
}

// A killed process is visible until the system has removed it.
bool all_end_with(const std::string& text) {
  for (int i = 0; i < 200 && processes_with(text) > 0; ++i) usleep(10'000);
  return processes_with(text) == 0;
}

class RunLimits : public ::testing::Test {
 protected:
  RunLimits() : path_(getenv("PATH")) {
    fs::create_directory(programs_);
    setenv("PATH", (programs_.string() + ":" + path_).c_str(), 1);
    for (const char* utility : {"blockMesh", "topoSet", "decomposePar"})
      script(utility, "echo End");
  }
  ~RunLimits() override { setenv("PATH", path_.c_str(), 1); }

  void script(const std::string& name, const std::string& commands) {
    std::ofstream(programs_ / name) << "#!/bin/sh\n" << commands << "\n";
    fs::permissions(programs_ / name, fs::perms::owner_all);
  }
  std::string end_of_run(const SloshingTank& tank, const TimeLimits& limits) {
    const fs::path run = directory_.path() / "run";
    fs::create_directories(run);
    return message_of<RunError>([&] { run_case(tank, run, {}, limits); });
  }

  TemporaryDirectory directory_;
  const fs::path programs_ = directory_.path() / "programs";
  const std::string path_;
};

void expect_in(const std::string& words, const std::string& part) {
  EXPECT_TRUE(holds(words, part));
}

// Checks that OpenFOAM's programs call the function of dictionary_digest.cpp.
TEST_F(RunLimits, AreOfProgramsThatPreloadTheDigestOfDictionaries) {
  void* const library = dlopen(preloaded_library().c_str(), RTLD_NOW);
  ASSERT_NE(library, nullptr) << dlerror();
  EXPECT_NE(dlsym(library, "_ZNK4Foam10dictionary6digestEv"), nullptr);
  dlclose(library);
  script("interFoam", "grep -m 1 -o libslosh_dictionary_digest.so /proc/self/maps; exit 3");
  end_of_run(small_tank(), {});
  expect_in(contents(directory_.path() / "run/log.interFoam"), "libslosh_dictionary_digest.so");
}

TEST_F(RunLimits, EndAUtilityWithTheTailOfItsLog) {
  script("topoSet", "echo reading the mesh\nsleep 63.4321");
  const std::string words = end_of_run(small_tank(), {.utility = 0.3});
  expect_in(words, "topoSet: ended at its time limit of 0.3 s");
  expect_in(words, "log.topoSet");
  expect_in(words, "\nreading the mesh");
  EXPECT_TRUE(all_end_with("63.4321")) << "the script's own child runs on";
}

TEST_F(RunLimits, EndASolverThatHearsNoTermination) {
  script("interFoam", "trap '' TERM\necho Time = 0.1\nwhile :; do sleep 64.4321; done");
  expect_in(end_of_run(small_tank(), {.solver = 0.3}),
            "interFoam: ended at its time limit of 0.3 s");
  EXPECT_TRUE(all_end_with("64.4321"));
}

TEST_F(RunLimits, EndEveryRankOfAParallelRun) {
  SloshingTank tank = small_tank();
  tank.processes = 2;
  script("interFoam", "sleep 65.4321");
  script("mpirun", "interFoam & interFoam & wait");
  expect_in(end_of_run(tank, {.solver = 0.3}), "interFoam: ended at its time limit of 0.3 s");
  EXPECT_TRUE(all_end_with("65.4321"));
}

TEST_F(RunLimits, LeaveARunAloneThatEndsBeforeThem) {
  script("interFoam", "echo Time = 0.1\necho End");
  EXPECT_EQ(end_of_run(small_tank(), {.utility = 30, .solver = 30}), "");
}

TEST_F(RunLimits, AreNotNeededWhereTheOwnerOfARunIsKilled) {
  script("interFoam", "exec sleep 66.4321");
  const pid_t owner = fork();
  if (owner == 0) {
    end_of_run(small_tank(), {});
    _exit(0);
  }
  for (int i = 0; i < 1000 && processes_with("66.4321") == 0; ++i) usleep(10'000);
  EXPECT_EQ(processes_with("66.4321"), 1) << "no solver was started: the test tests nothing";
  kill(owner, SIGKILL);
  waitpid(owner, nullptr, 0);
  EXPECT_TRUE(all_end_with("66.4321"));
}

TEST_F(RunLimits, AreNotNeededForAnAnswerOfAnyLengthAboutTheVersion) {
  script("interFoam", "yes 0123456789 | head -n 100000\necho 'Using: OpenFOAM- (1912) - visit'");
  EXPECT_EQ(installed_version(), "1912");
}

}  // namespace
}  // namespace slosh::openfoam::run_limits_test
