// Pairs of synthetic series whose every parameter is known, to find out how often the intervals of
// compare() hold the truth. The reference is
//   r(t) = A cos(w t + p) + B cos(n t + q),
// the candidate has 1.02 A, comes 1 degree late at w, and swings at (1 + 0.003) n with amplitude
// 1.02 B exp(-0.05 (t - t0)) at the window's begin t0. What no request names comes on top of the
// candidate, or of both: first-order autoregressive noise, a modulation, a further tone. Phases are
// drawn anew for every pair, each pair from a seed of its own.
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

// A mode's amplitude times 1 + depth cos(2 pi t / period + phase), of a mean that the truth keeps.
struct Modulation {
  double depth = 0, shortest_period = 1, longest_period = 1;  // [s], uniformly drawn
};

struct IntervalScenario {
  std::string name, meaning;
  double forcing = 0;         // w [rad/s]
  double natural = 0;         // n [rad/s]
  double natural_height = 0;  // B / A
  TimeWindow window = {0, 0};
  bool natural_requested = false;
  Noise candidate_noise = {}, reference_noise = {};
  Modulation of_forced = {}, of_natural = {};
  double beat_height = 0;       // of the further tone, as a share of A
  double beats_per_window = 0;  // (its frequency - that of the forcing) times the window's length
  bool beat_in_both = false;
  bool deterministic_leftovers = false;
  bool to_be_refused = false;   // no window of this length tells the tones apart
  bool may_be_refused = false;  // refusing is right too, as a window of this length tells little
  bool quick = false;           // drawn in the quick form too
};

const std::vector<IntervalScenario>& interval_scenarios();

struct SyntheticPair {
  TimeSeries candidate, reference;
};

// The samples lie 0.01 s apart, as in the cases.
SyntheticPair draw_pair(const IntervalScenario& scenario, std::uint64_t seed);

std::vector<ToneRequest> requests_of(const IntervalScenario& scenario);

// How often each interval held the truth, of the draws that were not refused: those where
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
