// One-sided power spectrum of a series over a window and its peaks: detrended, Hann window, zero-padded
// by four (which interpolates the spectrum and adds no resolution), parabola on the logarithm (FFTW).
#pragma once

#include <vector>

#include "verification/metrics/time_series.hpp"

namespace slosh {

struct Spectrum {
  std::vector<double> frequency;  // [Hz]
  std::vector<double> power;      // amplitude squared / 2 of a sine at that frequency [unit^2]
  double resolution;              // [Hz], main-lobe half width of the window: what two tones must be apart
};

struct SpectralPeak {
  double frequency;  // [Hz]
  double power;      // [unit^2]
};

Spectrum power_spectrum(const TimeSeries& series, TimeWindow window);

// The `count` highest local maxima, highest first, none closer to another than the resolution.
std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, int count);

}  // namespace slosh
