#include "verification/runs/run_pool.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "verification/tests/temporary_directory.hpp"

namespace slosh {
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

class RunPool : public ::testing::Test {
 protected:
  Job job(const std::string& name, std::vector<std::string> command) const {
    return {.name = name,
            .command = std::move(command),
            .log_file = directory.path() / "logs" / (name + ".log"),
            .progress_file = directory.path() / (name + ".progress")};
  }
  std::string log(const std::string& name) const {
    std::ifstream stream(directory.path() / "logs" / (name + ".log"));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::vector<JobState> run(const std::vector<Job>& jobs, int at_once) {
    return run_pool(jobs, at_once, stop, [](const auto&) {});
  }

  TemporaryDirectory directory;
  std::atomic<bool> stop = false;
};

TEST_F(RunPool, RunsAllJobsToTheirEnd) {
  const auto states =
      run({job("a", {"/bin/true"}), job("b", {"/bin/sleep", "0.1"}), job("c", {"/bin/true"})}, 2);
  ASSERT_EQ(states.size(), 3u);
  for (const JobState& state : states) EXPECT_TRUE(has_succeeded(state)) << state.job.name;
  EXPECT_GE(states[1].wall_time, 0.1);
}

TEST_F(RunPool, KeepsToTheNumberOfJobsAtOnce) {
  std::vector<Job> jobs;
  for (const char* name : {"a", "b", "c", "d"}) jobs.push_back(job(name, {"/bin/sleep", "0.2"}));
  std::ptrdiff_t most = 0;
  const auto begin = Clock::now();
  run_pool(jobs, 2, stop, [&](const std::vector<JobState>& states) {
    most = std::max(most, std::count_if(states.begin(), states.end(), [](const auto& s) {
                      return s.phase == JobPhase::running;
                    }));
  });
  EXPECT_EQ(most, 2);
  EXPECT_GE(seconds_since(begin), 0.4);
}

TEST_F(RunPool, RecordsAFailureAndRunsTheOthers) {
  const auto states = run(
      {job("fails", {"/bin/false"}), job("absent", {"/nowhere/solver"}),
       job("killed", {"/usr/bin/env", "-S", "perl -e 'kill 9, $$'"}), job("fine", {"/bin/true"})},
      1);
  EXPECT_EQ(description(states[0]), "exit status 1");
  EXPECT_EQ(states[1].phase, JobPhase::not_started);
  EXPECT_EQ(states[2].phase, JobPhase::signalled);
  EXPECT_EQ(states[2].status, SIGKILL);
  EXPECT_TRUE(has_succeeded(states[3]));
}

TEST_F(RunPool, WritesOutputAndErrorsToAFreshLog) {
  run({job("listing", {"/bin/ls", "/proc/self/cmdline", "/nowhere"})}, 1);
  EXPECT_NE(log("listing").find("/proc/self/cmdline"), std::string::npos);
  EXPECT_NE(log("listing").find("/nowhere"), std::string::npos);
  run({job("listing", {"/bin/true"})}, 1);
  EXPECT_EQ(log("listing"), "");
}

TEST_F(RunPool, HandsArgumentsOverAsTheyAre) {
  run({job("echo", {"/bin/echo", "a b", "$HOME", "*", "'ö\""})}, 1);
  EXPECT_EQ(log("echo"), "a b $HOME * 'ö\"\n");
}

TEST_F(RunPool, EndsAJobAtItsTimeLimit) {
  Job slow = job("slow", {"/bin/sleep", "60.1234"});
  slow.time_limit = 0.2;
  const auto begin = Clock::now();
  const auto states = run({slow, job("fine", {"/bin/true"})}, 1);
  EXPECT_LT(seconds_since(begin), 30);
  EXPECT_EQ(states[0].phase, JobPhase::timed_out);
  EXPECT_TRUE(has_succeeded(states[1]));
  EXPECT_EQ(processes_with("60.1234"), 0);
}

TEST_F(RunPool, LeavesNoProcessAfterAnInterrupt) {
  // The second one's child is the sleep: the whole group must go.
  const std::vector<Job> jobs{
      job("a", {"/bin/sleep", "61.4321"}),
      job("b", {"/usr/bin/timeout", "--foreground", "90", "/bin/sleep", "61.4321"}),
      job("c", {"/bin/sleep", "61.4321"})};
  const auto begin = Clock::now();
  int seen = 0;
  const auto states = run_pool(jobs, 2, stop, [&](const auto&) {
    if (seconds_since(begin) < 0.5) return;
    seen = std::max(seen, processes_with("61.4321"));
    stop = true;
  });
  EXPECT_EQ(seen, 3) << "two sleeps and timeout should have been running";
  for (const JobState& state : states) {
    EXPECT_EQ(state.phase, JobPhase::interrupted) << state.job.name;
    EXPECT_NE(state.status, SIGKILL) << "nobody refused SIGTERM";
  }
  EXPECT_EQ(processes_with("61.4321"), 0);
}

TEST_F(RunPool, KillsWhatDoesNotHeedTermination) {
  const std::vector<Job> jobs{
      job("deaf", {"/usr/bin/env", "--ignore-signal=TERM", "/bin/sleep", "62.5678"})};
  const auto begin = Clock::now();
  const auto states =
      run_pool(jobs, 1, stop, [&](const auto&) { stop = stop || seconds_since(begin) > 0.3; });
  EXPECT_EQ(states[0].phase, JobPhase::interrupted);
  EXPECT_EQ(states[0].status, SIGKILL);
  EXPECT_EQ(processes_with("62.5678"), 0);
}

TEST_F(RunPool, LeavesNoProcessWhenTheObserverThrows) {
  const auto begin = Clock::now();
  EXPECT_THROW(run_pool({job("a", {"/bin/sleep", "63.8765"})}, 1, stop,
                        [&](const auto&) {
                          if (seconds_since(begin) > 0.3) throw std::runtime_error("terminal gone");
                        }),
               std::runtime_error);
  EXPECT_EQ(processes_with("63.8765"), 0);
}

TEST_F(RunPool, TellsTheObserverOfTheProgressThatARunWrites) {
  const Job one = job("a", {"/bin/sleep", "2"});
  write_progress({.time = 99, .end_time = 100, .steps = 1},
                 one.progress_file);  // stale: must not be seen
  std::vector<double> times;
  const auto states = run_pool({one}, 1, stop, [&](const std::vector<JobState>& now) {
    if (now[0].progress) times.push_back(now[0].progress->time);
    if (now[0].phase == JobPhase::running) {
      write_progress({.time = 3, .end_time = 20, .steps = 7}, one.progress_file);
    }
  });
  ASSERT_FALSE(times.empty());
  EXPECT_EQ(std::count(times.begin(), times.end(), 3.0), static_cast<std::ptrdiff_t>(times.size()));
  EXPECT_GE(times.size(), 3u);
  EXPECT_LE(times.size(), 11u);
}

TEST_F(RunPool, OfNoJobsEndsAtOnceAndOfNoPlacesIsRefused) {
  EXPECT_TRUE(run({}, 1).empty());
  EXPECT_THROW(run({job("a", {"/bin/true"})}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace slosh
