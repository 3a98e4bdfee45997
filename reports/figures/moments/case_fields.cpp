// Flow fields side by side: one row for each time, one column for the finest run of each scheme and
// of interFoam.
#include "reports/figures/moments/case_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/drawing/field_range.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/motion.hpp"

namespace slosh {
namespace {

using reports::FieldFigure;
using reports::FieldPanel;

// More columns would make the panels too small to read, more rows would not fit on a screen.
constexpr std::size_t most_columns = 4, most_rows = 4;

// Splits into as few parts as possible of at most `most` values each, of nearly equal size.
template <class Value>
std::vector<std::vector<Value>> in_parts(const std::vector<Value>& values, std::size_t most) {
  const std::size_t count = (values.size() + most - 1) / most;
  std::vector<std::vector<Value>> cut;
  for (std::size_t i = 0; i < count; ++i)
    cut.emplace_back(values.begin() + static_cast<long>(i * values.size() / count),
                     values.begin() + static_cast<long>((i + 1) * values.size() / count));
  return cut;
}

std::string times_text(const std::vector<double>& times) {
  switch (times.size()) {
    case 1:
      return fmt::format("at {:g} s", times.front());
    case 2:
      return fmt::format("at {:g} and {:g} s", times.front(), times.back());
    default:
      return fmt::format("from {:g} to {:g} s", times.front(), times.back());
  }
}

FieldFigure field_figure(const CaseAssessment& assessment, const std::vector<double>& times,
                         const std::vector<std::string>& runs) {
  const CaseDefinition& definition = assessment.definition;
  FieldFigure figure;
  figure.title = "Pressure and velocity " + times_text(times);
  figure.caption = "Each row is a time, each column a run: the finest of each scheme and solver. " +
                   field_caption(definition, runs);
  figure.value_label = field_quantity;
  figure.columns = static_cast<int>(runs.size());
  for (const double time : times)
    for (const std::string& run : runs) figure.panels.push_back(panel_of(assessment, run, time));
  return figure;
}

// Numbers the pictures and gives them one scale of colours, so that they can be compared.
void set_side_by_side(std::vector<FieldFigure>& figures) {
  if (figures.size() < 2) return;
  FieldFigure all;
  for (const FieldFigure& one : figures)
    all.panels.insert(all.panels.end(), one.panels.begin(), one.panels.end());
  const reports::ColourRange range = reports::colour_range(all);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    figures[i].title += fmt::format(" ({} of {})", i + 1, figures.size());
    figures[i].caption += " All pictures have the same scale of colours.";
    figures[i].value_range = {range.lower, range.upper};
  }
}

}  // namespace

const FieldSnapshot* snapshot_at(const CaseAssessment& assessment, const std::string& run,
                                 double time) {
  return snapshot_at(assessment.definition, assessment.runs.results.at(run), time);
}

std::string moment_label(const CaseDefinition& definition, double time,
                         std::optional<int> decimals) {
  const std::string label =
      decimals ? fmt::format("t = {:.{}f} s", time, *decimals) : fmt::format("t = {:g} s", time);
  const auto roll = roll_motion(definition);
  if (!roll) return label;
  const double degrees = roll->angle(time) / radians_per_degree;
  return fmt::format("{}, roll {}{:.2f}°", label, degrees < 0 ? "−" : "", std::abs(degrees));
}

FieldPanel panel_of(const CaseAssessment& assessment, const std::string& run, double time) {
  const CaseDefinition& definition = assessment.definition;
  FieldPanel panel;
  panel.label = run + ", " + moment_label(definition, time);
  panel.tank_length = panel.point_width = definition.tank.length;
  panel.tank_height = panel.point_height = definition.tank.height;
  for (const Corner& corner : definition.tank.outline)
    panel.outline.push_back({corner.x, corner.z});
  if (const auto roll = roll_motion(definition)) {
    panel.angle = roll->angle(time);
    panel.axis_x = roll->axis_x;
    panel.axis_z = roll->axis_z;
  }
  const FieldSnapshot* snapshot = snapshot_at(assessment, run, time);
  if (!snapshot) {
    panel.label += ", not recorded";
    return panel;
  }
  panel.point_width = snapshot->width;
  panel.point_height = snapshot->height;
  panel.x = panel.arrow_x = snapshot->x;
  panel.z = panel.arrow_z = snapshot->z;
  panel.value = snapshot->pressure;
  panel.arrow_u = snapshot->velocity_x;
  panel.arrow_w = snapshot->velocity_z;
  return panel;
}

std::string field_caption(const CaseDefinition& definition, const std::vector<std::string>& runs) {
  return fmt::format(
      "Colour: pressure above that of the gas. Arrows: velocity relative to the tank{}. SPH: all "
      "particles; OpenFOAM: the cells that are at least half liquid. {} {}.",
      definition.motion.roll ? ", drawn at its roll angle" : "", who_is_who(definition, runs),
      definition.source);
}

std::vector<FieldFigure> case_fields(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<std::string> runs =
      finest_runs(assessment, [](const RunResult& result) { return !result.snapshots.empty(); });
  std::vector<double> times = definition.snapshot_times;
  std::erase_if(times, [&](double time) {
    return std::none_of(runs.begin(), runs.end(),
                        [&](const std::string& run) { return snapshot_at(assessment, run, time); });
  });
  std::vector<FieldFigure> figures;
  for (const auto& times_shown : in_parts(times, most_rows))
    for (const auto& columns : in_parts(runs, most_columns)) {
      figures.push_back(field_figure(assessment, times_shown, columns));
      figures.back().id = fmt::format("{}-fields-{}", definition.name, figures.size());
    }
  set_side_by_side(figures);
  if (std::optional<FieldFigure> film = case_film(assessment)) figures.push_back(std::move(*film));
  return figures;
}

}  // namespace slosh
