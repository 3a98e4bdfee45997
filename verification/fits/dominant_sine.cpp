#include "verification/fits/dominant_sine.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double fewest_periods_of_peak = 3;  // of the accuracy that spectrum.hpp states

// Returns the spectrum's highest peaks, one or two.
std::vector<SpectralPeak> highest_peaks(const TimeSeries& series, TimeWindow window) {
  require_variation(cut_to_window(series, window));
  const std::vector<SpectralPeak> peaks = spectral_peaks(power_spectrum(series, window), 2);
  if (peaks.empty() || !(peaks.front().frequency > 0))
    throw ComparisonError(series.name + ": its spectrum has no peak");
  const double periods = peaks.front().frequency * (window.end - window.begin);
  if (!(periods >= fewest_periods_of_peak))
    throw ComparisonError(fmt::format(
        "{}: the highest peak of its spectrum, at {:.4g} Hz, has {:.2g} periods in the window, and "
        "three or more tell a frequency",
        series.name, peaks.front().frequency, periods));
  return peaks;
}

// Returns the rms of what the best sine of this frequency [rad/s] leaves, over that of the sine.
double rest_beside(const TimeSeries& series, TimeWindow window, double frequency) {
  const HarmonicFit fit = fit_harmonics(series, window, {{"the sine", frequency, false}});
  return fit.residual_rms / (fit.tones.front().amplitude.value / std::numbers::sqrt2);
}

}  // namespace

DominantSine dominant_sine(const TimeSeries& series, TimeWindow window) {
  const std::vector<SpectralPeak> peaks = highest_peaks(series, window);
  const double start = two_pi * peaks.front().frequency;
  const Tone tone = fit_harmonics(series, window, {{"the sine", start, true}}).tones.front();
  const double frequency = tone.angular_frequency.value;
  const double rest = rest_beside(series, window, frequency);
  if (!(rest <= largest_rest))
    throw ComparisonError(fmt::format(
        "{}: the rest beside the sine of {:.4g} Hz is {:.3g} of it in rms, where a motion that is "
        "nearly a sine has at most {:.2g}{}",
        series.name, frequency / two_pi, rest, largest_rest,
        peaks.size() > 1 ? fmt::format("; the next peak is at {:.4g} Hz", peaks[1].frequency)
                         : ""));
  if (!tone.resolved || tone.beside)
    throw ComparisonError(
        fmt::format("{}: the window cannot tell the sine of {:.4g} Hz from another tone beside it",
                    series.name, frequency / two_pi));
  return {tone.angular_frequency, rest};
}

}  // namespace slosh
