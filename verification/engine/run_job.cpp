#include "verification/engine/run_job.hpp"

#include <sys/wait.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "verification/files/child_process.hpp"

namespace slosh {
namespace {

// Far below the time of any run.
constexpr std::chrono::milliseconds look_interval{10};

void wait_for(ChildProcess& child, JobState& state, const std::atomic<bool>& stop) {
  JobPhase end = JobPhase::running;
  while (!child.is_over()) {
    const bool too_long = state.job.time_limit > 0 && child.wall_time() > state.job.time_limit;
    if (end == JobPhase::running && (stop || too_long)) {
      end = stop ? JobPhase::interrupted : JobPhase::timed_out;
      child.terminate();
    }
    std::this_thread::sleep_for(look_interval);
  }
  state.wall_time = child.wall_time();
  const int status = child.wait_status();
  state.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  const JobPhase own_end = WIFSIGNALED(status) ? JobPhase::signalled : JobPhase::exited;
  state.phase = end == JobPhase::running ? own_end : end;
}

}  // namespace

JobState run_job(const JobList& list, std::size_t index, const std::atomic<bool>& stop) {
  JobState state{.job = list.jobs().at(index)};
  try {
    std::filesystem::remove(state.job.progress_file);  // from an earlier run
    list.mark_started(index);
    ChildProcess child(state.job.command, {.log_file = state.job.log_file});
    wait_for(child, state, stop);
  } catch (const std::runtime_error& error) {
    state.phase = JobPhase::not_started;
    state.message = error.what();
  }
  list.mark_ended(index, state);
  return state;
}

}  // namespace slosh
