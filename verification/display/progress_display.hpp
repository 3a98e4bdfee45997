// Shows the progress of jobs. On a terminal each running job has a live line with the time left,
// and there is one line for all jobs together. Elsewhere a line is written at each job's end, and
// one on the progress of the jobs after a minute without such an end.
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "verification/display/display_style.hpp"
#include "verification/engine/job.hpp"

namespace slosh {

class ProgressDisplay {
 public:
  using Clock = std::chrono::steady_clock;

  // The jobs share `at_once` cores.
  ProgressDisplay(std::ostream& stream, AskStyle style, int at_once);

  // Shows the states; an ObserveJobs. Each call has the states of the same jobs.
  void show(const std::vector<JobState>& states, Clock::time_point now = Clock::now());

  // Erases the live lines, as before an error message.
  void erase_live_lines();

 private:
  // Numbers on all jobs together; empty where there is only one.
  struct Sums {
    std::string ended;  // "[12/46] "
    std::string left;   // "3 min left"; empty where that is not known
  };
  static Sums sums_of(const std::vector<JobState>& states, int at_once);
  void show_end(const JobState& state, JobPhase before, const Sums& sums);
  void show_plain_progress(const std::vector<JobState>& states, const Sums& sums);
  void draw_live_line(const std::string& line);
  void draw_live_lines(const std::vector<JobState>& states, const Sums& sums);
  std::string paint(const char* colour, const std::string& text) const;

  std::ostream& stream_;
  AskStyle ask_style_;
  DisplayStyle style_;
  int at_once_;
  std::vector<std::size_t> live_lines_;  // their lengths
  std::vector<JobPhase> phases_;         // as last shown
  Clock::time_point written_;            // time of the last permanent line
};

// Returns "running  NAME  5.00 of 20 s, 0.5 simulated s per s, 0:30 left" in at most `columns`. The
// time left is always there: the least important parts are left out first, then the middle of a
// long name. Names are padded to `name_width`.
std::string running_line(const JobState& state, std::size_t name_width, std::size_t columns);

}  // namespace slosh
