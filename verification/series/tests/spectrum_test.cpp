#include "verification/series/spectrum.hpp"

#include <gtest/gtest.h>

#include <complex>

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

}  // namespace
}  // namespace slosh::spectrum_test
