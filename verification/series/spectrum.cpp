#include "verification/series/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "verification/series/fourier_transform.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr std::size_t padding = 4;

// Multiplies by the window in place and returns the sum of its weights.
double apply_hann_window(std::vector<double>& samples) {
  const double step = 2 * std::numbers::pi / static_cast<double>(samples.size());
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double weight = 0.5 * (1 - std::cos(step * static_cast<double>(i)));
    samples[i] *= weight;
    sum += weight;
  }
  return sum;
}

SpectralPeak interpolated_peak(const Spectrum& spectrum, std::size_t i) {
  const auto log_power = [&](std::size_t j) {
    return std::log(std::max(spectrum.power[j], std::numeric_limits<double>::min()));
  };
  const double left = log_power(i - 1), top = log_power(i), right = log_power(i + 1);
  const double offset = 0.5 * (left - right) / (left - 2 * top + right);
  return {.frequency = spectrum.frequency[i] + offset * spectrum.frequency[1],
          .power = std::exp(top - 0.25 * (left - right) * offset)};
}

}  // namespace

Spectrum power_spectrum(const TimeSeries& series, TimeWindow window) {
  const TimeSeries cut = cut_to_window(series, window);
  const std::size_t count = cut.time.size();
  std::vector<double> samples =
      interpolate(cut, uniform_times(cut.time.front(), cut.time.back(), count));
  const double interval = (cut.time.back() - cut.time.front()) / static_cast<double>(count - 1);
  remove_trend(samples);
  const double weight = apply_hann_window(samples);
  const auto length = static_cast<Eigen::Index>(padding * count);
  const Eigen::VectorXcd coefficients = fourier_transforms(
      Eigen::Map<const Eigen::VectorXd>(samples.data(), static_cast<Eigen::Index>(count)), length);

  Spectrum spectrum{
      .frequency = {}, .power = {}, .resolution = 2 / (static_cast<double>(count) * interval)};
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    spectrum.frequency.push_back(static_cast<double>(i) / (static_cast<double>(length) * interval));
    spectrum.power.push_back(2 * std::norm(coefficients[i]) / (weight * weight));
  }
  return spectrum;
}

std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, int count) {
  std::vector<SpectralPeak> maxima;
  for (std::size_t i = 1; i + 1 < spectrum.power.size(); ++i) {
    if (spectrum.power[i] > spectrum.power[i - 1] && spectrum.power[i] >= spectrum.power[i + 1]) {
      maxima.push_back(interpolated_peak(spectrum, i));
    }
  }
  std::sort(maxima.begin(), maxima.end(),
            [](const SpectralPeak& a, const SpectralPeak& b) { return a.power > b.power; });
  std::vector<SpectralPeak> peaks;
  for (const SpectralPeak& maximum : maxima) {
    if (static_cast<int>(peaks.size()) >= count) break;
    const bool apart = std::all_of(peaks.begin(), peaks.end(), [&](const SpectralPeak& peak) {
      return std::abs(peak.frequency - maximum.frequency) >= spectrum.resolution;
    });
    if (apart) peaks.push_back(maximum);
  }
  return peaks;
}

}  // namespace slosh
