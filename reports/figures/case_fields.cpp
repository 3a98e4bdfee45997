// Flow fields side by side: one row for each time, one column for the finest run of each scheme and
// of interFoam; and the animation, whose rows are shown one after the other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reports/drawing/field_parts.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/gate/field_metrics.hpp"

namespace slosh {
namespace {

using reports::FieldFigure;
using reports::FieldPanel;

using Names = std::vector<std::string>;

// More columns would make the panels too small to read, more rows would not fit on a screen.
constexpr std::size_t most_columns = 4, most_rows = 4;

constexpr const char* field_quantity = "pressure [Pa]";

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

// Returns null where the run recorded no field at that time.
const FieldSnapshot* snapshot_at(const CaseAssessment& assessment, const std::string& run,
                                 double time) {
  return snapshot_at(assessment.definition, assessment.runs.results.at(run), time);
}

std::string moment_label(const CaseDefinition& definition, double time) {
  const std::string label = fmt::format("t = {:g} s", time);
  const auto roll = roll_motion(definition);
  if (!roll) return label;
  const double degrees = roll->angle(time) / radians_per_degree;
  return fmt::format("{}, roll {}{:.2f}°", label, degrees < 0 ? "−" : "", std::abs(degrees));
}

// An empty tank that is labelled so where the run recorded none.
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

// Those of the times at which any of the runs recorded a field.
std::vector<double> recorded_times(const CaseAssessment& assessment, const Names& runs,
                                   std::vector<double> times) {
  std::erase_if(times, [&](double time) {
    return std::none_of(runs.begin(), runs.end(),
                        [&](const std::string& run) { return snapshot_at(assessment, run, time); });
  });
  return times;
}

// Says which runs recorded only a part of the moments, or none.
std::string recorded_text(const CaseAssessment& assessment, const Names& runs,
                          const std::vector<double>& times) {
  std::string text;
  Names families;
  for (const std::string& run : runs) {
    families.push_back(family(run_named(assessment.definition, run)));
    const auto count = std::count_if(times.begin(), times.end(), [&](double time) {
      return snapshot_at(assessment, run, time);
    });
    if (count < std::ssize(times))
      text += fmt::format(" {} recorded {} of these moments.", run, count);
  }
  for (const std::string& run : finest_runs(assessment, [](const RunResult&) { return true; }))
    if (is_simulation(run_named(assessment.definition, run)) &&
        !is_one_of(family(run_named(assessment.definition, run)), families))
      text += fmt::format(" {} recorded none of them.", run);
  return text;
}

// The finest run of each scheme and solver that recorded any of the animation's moments. Returns
// nullopt where the runs recorded fewer than two of them.
std::optional<FieldFigure> case_animation(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<double>& wanted = definition.animation_times;
  const Names runs = finest_runs(assessment, [&](const RunResult& result) {
    return std::any_of(wanted.begin(), wanted.end(),
                       [&](double time) { return snapshot_at(definition, result, time); });
  });
  const std::vector<double> times = recorded_times(assessment, runs, wanted);
  if (times.size() < 2) return std::nullopt;
  FieldFigure figure = field_figure(assessment, times, runs);
  figure.id = case_id(definition.name) + "-animation";
  figure.title = "The flow " + times_text(times);
  figure.caption = fmt::format(
      "Animation of {} moments, {:g} s apart, of the finest run of each scheme and solver.{} {}",
      times.size(), wanted[1] - wanted[0], recorded_text(assessment, runs, times),
      field_caption(definition, runs));
  figure.is_animation = true;
  return figure;
}

}  // namespace

std::vector<FieldFigure> case_fields(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const Names runs =
      finest_runs(assessment, [](const RunResult& result) { return !result.snapshots.empty(); });
  const std::vector<double> times = recorded_times(assessment, runs, definition.snapshot_times);
  std::vector<FieldFigure> figures;
  for (const auto& times_shown : in_parts(times, most_rows))
    for (const auto& columns : in_parts(runs, most_columns)) {
      figures.push_back(field_figure(assessment, times_shown, columns));
      figures.back().id = fmt::format("{}-fields-{}", case_id(definition.name), figures.size());
    }
  set_side_by_side(figures);
  if (std::optional<FieldFigure> animation = case_animation(assessment))
    figures.push_back(std::move(*animation));
  return figures;
}

}  // namespace slosh
