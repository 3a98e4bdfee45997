#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "verification/engine/job_list.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::run_job_test {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Processes whose command line holds the text: a sleep of a telling length.
int processes_with(const std::string& text) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "cmdline");
    std::ostringstream line;
    line << stream.rdbuf();  // nothing of a process that ends meanwhile
    count += line.str().find(text) != std::string::npos;
  }
  return count;
}

class RunJob : public ::testing::Test {
 protected:
  Job job(std::vector<std::string> command) const {
    return {.name = "one",
            .command = std::move(command),
            .log_file = directory.path() / "logs/one.log",
            .progress_file = directory.path() / "one.progress"};
  }
  JobState run(const Job& job) {
    const JobList list = JobList::create(directory.path() / "jobs", {job});
    const JobState state = run_job(list, 0, stop);
    states = list.initial_states();
    list.update(states);
    return state;
  }
  std::string log() const {
    std::ifstream stream(directory.path() / "logs/one.log");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  TemporaryDirectory directory;
  std::atomic<bool> stop = false;
  std::vector<JobState> states;  // as the list knows them after run()
};

TEST_F(RunJob, LeavesInTheListHowItHasEnded) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> ends{
      {{"/bin/true"}, "exit status 0"},
      {{"/bin/false"}, "exit status 1"},
      {{"/usr/bin/env", "-S", "perl -e 'kill 9, $$'"}, "killed by signal 9 (Killed)"}};
  for (const auto& [command, words] : ends) {
    EXPECT_EQ(description(run(job(command))), words);
    EXPECT_EQ(description(states[0]), words);
    EXPECT_EQ(has_succeeded(states[0]), words == "exit status 0");
  }
  EXPECT_EQ(run(job({"/nowhere/solver"})).phase, JobPhase::not_started);
  EXPECT_EQ(states[0].phase, JobPhase::not_started);
  EXPECT_NE(states[0].message, "");
}

TEST_F(RunJob, TellsItsWallTime) {
  EXPECT_GE(run(job({"/bin/sleep", "0.1"})).wall_time, 0.1);
  EXPECT_GE(states[0].wall_time, 0.1);
}

TEST_F(RunJob, WritesOutputAndErrorsToAFreshLog) {
  run(job({"/bin/ls", "/proc/self/cmdline", "/nowhere"}));
  EXPECT_NE(log().find("/proc/self/cmdline"), std::string::npos);
  EXPECT_NE(log().find("/nowhere"), std::string::npos);
  run(job({"/bin/true"}));
  EXPECT_EQ(log(), "");
}

TEST_F(RunJob, HandsArgumentsOverAsTheyAre) {
  run(job({"/bin/echo", "a b", "$HOME", "*", "'ö\"", "`id`"}));
  EXPECT_EQ(log(), "a b $HOME * 'ö\" `id`\n");
}

TEST_F(RunJob, RemovesTheProgressOfAnEarlierRun) {
  const Job one = job({"/bin/true"});
  write_progress({.time = 99, .end_time = 100, .steps = 1}, one.progress_file);
  run(one);
  EXPECT_FALSE(states[0].progress);
}

TEST_F(RunJob, EndsAtItsTimeLimit) {
  Job slow = job({"/bin/sleep", "60.1234"});
  slow.time_limit = 0.2;
  const auto begin = Clock::now();
  EXPECT_EQ(description(run(slow)), "ended at its time limit of 0.2 s");
  EXPECT_LT(seconds_since(begin), 30);
  EXPECT_EQ(states[0].phase, JobPhase::timed_out);
  EXPECT_EQ(processes_with("60.1234"), 0);
}

TEST_F(RunJob, LeavesNoProcessAfterAnInterrupt) {
  // Its child is the sleep: the whole group must go.
  std::thread interrupt([&] {
    while (processes_with("61.4321") < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop = true;
  });
  const JobState state =
      run(job({"/usr/bin/timeout", "--foreground", "90", "/bin/sleep", "61.4321"}));
  interrupt.join();
  EXPECT_EQ(state.phase, JobPhase::interrupted);
  EXPECT_NE(state.status, SIGKILL) << "nobody refused SIGTERM";
  EXPECT_EQ(processes_with("61.4321"), 0);
}

TEST_F(RunJob, KillsWhatDoesNotHeedTermination) {
  std::thread interrupt([&] {
    while (processes_with("62.5678") < 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until the signal is ignored
    stop = true;
  });
  const JobState state =
      run(job({"/usr/bin/env", "--ignore-signal=TERM", "/bin/sleep", "62.5678"}));
  interrupt.join();
  EXPECT_EQ(state.phase, JobPhase::interrupted);
  EXPECT_EQ(state.status, SIGKILL);
  EXPECT_EQ(processes_with("62.5678"), 0);
}

}  // namespace
}  // namespace slosh::run_job_test
