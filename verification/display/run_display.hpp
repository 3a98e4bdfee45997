// Shows the progress of a single run in this process, on a terminal alone.
#pragma once

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include "verification/display/progress_display.hpp"

namespace slosh {

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

}  // namespace slosh
