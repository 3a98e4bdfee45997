// The energy budget of the SPH runs that recorded one, the finest of each scheme.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/figures/figure_kinds.hpp"
#include "reports/figures/figure_runs.hpp"

namespace slosh {
namespace {

using reports::Figure;

constexpr std::pair<const char*, const char*> parts[] = {
    {"kinetic_energy", "kinetic"},       {"potential_energy", "potential"},
    {"internal_energy", "internal"},     {"wall_work", "work of the walls"},
    {"dissipated_energy", "dissipated"}, {"energy_residual", "residual"}};

const TimeSeries* find(const RunResult& result, const std::string& name) {
  const auto found = std::find_if(result.series.begin(), result.series.end(),
                                  [&](const TimeSeries& series) { return series.name == name; });
  return found == result.series.end() || found->value.empty() ? nullptr : &*found;
}

bool has_budget(const RunResult& result) {
  return std::all_of(std::begin(parts), std::end(parts),
                     [&](const auto& part) { return find(result, part.first); });
}

Figure budget(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  figure.id = definition.name + "-energy-" + run;
  figure.title = "Energy budget of " + run;
  figure.caption =
      "Changes since the start, in the frame of the earth, per metre of width: kinetic + potential "
      "+ internal = work of the walls - dissipated + residual. Work and dissipation are summed up "
      "along the run. " +
      who_is_who(definition, {run});
  figure.x_label = "time [s]";
  figure.y_label = "energy [J/m]";
  figure.x_range = {0, definition.duration};
  for (const auto& [name, word] : parts) {
    const TimeSeries& series = *find(assessment.runs.results.at(run), name);
    reports::Curve curve{word, series.time, series.value, {}, {}};
    for (double& value : curve.y) value -= series.value.front();
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

}  // namespace

std::vector<Figure> energy_figures(const CaseAssessment& assessment) {
  std::vector<Figure> figures;
  for (const std::string& run : finest_runs(assessment, has_budget))
    figures.push_back(budget(assessment, run));
  return figures;
}

}  // namespace slosh
