// Runs child processes side by side, a given number at once. A crash, a divergence or a time-out of
// one is recorded and leaves the others alone; an interrupt ends them all, their own children
// included.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/runs/progress_file.hpp"

namespace slosh {

// A command without a shell: its first element is the program (a path), its standard output and
// error go to the log.
struct Job {
  std::string name;
  std::vector<std::string> command;
  std::filesystem::path log_file;       // replaced; its directory is made if need be
  std::filesystem::path progress_file;  // removed first, then looked at; empty for none
  double time_limit = 0;                // [s] of wall time; 0: none
};

enum class JobPhase {
  waiting,
  running,
  exited,     // status: the exit status
  signalled,  // status: the signal that ended it
  timed_out,
  interrupted,  // ended by the interrupt, or never started because of it
  not_started   // message: why
};

struct JobState {
  Job job;
  JobPhase phase = JobPhase::waiting;
  int status = 0;
  std::string message;
  double wall_time = 0;  // [s], so far
  std::optional<RunProgress> progress;
};

bool has_ended(const JobState& state);
bool has_succeeded(const JobState& state);  // exited with status 0
std::string description(
    const JobState& state);  // "exit status 3", "killed by signal 9 (Killed)", ...

// Called from run_pool's thread at each change and about five times a second with the states of all
// jobs, in the order of the jobs.
using ObserveJobs = std::function<void(const std::vector<JobState>&)>;

// Runs all jobs, `at_once` of them at a time, in their order, and returns their last states. Once
// `stop` is true every child's process group gets SIGTERM, three seconds later what is left of it
// SIGKILL, and no further job starts. Not to be used beside other code of this process that waits
// for any child.
std::vector<JobState> run_pool(const std::vector<Job>& jobs, int at_once,
                               const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
