#include "verification/engine/progress_display.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace slosh {
namespace {

// A run's own forecast counts after a fiftieth of its time: the first steps do not represent the
// others.
constexpr double telling_share = 0.02;
// The weight of the estimates in the correction: that of so many seconds of jobs that took exactly
// the expected time.
constexpr double belief = 10;  // [s]

// Returns the share of the simulated time that a running job has completed; 0 where it is too small
// for a forecast.
double share_done(const JobState& state) {
  if (!state.progress || !(state.progress->end_time > 0)) return 0;
  const double share = std::min(state.progress->time / state.progress->end_time, 1.0);
  return share >= telling_share ? share : 0;
}

// Returns the ratio of the jobs' actual times to their expected times.
double slowness(const std::vector<JobState>& states) {
  double expected = belief, taken = belief;
  for (const JobState& state : states) {
    const double share = has_succeeded(state)               ? 1
                         : state.phase == JobPhase::running ? share_done(state)
                                                            : 0;
    if (!(share > 0) || !(state.job.expected_time > 0)) continue;
    expected += share * state.job.expected_time;
    taken += state.wall_time;
  }
  return taken / expected;
}

// Returns the wall time that is left of a job [s].
std::optional<double> rest_of(const JobState& state, double slowness) {
  if (has_ended(state)) return 0;
  const bool running = state.phase == JobPhase::running;
  if (const double share = running ? share_done(state) : 0; share > 0)
    return state.wall_time * (1 / share - 1);
  if (!(state.job.expected_time > 0)) return {};
  const double all = slowness * state.job.expected_time;
  return running ? std::max(all - state.wall_time, 0.0) : all;
}

constexpr std::chrono::seconds plain_interval{60};
constexpr const char* line_up_and_erase = "\033[1A\033[2K";

// Returns texts on the progress of the job, the longest first.
std::vector<std::string> progress_texts(const JobState& state) {
  const std::string ago = fmt::format("started {} ago", clock_time(state.wall_time));
  if (!state.progress) {
    if (!(state.job.expected_time > state.wall_time)) return {ago};
    const std::string left =
        fmt::format("about {} left", clock_time(state.job.expected_time - state.wall_time));
    return {ago + ", " + left, left};
  }
  const RunProgress& progress = *state.progress;
  const std::string so_far = fmt::format("{:.2f} of {:g} s", progress.time, progress.end_time);
  if (!(progress.time > 0 && state.wall_time > 0)) return {so_far, ago};
  const double speed = progress.time / state.wall_time;
  const std::string left =
      fmt::format("{} left", clock_time((progress.end_time - progress.time) / speed));
  return {fmt::format("{}, {:.3g} simulated s per s, {}", so_far, speed, left),
          so_far + ", " + left,
          fmt::format("{:.0f} %, {}", 100 * progress.time / progress.end_time, left), left};
}

std::string without_middle(const std::string& name, std::size_t width) {
  constexpr std::size_t dots = 2;
  if (name.size() <= width) return name;
  if (width <= dots) return name.substr(0, width);
  const std::size_t head = (width - dots) / 2, tail = width - dots - head;
  return name.substr(0, head) + ".." + name.substr(name.size() - tail);
}

}  // namespace

std::optional<double> time_left(const std::vector<JobState>& states, int at_once) {
  const double factor = slowness(states);
  double shared = 0, longest = 0, alone = 0;  // [s] of a core, of wall time, of wall time
  for (const JobState& state : states) {
    const std::optional<double> rest = rest_of(state, factor);
    if (!rest) return {};
    if (state.job.alone) {
      alone += *rest;
      continue;
    }
    shared += *rest * std::min(state.job.cores, at_once);
    longest = std::max(longest, *rest);
  }
  return std::max(shared / at_once, longest) + alone;
}

std::string rough_time(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", std::max(seconds, 0.0));
  const double minutes = seconds / 60;
  return minutes < 90 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

std::string clock_time(double seconds) {
  const auto whole = std::lround(std::max(seconds, 0.0));
  return whole < 3600 ? fmt::format("{}:{:02d}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02d}:{:02d}", whole / 3600, whole / 60 % 60, whole % 60);
}

DisplayStyle style_of(int descriptor) {
  constexpr int usual_columns = 80;  // where the terminal reports none
  const auto variable = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string_view(text ? text : "");
  };
  const bool live = isatty(descriptor) && variable("TERM") != "dumb";
  winsize size{};
  const bool has_size = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return {.live = live,
          .colour = live && variable("NO_COLOR").empty(),
          .columns = has_size ? size.ws_col : usual_columns};
}

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

std::string running_line(const JobState& state, std::size_t name_width, std::size_t columns) {
  const std::string head = "running  ", space = "  ";
  const std::vector<std::string> texts = progress_texts(state);
  const auto room = [&](const std::string& text) {
    const std::size_t rest = head.size() + space.size() + text.size();
    return columns > rest ? columns - rest : 0;
  };
  const auto fitting = std::find_if(texts.begin(), texts.end(), [&](const std::string& text) {
    return room(text) >= name_width;
  });
  const std::string& text = fitting == texts.end() ? texts.back() : *fitting;
  const std::size_t width = std::min(name_width, room(text));
  const std::string line =
      width > 0 ? fmt::format("{}{:{}}{}{}", head, without_middle(state.job.name, width), width,
                              space, text)
                : text;
  return line.substr(0, columns);
}

ProgressDisplay::ProgressDisplay(std::ostream& stream, AskStyle style, int at_once)
    : stream_(stream), ask_style_(std::move(style)), style_(ask_style_()), at_once_(at_once) {}

void ProgressDisplay::show(const std::vector<JobState>& states, Clock::time_point now) {
  if (phases_.empty()) written_ = now;
  style_ = ask_style_();
  phases_.resize(states.size(), JobPhase::waiting);
  erase_live_lines();
  const Sums sums = sums_of(states, at_once_);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const JobPhase before = std::exchange(phases_[i], states[i].phase);
    if (before == states[i].phase || !has_ended(states[i])) continue;
    show_end(states[i], before, sums);
    written_ = now;
  }
  if (style_.live) {
    draw_live_lines(states, sums);
  } else if (now - written_ >= plain_interval) {
    show_plain_progress(states, sums);
    written_ = now;
  }
  stream_.flush();
}

ProgressDisplay::Sums ProgressDisplay::sums_of(const std::vector<JobState>& states, int at_once) {
  if (states.size() < 2) return {};
  const auto ended = std::count_if(states.begin(), states.end(), has_ended);
  const std::optional<double> left = time_left(states, at_once);
  return {fmt::format("[{}/{}] ", ended, states.size()),
          left && *left > 0 ? rough_time(*left) + " left" : ""};
}

void ProgressDisplay::show_end(const JobState& state, JobPhase before, const Sums& sums) {
  if (!style_.live) stream_ << sums.ended;
  if (has_succeeded(state))
    stream_ << fmt::format("{} {} in {}", paint(green, "finished"), state.job.name,
                           clock_time(state.wall_time));
  else if (before == JobPhase::waiting && state.phase == JobPhase::interrupted)
    stream_ << fmt::format("{} {}: not started", paint(red, "skipped "), state.job.name);
  else if (state.phase == JobPhase::not_started)  // it has no log
    stream_ << fmt::format("{} {}: {}", paint(red, "skipped "), state.job.name, description(state));
  else
    stream_ << fmt::format("{} {}: {} (log: {})", paint(red, "failed  "), state.job.name,
                           description(state), state.job.log_file.string());
  if (!style_.live && !sums.left.empty()) stream_ << "; " << sums.left;
  stream_ << '\n';
}

void ProgressDisplay::show_plain_progress(const std::vector<JobState>& states, const Sums& sums) {
  std::vector<std::string> running;
  for (const JobState& state : states)
    if (state.phase == JobPhase::running)
      running.push_back(fmt::format("{} ({})", state.job.name, progress_texts(state).back()));
  stream_ << fmt::format(
      "{}{}{}{}\n", sums.ended, sums.left, sums.left.empty() ? "" : "; ",
      running.empty() ? "nothing runs yet" : fmt::format("running {}", fmt::join(running, ", ")));
}

void ProgressDisplay::erase_live_lines() {
  // A terminal that has become narrower wraps a line into several rows.
  const auto columns = static_cast<std::size_t>(std::max(style_.columns, 1));
  for (const std::size_t length : live_lines_)
    for (std::size_t row = 0; row < std::max<std::size_t>(length, 1); row += columns)
      stream_ << line_up_and_erase;
  live_lines_.clear();
  stream_.flush();
}

void ProgressDisplay::draw_live_line(const std::string& line) {
  stream_ << line << '\n';
  live_lines_.push_back(line.size());
}

void ProgressDisplay::draw_live_lines(const std::vector<JobState>& states, const Sums& sums) {
  // A terminal may wrap a line that fills its last column.
  const auto columns = static_cast<std::size_t>(std::max(style_.columns - 1, 1));
  std::size_t width = 0;
  for (const JobState& state : states)
    if (state.phase == JobPhase::running) width = std::max(width, state.job.name.size());
  for (const JobState& state : states) {
    if (state.phase != JobPhase::running) continue;
    draw_live_line(running_line(state, width, columns));
  }
  if (live_lines_.empty() || sums.ended.empty()) return;
  draw_live_line((sums.ended + sums.left).substr(0, columns));
}

std::string ProgressDisplay::paint(const char* colour, const std::string& text) const {
  return style_.colour ? colour + text + normal : text;
}

}  // namespace slosh
