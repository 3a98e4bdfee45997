#include "verification/engine/job.hpp"

#include <fmt/format.h>
#include <string.h>

namespace slosh {

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
    case JobPhase::lost:
      return "left no word of its end: " + state.message;
  }
  return "";
}

}  // namespace slosh
