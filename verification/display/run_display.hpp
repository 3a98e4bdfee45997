// Shows how far the one run of this process is, on a terminal alone.
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
  // `expected_time` [s]: of the wall, for a solver that does not tell how far it is.
  RunDisplay(std::ostream& stream, const AskStyle& style, const std::string& name,
             double expected_time);
  ~RunDisplay();  // takes the line away
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  // From any thread.
  void tell(const RunProgress& progress);

 private:
  void draw();  // until the end, a few times a second

  ProgressDisplay display_;
  JobState state_;
  std::mutex mutex_;  // of what follows and the state
  std::condition_variable end_;
  bool ended_ = false;
  std::thread thread_;  // none outside a terminal
};

}  // namespace slosh
