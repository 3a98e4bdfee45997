// Figures over time: the time series of every compared quantity, residuals and the energy budget.
//
// Power spectra over the comparison window, with the frequencies that theory predicts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/history_uncertainty.hpp"
#include "verification/series/sample_moments.hpp"
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

// Adds what rows on the candidate alone allow, unless the curves would be flat beside it.
void add_limits(const CaseDefinition& definition, const std::string& quantity, double scale,
                Figure& figure) {
  double largest = 0, lowest = 0;
  for (const Curve& curve : figure.curves) {
    largest = std::max(largest, farthest_from(0, curve));
    for (const double y : curve.y) lowest = std::min(lowest, y);
  }
  for (const GateRow& row : definition.gate) {
    if (row.metric != Metric::largest_magnitude || row.quantity != quantity || !row.limit) continue;
    const double limit = scale * *row.limit;
    if (limit > 4 * largest) continue;
    add_tolerance_band({row.candidate, lowest < 0 ? -limit : 0, limit, {}}, figure);
  }
}

Figure history(const CaseAssessment& assessment, const std::string& quantity,
               const HistoryAxes& axes) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  const std::vector<std::string> runs = finest_runs(assessment, quantity);
  Figure figure = histories(assessment, quantity, runs, axes);
  figure.id = case_id(definition.name) + "-" +
              (quantity == compared_quantities(definition).front() ? "history" : id_of(quantity));
  figure.title = shown.title;
  figure.caption =
      axes.symbols +
      "Time series of the references and of the finest run of each scheme and solver. " +
      measured_how(shown, definition, runs) + who_is_who(definition, runs) + " " +
      definition.source + ".";
  figure.x_range = {0, axes.scales.time * definition.duration};
  figure.spans = outside_window(definition, quantity, axes.scales.time);
  add_limits(definition, quantity, axes.scales.value, figure);
  bool has_ribbon = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<double> widths =
        numerical_half_widths(definition, assessment.runs, runs[i], quantity);
    if (widths.empty()) continue;
    for (double& width : widths) width *= axes.scales.value;
    set_uncertainty(figure.curves[i], widths, "95 % numerical uncertainty");
    has_ribbon = true;
  }
  if (has_ribbon)
    figure.caption +=
        " Ribbons around solvers: 95 % numerical uncertainty from coarser runs (Celik et al. 2008, "
        "one order for the whole series; ribbons are narrow where the series cross).";
  figure.caption += cut_off_text(figure);
  return figure;
}

constexpr std::pair<const char*, const char*> parts[] = {
    {"kinetic_energy", "kinetic"},       {"potential_energy", "potential"},
    {"internal_energy", "internal"},     {"wall_work", "work of the walls"},
    {"dissipated_energy", "dissipated"}, {"energy_residual", "residual"}};

const TimeSeries* find(const RunResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.series, name, &TimeSeries::name);
  return found == result.series.end() || found->value.empty() ? nullptr : &*found;
}

bool has_budget(const RunResult& result) {
  return std::ranges::all_of(parts, [&](const auto& part) { return find(result, part.first); });
}

Figure budget(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure{.id = case_id(definition.name) + "-energy-" + name_id(run),
                .title = "Energy budget of " + run,
                .caption =
                    "Changes since the start, in the earth-fixed frame, per metre of width: "
                    "kinetic + potential + internal = work of the walls - dissipated + residual. "
                    "Work and dissipation are integrated over the run. " +
                    who_is_who(definition, {run}),
                .x_label = "time [s]",
                .y_label = "energy [J/m]",
                .x_range = {0, definition.duration}};
  for (const auto& [name, word] : parts) {
    const TimeSeries& series = *find(assessment.runs.results.at(run), name);
    figure.curves.push_back({word, series.time, series.value});
    for (double& value : figure.curves.back().y) value -= series.value.front();
  }
  return figure;
}

// Returns the rms residual that the gate row on normalised_rms allows, in the quantity's unit; zero
// where no row limits it.
double tolerated_residual(const CaseAssessment& assessment, const Comparison& comparison) {
  for (const GateRow& row : assessment.definition.gate)
    if (row.metric == Metric::normalised_rms && row.limit && !row.part &&
        row.candidate == comparison.candidate && row.reference == comparison.reference &&
        row.quantity == comparison.quantity)
      return *row.limit * rms(comparison.residual.value) / comparison.normalised_rms.value;
  return 0;
}

// Those that gate rows judge; the first of a case without rows.
std::vector<std::string> main_quantities(const CaseDefinition& definition) {
  std::vector<std::string> quantities = compared_quantities(definition);
  const std::string first = quantities.front();
  std::erase_if(quantities, [&](const std::string& quantity) {
    return std::none_of(definition.gate.begin(), definition.gate.end(),
                        [&](const GateRow& row) { return row.quantity == quantity; });
  });
  return quantities.empty() ? std::vector<std::string>{first} : quantities;
}

std::vector<Figure> with_curves(std::vector<Figure> figures) {
  std::erase_if(figures, [](const Figure& figure) { return figure.curves.empty(); });
  return figures;
}

}  // namespace

Figure spectrum_figure(const CaseAssessment& assessment, const std::string& quantity,
                       const std::vector<std::string>& candidates) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  const bool is_main = quantity == compared_quantities(definition).front();
  Figure figure{
      .id = case_id(definition.name) + "-spectrum" + (is_main ? "" : "-" + id_of(quantity)),
      .title = "Spectrum of the " + shown.word +
               (is_main ? "" : " at gauge " + quantity.substr(quantity.find('@') + 1)),
      .x_label = "frequency [Hz]",
      .y_label = fmt::format("power [{}2]", unit_of(quantity)),
      .log_y = true,
      .markers = expected_frequencies(definition)};
  double highest = 0;
  for (const Marker& marker : figure.markers) highest = std::max(highest, marker.x);
  figure.x_range = {0, 1.3 * highest};
  double resolution_hz = 0;
  std::vector<std::string> runs;
  for (const std::string& run : candidates) {
    const auto found = spectrum_of(assessment, run, quantity);
    if (!found) continue;
    runs.push_back(run);
    resolution_hz = found->resolution;
    const auto end = std::ranges::upper_bound(found->frequency, figure.x_range.second);
    const auto count = end - found->frequency.begin();
    figure.curves.push_back({.label = run_label(assessment, run),
                             .x = {found->frequency.begin(), end},
                             .y = {found->power.begin(), found->power.begin() + count},
                             .look = look_of(definition, run),
                             .sets_scale = is_in_range(assessment, run)});
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
  for (const std::string& quantity : quantities)
    figures.push_back(spectrum_figure(assessment, quantity, finest_runs(assessment, quantity)));
  return with_curves(std::move(figures));
}

std::vector<Figure> main_histories(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<Figure> figures;
  for (const std::string& quantity : main_quantities(definition))
    figures.push_back(history(assessment, quantity, axes_with_units(definition, quantity)));
  return with_curves(std::move(figures));
}

std::vector<Figure> other_histories(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<std::string> main = main_quantities(definition);
  std::vector<Figure> figures;
  for (const std::string& quantity : compared_quantities(definition))
    if (!is_one_of(quantity, main))
      figures.push_back(history(
          assessment, quantity,
          axes_over_depth(definition, quantity).value_or(axes_with_units(definition, quantity))));
  return with_curves(std::move(figures));
}

std::vector<Figure> residual_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::string quantity = compared_quantities(definition).front();
  const ShownQuantity shown = shown_quantity(definition, quantity);
  Figure figure{
      .id = case_id(definition.name) + "-residual",
      .title = "Residual against the reference",
      .caption = fmt::format("The {}: candidate minus reference over the comparison window, for "
                             "the finest run of each scheme and solver.",
                             shown.word),
      .x_label = "time [s]",
      .y_label = fmt::format("residual [{}]", shown.unit),
      .x_range = {definition.window_begin, definition.window_end}};
  for (const Comparison* judging : shown_comparisons(assessment)) {
    figure.curves.push_back({.label = judging->candidate + " - " + judging->reference,
                             .x = judging->residual.time,
                             .y = judging->residual.value,
                             .look = look_of(definition, judging->candidate)});
    for (double& value : figure.curves.back().y) value *= shown.scale;
    if (const double band = shown.scale * tolerated_residual(assessment, *judging); band > 0)
      add_tolerance_band({judging->candidate, -band, band, figure.curves.back().look}, figure);
  }
  if (figure.curves.empty()) return {};
  let_most_set_scale(figure, [](const Curve& curve) { return farthest_from(0, curve); });
  figure.caption += cut_off_text(figure);
  if (!figure.bands.empty()) figure.caption += " Bands show the rms residual that the gate allows.";
  return {figure};
}

std::vector<Figure> energy_figures(const CaseAssessment& assessment) {
  std::vector<Figure> figures;
  for (const std::string& run : finest_runs(assessment, has_budget))
    figures.push_back(budget(assessment, run));
  return figures;
}

}  // namespace slosh
