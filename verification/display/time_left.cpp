#include "verification/display/time_left.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

}  // namespace slosh
