#include "verification/engine/watch.hpp"

namespace slosh {
namespace {

constexpr std::chrono::milliseconds observe_interval{200};

}  // namespace

Watch::Watch(const JobList& list, const ObserveJobs& observe)
    : list_(list), observe_(observe), states_(list.initial_states()) {}

void Watch::look() {
  if (list_.update(states_) || Clock::now() - told_ >= observe_interval) tell();
}

void Watch::lose(std::size_t index, const std::string& what_is_known) {
  JobPhase& phase = states_[index].phase;
  phase = phase == JobPhase::waiting ? JobPhase::not_started : JobPhase::lost;
  states_[index].message = what_is_known;
}

std::vector<JobState> Watch::finish(bool stopped, const std::string& what_is_known) {
  list_.update(states_);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (has_ended(states_[i])) continue;
    if (stopped)
      states_[i].phase = JobPhase::interrupted;
    else
      lose(i, what_is_known);
  }
  tell();
  return states_;
}

void Watch::tell() {
  observe_(states_);
  told_ = Clock::now();
}

}  // namespace slosh
