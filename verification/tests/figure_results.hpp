// Series and snapshots made by hand, added to the small surge's results, and what its figures show
// of them.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reports/figures/case_figures.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh {

// scale (1 + sin(w t)), w the forcing's, over the whole case.
inline TimeSeries waving(const std::string& name, const std::string& unit, double scale) {
  TimeSeries series{name, unit, {}, {}};
  for (int i = 0; i <= 1000; ++i) {
    series.time.push_back(0.02 * i);
    series.value.push_back(scale * (1 + std::sin(0.3 * 4.94488 * series.time.back())));
  }
  return series;
}

inline void add_series(CaseRuns& runs, const std::string& run, const std::string& name,
                       const std::string& unit, double scale) {
  runs.results.at(run).series.push_back(waving(name, unit, scale));
}

// A surge with a pressure gauge and its filter, where theory, particles and mesh left a pressure.
inline CaseDefinition gauged_surge() {
  CaseDefinition definition = surge_case();
  definition.pressure_gauges = {{"B", Wall::left, 0.2, 0.004, 5}};
  RunDefinition record = sample_run(RecordRun{"b.csv", "wall_pressure@B", "Pa", {0, 20}, {}, 3.0});
  record.name = "measured";
  definition.runs.push_back(record);
  return definition;
}

inline CaseRuns gauged_runs() {
  CaseRuns runs = surge_runs();
  add_series(runs, "theory", "wall_pressure@B", "Pa", 1000);
  add_series(runs, "particles", "wall_pressure@B", "Pa", 1010);
  add_series(runs, "fine_mesh", "wall_pressure@B", "Pa", 1020);
  runs.results["measured"] = result_of("measured", waving("wall_pressure@B", "Pa", 1030));
  runs.status["measured"] = {RunState::finished, ""};
  return runs;
}

inline FieldSnapshot snapshot_at(double time, double pressure) {
  return {.time = time,
          .width = 0.01,
          .height = 0.02,
          .x = {0.1, 0.2},
          .z = {0.3, 0.4},
          .velocity_x = {1, 2},
          .velocity_z = {3, 4},
          .pressure = {pressure, 2 * pressure}};
}

inline std::vector<std::string> ids(const std::vector<reports::Figure>& figures) {
  std::vector<std::string> names;
  for (const reports::Figure& figure : figures) names.push_back(figure.id);
  return names;
}

// The surge with theory and these runs instead of its own, which nothing judges.
inline CaseAssessment unjudged(const std::vector<ScaledRun>& runs) {
  CaseAssessment assessment{surge_case(), {}, {}, {}, {}};
  std::vector<RunDefinition>& declared = assessment.definition.runs;
  declared.resize(1);
  assessment.runs.results["theory"] = result_of("theory", elevation_of({}));
  for (const ScaledRun& one : runs) {
    declared.push_back(sample_run(one.solver));
    declared.back().name = one.name;
    assessment.runs.results[one.name] = result_of(one.name, scaled(elevation_of({}), one.scale));
  }
  for (const RunDefinition& run : declared)
    assessment.runs.status[run.name] = {RunState::finished, ""};
  return assessment;
}

// On the case's page and in its appendix.
inline std::vector<reports::Figure> figures_of(const CaseAssessment& assessment) {
  std::vector<reports::Figure> figures = case_figures(assessment);
  for (const reports::Figure& figure : appendix_figures(assessment)) figures.push_back(figure);
  return figures;
}

// Of the given id behind "small_surge-"; an empty one where there is none.
inline reports::Figure figure_of(const std::vector<reports::Figure>& figures,
                                 const std::string& id) {
  for (const reports::Figure& figure : figures)
    if (figure.id == "small_surge-" + id) return figure;
  return {};
}

inline reports::Figure figure_of(const CaseAssessment& assessment, const std::string& id) {
  return figure_of(figures_of(assessment), id);
}

inline std::vector<std::string> labels(const reports::Figure& figure) {
  std::vector<std::string> names;
  for (const reports::Curve& curve : figure.curves) names.push_back(curve.label);
  return names;
}

}  // namespace slosh
