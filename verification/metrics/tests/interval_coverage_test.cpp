// How often the 95 % intervals of compare_modes() hold the truth: pairs of series with known
// parameters are compared, and the intervals are counted that do. The reference is
//   r(t) = A cos(w t + p) + B cos(n t + q).
// The candidate has the amplitude (1 + e) A and the lag d at w, and its natural mode has the
// frequency (1 + 0.003) n and the amplitude (1 + e) B exp(-0.05 (t - t0)), with t0 the window's
// begin; e is 0.02 and d is 1 degree unless the scenario says otherwise. Contributions that no
// request names are added to the candidate or to both: first-order autoregressive noise, a
// modulation, another tone. The share should be 0.95 (Student 1908, Biometrika 6:1). Its standard
// error over 400 pairs is 0.011, so that a deviation of 0.04 is 3.7 of them: one of a hundred right
// shares deviates by more in one of fifty runs. Where the window is too short to separate the tones
// only a refusal is right. The share of answers there is held against 0.05, near which it lies
// (0.045), over 1600 pairs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "verification/metrics/comparison.hpp"

namespace slosh::interval_coverage_test {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;
constexpr double frequency_error = 0.003, decay_rate = 0.05;
constexpr double sample_interval = 0.01;  // [s], as in the cases
constexpr double round_off = 1e-10;       // of an estimate without noise, in each quantity's unit
// The levels of residual_model.hpp and local_noise.hpp were chosen with smaller seeds.
constexpr std::uint64_t first_seed = 1001;

struct Noise {
  double deviation = 0;         // as a share of A
  double correlation_time = 0;  // [s]; 0: white
};

// The factor 1 + 0.1 cos(2 pi t / period + phase) on a mode's amplitude, whose mean is the truth.
struct Modulation {
  double depth = 0, shortest_period = 1, longest_period = 1;  // [s], uniformly drawn
};

enum class Due { answer, answer_or_refusal, refusal };

struct Scenario {
  std::string name;
  double forcing = 0;  // w [rad/s]
  TimeWindow window = {0, 0};
  Noise candidate_noise = {}, reference_noise = {};
  Noise shared_noise = {};                 // the same samples in both
  double natural = 0, natural_height = 0;  // n [rad/s], B / A
  bool natural_requested = false;
  double amplitude_error = 0.02, lag_degrees = 1;  // e and d
  Modulation of_forced = {}, of_natural = {};
  double beat_height = 0;       // of the further tone, as a share of A
  double beats_per_window = 0;  // (its frequency - that of the forcing) times the window's length
  bool beat_in_both = false;
  Due due = Due::answer;

  bool without_noise() const {
    return candidate_noise.deviation + reference_noise.deviation + shared_noise.deviation == 0;
  }
};

// The surge of the small-amplitude cases, their ramp, the mild roll, and the paper's resonant
// surges.
constexpr double surge = 1.483464, natural = 4.96646, roll = 2.0, natural_of_roll = 5.55095;
constexpr double surge_13 = 2 * pi / 1.3, surge_12 = 2 * pi / 1.2;
constexpr Noise none{}, white{0.1, 0}, red{0.1, 0.3}, redder{0.1, 1}, faint{0.01, 0.3};
constexpr TimeWindow whole{1, 20};

Scenario with_natural(const std::string& name, TimeWindow window, double height, Noise noise,
                      double forcing = surge, double natural_frequency = natural) {
  Scenario one{name, forcing, window, noise};
  one.natural = natural_frequency;
  one.natural_height = height;
  one.natural_requested = true;
  return one;
}

Scenario with_beat(const std::string& name, double height, double beats) {
  Scenario one{name, surge, whole, faint};
  one.beat_height = height;
  one.beats_per_window = beats;
  return one;
}

// Tones that both series share and nobody named, over frequencies, heights, distances, amplitude
// errors, lags and windows. Before the metrics came from the corrected tones, 0 to 86 % of the
// intervals held the truth.
void add_shared_tones(std::vector<Scenario>& all) {
  struct Shared {
    double frequency, length, height, bins, amplitude_error, lag_degrees;  // [Hz], [s], ...
  };
  struct Source {
    const char* name;
    Noise own, shared;
  };
  constexpr Shared places[] = {
      {0.8, 9.37, 0.6, 1.4, 0.06, 20},  {0.8, 9.37, 0.6, 1.4, -0.1, 0},
      {0.3, 19, 0.3, 1.3, 0.06, -40},   {1.4, 6.1, 0.2, 2.3, 0.02, 60},
      {0.5, 12.6, 0.4, 3.5, -0.05, 10}, {0.8, 30.2, 0.8, -2.2, 0, 90},
  };
  for (const auto& [name, own, shared] : {Source{"exact", none, none}, Source{"own", faint, none},
                                          Source{"noisy", red, none}, Source{"alike", none, red}}) {
    int number = 0;
    for (const Shared& place : places) {
      Scenario one{fmt::format("shared_tone_{}_{}", ++number, name),
                   2 * pi * place.frequency,
                   {1, 1 + place.length},
                   own,
                   own,
                   shared};
      one.amplitude_error = place.amplitude_error;
      one.lag_degrees = place.lag_degrees;
      one.beat_height = place.height;
      one.beats_per_window = place.bins;
      one.beat_in_both = true;
      all.push_back(one);
    }
  }
}

std::vector<Scenario> all_scenarios() {
  std::vector<Scenario> all{with_natural("white_19s", whole, 2.5, white),
                            with_natural("red_19s", whole, 2.5, red),
                            with_natural("redder_19s", whole, 2.5, redder),
                            with_natural("mild_roll", {1, 10}, 0.3, red, roll, natural_of_roll),
                            with_natural("ramp", {8.5, 20}, 0.1, {0.02, 0.3}),
                            with_natural("resonant_12", {1, 25}, 1, red, surge_12),
                            with_natural("resonant_13", {1, 25}, 1, red, surge_13),
                            {"white_6s", surge, {1, 7.4}, white},
                            {"red_12s", surge, {1, 13}, red},
                            {"red_8s", surge, {1, 9}, red},
                            {"red_6s", surge, {1, 7.4}, red},
                            {"red_5s", surge, {1, 6}, red},
                            {"redder_8s", surge, {1, 9}, redder},
                            {"redder_12s", surge, {1, 13}, redder},
                            {"both_12s", surge, {1, 13}, red, red},
                            {"modulated_5s", surge, whole, faint},
                            {"modulated_10s", surge, whole, faint},
                            with_natural("modulated_natural", whole, 2.5, faint),
                            with_beat("beat", 0.1, 1.6),
                            with_beat("shared_beat", 0.2, 0.4),
                            with_beat("near_beat", 0.1, 0.5)};
  const auto named = [&](const std::string& name) -> Scenario& {
    return *std::ranges::find(all, name, &Scenario::name);
  };
  named("modulated_5s").of_forced = named("modulated_natural").of_natural = {0.1, 4, 6};
  named("modulated_10s").of_forced = {0.1, 8, 12};
  named("shared_beat").beat_in_both = true;
  named("shared_beat").due = Due::answer_or_refusal;  // the window hardly separates the tones
  named("near_beat").due = named("resonant_13").due = Due::refusal;
  Scenario unnamed = named("resonant_13");
  unnamed.name = "resonant_13_forced";
  unnamed.natural_requested = false;
  all.push_back(unnamed);
  add_shared_tones(all);
  return all;
}

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

struct Pair {
  TimeSeries candidate{"elevation@right", "m", {}, {}}, reference = candidate;
};

Pair draw_pair(const Scenario& scenario, std::uint64_t seed) {
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
  const double length = scenario.window.end - begin, middle = begin + 0.5 * length;
  const double beat = w + 2 * pi * scenario.beats_per_window / length;
  Pair pair;
  for (long i = 0; i <= std::lround(length / sample_interval); ++i) {
    const double t = begin + static_cast<double>(i) * sample_interval, b = scenario.natural_height;
    const double further = scenario.beat_height * std::cos(beat * t + beat_phase);
    pair.candidate.time.push_back(t);
    pair.reference.time.push_back(t);
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

// An estimate of one pair and its true value.
struct Judged {
  Estimate estimate;
  double truth;
};

// Returns the forced mode's amplitude and lag and the natural mode's amplitude, frequency and
// decay; nothing where the comparison refuses the pair.
std::vector<Judged> judged(const Scenario& scenario, std::uint64_t seed) try {
  const Pair pair = draw_pair(scenario, seed);
  std::vector<ToneRequest> requests{{"forced", scenario.forcing, false}};
  if (scenario.natural_requested) requests.push_back({"natural_1", scenario.natural, true});
  const std::vector<ModeComparison> modes =
      compare_modes(pair.candidate, pair.reference, scenario.window, requests);
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

struct Coverage {
  struct Quantity {
    double held = 0, half_width = 0, square_error = 0;  // sums
  };
  std::vector<Quantity> quantities = std::vector<Quantity>(5);
  double judged = 0, refused = 0;
};

// The seeds are always the same. The intervals are taken times the factor.
Coverage coverage(const Scenario& scenario, int draws, double factor = 1) {
  Coverage sums;
  for (int i = 0; i < draws; ++i) {
    const std::vector<Judged> all = judged(scenario, first_seed + static_cast<std::uint64_t>(i));
    ++(all.empty() ? sums.refused : sums.judged);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double error = all[k].estimate.value - all[k].truth;
      sums.quantities[k].held += std::abs(error) <= factor * all[k].estimate.half_width + round_off;
      sums.quantities[k].half_width += all[k].estimate.half_width;
      sums.quantities[k].square_error += error * error;
    }
  }
  sums.quantities.resize(scenario.natural_requested ? 5 : 2);
  return sums;
}

// What is wrong with the intervals; empty for nothing.
std::string fault(const Scenario& scenario, const Coverage& found) {
  const double refused = found.refused / (found.refused + found.judged);
  if (scenario.due == Due::refusal)
    return refused >= 0.95 ? "" : fmt::format("only {} of the pairs are refused", refused);
  if (refused > (scenario.due == Due::answer ? 0.05 : 0.67))
    return fmt::format("{} of the pairs are refused", refused);
  for (std::size_t k = 0; k < found.quantities.size(); ++k) {
    const double excess = found.quantities[k].held / found.judged - 0.95;
    // Without noise there is nothing that one interval in twenty should miss.
    if (excess < -0.0401 || (excess > 0.0401 && !scenario.without_noise()))
      return fmt::format("quantity {}: {} of the intervals hold the truth", k, 0.95 + excess);
  }
  return "";
}

class IntervalCoverage : public testing::TestWithParam<Scenario> {};

TEST_P(IntervalCoverage, IsNineteenInTwenty) {
  const int draws = GetParam().due == Due::refusal ? 1600 : 400;
  EXPECT_EQ(fault(GetParam(), coverage(GetParam(), draws)), "");
}

// Those that were furthest from 95 % once; the others run with the long tests.
std::vector<Scenario> of_the_worst(bool chosen) {
  const std::set<std::string> worst{"red_8s",
                                    "red_6s",
                                    "redder_8s",
                                    "both_12s",
                                    "beat",
                                    "modulated_5s",
                                    "shared_beat",
                                    "near_beat",
                                    "shared_tone_1_exact",
                                    "shared_tone_1_own",
                                    "shared_tone_1_alike",
                                    "shared_tone_6_own"};
  std::vector<Scenario> all = all_scenarios();
  std::erase_if(all, [&](const Scenario& one) { return worst.contains(one.name) != chosen; });
  return all;
}

const auto name_of_test = [](const auto& one) { return one.param.name; };
INSTANTIATE_TEST_SUITE_P(Worst, IntervalCoverage, testing::ValuesIn(of_the_worst(true)),
                         name_of_test);
INSTANTIATE_TEST_SUITE_P(Others, IntervalCoverage, testing::ValuesIn(of_the_worst(false)),
                         name_of_test);

Scenario scenario(const std::string& name) {
  const std::vector<Scenario> all = all_scenarios();
  return *std::ranges::find(all, name, &Scenario::name);
}

TEST(IntervalCoverageOfWrongIntervals, IsFound) {
  for (const double factor : {0.5, 2.0})
    EXPECT_NE(fault(scenario("red_8s"), coverage(scenario("red_8s"), 400, factor)), "") << factor;
  Scenario answered = scenario("red_8s");
  answered.due = Due::refusal;
  EXPECT_NE(fault(answered, coverage(answered, 20)), "");
  Scenario refused = scenario("near_beat");
  refused.due = Due::answer;
  EXPECT_NE(fault(refused, coverage(refused, 20)), "");
}

TEST(IntervalCoverageUnderWhiteNoise, HasIntervalsNoWiderThanTheNoiseAsksFor) {
  const Coverage found = coverage(scenario("white_19s"), 60);
  // Student's quantile of about ten degrees of freedom, 2.23, and 15 %: of the root mean square
  // error, which 60 pairs tell to 9 %.
  for (const auto& [held, half_width, square_error] : found.quantities)
    EXPECT_LE(half_width / found.judged,
              2.23 * 1.15 * 1.18 * std::sqrt(square_error / found.judged));
}

TEST(IntervalCoverageOfABeat, DoesNotTakeWhatIsDeterministicForNoise) {
  const Coverage found = coverage(scenario("beat"), 60);
  // A tenth of the forcing's amplitude would be as much noise.
  EXPECT_LE(found.quantities[0].half_width / found.judged, 0.01);
}

}  // namespace
}  // namespace slosh::interval_coverage_test
