// Follows the jobs of a list while an engine runs them.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "verification/engine/job_list.hpp"

namespace slosh {

class Watch {
 public:
  static constexpr std::chrono::milliseconds interval{20};  // between calls of look()

  Watch(const JobList& list, const ObserveJobs& observe);

  // Reads the list, and calls the observer at each change and about five times a second.
  void look();

  const std::vector<JobState>& states() const { return states_; }

  // Marks a job that the engine no longer knows and of whose end the list has no record: as lost,
  // or as not started where the list has no record of its start either.
  void lose(std::size_t index, const std::string& what_is_known);

  // Is called once the engine has ended. A job without a record of its end is marked as interrupted
  // where `stopped`, else as lose() does.
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
