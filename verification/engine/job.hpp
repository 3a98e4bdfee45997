// A job: one process of a campaign, its expected cost, and its state.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/results/progress_file.hpp"

namespace slosh {

// How a list of jobs is to be started: the settings that the launcher and its engines share.

enum class Engine { ninja, slurm };

struct LaunchSettings {
  // Only one start at a time works in this directory, which the caller sees to; it is made if need
  // be. The lists of earlier starts are removed from it: what is left of such a start writes into
  // its own list.
  std::filesystem::path directory;
  std::filesystem::path tool;  // its command `job N`, in the directory, runs job N of the list
  Engine engine = Engine::ninja;
  int at_once = 1;  // cores to fill on this machine; a cluster fills its own
};

// The engine cannot be used: what() says why.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Its program is not installed.
struct MissingEngine : EngineError {
  using EngineError::EngineError;
};

// A command that runs without a shell: its first element is the program (a path), and its standard
// output and error go to the log.
struct Job {
  std::string name;
  std::vector<std::string> command;
  std::filesystem::path log_file;            // replaced; its directory is made if need be
  std::filesystem::path progress_file = {};  // removed first, then read; empty for none
  double time_limit = 0;                     // [s] of wall time; 0: none
  int cores = 1;
  double expected_time = 0;    // [s] of wall time; 0: unknown
  double expected_memory = 0;  // [byte], at its peak; 0: unknown
  bool alone = false;          // starts after all that are not, and nothing runs beside it
};

enum class JobPhase {
  waiting,
  running,
  exited,     // status: the exit status
  signalled,  // status: the signal that ended it
  timed_out,
  interrupted,  // ended by the interrupt, or never started because of it
  not_started,  // it could not start, or its engine ended before it; message: why
  lost          // no record of its end (killed, or its machine failed); message: what is known
};

struct JobState {
  Job job;
  JobPhase phase = JobPhase::waiting;
  int status = 0;
  std::string message = {};
  double wall_time = 0;  // [s], so far
  std::optional<RunProgress> progress = {};
};

bool has_ended(const JobState& state);
bool has_succeeded(const JobState& state);  // exited with status 0
std::string description(
    const JobState& state);  // "exit status 3", "killed by signal 9 (Killed)", ...

// Called from the launcher's thread at each change and about five times a second with the states of
// all jobs, in the order of the jobs.
using ObserveJobs = std::function<void(const std::vector<JobState>&)>;

}  // namespace slosh
