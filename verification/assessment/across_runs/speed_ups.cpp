#include "verification/assessment/across_runs/speed_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/assessment/work_points.hpp"
#include "verification/fits/block_jackknife.hpp"

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

// The ratio at the smallest error that both curves reach, and the spread that its costs' bars give.
std::optional<EqualErrorSpeed> speed_at_equal_error(const std::string& family,
                                                    const std::vector<WorkPoint>& points,
                                                    const std::vector<WorkPoint>& of_mesh) {
  const std::vector<WorkPoint> front = pareto_front(points), mesh_front = pareto_front(of_mesh);
  if (front.empty() || mesh_front.empty()) return {};
  const double error = std::max(front.back().error.value, mesh_front.back().error.value);
  const auto own = cost_at_reached(points, error), mesh = cost_at_reached(of_mesh, error);
  if (!own || !mesh) return {};
  const bool is_repeated = !std::isnan(own->cost_spread) && !std::isnan(mesh->cost_spread);
  const auto known = [](double spread) { return std::isnan(spread) ? 0 : spread; };
  return EqualErrorSpeed{family, error, mesh->cost / own->cost,
                         std::hypot(known(own->cost_spread), known(mesh->cost_spread)),
                         is_repeated};
}

const Comparison* judging_comparison(const CaseAssessment& assessment, const std::string& run,
                                     const std::string& reference) {
  for (const Comparison* one : judging_comparisons(assessment))
    if (one->candidate == run && one->reference == reference) return one;
  return nullptr;
}

// The blocks of the window that block_jackknife() of its errors has; 1 where it has none.
int blocks_of(const CaseAssessment& assessment, const WorkFamily& family) {
  int fewest = most_blocks;
  for (const WorkRun& run : family.runs) {
    const Comparison* compared = judging_comparison(assessment, run.run, family.reference);
    double slowest = std::numeric_limits<double>::infinity();
    if (compared)
      for (const ModeComparison& mode : compared->modes)
        slowest = std::min(slowest, mode.reference.angular_frequency.value);
    if (!std::isfinite(slowest)) return 1;
    const double period = 2 * std::numbers::pi / slowest;
    fewest = std::min(fewest, block_count(compared->window.end - compared->window.begin, period));
  }
  return fewest;
}

// The points with the errors that are left without the residual of one of the blocks. What the
// errors are divided by is nearly the same for all runs and left as it is.
std::vector<WorkPoint> without_block(const CaseAssessment& assessment, const WorkFamily& family,
                                     int block, int blocks) {
  std::vector<WorkPoint> points = by_core_seconds(family);
  for (WorkPoint& point : points) {
    const Comparison& compared = *judging_comparison(assessment, point.run, family.reference);
    const auto& [begin, end] = compared.window;
    double all = 0, left = 0;
    for (std::size_t i = 0; i < compared.residual.time.size(); ++i) {
      const double square = compared.residual.value[i] * compared.residual.value[i];
      const double share = (compared.residual.time[i] - begin) / (end - begin);
      all += square;
      if (static_cast<int>(share * blocks) != block) left += square;
    }
    point.error.value *= std::sqrt(left / all * blocks / (blocks - 1));
  }
  return points;
}

// Adds what another window of the same flow would change, by the jackknife over the blocks
// (block_jackknife.hpp) of both curves together: a stretch where all runs err more makes no ratio
// uncertain. Returns false where a curve does not reach the error without one of the blocks.
bool add_spread_of_windows(const CaseAssessment& assessment, const WorkFamily& family,
                           const WorkFamily& mesh, EqualErrorSpeed& speed) {
  const int blocks = std::min(blocks_of(assessment, family), blocks_of(assessment, mesh));
  if (blocks < fewest_blocks) return true;
  std::vector<double> ratios;
  for (int block = 0; block < blocks; ++block) {
    const auto one =
        speed_at_equal_error(family.name, without_block(assessment, family, block, blocks),
                             without_block(assessment, mesh, block, blocks));
    if (!one) return false;
    ratios.push_back(std::log(one->value));
  }
  speed.spread = std::hypot(speed.spread, jackknife_half_width(ratios));
  return true;
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

std::vector<EqualErrorSpeed> equal_error_speeds(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = stated_families(assessment);
  const auto mesh = std::find_if(families.begin(), families.end(),
                                 [](const WorkFamily& one) { return one.name == mesh_family; });
  if (mesh == families.end()) return {};
  std::vector<EqualErrorSpeed> found;
  for (const WorkFamily& family : families) {
    if (family.name == mesh_family) continue;
    auto speed = speed_at_equal_error(family.name, by_core_seconds(family), by_core_seconds(*mesh));
    if (speed && add_spread_of_windows(assessment, family, *mesh, *speed))
      found.push_back(std::move(*speed));
  }
  return found;
}

std::string speed_text(const EqualErrorSpeed& speed) {
  const auto two_digits = [](double value) {
    return value < 9.95 ? fmt::format("{:.{}f}", value, value < 0.995 ? 2 : 1)
                        : fmt::format("{:.0f}", value);
  };
  return fmt::format(
      "{}: {} times the speed of interFoam at equal error ({:.2g} %), {} to {}{}",
      speed.family == "recommended" ? "SPH" : speed.family, two_digits(speed.value),
      100 * speed.error, two_digits(speed.value * std::exp(-speed.spread)),
      two_digits(speed.value * std::exp(speed.spread)),
      speed.is_repeated ? "" : " beside the scatter of costs that were measured once");
}

}  // namespace slosh
