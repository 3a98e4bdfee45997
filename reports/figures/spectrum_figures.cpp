// Power spectra over the comparison window, with the frequencies that theory predicts.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/figures/run_looks.hpp"
#include "reports/wording/report_places.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;
using reports::Marker;

// Returns nullopt for a series that cannot be compared or is constant; the gate reports why.
std::optional<Spectrum> spectrum_of(const CaseAssessment& assessment, const std::string& run,
                                    const std::string& quantity) try {
  const CaseDefinition& definition = assessment.definition;
  const TimeSeries& series = assessment.runs.results.at(run).at(quantity);
  const TimeWindow window{definition.window_begin, definition.window_end};
  require_variation(cut_to_window(series, window));
  return power_spectrum(series, window);
} catch (const ComparisonError&) {
  return std::nullopt;
}

// Returns the forcing frequency, twice it, and the natural modes that the case fits, at least one.
std::vector<Marker> expected_frequencies(const CaseDefinition& definition) {
  std::vector<Marker> markers;
  for (const ToneRequest& mode : modes_of(definition, std::max(1, definition.natural_modes)))
    markers.push_back({mode.name, mode.angular_frequency / (2 * std::numbers::pi)});
  if (const double forcing = forcing_frequency(definition); forcing > 0)
    markers.push_back({"2 x forced", forcing / std::numbers::pi});
  return markers;
}

Curve shown_part(const std::string& label, const Spectrum& spectrum, double highest_frequency) {
  const auto end =
      std::upper_bound(spectrum.frequency.begin(), spectrum.frequency.end(), highest_frequency);
  const auto count = end - spectrum.frequency.begin();
  return {label,
          {spectrum.frequency.begin(), end},
          {spectrum.power.begin(), spectrum.power.begin() + count},
          {},
          {}};
}

}  // namespace

Figure spectrum_figure(const CaseAssessment& assessment, const std::string& quantity,
                       const std::vector<std::string>& candidates) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  const bool is_main = quantity == compared_quantities(definition).front();
  Figure figure;
  figure.id = case_id(definition.name) + "-spectrum" + (is_main ? "" : "-" + id_of(quantity));
  figure.title = "Spectrum of the " + shown.word +
                 (is_main ? "" : " at gauge " + quantity.substr(quantity.find('@') + 1));
  figure.x_label = "frequency [Hz]";
  figure.y_label = fmt::format("power [{}2]", unit_of(quantity));
  figure.log_y = true;
  figure.markers = expected_frequencies(definition);
  double highest = 0, resolution_hz = 0;
  for (const Marker& marker : figure.markers) highest = std::max(highest, marker.x);
  figure.x_range = {0, 1.3 * highest};
  std::vector<std::string> runs;
  for (const std::string& run : candidates) {
    const auto found = spectrum_of(assessment, run, quantity);
    if (!found) continue;
    runs.push_back(run);
    resolution_hz = found->resolution;
    figure.curves.push_back(shown_part(run_label(assessment, run), *found, figure.x_range.second));
    figure.curves.back().look = look_of(definition, run);
    figure.curves.back().sets_scale = is_in_range(assessment, run);
  }
  figure.caption = fmt::format(
      "One-sided, detrended, Hann window from {} to {} s. Vertical lines mark {} and the natural "
      "frequencies of linear theory{}. The frequency resolution is {:.2g} Hz; zero-padding does "
      "not improve it. {}",
      definition.window_begin, definition.window_end,
      forced_modes(definition).size() > 1 ? "the frequencies of the motion"
                                          : "the forcing frequency, twice that,",
      definition.obstacles.empty() ? "" : " (without the obstacles)", resolution_hz,
      who_is_who(definition, runs));
  figure.caption += cut_off_text(figure);
  return figure;
}

std::vector<Figure> spectrum_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  // A still tank and a dam break have no tone to look for.
  if (fitted_modes(definition).empty()) return {};
  std::vector<std::string> quantities = compared_quantities(definition);
  const std::string main = quantities.front();
  std::erase_if(quantities, [&](const std::string& quantity) {
    return quantity != main && find_quantity(quantity)->at != MeasuredAt::surface_gauge;
  });
  std::vector<Figure> figures;
  for (const std::string& quantity : quantities) {
    Figure figure = spectrum_figure(assessment, quantity, finest_runs(assessment, quantity));
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace slosh
