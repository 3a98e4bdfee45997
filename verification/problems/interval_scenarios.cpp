#include "verification/problems/interval_scenarios.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

namespace slosh {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;
constexpr double frequency_error = 0.003, decay_rate = 0.05;
constexpr double sample_interval = 0.01;
constexpr double round_off = 1e-10;  // of an estimate without noise, in each quantity's unit
// The levels of residual_model.hpp and local_noise.hpp were chosen with smaller seeds.
constexpr std::uint64_t first_seed = 1001;

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double phase() { return uniform(0, 2 * pi); }
  // The Box-Muller transform gives the same numbers with every standard library.
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

// The surge of the small-amplitude cases, their ramp, the mild roll, and the paper's resonant
// surges.
constexpr double surge = 1.483464, natural = 4.96646;
constexpr double roll = 2.0, natural_of_roll = 5.55095;
constexpr double surge_13 = 2 * pi / 1.3, surge_12 = 2 * pi / 1.2;
constexpr Noise white{0.1, 0}, red{0.1, 0.3}, redder{0.1, 1}, faint{0.01, 0.3};

IntervalScenario forced_alone(const std::string& name, const std::string& meaning, double length,
                              Noise noise) {
  return {.name = name,
          .meaning = meaning,
          .forcing = surge,
          .window = {1, 1 + length},
          .candidate_noise = noise};
}

IntervalScenario with_natural(const std::string& name, const std::string& meaning,
                              TimeWindow window, double natural_height, Noise noise) {
  IntervalScenario scenario{.name = name, .meaning = meaning, .forcing = surge, .window = window};
  scenario.natural = natural;
  scenario.natural_height = natural_height;
  scenario.natural_requested = true;
  scenario.candidate_noise = noise;
  return scenario;
}

IntervalScenario in_quick(IntervalScenario scenario) {
  scenario.quick = true;
  return scenario;
}

std::vector<IntervalScenario> noises() {
  std::vector<IntervalScenario> all{
      in_quick(with_natural("white_19s", "white noise", {1, 20}, 2.5, white)),
      forced_alone("white_6s", "white noise, 1.5 periods", 6.4, white),
      with_natural("red_19s", "noise of 0.3 s", {1, 20}, 2.5, red),
      in_quick(forced_alone("red_12s", "noise of 0.3 s", 12, red)),
      in_quick(forced_alone("red_8s", "noise of 0.3 s", 8, red)),
      forced_alone("red_6s", "noise of 0.3 s, 1.5 periods", 6.4, red),
      forced_alone("red_5s", "noise of 0.3 s, 1.2 periods", 5, red),
      in_quick(forced_alone("redder_8s", "noise of 1 s", 8, redder)),
      forced_alone("redder_12s", "noise of 1 s", 12, redder),
      with_natural("redder_19s", "noise of 1 s", {1, 20}, 2.5, redder)};
  IntervalScenario both = forced_alone("both_12s", "noise of 0.3 s on both", 12, red);
  both.reference_noise = red;
  all.push_back(in_quick(both));
  IntervalScenario mild = with_natural("mild_roll", "the mild roll's window", {1, 10}, 0.3, red);
  mild.forcing = roll;
  mild.natural = natural_of_roll;
  all.push_back(in_quick(mild));
  all.push_back(with_natural("ramp", "the ramp's window", {8.5, 20}, 0.1, {0.02, 0.3}));
  return all;
}

std::vector<IntervalScenario> leftovers() {
  std::vector<IntervalScenario> all;
  IntervalScenario one =
      forced_alone("modulated_5s", "forced mode modulated within 5 s", 19, faint);
  one.of_forced = {0.1, 4, 6};
  all.push_back(in_quick(one));
  one = forced_alone("modulated_10s", "forced mode modulated within 10 s", 19, faint);
  one.of_forced = {0.1, 8, 12};
  all.push_back(one);
  one = with_natural("modulated_natural", "natural mode modulated within 5 s", {1, 20}, 2.5, faint);
  one.of_natural = {0.1, 4, 6};
  all.push_back(one);
  one = forced_alone("beat", "an unnamed tone 1.6 bins from the forcing", 19, faint);
  one.beat_height = 0.1;
  one.beats_per_window = 1.6;
  all.push_back(in_quick(one));
  one = forced_alone("shared_beat", "an unnamed tone 0.4 bins off, alike in both", 19, faint);
  one.beat_height = 0.2;
  one.beats_per_window = 0.4;
  one.beat_in_both = true;
  one.may_be_refused = true;
  all.push_back(one);
  one = with_natural("resonant_12", "surge of 1.2 s beside the natural mode", {1, 25}, 1, red);
  one.forcing = surge_12;
  all.push_back(one);
  for (IntervalScenario& scenario : all) scenario.deterministic_leftovers = true;
  return all;
}

// Tones that both series share, over frequencies, heights, distances, amplitude errors, lags and
// windows, without noise, with noise of each series and with noise that they share too.
std::vector<IntervalScenario> shared_tones() {
  struct Shared {
    double frequency, length, height, bins, amplitude_error, lag_degrees;  // [Hz], [s], ...
  };
  constexpr Shared places[] = {
      {0.8, 9.37, 0.6, 1.4, 0.06, 20},  {0.8, 9.37, 0.6, 1.4, -0.1, 0},
      {0.3, 19, 0.3, 1.3, 0.06, -40},   {1.4, 6.1, 0.2, 2.3, 0.02, 60},
      {0.5, 12.6, 0.4, 3.5, -0.05, 10}, {0.8, 30.2, 0.8, -2.2, 0, 90},
  };
  struct Source {
    const char *name, *meaning;
    Noise own, shared;
  };
  constexpr Noise none{};
  constexpr Source sources[] = {{"exact", "without noise", none, none},
                                {"own", "and noise of 0.3 s of each", faint, none},
                                {"noisy", "and much noise of 0.3 s of each", red, none},
                                {"alike", "and noise of 0.3 s, alike in both", none, red}};
  std::vector<IntervalScenario> all;
  for (const Source& source : sources) {
    int number = 0;
    for (const Shared& place : places) {
      IntervalScenario one = forced_alone(
          fmt::format("shared_tone_{}_{}", ++number, source.name),
          fmt::format("an unnamed tone {} bins off, alike in both, {}", place.bins, source.meaning),
          place.length, source.own);
      one.forcing = 2 * pi * place.frequency;
      one.amplitude_error = place.amplitude_error;
      one.lag_degrees = place.lag_degrees;
      one.reference_noise = source.own;
      one.shared_noise = source.shared;
      one.without_noise = source.own.deviation == 0 && source.shared.deviation == 0;
      one.beat_height = place.height;
      one.beats_per_window = place.bins;
      one.beat_in_both = one.deterministic_leftovers = true;
      one.quick = number == 1;
      all.push_back(one);
    }
  }
  return all;
}

// Scenarios whose tones cannot be separated: only a refusal is right.
std::vector<IntervalScenario> beyond_the_window() {
  std::vector<IntervalScenario> all;
  IntervalScenario one = forced_alone("near_beat", "an unnamed tone half a bin off", 19, faint);
  one.beat_height = 0.1;
  one.beats_per_window = 0.5;
  all.push_back(in_quick(one));
  one = with_natural("resonant_13", "surge of 1.3 s beside the natural mode", {1, 25}, 1, red);
  one.forcing = surge_13;
  all.push_back(one);
  one.name = "resonant_13_forced";
  one.meaning = "the same, the natural mode unnamed";
  one.natural_requested = false;
  all.push_back(one);
  for (IntervalScenario& scenario : all) scenario.to_be_refused = true;
  return all;
}

}  // namespace

SyntheticPair draw_pair(const IntervalScenario& scenario, std::uint64_t seed) {
  Random random(seed);
  const double w = scenario.forcing, n = scenario.natural, begin = scenario.window.begin;
  const double lag = scenario.lag_degrees * degree, gain = 1 + scenario.amplitude_error;
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
    const double further = scenario.beat_height * std::cos(beat * t + beat_phase);
    pair.reference.value.push_back(std::cos(w * t + p) + b * std::cos(n * t + q) +
                                   (scenario.beat_in_both ? further : 0));
    pair.candidate.value.push_back(
        gain * forced_envelope(t) * std::cos(w * t + p - lag) +
        gain * b * natural_envelope(t) * std::exp(-decay_rate * (t - begin)) *
            std::cos((1 + frequency_error) * n * (t - middle) + n * middle + q) +
        further);
  }
  Random shared = random;
  add_noise(pair.candidate, scenario.shared_noise, random);
  add_noise(pair.reference, scenario.shared_noise, shared);
  add_noise(pair.candidate, scenario.candidate_noise, random);
  add_noise(pair.reference, scenario.reference_noise, random);
  return pair;
}

const std::vector<IntervalScenario>& interval_scenarios() {
  static const std::vector<IntervalScenario> scenarios = [] {
    std::vector<IntervalScenario> all = noises();
    for (const auto& more : {leftovers(), shared_tones(), beyond_the_window()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return scenarios;
}

std::vector<ToneRequest> requests_of(const IntervalScenario& scenario) {
  std::vector<ToneRequest> requests{{"forced", scenario.forcing, false}};
  if (scenario.natural_requested) requests.push_back({"natural_1", scenario.natural, true});
  return requests;
}

namespace {

// The estimates of one pair and their true values, in the order of quantities_of().
struct Judged {
  Estimate estimate;
  double truth;
};

std::vector<std::string> quantities_of(const IntervalScenario& scenario) {
  std::vector<std::string> names{"forced amplitude", "forced lag"};
  if (scenario.natural_requested)
    for (const char* quantity : {"amplitude", "frequency", "decay rate"})
      names.push_back(std::string("natural ") + quantity);
  return names;
}

// Returns nullopt where the comparison refuses the pair.
std::vector<Judged> judged(const IntervalScenario& scenario, std::uint64_t seed) try {
  const SyntheticPair pair = draw_pair(scenario, seed);
  const std::vector<ModeComparison> modes =
      compare_modes(pair.candidate, pair.reference, scenario.window, requests_of(scenario));
  for (const ModeComparison& mode : modes)
    if (!mode.resolved()) return {};
  std::vector<Judged> all{{modes[0].amplitude_error, scenario.amplitude_error},
                          {modes[0].phase_lag_degrees, scenario.lag_degrees}};
  if (scenario.natural_requested) {
    all.push_back({modes[1].amplitude_error, scenario.amplitude_error});
    all.push_back({modes[1].frequency_error, frequency_error});
    all.push_back({modes[1].decay_rate, decay_rate});
  }
  return all;
} catch (const ComparisonError&) {
  return {};
}

}  // namespace

IntervalCoverage interval_coverage(const IntervalScenario& scenario, int draws) {
  IntervalCoverage coverage;
  for (const std::string& name : quantities_of(scenario)) coverage.quantities.push_back({name});
  for (int i = 0; i < draws; ++i) {
    const std::vector<Judged> all = judged(scenario, first_seed + static_cast<std::uint64_t>(i));
    ++(all.empty() ? coverage.refused : coverage.judged);
    for (std::size_t k = 0; k < all.size(); ++k) {
      IntervalCoverage::Quantity& quantity = coverage.quantities[k];
      const double error = all[k].estimate.value - all[k].truth;
      quantity.held += std::abs(error) <= all[k].estimate.half_width + round_off;
      quantity.mean_half_width += all[k].estimate.half_width;
      quantity.rms_error += error * error;
    }
  }
  for (IntervalCoverage::Quantity& quantity : coverage.quantities) {
    quantity.mean_half_width /= coverage.judged;
    quantity.rms_error = std::sqrt(quantity.rms_error / coverage.judged);
  }
  return coverage;
}

}  // namespace slosh
