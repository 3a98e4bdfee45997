// Shows jobs to whoever waits: on a terminal a live line for each running one with its
// simulated time, speed and remaining time; elsewhere plain lines at its start and end and at most
// every ten seconds between.
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

struct DisplayStyle {
  bool live;    // redraw lines (a terminal)
  bool colour;  // ANSI colours
  int columns;  // of the terminal; live lines are cut to fit
};

// What standard error can show: live on a terminal that is not "dumb", colour there unless NO_COLOR
// is set and not empty (no-color.org).
DisplayStyle style_of_standard_error();

class ProgressDisplay {
 public:
  ProgressDisplay(std::ostream& stream, const DisplayStyle& style);

  // To be called with the states of the same jobs each time: an ObserveJobs.
  void show(const std::vector<JobState>& states);

 private:
  using Clock = std::chrono::steady_clock;
  void show_change(const JobState& state, JobPhase before);
  void show_plain_progress(const JobState& state, Clock::time_point& shown);
  void erase_live_lines();
  void draw_live_lines(const std::vector<JobState>& states);
  std::string paint(const char* colour, const std::string& text) const;

  std::ostream& stream_;
  DisplayStyle style_;
  int live_lines_ = 0;
  std::vector<JobPhase> phases_;          // as last shown
  std::vector<Clock::time_point> shown_;  // when a plain line was last written
};

}  // namespace slosh
