#include "verification/metrics/prepared_series.hpp"

#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

TimeSeries named(const std::string& role, TimeSeries series) {
  series.name = role + " " + series.name;
  return series;
}

}  // namespace

PreparedSeries::PreparedSeries(const std::string& role, TimeSeries of, TimeWindow over,
                               std::vector<ToneRequest> requests, Detail detail)
    : quantity(of.name),
      series(named(role, std::move(of))),
      window(over),
      modes(std::move(requests)),
      cut(cut_to_window(series, window)) {
  require_variation(cut);
  if (modes.empty()) return;
  require_resolved(window, modes);
  require_sampled(cut, modes);
  if (detail == Detail::fitted_tones) fit.emplace(series, window, modes);
  spectrum = power_spectrum(series, window);
}

}  // namespace slosh
