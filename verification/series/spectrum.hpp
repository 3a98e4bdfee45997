// One-sided power spectrum of a series over a window, and its peaks. The least-squares line is
// removed, a Hann window applied, and the samples padded with zeros to four times their number
// (which interpolates the spectrum and adds no resolution):
//   P(f) = 2 |sum_i w_i y_i exp(-2 pi i f t_i)|^2 / (sum_i w_i)^2,
//   w_i = (1 - cos(2 pi i / n)) / 2,   i = 0 ... n - 1
// so that a sine of amplitude A, three or more periods long, peaks at A^2 / 2. A peak's frequency
// and height come from the parabola through the logarithm of its three highest points (Harris 1978
// for the window; Gasior & Gonzalez 2004 for the parabola). At three periods the error in frequency
// is 0.1 to 0.3 %, depending on the starting phase.
#pragma once

#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

struct Spectrum {
  std::vector<double> frequency;  // [Hz], 0 to Nyquist's, four points per 1 / window
  std::vector<double> power;      // amplitude squared / 2 of a sine at that frequency [unit^2]
  // [Hz], main-lobe half width of the Hann window, 2 / window. Two tones must be this far apart.
  double resolution;
};

struct SpectralPeak {
  double frequency;  // [Hz]
  double power;      // [unit^2]
};

// Unequally spaced samples are first interpolated (cubic) to as many equally spaced ones. Throws
// ComparisonError as cut_to_window() does.
Spectrum power_spectrum(const TimeSeries& series, TimeWindow window);

// The `count` highest local maxima, highest first, at least the resolution apart; fewer where the
// spectrum has fewer. Below 0.07 % of the highest peak's power a maximum may be a side lobe of the
// window (-31.5 dB).
std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, int count);

}  // namespace slosh
