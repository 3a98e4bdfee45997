// The peaks of each impact of a case as cumulative distributions: those of the experiment's repeats
// and those of each ensemble. The impacts are not put together: an ensemble with one impact too
// high and another too low would look right.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;
using Repeats = std::vector<const RunDefinition*>;

// The steps of the cumulative distribution of the peaks over the published one.
Curve steps_of(const std::string& label, std::vector<double> peaks, double published,
               const reports::Look& look) {
  Curve curve{.label = label, .look = look};
  std::ranges::sort(peaks);
  const double count = static_cast<double>(peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i)
    for (const double below : {static_cast<double>(i), static_cast<double>(i + 1)}) {
      curve.x.push_back(peaks[i] / published);
      curve.y.push_back(below / count);
    }
  return curve;
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

Figure distributions(const CaseAssessment& assessment, const std::string& pressure,
                     std::size_t impact) {
  const CaseDefinition& definition = assessment.definition;
  const ImpactsDefinition& impacts = definition.impacts.value();
  const double published = impacts.peak_means.at(impact);
  const bool of_filtered = is_filtered(pressure);
  const bool is_only = impacts.times.size() == 1;
  Figure figure{
      .id = fmt::format("{}{}-peaks{}", case_id(definition.name), of_filtered ? "-filtered" : "",
                        is_only ? "" : fmt::format("-{}", impact + 1)),
      .title = fmt::format("Distribution of the peaks{}{}",
                           is_only ? "" : fmt::format(" of impact {}", impact + 1),
                           of_filtered ? ", filtered" : ""),
      .x_label = "peak over the published one [1]",
      .y_label = "share of the peaks up to it [1]"};
  std::vector<std::string> runs;
  std::string comparisons;
  for (const Repeats& repeats : repeated_runs(definition)) {
    const PeakSample sample = peak_sample(assessment, repeats, pressure, impact);
    if (sample.peaks.size() < 2) continue;
    const std::string& run = runs.emplace_back(repeats.front()->name);
    if (const auto found = against_experiment(definition, sample, impact))
      comparisons +=
          fmt::format(" {}: {} peaks, {}.", run, sample.peaks.size(), comparison_text(*found));
    figure.curves.push_back(steps_of(fmt::format("{}, {} peaks", run, sample.peaks.size()),
                                     sample.peaks, published, look_of(definition, run)));
  }
  if (figure.curves.empty()) return figure;
  if (!impacts.repeats.empty()) {
    const std::vector<double>& peaks = impacts.repeats.at(impact);
    figure.curves.insert(figure.curves.begin(),
                         steps_of(fmt::format("experiment, {} peaks", peaks.size()), peaks,
                                  published, guide_look(0)));
  }
  if (is_only)
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
      "The steps of a curve are its peaks, each divided by the published peak. The repeats of a "
      "run differ only in their random seed, by which their starts are disturbed or their inputs "
      "are drawn. {}{} Published: {}.{}",
      figure.markers.empty()
          ? of_filtered ? "The runs are filtered and the published peaks are not. " : ""
          : "Vertical lines: the peaks of the edges of the record's band. ",
      who_is_who(definition, runs), impacts.source, comparisons);
  return figure;
}

}  // namespace

std::vector<Figure> impact_figures(const CaseAssessment& assessment) {
  if (!assessment.definition.impacts) return {};
  std::vector<Figure> figures;
  for (const std::string& pressure : impact_pressures(assessment.definition))
    for (std::size_t n = 0; n < assessment.definition.impacts->times.size(); ++n)
      if (Figure figure = distributions(assessment, pressure, n); !figure.curves.empty())
        figures.push_back(std::move(figure));
  return figures;
}

}  // namespace slosh
