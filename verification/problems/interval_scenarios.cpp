#include "verification/problems/interval_scenarios.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace slosh {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;
constexpr double amplitude_error = 0.02, lag = degree, frequency_error = 0.003, decay_rate = 0.05;
constexpr double sample_interval = 0.01;

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double phase() { return uniform(0, 2 * pi); }
  // By Box and Muller, so that every library draws the same.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
    return radius * std::cos(phase());
  }

 private:
  std::mt19937_64 generator_;
};

void add_noise(TimeSeries& series, const Noise& noise, Random& random) {
  if (noise.deviation == 0) return;
  const double kept =
      noise.correlation_time > 0 ? std::exp(-sample_interval / noise.correlation_time) : 0;
  double now = noise.deviation * random.normal();
  for (double& value : series.value) {
    value += now;
    now = kept * now + noise.deviation * std::sqrt(1 - kept * kept) * random.normal();
  }
}

}  // namespace

SyntheticPair draw_pair(const IntervalScenario& scenario, std::uint64_t seed) {
  Random random(seed);
  const double w = scenario.forcing, n = scenario.natural, begin = scenario.window.begin;
  const double p = random.phase(), q = random.phase(), beat_phase = random.phase();
  const auto envelope = [&](const Modulation& modulation) {
    const double rate =
        2 * pi / random.uniform(modulation.shortest_period, modulation.longest_period);
    return [depth = modulation.depth, rate, phase = random.phase()](double t) {
      return 1 + depth * std::cos(rate * t + phase);
    };
  };
  const auto forced_envelope = envelope(scenario.of_forced);
  const auto natural_envelope = envelope(scenario.of_natural);
  const double length = scenario.window.end - begin;
  const double middle = begin + 0.5 * length;
  const double beat = w + 2 * pi * scenario.beats_per_window / length;
  SyntheticPair pair{{"elevation@right", "m", {}, {}}, {"elevation@right", "m", {}, {}}};
  const int last = static_cast<int>(std::lround(length / sample_interval));
  for (int i = 0; i <= last; ++i) {
    const double t = begin + i * sample_interval;
    pair.candidate.time.push_back(t);
    pair.reference.time.push_back(t);
    const double b = scenario.natural_height;
    pair.reference.value.push_back(std::cos(w * t + p) + b * std::cos(n * t + q));
    pair.candidate.value.push_back(
        (1 + amplitude_error) * forced_envelope(t) * std::cos(w * t + p - lag) +
        (1 + amplitude_error) * b * natural_envelope(t) * std::exp(-decay_rate * (t - begin)) *
            std::cos((1 + frequency_error) * n * (t - middle) + n * middle + q) +
        scenario.beat_height * std::cos(beat * t + beat_phase));
  }
  add_noise(pair.candidate, scenario.candidate_noise, random);
  add_noise(pair.reference, scenario.reference_noise, random);
  return pair;
}

std::vector<ToneRequest> requests_of(const IntervalScenario& scenario) {
  std::vector<ToneRequest> requests{{"forced", scenario.forcing, false}};
  if (scenario.natural_requested) requests.push_back({"natural_1", scenario.natural, true});
  return requests;
}

IntervalCoverage interval_coverage(const IntervalScenario& scenario, int draws) {
  IntervalCoverage coverage;
  coverage.quantities = {{"forced amplitude"}, {"forced lag"}};
  const bool of_natural = scenario.natural_requested && scenario.natural_height > 0;
  if (of_natural)
    for (const char* name : {"natural amplitude", "natural frequency", "natural decay rate"})
      coverage.quantities.push_back({name});
  for (int i = 1; i <= draws; ++i) {
    const SyntheticPair pair = draw_pair(scenario, static_cast<std::uint64_t>(i));
    std::vector<ModeComparison> modes;
    try {
      modes = compare_modes(pair.candidate, pair.reference, scenario.window, requests_of(scenario));
    } catch (const ComparisonError&) {
      ++coverage.refused;
      continue;
    }
    if (!modes[0].resolved() || (of_natural && !modes[1].resolved())) {
      ++coverage.refused;
      continue;
    }
    ++coverage.drawn;
    std::size_t next = 0;
    const auto count = [&](const Estimate& estimate, double truth) {
      IntervalCoverage::Quantity& quantity = coverage.quantities[next++];
      const double error = estimate.value - truth;
      quantity.held += std::abs(error) <= estimate.half_width;
      quantity.mean_half_width += estimate.half_width;
      quantity.rms_error += error * error;
    };
    count(modes[0].amplitude_error, amplitude_error);
    count(modes[0].phase_lag_degrees, 1);
    if (!of_natural) continue;
    count(modes[1].amplitude_error, amplitude_error);
    count(modes[1].frequency_error, frequency_error);
    count(modes[1].decay_rate, decay_rate);
  }
  for (IntervalCoverage::Quantity& quantity : coverage.quantities) {
    quantity.mean_half_width /= coverage.drawn;
    quantity.rms_error = std::sqrt(quantity.rms_error / coverage.drawn);
  }
  return coverage;
}

}  // namespace slosh
