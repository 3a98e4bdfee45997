// The peaks of a case's impacts as cumulative distributions: over the repeats of the experiment and
// over those of each run, each peak over the published mean of its impact, so that the impacts of a
// case stand in one curve.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/figures/run_looks.hpp"
#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;
using Repeats = std::vector<const RunDefinition*>;

// The steps of the cumulative distribution.
Curve steps_of(const std::string& label, const std::vector<double>& values) {
  Curve curve{label, {}, {}, {}, {}};
  const Distribution peaks(label, values);
  const double count = static_cast<double>(peaks.sorted().size());
  for (std::size_t i = 0; i < peaks.sorted().size(); ++i)
    for (const double below : {static_cast<double>(i), static_cast<double>(i + 1)}) {
      curve.x.push_back(peaks.sorted()[i]);
      curve.y.push_back(below / count);
    }
  return curve;
}

std::vector<double> of_experiment(const ImpactsDefinition& impacts) {
  std::vector<double> peaks;
  for (std::size_t n = 0; n < impacts.repeats.size(); ++n)
    for (const double peak : impacts.repeats[n]) peaks.push_back(peak / impacts.peak_means[n]);
  return peaks;
}

std::vector<double> of_runs(const CaseAssessment& assessment, const Repeats& repeats,
                            const std::string& pressure) {
  const ImpactsDefinition& impacts = assessment.definition.impacts.value();
  std::vector<double> peaks;
  for (std::size_t n = 0; n < impacts.times.size(); ++n)
    for (const double peak : peak_sample(assessment, repeats, pressure, n).peaks)
      peaks.push_back(peak / impacts.peak_means[n]);
  return peaks;
}

// The peak of one edge of a record's band over the published one, of a case of a single impact.
std::optional<double> edge_of_band(const CaseAssessment& assessment, const std::string& edge) try {
  const TimeSeries* series = series_of_record(assessment, edge);
  if (!series) return std::nullopt;
  const auto peak = impacts_in(*series, assessment.definition).at(0);
  if (!peak) return std::nullopt;
  return peak->pressure / assessment.definition.impacts->peak_means.at(0);
} catch (const ComparisonError&) {
  return std::nullopt;
}

// " NAME, impact 1: 20 peaks, median 1.12 (0.95 to 1.30) times the experiment's, ...; impact 2:
// ..." of runs with enough peaks; else empty.
std::string comparisons_text(const CaseAssessment& assessment, const Repeats& repeats,
                             const std::string& pressure) {
  std::string text;
  for (std::size_t n = 0; n < assessment.definition.impacts->times.size(); ++n) {
    const PeakSample sample = peak_sample(assessment, repeats, pressure, n);
    if (const auto found = against_experiment(assessment.definition, sample, n))
      text += fmt::format("{}impact {}: {} peaks, {}", text.empty() ? "" : "; ", n + 1,
                          sample.peaks.size(), comparison_text(*found));
  }
  return text.empty() ? "" : fmt::format(" {}, {}.", repeats.front()->name, text);
}

Figure distributions(const CaseAssessment& assessment, const std::string& pressure) {
  const CaseDefinition& definition = assessment.definition;
  const ImpactsDefinition& impacts = definition.impacts.value();
  const bool is_filtered = pressure.ends_with(through_filter);
  Figure figure;
  figure.id = definition.name + (is_filtered ? "-filtered-peaks" : "-peaks");
  figure.title = is_filtered ? "Distribution of the peaks, filtered" : "Distribution of the peaks";
  figure.x_label = "peak over the published one [1]";
  figure.y_label = "share of the peaks up to it [1]";
  std::vector<std::string> runs;
  std::string comparisons;
  for (const Repeats& repeats : repeated_runs(definition)) {
    const std::vector<double> peaks = of_runs(assessment, repeats, pressure);
    if (peaks.size() < 2) continue;
    runs.push_back(repeats.front()->name);
    comparisons += comparisons_text(assessment, repeats, pressure);
    figure.curves.push_back(
        steps_of(fmt::format("{}, {} peaks", runs.back(), peaks.size()), peaks));
    figure.curves.back().look = look_of(definition, runs.back());
  }
  if (figure.curves.empty()) return figure;
  if (!impacts.repeats.empty()) {
    const std::vector<double> peaks = of_experiment(impacts);
    figure.curves.insert(figure.curves.begin(),
                         steps_of(fmt::format("experiment, {} peaks", peaks.size()), peaks));
    figure.curves.front().look = guide_look(0);
  }
  if (impacts.times.size() == 1)
    for (const auto& [label, edge] :
         {std::pair{"lower edge", lower_edge}, {"upper edge", upper_edge}})
      if (const auto peak = edge_of_band(assessment, pressure + edge))
        figure.markers.push_back({label, *peak});
  // The edges of a band set no scale of their own.
  double highest = 0;
  for (const Curve& curve : figure.curves) highest = std::max(highest, curve.x.back());
  for (const reports::Marker& edge : figure.markers) highest = std::max(highest, edge.x);
  figure.x_range = {0, 1.05 * highest};
  figure.caption = fmt::format(
      "Each peak over the published mean of its impact; the steps of a curve are its peaks. Runs "
      "are repeats that differ only in their random seed. {}{} Published: {}.{}",
      figure.markers.empty()
          ? is_filtered ? "The runs are filtered and the published peaks are not. " : ""
          : "Vertical lines: the peaks of the edges of the record's band. ",
      who_is_who(definition, runs), impacts.source, comparisons);
  return figure;
}

}  // namespace

std::vector<Figure> impact_figures(const CaseAssessment& assessment) {
  if (!assessment.definition.impacts) return {};
  std::vector<Figure> figures;
  for (const std::string& pressure : impact_pressures(assessment.definition))
    if (Figure figure = distributions(assessment, pressure); !figure.curves.empty())
      figures.push_back(std::move(figure));
  return figures;
}

}  // namespace slosh
