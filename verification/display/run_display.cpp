#include "verification/display/run_display.hpp"

#include <chrono>

namespace slosh {

RunDisplay::RunDisplay(std::ostream& stream, const AskStyle& style, const std::string& name,
                       double expected_time)
    : display_(stream, style, 1) {
  state_.job.name = name;
  state_.job.expected_time = expected_time;
  state_.phase = JobPhase::running;
  if (style().live) thread_ = std::thread([this] { draw(); });
}

RunDisplay::~RunDisplay() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  end_.notify_one();
  if (thread_.joinable()) thread_.join();
  display_.erase_live_lines();
}

void RunDisplay::tell(const RunProgress& progress) {
  const std::lock_guard lock(mutex_);
  state_.progress = progress;
}

void RunDisplay::draw() {
  constexpr std::chrono::milliseconds interval{200};
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!end_.wait_for(lock, interval, [this] { return ended_; })) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
    state_.wall_time = gone.count();
    display_.show({state_});
  }
}

}  // namespace slosh
