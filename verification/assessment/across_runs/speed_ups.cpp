#include "verification/assessment/across_runs/speed_ups.hpp"

#include <algorithm>
#include <cmath>

#include "verification/assessment/work_points.hpp"

namespace slosh {
namespace {

const std::string mesh_family = "interFoam";

// How far the cost moves, as a logarithm, while the error that is asked for moves within its
// interval; an end of the interval that is not reached is left out.
double moved_by_error(const std::vector<WorkPoint>& own, double cost, const Estimate& error) {
  double most = 0;
  for (const double side : {-1.0, 1.0}) {
    const double other = error.value * std::exp(side * error.half_width / error.value);
    most = std::fmax(most, std::abs(std::log(cost_at_error(own, other).cost / cost)));
  }
  return most;
}

}  // namespace

const std::vector<double>& stated_errors() {
  static const std::vector<double> errors{0.1, 0.05, 0.02, 0.01};
  return errors;
}

std::vector<WorkFamily> stated_families(const CaseAssessment& assessment) {
  std::vector<WorkFamily> families = work_families(assessment);
  std::erase_if(families, [](const WorkFamily& family) {
    return family.changed && !work_slope(by_core_seconds(family));
  });
  return families;
}

std::vector<SpeedUp> speed_ups(const WorkFamily& family, const std::vector<WorkFamily>& families) {
  const auto mesh = std::find_if(families.begin(), families.end(),
                                 [](const WorkFamily& one) { return one.name == mesh_family; });
  if (mesh == families.end() || family.name == mesh_family) return {};
  std::vector<SpeedUp> found;
  for (const WorkPoint& point : pareto_front(by_core_seconds(*mesh))) {
    const std::vector<WorkPoint> points = by_core_seconds(family);
    const CostAtError own = cost_at_error(points, point.error.value);
    const double of_mesh = point.cost.half_width / point.cost.value;
    found.push_back({point.error.value, point.run, point.cost.value / own.cost,
                     std::hypot(known_spread(own), std::isnan(of_mesh) ? 0 : of_mesh,
                                moved_by_error(points, own.cost, point.error)),
                     own.reach});
  }
  return found;
}

}  // namespace slosh
