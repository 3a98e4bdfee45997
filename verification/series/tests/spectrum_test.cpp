#include "verification/series/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <limits>

#include "verification/series/low_pass_filter.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::spectrum_test {
namespace {

TEST(PowerSpectrum, PeaksAtHalfTheSquaredAmplitudeWithMeanAndDriftRemoved) {
  const auto series =
      sampled([](double t) { return 5 + 0.3 * t + 0.2 * std::sin(two_pi * 0.77 * t + 1); }, 0, 20);
  const auto peaks = spectral_peaks(power_spectrum(series, {0, 20}), 1);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].frequency, 0.77, 1e-4);
  EXPECT_NEAR(peaks[0].power, 0.02, 0.02 * 0.005);
}

// The same estimate without a Hann window, by the definition of the transform.
double peak_of_rectangular_window(const TimeSeries& series) {
  Spectrum spectrum{.frequency = {}, .power = {}, .resolution = 1.0 / 3};
  for (int k = 0; k < 40; ++k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < series.time.size(); ++i) {
      sum += series.value[i] * std::polar(1.0, -two_pi * k / 12.0 * series.time[i]);
    }
    spectrum.frequency.push_back(k / 12.0);
    spectrum.power.push_back(std::norm(sum));
  }
  return spectral_peaks(spectrum, 1).at(0).frequency;
}

TEST(PowerSpectrum, FindsAFrequencyFromThreePeriodsThatARectangularWindowMisses) {
  const auto three_periods = [](double phase) {
    return sampled([&](double t) { return std::cos(two_pi * t + phase); }, 0, 3);
  };
  const auto error = [](const TimeSeries& series) {
    return spectral_peaks(power_spectrum(series, {0, 3}), 1).at(0).frequency - 1;
  };
  EXPECT_NEAR(error(three_periods(0)), -0.001, 5e-4);
  EXPECT_GT(peak_of_rectangular_window(three_periods(0)) - 1, 0.014);
  for (int i = 0; i < 16; ++i) {
    EXPECT_LT(std::abs(error(three_periods(two_pi * i / 16))), 0.0035);
  }
}

TEST(PowerSpectrum, SeparatesTonesOnlyWhenTheyAreTheResolutionApart) {
  const auto peaks_of_tones_apart = [](double difference) {
    const auto series = sampled(
        [&](double t) {
          return std::sin(two_pi * 0.77 * t) + 0.5 * std::sin(two_pi * (0.77 + difference) * t);
        },
        0, 20);
    const auto spectrum = power_spectrum(series, {0, 20});
    EXPECT_NEAR(spectrum.resolution, 0.1, 1e-3);
    return spectral_peaks(spectrum, 2);
  };
  const auto apart = peaks_of_tones_apart(0.77);
  ASSERT_EQ(apart.size(), 2U);
  EXPECT_NEAR(apart[0].power, 0.5, 0.005);
  EXPECT_NEAR(apart[1].frequency, 1.54, 1e-3);
  EXPECT_NEAR(apart[1].power, 0.125, 0.00125);
  const auto merged = peaks_of_tones_apart(0.03);
  EXPECT_LT(merged.at(1).power, 0.01 * merged.at(0).power);  // a side lobe, not the second tone
}

TEST(PowerSpectrum, ReadsUnequallySpacedSamples) {
  auto series = sampled([](double) { return 0.0; }, 0, 20);
  for (std::size_t i = 1; i + 1 < series.time.size(); ++i)
    series.time[i] += 0.004 * std::sin(1.0 * i);
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    series.value[i] = std::sin(two_pi * 1.1 * series.time[i]);
  }
  const auto peak = spectral_peaks(power_spectrum(series, {0, 20}), 1).at(0);
  EXPECT_NEAR(peak.frequency, 1.1, 1e-4);
  EXPECT_NEAR(peak.power, 0.5, 0.0025);
}

TEST(PowerSpectrum, RefusesASeriesThatIsNotFiniteOrTooShort) {
  auto series = sampled([](double t) { return std::sin(t); }, 0, 20);
  EXPECT_THROW(power_spectrum(series, {0, 25}), ComparisonError);
  series.value[3] = std::nan("");
  EXPECT_THROW(power_spectrum(series, {0, 20}), ComparisonError);
}

constexpr double cutoff = 5;                                        // [Hz]
constexpr double reach = 5 * 0.8325546111576977 / two_pi / cutoff;  // 5 sqrt(ln 2) / (2 pi f_c) [s]
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// The intervals vary from 4 to 6 ms over a second.
std::vector<double> slowly_uneven_times() {
  std::vector<double> times{0};
  while (times.back() < 10)
    times.push_back(times.back() + 0.005 + 0.001 * std::sin(two_pi * times.back()));
  return times;
}

// The intervals are random between 2.5 and 7.5 ms.
std::vector<double> ragged_times() {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> interval(0.0025, 0.0075);
  std::vector<double> times{0};
  while (times.back() < 10) times.push_back(times.back() + interval(generator));
  return times;
}

TimeSeries at_times(const std::vector<double>& times, const std::function<double(double)>& signal) {
  TimeSeries series{.name = "pressure@left", .unit = "Pa", .time = times, .value = {}};
  for (const double t : times) series.value.push_back(signal(t));
  return series;
}

// The largest difference at more than the filter's reach from either end.
double largest_error_inside(const TimeSeries& filtered,
                            const std::function<double(double)>& expected) {
  double largest = 0;
  for (std::size_t i = 0; i < filtered.time.size(); ++i) {
    const double t = filtered.time[i];
    if (t < filtered.time.front() + reach || t > filtered.time.back() - reach) continue;
    largest = std::max(largest, std::abs(filtered.value[i] - expected(t)));
  }
  return largest;
}

double trapezoidal_area(const TimeSeries& series) {
  double sum = 0;
  for (std::size_t i = 1; i < series.time.size(); ++i) {
    sum += 0.5 * (series.time[i] - series.time[i - 1]) * (series.value[i] + series.value[i - 1]);
  }
  return sum;
}

TEST(LowPass, HalvesThePowerAtTheCutoffWithoutALag) {
  const auto sine = [](double t) { return std::sin(two_pi * cutoff * t + 0.3); };
  const auto half_power = [&](double t) { return std::sqrt(0.5) * sine(t); };
  EXPECT_LT(largest_error_inside(low_pass(sampled(sine, 0, 10, 0.005), cutoff), half_power), 1e-6);
}

TEST(LowPass, HasTheGainOfAGaussianAtOtherFrequencies) {
  // exp(-(ln 2 / 2) r^2) = 2^(-r^2 / 2), r = f / f_c.
  for (const auto& [frequency, gain] :
       std::vector<std::pair<double, double>>{{2.5, 0.917004}, {10, 0.25}, {15, 0.0441942}}) {
    const auto sine = [f = frequency](double t) { return std::sin(two_pi * f * t); };
    const auto expected = [&, g = gain](double t) { return g * sine(t); };
    EXPECT_LT(largest_error_inside(low_pass(sampled(sine, 0, 10, 0.005), cutoff), expected), 2e-6)
        << frequency;
  }
}

TEST(LowPass, HoldsItsGainUpToTheHighestCutoffItTakes) {
  const auto sine = [](double t) { return std::sin(two_pi * cutoff * t + 0.3); };
  const auto half_power = [&](double t) { return std::sqrt(0.5) * sine(t); };
  const double coarsest = 1 / (6 * cutoff);
  const double error =
      largest_error_inside(low_pass(sampled(sine, 0, 10, coarsest), cutoff), half_power);
  EXPECT_LT(error, 2e-4);
  EXPECT_GT(error, 1e-4);
  EXPECT_THROW(low_pass(sampled(sine, 0, 10, 1.001 * coarsest), cutoff), ComparisonError);
}

TEST(LowPass, KeepsAConstantToItsEnds) {
  for (const auto& times : {slowly_uneven_times(), ragged_times()}) {
    const TimeSeries filtered = low_pass(at_times(times, [](double) { return 670; }), cutoff);
    for (const double value : filtered.value) ASSERT_NEAR(value, 670, 1e-10);
  }
}

TEST(LowPass, KeepsAStraightLineInside) {
  const auto line = [](double t) { return 3 - 2 * t; };
  EXPECT_LT(largest_error_inside(low_pass(sampled(line, 0, 10, 0.005), cutoff), line), 1e-12);
}

TEST(LowPass, SpreadsASpikeOverAPositiveBellOfTheSameArea) {
  TimeSeries spike = sampled([](double) { return 0; }, 0, 2, 0.001);
  spike.value[1000] = 5000;
  const TimeSeries filtered = low_pass(spike, cutoff);
  EXPECT_GE(*std::min_element(filtered.value.begin(), filtered.value.end()), 0);
  EXPECT_NEAR(trapezoidal_area(filtered), 5, 1e-9);
  const auto top = std::max_element(filtered.value.begin(), filtered.value.end());
  EXPECT_EQ(top - filtered.value.begin(), 1000);
  // 5 Pa s / (sqrt(2 pi) sigma), sigma = 26.5 ms.
  EXPECT_NEAR(*top, 5 / (std::sqrt(two_pi) * reach / 5), 1e-4);
  EXPECT_NEAR(filtered.value[980], filtered.value[1020], 1e-9);
}

TEST(LowPass, DoesNotOvershootAStep) {
  const TimeSeries filtered =
      low_pass(sampled([](double t) { return t < 1 ? 0 : 100; }, 0, 2, 0.001), cutoff);
  EXPECT_GE(*std::min_element(filtered.value.begin(), filtered.value.end()), 0);
  EXPECT_LE(*std::max_element(filtered.value.begin(), filtered.value.end()), 100 + 1e-10);
}

TEST(LowPass, TakesUnevenSampling) {
  const auto sine = [](double t) { return std::sin(two_pi * cutoff * t + 0.3); };
  const auto half_power = [&](double t) { return std::sqrt(0.5) * sine(t); };
  const auto error = [&](const std::vector<double>& times) {
    return largest_error_inside(low_pass(at_times(times, sine), cutoff), half_power);
  };
  EXPECT_LT(error(slowly_uneven_times()), 5e-6);
  EXPECT_LT(error(ragged_times()), 2e-3);
  const auto line = [](double t) { return 3 - 2 * t; };
  const auto bend = [&](const std::vector<double>& times) {
    return largest_error_inside(low_pass(at_times(times, line), cutoff), line);
  };
  EXPECT_LT(bend(slowly_uneven_times()), 1e-6);
  EXPECT_LT(bend(ragged_times()), 1e-4);  // 1 % of what it changes by in a mean interval
}

TEST(LowPass, KeepsTimesUnitAndNameAndNamesTheFilter) {
  const TimeSeries series = at_times(ragged_times(), [](double t) { return t; });
  const TimeSeries filtered = low_pass(series, cutoff);
  EXPECT_EQ(filtered.time, series.time);
  EXPECT_EQ(filtered.unit, "Pa");
  EXPECT_EQ(filtered.name, "pressure@left");
  EXPECT_EQ(low_pass_name(50), "Gaussian, zero phase, -3 dB at 50 Hz");
  EXPECT_EQ(low_pass_name(12.5), "Gaussian, zero phase, -3 dB at 12.5 Hz");
}

std::string complaint(const TimeSeries& series, double frequency) {
  return message_of<ComparisonError>([&] { low_pass(series, frequency); });
}

TEST(LowPass, RefusesWhatItCannotFilter) {
  const TimeSeries sound = sampled([](double t) { return t; }, 0, 10, 0.005);
  EXPECT_EQ(complaint(sound, cutoff), "");
  for (const double wrong : {0.0, -5.0, nan_value, 33.4, 100.0, 200.0}) {
    EXPECT_TRUE(
        holds(complaint(sound, wrong), "at most 33.33 Hz, a third of the Nyquist frequency"));
  }
  TimeSeries gap = sound;  // one interval of 0.1 s
  gap.time.erase(gap.time.begin() + 1000, gap.time.begin() + 1019);
  gap.value.erase(gap.value.begin() + 1000, gap.value.begin() + 1019);
  EXPECT_TRUE(holds(complaint(gap, cutoff), "at most 1.667 Hz"));

  TimeSeries with_nan = sound;
  with_nan.value[700] = nan_value;
  EXPECT_TRUE(holds(complaint(with_nan, cutoff), "sample 700 is not finite"));
  TimeSeries backwards = sound;
  std::swap(backwards.time[3], backwards.time[4]);
  EXPECT_TRUE(holds(complaint(backwards, cutoff), "times do not increase"));

  const TimeSeries brief = sampled([](double t) { return t; }, 0, 0.26, 0.005);
  EXPECT_TRUE(
      holds(complaint(brief, cutoff), "covers 0.26 s; a low-pass filter at 5 Hz needs 0.265 s"));
  EXPECT_EQ(complaint(sampled([](double t) { return t; }, 0, 0.27, 0.005), cutoff), "");
  EXPECT_TRUE(holds(complaint({.name = "none", .unit = "m", .time = {}, .value = {}}, cutoff),
                    "none: no samples"));
}

}  // namespace
}  // namespace slosh::spectrum_test
