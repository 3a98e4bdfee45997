#include "verification/campaign/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "verification/campaign/choice_table.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/metrics/spectrum.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

std::string first_quantity(const CaseDefinition& definition) {
  return compared_quantities(definition).front();
}

// How the figures show the case's first quantity, which is one of these three.
struct ShownQuantity {
  std::string word, title;
  std::string unit;  // on the axis: millimetres for metres
  double scale;      // from SI
};

std::string wall_text(const PressureGaugeDefinition& gauge) {
  if (gauge.wall == Wall::bottom)
    return fmt::format("on the bottom {:.3g} m from the left wall", gauge.position);
  return fmt::format("on the {} wall {:.3g} m above the bottom",
                     gauge.wall == Wall::left ? "left" : "right", gauge.position);
}

ShownQuantity shown_quantity(const CaseDefinition& definition) {
  if (definition.liquid.column_width)
    return {"front position", "Front of the breaking dam, from the left wall", "mm", 1000};
  if (!definition.gauges.empty())
    return {
        "elevation",
        fmt::format("Surface elevation {:.3g} m from the left wall", definition.gauges.front().x),
        "mm", 1000};
  return {"pressure", "Pressure " + wall_text(definition.pressure_gauges.front()), "Pa", 1};
}

// SPH by its scheme, the others by their kind: the runs of a family differ in resolution alone.
std::string family(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) return sph->scheme;
  if (std::holds_alternative<InterFoamRun>(run.solver)) return "interFoam";
  return run.name;
}

double resolution(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return 1 / (sph->particle_spacing * sph->surface_particle_spacing);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return 1.0 * mesh->cells_x * mesh->cells_z;
  return 0;
}

// Whether an SPH run has something of its scheme changed.
bool is_changed(const RunDefinition& run) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  return sph && !changes_of(*sph).empty();
}

// The finest run of each family that stands, in the order of the case file; one that changes
// something of its scheme only where the family has no other.
std::vector<std::string> finest_runs(const CaseAssessment& assessment) {
  std::vector<std::string> families;
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (!assessment.runs.results.contains(run.name) ||
        !has_series(assessment.runs, run.name, first_quantity(assessment.definition)))
      continue;
    const RunDefinition*& best = finest[family(run)];
    if (!best) families.push_back(family(run));
    const auto preference = [](const RunDefinition& one) {
      return std::pair{!is_changed(one), resolution(one)};
    };
    if (!best || preference(run) > preference(*best)) best = &run;
  }
  std::vector<std::string> names;
  for (const std::string& one : families) names.push_back(finest[one]->name);
  return names;
}

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

std::string label(const CaseAssessment& assessment, const std::string& run) {
  return assessment.runs.status.at(run).state == RunState::out_of_range
             ? run + " (out of its range)"
             : run;
}

// A record as points with its uncertainty, anything else as a line.
Curve history_curve(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  const TimeSeries& series = assessment.runs.results.at(run).at(first_quantity(definition));
  const double scale = shown_quantity(definition).scale;
  Curve curve{label(assessment, run), series.time, scaled(series.value, scale), {}, {}};
  if (const auto* record = std::get_if<RecordRun>(&run_named(definition, run).solver)) {
    curve.style = Curve::Style::points;
    if (record->uncertainty) curve.y_error.assign(curve.y.size(), scale * *record->uncertainty);
  }
  return curve;
}

Figure history(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  figure.id = definition.name + "-history";
  const ShownQuantity shown = shown_quantity(definition);
  figure.title = shown.title;
  figure.caption =
      "Time history: the references and the finest run of each solver; bars are a record's 95 % "
      "interval. " +
      definition.source + ".";
  figure.x_label = "time [s]";
  figure.y_label = fmt::format("{} [{}]", shown.word, shown.unit);
  figure.x_range = {0, definition.duration};
  for (const std::string& run : finest_runs(assessment))
    figure.curves.push_back(history_curve(assessment, run));
  return figure;
}

// The limit of the case's normalised_rms row in the quantity's own unit: rms error allowed; zero
// where no row gives one.
double tolerated_residual(const CaseAssessment& assessment, const Comparison& comparison) {
  for (const GateRow& row : assessment.definition.gate)
    if (row.metric == Metric::normalised_rms && row.limit &&
        row.candidate == comparison.candidate && row.reference == comparison.reference &&
        row.quantity == comparison.quantity) {
      double sum2 = 0;
      for (const double r : comparison.residual.value) sum2 += r * r;
      const double rms = std::sqrt(sum2 / static_cast<double>(comparison.residual.value.size()));
      return *row.limit * rms / comparison.normalised_rms;
    }
  return 0;
}

Figure residuals(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  figure.id = definition.name + "-residual";
  figure.title = "Residual against the reference";
  figure.caption =
      "Candidate minus its reference over the comparison window, for the finest run of each "
      "solver. A band is the rms "
      "residual that the gate tolerates.";
  figure.x_label = "time [s]";
  const ShownQuantity shown = shown_quantity(definition);
  figure.y_label = fmt::format("residual [{}]", shown.unit);
  const auto finest = finest_runs(assessment);
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const Comparison& comparison = *judging;
    if (std::find(finest.begin(), finest.end(), comparison.candidate) == finest.end()) continue;
    figure.curves.push_back({comparison.candidate + " - " + comparison.reference,
                             comparison.residual.time,
                             scaled(comparison.residual.value, shown.scale),
                             {},
                             {}});
    if (const double band = shown.scale * tolerated_residual(assessment, comparison); band > 0)
      figure.bands.push_back({"tolerance, " + comparison.candidate, -band, band});
  }
  return figure;
}

// Nothing of a series that cannot be compared: the gate says why.
std::optional<Spectrum> spectrum_of(const CaseAssessment& assessment, const std::string& run) try {
  const CaseDefinition& definition = assessment.definition;
  return power_spectrum(assessment.runs.results.at(run).at(first_quantity(definition)),
                        {definition.window_begin, definition.window_end});
} catch (const ComparisonError&) {
  return std::nullopt;
}

Figure spectra(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  // A tank that stands, a dam that breaks: there is no tone to look for.
  if (fitted_modes(definition).empty()) return figure;
  figure.id = definition.name + "-spectrum";
  figure.title = "Spectrum of the " + shown_quantity(definition).word;
  figure.x_label = "frequency [Hz]";
  figure.y_label = fmt::format("power [{}2]", unit_of(first_quantity(definition)));
  figure.log_y = true;
  double highest = 0, apart = 0;
  constexpr int marked_natural_modes = 3;
  for (const ToneRequest& mode : modes_of(definition, marked_natural_modes)) {
    const double frequency = mode.angular_frequency / (2 * std::numbers::pi);
    figure.markers.push_back({mode.name, frequency});
    highest = std::max(highest, frequency);
  }
  const double shown = 1.3 * highest;
  figure.x_range = {0, shown};
  for (const std::string& run : finest_runs(assessment)) {
    const auto spectrum = spectrum_of(assessment, run);
    if (!spectrum) continue;
    apart = spectrum->resolution;
    Curve curve{label(assessment, run), {}, {}, {}, {}};
    for (std::size_t i = 0; i < spectrum->frequency.size() && spectrum->frequency[i] <= shown;
         ++i) {
      curve.x.push_back(spectrum->frequency[i]);
      curve.y.push_back(spectrum->power[i]);
    }
    figure.curves.push_back(std::move(curve));
  }
  figure.caption = fmt::format(
      "One-sided, detrended, Hann window over the comparison window; vertical lines mark the "
      "forcing and the natural frequencies of linear theory{}. The window tells frequencies {:.2g} "
      "Hz apart; zero-padding "
      "adds no resolution.",
      definition.obstacles.empty() ? "" : ", which knows no obstacle", apart);
  return figure;
}

// More changes than the figures have colours do not make a legend that one can read.
constexpr std::size_t most_changes_named = 6;

std::size_t count_changes(const CaseAssessment& assessment) {
  std::set<std::string> changes;
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const RunDefinition& run = run_named(assessment.definition, judging->candidate);
    if (is_changed(run)) changes.insert(family(run) + changes_of(std::get<SphRun>(run.solver)));
  }
  return changes.size();
}

// Under which label a run is a point: an unchanged one with its family, a changed one with what it
// changes, or with all that change anything of its scheme.
std::string cost_label(const RunDefinition& run, bool name_changes) {
  if (!is_changed(run)) return family(run);
  return family(run) + ", " +
         (name_changes ? changes_of(std::get<SphRun>(run.solver)) : "one choice changed");
}

// Each family a curve, each change of one points of its own.
Figure error_against_run_time(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  figure.id = definition.name + "-cost";
  figure.title = "Error against run time";
  figure.caption =
      "Normalised rms error over the comparison window against the processor time of the run (user "
      "and system, all "
      "processes), other runs beside it.";
  figure.x_label = "processor time [s]";
  figure.y_label = "normalised rms error [1]";
  figure.log_x = figure.log_y = true;
  const bool name_changes = count_changes(assessment) <= most_changes_named;
  std::map<std::string, std::multimap<double, std::pair<double, double>>> points;
  std::map<std::string, Curve::Style> styles;
  std::vector<std::string> labels;
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const Comparison& comparison = *judging;
    const RunDefinition& run = run_named(definition, comparison.candidate);
    const RunCost& cost = assessment.runs.results.at(run.name).cost;
    const std::string name = cost_label(run, name_changes) + " against " + comparison.reference;
    if (!points.contains(name)) labels.push_back(name);
    points[name].insert(
        {resolution(run), {cost.user_time + cost.system_time, comparison.normalised_rms}});
    styles[name] = is_changed(run) ? Curve::Style::points : Curve::Style::line_points;
  }
  for (const std::string& name : labels) {
    Curve curve{name, {}, {}, {}, styles[name]};
    for (const auto& [fineness, point] : points[name]) {
      curve.x.push_back(point.first);
      curve.y.push_back(point.second);
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

}  // namespace

std::vector<Figure> case_figures(const CaseAssessment& assessment) {
  std::vector<Figure> figures;
  for (auto make : {history, residuals, spectra, error_against_run_time}) {
    Figure figure = make(assessment);
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace slosh
