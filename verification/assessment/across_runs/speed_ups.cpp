#include "verification/assessment/across_runs/speed_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/assessment/work_points.hpp"

namespace slosh {
namespace {

const std::string mesh_family = "interFoam";

// The cost at this error with runs on both sides of it, or of the run that has it.
std::optional<CostAtError> cost_at_reached(const std::vector<WorkPoint>& points, double error) {
  const CostAtError found = cost_at_error(points, error);
  const bool is_reached =
      found.reach == Reach::between ||
      (found.reach == Reach::by_cheapest && pareto_front(points).front().error.value == error);
  return is_reached ? std::optional(found) : std::nullopt;
}

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

// The bars of the error that is asked for widen the cost of the other curve alone.
std::optional<EqualErrorSpeed> speed_at_equal_error(const std::string& family,
                                                    const std::vector<WorkPoint>& points,
                                                    const std::vector<WorkPoint>& of_mesh) {
  const std::vector<WorkPoint> front = pareto_front(points), mesh_front = pareto_front(of_mesh);
  if (front.empty() || mesh_front.empty()) return {};
  const bool is_of_mesh = mesh_front.back().error.value > front.back().error.value;
  const Estimate error = (is_of_mesh ? mesh_front : front).back().error;
  const auto own = cost_at_reached(points, error.value),
             mesh = cost_at_reached(of_mesh, error.value);
  if (!own || !mesh) return {};
  const CostAtError &asking = is_of_mesh ? *mesh : *own, &asked = is_of_mesh ? *own : *mesh;
  const bool is_repeated = !std::isnan(own->cost_spread) && !std::isnan(mesh->cost_spread);
  const double spread =
      std::hypot(std::isnan(asking.cost_spread) ? 0 : asking.cost_spread, known_spread(asked),
                 moved_by_error(is_of_mesh ? points : of_mesh, asked.cost, error));
  return EqualErrorSpeed{family, error.value, mesh->cost / own->cost, spread, is_repeated};
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

std::vector<EqualErrorSpeed> equal_error_speeds(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = stated_families(assessment);
  const auto mesh = std::find_if(families.begin(), families.end(),
                                 [](const WorkFamily& one) { return one.name == mesh_family; });
  std::vector<EqualErrorSpeed> found;
  for (const WorkFamily& family : families)
    if (mesh != families.end() && family.name != mesh_family)
      if (auto speed =
              speed_at_equal_error(family.name, by_core_seconds(family), by_core_seconds(*mesh)))
        found.push_back(std::move(*speed));
  return found;
}

std::string speed_text(const EqualErrorSpeed& speed) {
  return fmt::format(
      "{}: {:.2g} times ({:.2g} to {:.2g}{}) the speed of interFoam at equal error ({:.2g} %)",
      speed.family == "recommended" ? "SPH" : speed.family, speed.value,
      speed.value * std::exp(-speed.spread), speed.value * std::exp(speed.spread),
      speed.is_repeated ? "" : ", beside the scatter of costs that were measured once",
      100 * speed.error);
}

}  // namespace slosh
