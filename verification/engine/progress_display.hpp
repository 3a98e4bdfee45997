// Shows the progress of jobs. On a terminal each running job has a live line with the time left,
// and there is one line for all jobs together. Elsewhere a line is written at each job's end, and
// one on the progress of the jobs after a minute without such an end.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

// What an output of the process (a terminal, a file) can show.

struct DisplayStyle {
  bool live;    // a terminal: lines may be drawn anew, and break at its width
  bool colour;  // ANSI colours
  int columns;  // of the terminal
};

// Returns the style of standard output or error (STDOUT_FILENO, STDERR_FILENO). It is live on a
// terminal that is not "dumb", with colour unless NO_COLOR is set and not empty (no-color.org).
DisplayStyle style_of(int descriptor);

// Is called before each drawing, for a user may resize the terminal.
using AskStyle = std::function<DisplayStyle()>;
inline AskStyle style_now_of(int descriptor) {
  return [descriptor] { return style_of(descriptor); };
}

// ANSI X3.64 (ECMA-48) sequences.
inline constexpr const char *green = "\033[32m", *red = "\033[31m", *yellow = "\033[33m",
                            *blue = "\033[34m", *normal = "\033[0m";

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

// Shows the progress of a single run in this process, on a terminal alone.

class RunDisplay {
 public:
  // `expected_time` [s] of wall time serves for a solver that does not report its progress.
  RunDisplay(std::ostream& stream, const AskStyle& style, const std::string& name,
             double expected_time);
  ~RunDisplay();  // erases the line
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  // May be called from any thread.
  void tell(const RunProgress& progress);

 private:
  void draw();  // until the end, a few times a second

  ProgressDisplay display_;
  JobState state_;
  std::mutex mutex_;  // guards the state and ended_
  std::condition_variable end_;
  bool ended_ = false;
  std::thread thread_;  // none outside a terminal
};

// Returns the wall time [s] on `at_once` cores: the time of the jobs that share the cores, which is
// at least that of the longest of them, and then the time of the jobs that run alone. Returns
// nullopt where the expected time of a job is not known.
std::optional<double> time_left(const std::vector<JobState>& states, int at_once);

// "40 s", "3 min", "2.5 h".
std::string rough_time(double seconds);

// "0:05", "1:02:30".
std::string clock_time(double seconds);

}  // namespace slosh
