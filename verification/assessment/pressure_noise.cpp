#include "verification/assessment/pressure_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/assessment/case_assessment.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double lowest_band = 5;  // [Hz]
constexpr double bands_per_mode = 3;
// Hann's window has sum w^2 / (sum w)^2 = 1.5 / n, and the padded transform has 4 n bins.
constexpr double bins_of_noise = 6;

}  // namespace

double noise_band(const CaseDefinition& definition) {
  constexpr int third = 3;
  const double mode = modes_of(definition, third).back().angular_frequency / (2 * std::numbers::pi);
  return std::max(lowest_band, bands_per_mode * mode);
}

double pressure_noise(const TimeSeries& pressure, TimeWindow window, double band) {
  const TimeSeries cut = cut_to_window(pressure, window);
  const Spectrum spectrum = power_spectrum(pressure, window);
  if (!(spectrum.frequency.back() > 2 * band))
    throw ComparisonError(
        fmt::format("{}: sampled up to {:.3g} Hz; its noise needs more than {:.3g}", pressure.name,
                    spectrum.frequency.back(), 2 * band));
  double above = 0, all = 0;
  for (std::size_t i = 0; i < spectrum.frequency.size(); ++i)
    if (spectrum.frequency[i] > band) above += spectrum.power[i];
  for (const double value : cut.value) all += value * value;
  return above / bins_of_noise / (all / static_cast<double>(cut.value.size()));
}

double plateau_noise(const TimeSeries& pressure, const CaseDefinition& definition) {
  if (!definition.impacts)
    throw ComparisonError("the case " + definition.name + " has no [impacts]");
  const ImpactsDefinition& impacts = *definition.impacts;
  if (!(impacts.plateau > 0))
    throw ComparisonError("the [impacts] of the case " + definition.name + " have no plateau");
  double sum = 0;
  std::size_t count = 0;
  for (const double time : impacts.times) {
    const double later = time - impacts.times.front();
    if (impacts.plateau_end + later > definition.duration) continue;
    std::vector<double> values =
        cut_to_window(pressure, {impacts.plateau_begin + later, impacts.plateau_end + later}).value;
    remove_trend(values);
    for (const double value : values) sum += value * value;
    count += values.size();
  }
  return std::sqrt(sum / static_cast<double>(count)) / impacts.plateau;
}

}  // namespace slosh
