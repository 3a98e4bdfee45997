#include "verification/runs/run_pool.hpp"

#include <fmt/format.h>
#include <string.h>
#include <sys/wait.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "verification/runs/child_process.hpp"

namespace slosh {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds look_interval{
    20};  // at the children's ends: far below any run's time
constexpr std::chrono::milliseconds observe_interval{200};  // at their progress

class Pool {
 public:
  Pool(const std::vector<Job>& jobs, std::size_t at_once, const ObserveJobs& observe)
      : at_once_(at_once), observe_(observe) {
    for (const Job& job : jobs) states_.push_back({.job = job, .message = {}, .progress = {}});
  }

  std::vector<JobState> run(const std::atomic<bool>& stop) {
    for (;;) {
      if (stop) {
        interrupt();
      } else {
        start_waiting_jobs();
      }
      for (Running& one : running_) look_at(one);
      std::erase_if(running_, [this](const Running& one) { return has_ended(states_[one.index]); });
      observe_when_due();
      // A job that could not start leaves its place to the next, so more may wait with none
      // running.
      if (std::all_of(states_.begin(), states_.end(), has_ended)) return states_;
      std::this_thread::sleep_for(look_interval);
    }
  }

 private:
  struct Running {
    std::size_t index;  // of its state
    ChildProcess child;
    JobPhase end = JobPhase::running;  // why it was terminated, where it was
  };

  void interrupt() {
    for (JobState& state : states_) {
      if (state.phase == JobPhase::waiting) enter(state, JobPhase::interrupted);
    }
    for (Running& one : running_) terminate(one, JobPhase::interrupted);
  }

  void start_waiting_jobs() {
    for (std::size_t i = 0; i < states_.size() && running_.size() < at_once_; ++i) {
      if (states_[i].phase == JobPhase::waiting) start(i);
    }
  }

  void start(std::size_t index) {
    JobState& state = states_[index];
    try {
      std::filesystem::remove(state.job.progress_file);  // an earlier run's
      running_.push_back({index, ChildProcess(state.job.command, state.job.log_file)});
      enter(state, JobPhase::running);
    } catch (const std::runtime_error& error) {
      state.message = error.what();
      enter(state, JobPhase::not_started);
    }
  }

  void look_at(Running& one) {
    JobState& state = states_[one.index];
    const bool is_over = one.child.is_over();
    state.wall_time = one.child.wall_time();
    if (is_over) {
      read_progress_of(state);
      const int status = one.child.wait_status();
      state.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
      const JobPhase natural_end = WIFSIGNALED(status) ? JobPhase::signalled : JobPhase::exited;
      enter(state, one.end == JobPhase::running ? natural_end : one.end);
    } else if (state.job.time_limit > 0 && state.wall_time > state.job.time_limit) {
      terminate(one, JobPhase::timed_out);
    }
  }

  void terminate(Running& one, JobPhase why) {
    if (one.end == JobPhase::running) one.end = why;
    one.child.terminate();
  }

  void enter(JobState& state, JobPhase phase) {
    state.phase = phase;
    changed_ = true;
  }

  static void read_progress_of(JobState& state) {
    if (const auto progress = read_progress(state.job.progress_file)) state.progress = progress;
  }

  void observe_when_due() {
    if (!changed_ && Clock::now() - observed_ < observe_interval) return;
    for (const Running& one : running_) read_progress_of(states_[one.index]);
    observe_(states_);
    observed_ = Clock::now();
    changed_ = false;
  }

  std::size_t at_once_;
  const ObserveJobs& observe_;
  std::vector<JobState> states_;
  std::vector<Running> running_;
  Clock::time_point observed_ = Clock::now();
  bool changed_ = true;
};

}  // namespace

bool has_ended(const JobState& state) {
  return state.phase != JobPhase::waiting && state.phase != JobPhase::running;
}

bool has_succeeded(const JobState& state) {
  return state.phase == JobPhase::exited && state.status == 0;
}

std::string description(const JobState& state) {
  switch (state.phase) {
    case JobPhase::waiting:
      return "waiting";
    case JobPhase::running:
      return "running";
    case JobPhase::exited:
      return fmt::format("exit status {}", state.status);
    case JobPhase::signalled:
      return fmt::format("killed by signal {} ({})", state.status, strsignal(state.status));
    case JobPhase::timed_out:
      return fmt::format("ended at its time limit of {:g} s", state.job.time_limit);
    case JobPhase::interrupted:
      return "interrupted";
    case JobPhase::not_started:
      return "not started: " + state.message;
  }
  return "";
}

std::vector<JobState> run_pool(const std::vector<Job>& jobs, int at_once,
                               const std::atomic<bool>& stop, const ObserveJobs& observe) {
  if (at_once < 1) {
    throw std::invalid_argument(
        fmt::format("at_once = {}: expected at least one job at a time", at_once));
  }
  return Pool(jobs, static_cast<std::size_t>(at_once), observe).run(stop);
}

}  // namespace slosh
