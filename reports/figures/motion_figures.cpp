// The motion of a tank that rolls, as every run was handed it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "reports/figures/figure_kinds.hpp"
#include "verification/case/motion.hpp"
#include "verification/case_file/motion_table.hpp"

namespace slosh {
namespace {

using reports::Figure;

reports::Curve sampled(const CaseDefinition& definition, const std::string& label,
                       const std::function<double(double)>& motion, double scale) {
  reports::Curve curve{label, {}, {}, {}, {}};
  const long last = std::lround(definition.duration / definition.sample_interval);
  for (long i = 0; i <= last; ++i) {
    // The last multiple of the interval must not pass the end of a table by round-off.
    curve.x.push_back(std::min(i * definition.sample_interval, definition.duration));
    curve.y.push_back(scale * motion(curve.x.back()));
  }
  return curve;
}

}  // namespace

std::vector<Figure> motion_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const auto roll = roll_motion(definition);
  if (!roll) return {};
  Figure angle;
  angle.id = definition.name + "-roll";
  angle.title = "Roll of the tank";
  angle.caption = fmt::format(
      "Counter-clockwise about the point {:.3g} m from the left wall and {:.3g} m above the "
      "bottom, as every run was handed it.",
      roll->axis_x, roll->axis_z);
  angle.x_label = "time [s]";
  angle.y_label = "roll [deg]";
  angle.x_range = {0, definition.duration};
  angle.curves = {sampled(definition, "roll", roll->angle, 1 / radians_per_degree)};
  if (!definition.motion.surge) return {angle};
  Figure surge = angle;
  surge.id = definition.name + "-surge";
  surge.title = "Surge of the tank";
  surge.caption = "Of the roll's axis and the tank with it, as every run was handed it.";
  surge.y_label = "surge [mm]";
  surge.curves = {sampled(definition, "surge", surge_motion(definition).displacement, 1000)};
  return {angle, surge};
}

}  // namespace slosh
