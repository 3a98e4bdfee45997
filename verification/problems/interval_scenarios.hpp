// Pairs of synthetic series with known parameters, to measure how often the intervals of compare()
// contain the truth. The reference is
//   r(t) = A cos(w t + p) + B cos(n t + q).
// The candidate has the amplitude (1 + e) A and the lag d at w, and its natural mode has the
// frequency (1 + 0.003) n and the amplitude (1 + e) B exp(-0.05 (t - t0)), with t0 the window's
// begin; e is 0.02 and d is 1 degree unless the scenario says otherwise. Contributions that no
// request names are added to the candidate or to both: first-order autoregressive noise, a
// modulation, another tone. Each pair has a seed of its own, from which its
// phases are drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "verification/metrics/comparison.hpp"

namespace slosh {

struct Noise {
  double deviation = 0;         // as a share of A
  double correlation_time = 0;  // [s]; 0: white
};

// The factor 1 + depth cos(2 pi t / period + phase) on a mode's amplitude, whose mean is the truth.
struct Modulation {
  double depth = 0, shortest_period = 1, longest_period = 1;  // [s], uniformly drawn
};

struct IntervalScenario {
  std::string name, meaning;
  double forcing = 0;                              // w [rad/s]
  double amplitude_error = 0.02, lag_degrees = 1;  // e and d
  double natural = 0;                              // n [rad/s]
  double natural_height = 0;                       // B / A
  TimeWindow window = {0, 0};
  bool natural_requested = false;
  Noise candidate_noise = {}, reference_noise = {};
  Noise shared_noise = {};  // the same samples in both
  Modulation of_forced = {}, of_natural = {};
  double beat_height = 0;       // of the further tone, as a share of A
  double beats_per_window = 0;  // (its frequency - that of the forcing) times the window's length
  bool beat_in_both = false;
  bool deterministic_leftovers = false;
  bool without_noise = false;   // every interval should hold the truth
  bool to_be_refused = false;   // no window of this length separates the tones
  bool may_be_refused = false;  // a refusal is right too: the window hardly separates the tones
  bool quick = false;           // drawn in the quick form too
};

const std::vector<IntervalScenario>& interval_scenarios();

struct SyntheticPair {
  TimeSeries candidate, reference;
};

// The samples lie 0.01 s apart, as in the cases.
SyntheticPair draw_pair(const IntervalScenario& scenario, std::uint64_t seed);

std::vector<ToneRequest> requests_of(const IntervalScenario& scenario);

// The number of intervals that contained the truth among the draws that were not refused, for which
// compare_modes() neither threw nor left a mode unresolved. The seeds are always the same.
struct IntervalCoverage {
  struct Quantity {
    std::string name;  // "forced amplitude", ...
    int held = 0;
    double mean_half_width = 0, rms_error = 0;
  };
  std::vector<Quantity> quantities;
  int judged = 0, refused = 0;
};

IntervalCoverage interval_coverage(const IntervalScenario& scenario, int draws);

}  // namespace slosh
