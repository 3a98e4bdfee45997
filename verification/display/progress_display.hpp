// Shows jobs to whoever waits. On a terminal: a live line for each running one, which fits it, with
// the time left, and one for all of them together. Elsewhere: a line at each job's end, and where a
// minute brings none, one that tells how far the jobs are.
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

  // To be called with the states of the same jobs each time: an ObserveJobs.
  void show(const std::vector<JobState>& states, Clock::time_point now = Clock::now());

  // Takes the live lines away, as before an error's message.
  void erase_live_lines();

 private:
  // Of all jobs; empty of a single one.
  struct Sums {
    std::string ended;  // "[12/46] "
    std::string left;   // "3 min left", or nothing where that is not known
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
  Clock::time_point written_;            // when the last line was that stays
};

// "running  NAME  5.00 of 20 s, 0.5 simulated s per s, 0:30 left" in at most `columns`, the time
// left in any case: what tells least is left out first, and of a name that is too long the middle.
// Names are padded to `name_width`.
std::string running_line(const JobState& state, std::size_t name_width, std::size_t columns);

}  // namespace slosh
