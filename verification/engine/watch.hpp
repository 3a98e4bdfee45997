// Follows the jobs of a list until an engine has done with them.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "verification/engine/job_list.hpp"

namespace slosh {

class Watch {
 public:
  static constexpr std::chrono::milliseconds interval{20};  // to look() at

  Watch(const JobList& list, const ObserveJobs& observe);

  // Tells the observer at each change, and of the progress about five times a second.
  void look();

  const std::vector<JobState>& states() const { return states_; }

  // A job of which the engine knows no more, while the list knows of no end.
  void lose(std::size_t index, const std::string& what_is_known);

  // Once the engine has ended: a job without a word is interrupted where `stopped`, else lost.
  std::vector<JobState> finish(bool stopped, const std::string& what_is_known);

 private:
  using Clock = std::chrono::steady_clock;
  void tell();

  const JobList& list_;
  const ObserveJobs& observe_;
  std::vector<JobState> states_;
  Clock::time_point told_ = {};
};

}  // namespace slosh
