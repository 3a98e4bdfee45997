// One series over one window, with what a comparison asks of it alone: computed once, however many
// others it is compared with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// Of the tones: their fit, or nothing but what a spectrum says of them, which takes a hundredth of
// the time.
enum class Detail { fitted_tones, spectrum_alone };

struct PreparedSeries {
  // Throws ComparisonError, naming the series by its role ("candidate elevation@left"), when it
  // holds a non-finite value, does not vary, falls short of the window by more than one sample or
  // is too sparse for the modes, or when the window cannot resolve these.
  PreparedSeries(const std::string& role, TimeSeries series, TimeWindow window,
                 std::vector<ToneRequest> modes, Detail detail = Detail::fitted_tones);

  std::string quantity;
  TimeSeries series;  // named by its role and quantity
  TimeWindow window;
  std::vector<ToneRequest> modes;
  TimeSeries cut;                    // to the window
  std::optional<SeriesFit> fit;      // none without modes, nor of a spectrum alone
  std::optional<Spectrum> spectrum;  // none without modes
};

}  // namespace slosh
