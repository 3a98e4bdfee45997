// The section on wall treatments: the runs of cases with the tag "walls", named by their walls.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/assessment/pressure_noise.hpp"
#include "verification/case/quantities.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/series/impact_peaks.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double late_part = 0.2;  // the last part of the run, after the initial transient

// Returns the mean over the last fifth of the run; NaN where the run lacks the series, or the
// series has NaN or ends early.
double late_mean(const CaseAssessment& assessment, const std::string& run,
                 const std::string& series) {
  const double end = assessment.definition.duration;
  if (!has_series(assessment.runs, run, series)) return not_a_number;
  try {
    return plateau_mean(assessment.runs.results.at(run).at(series), {(1 - late_part) * end, end});
  } catch (const ComparisonError&) {
    return not_a_number;
  }
}

// Returns the noise at the case's first pressure gauge; NaN as above.
double noise_of(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  if (definition.pressure_gauges.empty()) return not_a_number;
  const std::string pressure = wall_pressure(definition.pressure_gauges.front().name);
  if (!has_series(assessment.runs, run, pressure)) return not_a_number;
  try {
    return pressure_noise(assessment.runs.results.at(run).at(pressure),
                          comparison_window(definition), noise_band(definition));
  } catch (const ComparisonError&) {
    return not_a_number;
  }
}

double nanoseconds(const RunCost& cost) {
  return 1e9 * cost.user_time / (cost.elements * cost.steps);
}

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "not available";
}

// How often a particle crossed a wall, and whether the walls hold the liquid: a count that is NaN
// or missing is not decidable.
std::pair<std::string, std::string> crossings_of(const RunResult& result) {
  const auto found = result.diagnostics.find("wall_crossings");
  if (found == result.diagnostics.end()) return {"not counted", "not decidable"};
  if (!std::isfinite(found->second)) return {"not available", "not decidable"};
  return {fmt::format("{:.0f}", found->second), found->second == 0 ? "confirmed" : "refuted"};
}

std::vector<std::string> row_of(const CaseAssessment& assessment, const std::string& run) {
  const std::string& name = assessment.definition.name;
  const auto found = assessment.runs.results.find(run);
  if (found == assessment.runs.results.end()) {
    const RunStatus& status = assessment.runs.status.at(run);
    const std::string message = status.message.empty() ? "" : ": " + status.message;
    return {name, run, "", "", "", "", "not decidable", "", state_name(status.state) + message};
  }
  const auto [crossings, holds] = crossings_of(found->second);
  return {name,
          run,
          number(late_mean(assessment, run, "wall_gap"), "{:+.3f}"),
          number(noise_of(assessment, run), "{:.2e}"),
          number(100 * late_mean(assessment, run, "volume_drift"), "{:+.3f}"),
          crossings,
          holds,
          number(nanoseconds(found->second.cost), "{:.0f}"),
          ""};
}

reports::Table table_of(const std::vector<const CaseAssessment*>& cases) {
  std::vector<std::string> bands;
  for (const CaseAssessment* one : cases)
    bands.push_back(
        fmt::format("{:.3g} Hz ({})", noise_band(one->definition), one->definition.name));
  reports::Table table{
      "walls-table",
      "Comparison of wall treatments",
      fmt::format(
          "Gap (between a wall and the nearest particles) and volume drift: mean over the last "
          "fifth of the run, where the run records it. Pressure noise: power of the first pressure "
          "gauge's series above a frequency, over its mean square with the mean included; the "
          "frequency is the larger one of 5 Hz and three times the third natural mode that surge "
          "excites: {}. Wall crossings: how often a particle beyond a wall was put back; the walls "
          "hold the liquid where that never happened. Cost: user time.",
          fmt::join(bands, ", ")),
      {"case", "walls", "gap [spacings]", "pressure noise [1]", "volume drift [%]",
       "wall crossings", "holds the liquid", "cost [ns per particle and step]", "remark"}};
  for (const CaseAssessment* one : cases)
    for (const char* treatment : wall_treatments)
      if (std::ranges::find(one->definition.runs, treatment, &RunDefinition::name) !=
          one->definition.runs.end())
        table.rows.push_back(row_of(*one, treatment));
  return table;
}

reports::Figure figure_of(const std::vector<const CaseAssessment*>& cases) {
  reports::Figure figure{.id = "walls-noise-and-cost",
                         .title = "Noise and cost of each wall treatment",
                         .caption = "Each point is a case of the table; lower left is better.",
                         .x_label = "user time [ns per particle and step]",
                         .y_label = "pressure noise [1]",
                         .log_y = true};
  for (const char* treatment : wall_treatments) {
    reports::Curve curve{.label = treatment, .style = reports::Curve::Style::points};
    for (const CaseAssessment* one : cases) {
      const auto found = one->runs.results.find(treatment);
      if (found == one->runs.results.end()) continue;
      curve.x.push_back(nanoseconds(found->second.cost));
      curve.y.push_back(noise_of(*one, treatment));
    }
    if (std::any_of(curve.y.begin(), curve.y.end(), [](double y) { return y > 0; }))
      figure.curves.push_back(std::move(curve));
  }
  return figure;
}

}  // namespace

std::optional<reports::Section> wall_treatment_section(const std::vector<CaseAssessment>& cases) {
  std::vector<const CaseAssessment*> tagged;
  for (const CaseAssessment& one : cases)
    if (std::ranges::find(one.definition.tags, "walls") != one.definition.tags.end())
      tagged.push_back(&one);
  reports::Section section{"walls", "Wall treatments", {}, {table_of(tagged)}};
  if (section.tables[0].rows.empty()) return std::nullopt;
  section.paragraphs = {
      "`repulsive_mirror` are the walls of Li et al. 2010, `dynamic_moving` and `dynamic_fixed` "
      "those of Zhao et al. 2021, `mirror` those of the scheme `recommended`."};
  reports::Figure figure = figure_of(tagged);
  if (!figure.curves.empty()) section.figures.push_back(std::move(figure));
  return section;
}

}  // namespace slosh
