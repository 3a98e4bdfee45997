// Flow fields side by side: a row a moment, a column the finest run of a scheme or of interFoam.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "verification/case/motion.hpp"
#include "verification/case_file/motion_table.hpp"

namespace slosh {
namespace {

using reports::FieldFigure;
using reports::FieldPanel;

// What of a page's width leaves panels that one can read, and of its height one view.
constexpr std::size_t most_columns = 4, most_rows = 4;

// Of an animation, whose frames all travel in one picture.
constexpr std::size_t animated_columns = 2;
constexpr int animated_height = 240;  // px

// Null where the run left none at that time.
const FieldSnapshot* snapshot_at(const CaseAssessment& assessment, const std::string& run,
                                 double time) {
  const auto& snapshots = assessment.runs.results.at(run).snapshots;
  const double tolerance = 0.5 * assessment.definition.sample_interval;
  const auto found = std::find_if(snapshots.begin(), snapshots.end(), [&](const auto& snapshot) {
    return std::abs(snapshot.time - time) < tolerance;
  });
  return found == snapshots.end() ? nullptr : &*found;
}

FieldPanel empty_tank(const CaseDefinition& definition, const std::string& run, double time) {
  FieldPanel panel;
  panel.label = fmt::format("{}, t = {:g} s", run, time);
  panel.tank_length = panel.point_width = definition.tank.length;
  panel.tank_height = panel.point_height = definition.tank.height;
  if (const auto roll = roll_motion(definition)) {
    panel.angle = roll->angle(time);
    panel.axis_x = roll->axis_x;
    panel.axis_z = roll->axis_z;
    const double degrees = panel.angle / radians_per_degree;
    panel.label += fmt::format(", roll {}{:.2f}°", degrees < 0 ? "−" : "", std::abs(degrees));
  }
  return panel;
}

FieldPanel panel_of(const CaseAssessment& assessment, const std::string& run, double time) {
  FieldPanel panel = empty_tank(assessment.definition, run, time);
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

// Cut into as few parts as hold at most `most` each, of nearly one size.
template <class Value>
std::vector<std::vector<Value>> in_parts(const std::vector<Value>& values, std::size_t most) {
  const std::size_t count = (values.size() + most - 1) / most;
  std::vector<std::vector<Value>> cut;
  for (std::size_t i = 0; i < count; ++i)
    cut.emplace_back(values.begin() + static_cast<long>(i * values.size() / count),
                     values.begin() + static_cast<long>((i + 1) * values.size() / count));
  return cut;
}

FieldFigure field_figure(const CaseAssessment& assessment, const std::vector<double>& times,
                         const std::vector<std::string>& runs) {
  const CaseDefinition& definition = assessment.definition;
  FieldFigure figure;
  figure.title = times.size() == 1 ? fmt::format("Pressure and velocity at {:g} s", times.front())
                                   : fmt::format("Pressure and velocity from {:g} to {:g} s",
                                                 times.front(), times.back());
  figure.caption = fmt::format(
      "A row is a moment, a column a run: the finest of each scheme and solver. The colour is the "
      "pressure above the gas's, the arrows are velocities against the tank{}. SPH: all particles; "
      "interFoam: the cells that are at least half liquid. {} {}.",
      definition.motion.roll ? ", which is turned by its roll" : "", who_is_who(definition, runs),
      definition.source);
  figure.value_label = "pressure [Pa]";
  figure.columns = static_cast<int>(runs.size());
  for (const double time : times)
    for (const std::string& run : runs) figure.panels.push_back(panel_of(assessment, run, time));
  return figure;
}

// A frame a moment; of the runs the first two, side by side.
FieldFigure animation(const CaseAssessment& assessment, std::vector<std::string> runs) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<double>& times = definition.animation_times;
  runs.resize(std::min(runs.size(), animated_columns));
  FieldFigure figure = field_figure(assessment, times, runs);
  figure.id = definition.name + "-animation";
  figure.title = fmt::format("The flow from {:g} to {:g} s", times.front(), times.back());
  figure.caption = fmt::format(
      "An animation in {} frames, {:g} s apart; it stands still until it is played. {}",
      times.size(), times[1] - times[0], figure.caption.substr(figure.caption.find("The colour")));
  figure.panel_height = animated_height;
  for (const double time : times) figure.frames.push_back(fmt::format("t = {:.2f} s", time));
  return figure;
}

}  // namespace

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
  for (const auto& moments : in_parts(times, most_rows))
    for (const auto& columns : in_parts(runs, most_columns)) {
      figures.push_back(field_figure(assessment, moments, columns));
      figures.back().id = fmt::format("{}-fields-{}", definition.name, figures.size());
    }
  std::vector<std::string> moving = runs;
  std::erase_if(moving, [&](const std::string& run) {
    return std::any_of(definition.animation_times.begin(), definition.animation_times.end(),
                       [&](double time) { return !snapshot_at(assessment, run, time); });
  });
  if (!definition.animation_times.empty() && !moving.empty())
    figures.push_back(animation(assessment, moving));
  return figures;
}

}  // namespace slosh
