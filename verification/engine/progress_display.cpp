#include "verification/engine/progress_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace slosh {
namespace {

constexpr std::chrono::seconds plain_interval{10};
constexpr int usual_columns = 80;  // where the terminal does not tell

// ANSI X3.64 (ECMA-48) sequences.
constexpr const char *green = "\033[32m", *red = "\033[31m", *normal = "\033[0m";
constexpr const char* line_up_and_erase = "\033[1A\033[2K";

std::string clock_time(double seconds) {
  const auto whole = std::lround(std::max(seconds, 0.0));
  return whole < 3600 ? fmt::format("{}:{:02d}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02d}:{:02d}", whole / 3600, whole / 60 % 60, whole % 60);
}

// "12.40 of 20 s, 1.52 simulated s per s, 0:05 left"
std::string progress_text(const JobState& state) {
  if (!state.progress) return fmt::format("started {} ago", clock_time(state.wall_time));
  const RunProgress& progress = *state.progress;
  const std::string so_far = fmt::format("{:.2f} of {:g} s", progress.time, progress.end_time);
  if (!(progress.time > 0 && state.wall_time > 0)) return so_far;
  const double speed = progress.time / state.wall_time;
  return fmt::format("{}, {:.3g} simulated s per s, {} left", so_far, speed,
                     clock_time((progress.end_time - progress.time) / speed));
}

}  // namespace

DisplayStyle style_of_standard_error() {
  const auto variable = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string_view(text ? text : "");
  };
  const bool live = isatty(STDERR_FILENO) && variable("TERM") != "dumb";
  winsize size{};
  const bool has_size = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return {.live = live,
          .colour = live && variable("NO_COLOR").empty(),
          .columns = has_size ? size.ws_col : usual_columns};
}

ProgressDisplay::ProgressDisplay(std::ostream& stream, const DisplayStyle& style)
    : stream_(stream), style_(style) {}

void ProgressDisplay::show(const std::vector<JobState>& states) {
  phases_.resize(states.size(), JobPhase::waiting);
  shown_.resize(states.size());
  erase_live_lines();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const JobPhase before = std::exchange(phases_[i], states[i].phase);
    if (before != states[i].phase) {
      show_change(states[i], before);
      shown_[i] = Clock::now();
    } else if (!style_.live && states[i].phase == JobPhase::running) {
      show_plain_progress(states[i], shown_[i]);
    }
  }
  if (style_.live) draw_live_lines(states);
  stream_.flush();
}

void ProgressDisplay::show_change(const JobState& state, JobPhase before) {
  if (state.phase == JobPhase::running) {
    if (!style_.live) stream_ << fmt::format("start    {}\n", state.job.name);
  } else if (has_succeeded(state)) {
    stream_ << fmt::format("{} {} in {}\n", paint(green, "finished"), state.job.name,
                           clock_time(state.wall_time));
  } else if (before == JobPhase::waiting && state.phase == JobPhase::interrupted) {
    stream_ << fmt::format("{} {}: not started\n", paint(red, "skipped "), state.job.name);
  } else {
    stream_ << fmt::format("{} {}: {} (log: {})\n", paint(red, "failed  "), state.job.name,
                           description(state), state.job.log_file.string());
  }
}

void ProgressDisplay::show_plain_progress(const JobState& state, Clock::time_point& shown) {
  if (Clock::now() - shown < plain_interval) return;
  stream_ << fmt::format("running  {}: {}\n", state.job.name, progress_text(state));
  shown = Clock::now();
}

void ProgressDisplay::erase_live_lines() {
  for (; live_lines_ > 0; --live_lines_) stream_ << line_up_and_erase;
}

void ProgressDisplay::draw_live_lines(const std::vector<JobState>& states) {
  std::size_t width = 0;
  for (const JobState& state : states) width = std::max(width, state.job.name.size());
  for (const JobState& state : states) {
    if (state.phase != JobPhase::running) continue;
    const std::string line =
        fmt::format("running  {:{}}  {}", state.job.name, width, progress_text(state));
    stream_ << line.substr(0, static_cast<std::size_t>(style_.columns - 1)) << '\n';
    ++live_lines_;
  }
}

std::string ProgressDisplay::paint(const char* colour, const std::string& text) const {
  return style_.colour ? colour + text + normal : text;
}

}  // namespace slosh
