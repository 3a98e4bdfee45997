#include "verification/convergence/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double furthest_beyond = 2;  // largest ratio of the smallest error to the one asked for

bool is_usable(const WorkPoint& point) {
  const auto fits = [](double value) { return std::isfinite(value) && value > 0; };
  return fits(point.cost.value) && fits(point.error.value);
}

double relative(const Estimate& estimate) { return estimate.half_width / estimate.value; }

double log_cost(const WorkPoint& point) { return std::log(point.cost.value); }
double log_error(const WorkPoint& point) { return std::log(point.error.value); }

std::size_t resolutions_of(const std::vector<WorkPoint>& points) {
  std::set<double> different;
  for (const WorkPoint& point : points) different.insert(point.resolution);
  return different.size();
}

// The cost on the chord between two runs, with t = 0 at the first.
CostAtError between(const WorkPoint& first, const WorkPoint& second, double error) {
  const double t = (log_error(first) - std::log(error)) / (log_error(first) - log_error(second));
  const double gain = (log_cost(second) - log_cost(first)) / (log_error(first) - log_error(second));
  const auto spread = [&](double of_first, double of_second) {
    if (t == 1) return of_second;  // the first may be unknown (NaN)
    return std::hypot((1 - t) * of_first, t * of_second);
  };
  CostAtError found{Reach::between,
                    std::exp(std::lerp(log_cost(first), log_cost(second), t)),
                    spread(relative(first.cost), relative(second.cost)),
                    gain * spread(relative(first.error), relative(second.error)),
                    {},
                    {}};
  if (t < 1) found.rests_on.push_back(first.run);
  found.rests_on.push_back(second.run);
  return found;
}

// The bar of the cheapest run's error counts where it reaches beyond the error asked for, at the
// additional cost of the next run's smaller error; without a next run that cost is NaN.
CostAtError by_cheapest(const std::vector<WorkPoint>& front, double error) {
  const WorkPoint& cheapest = front.front();
  const double beyond = relative(cheapest.error) - (std::log(error) - log_error(cheapest));
  double gain = not_a_number;
  if (front.size() > 1)
    gain = (log_cost(front[1]) - log_cost(cheapest)) / (log_error(cheapest) - log_error(front[1]));
  return {Reach::by_cheapest,      cheapest.cost.value,
          relative(cheapest.cost), beyond > 0 ? gain * beyond : 0,
          {cheapest.run},          {}};
}

CostAtError along_slope(const WorkPoint& last, const Estimate& slope, double error) {
  const double fall = -slope.value, further = log_error(last) - std::log(error);
  return {Reach::extrapolated,
          last.cost.value * std::exp(further / fall),
          relative(last.cost),
          std::hypot(relative(last.error) / fall, further * slope.half_width / (fall * fall)),
          {last.run},
          {}};
}

}  // namespace

std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points) {
  std::erase_if(points, [](const WorkPoint& point) { return !is_usable(point); });
  std::sort(points.begin(), points.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return a.cost.value != b.cost.value ? a.cost.value < b.cost.value
                                        : a.error.value < b.error.value;
  });
  std::vector<WorkPoint> front;
  for (WorkPoint& point : points)
    if (front.empty() || point.error.value < front.back().error.value)
      front.push_back(std::move(point));
  return front;
}

std::optional<Estimate> work_slope(const std::vector<WorkPoint>& points) {
  std::vector<WorkPoint> usable = points;
  std::erase_if(usable, [](const WorkPoint& point) { return !is_usable(point); });
  const std::size_t resolutions = resolutions_of(usable);
  if (resolutions < 2) return std::nullopt;
  const double n = static_cast<double>(usable.size());
  double mean_w = 0, mean_l = 0;
  for (const WorkPoint& point : usable) {
    mean_w += log_cost(point) / n;
    mean_l += log_error(point) / n;
  }
  double ww = 0, wl = 0, ll = 0;
  for (const WorkPoint& point : usable) {
    const double w = log_cost(point) - mean_w, l = log_error(point) - mean_l;
    ww += w * w;
    wl += w * l;
    ll += l * l;
  }
  if (!(ww > 0)) return std::nullopt;
  const double slope = wl / ww;
  if (resolutions == 2) return Estimate{slope, not_a_number};
  const double left = std::max(0.0, ll - slope * wl);  // sum of the squared residuals
  const double t = t95(n - 2);
  return Estimate{slope, t * std::sqrt(left / (n - 2) / ww)};
}

double known_spread(const CostAtError& found) {
  const auto known = [](double spread) { return std::isnan(spread) ? 0 : spread; };
  return std::hypot(known(found.cost_spread), known(found.error_spread));
}

CostAtError cost_at_error(const std::vector<WorkPoint>& points, double error) {
  const std::vector<WorkPoint> front = pareto_front(points);
  CostAtError found{Reach::not_at_all, not_a_number, not_a_number, not_a_number, {}, {}};
  if (front.empty()) return found;
  const auto reached = std::find_if(front.begin(), front.end(), [&](const WorkPoint& point) {
    return point.error.value <= error;
  });
  if (reached == front.begin())
    found = by_cheapest(front, error);
  else if (reached != front.end())
    found = between(*std::prev(reached), *reached, error);
  found.most_exact = front.back();
  return found;
}

CostAtError cost_at_error_or_beyond(const std::vector<WorkPoint>& points, double error) {
  CostAtError within = cost_at_error(points, error);
  if (within.reach != Reach::not_at_all || !within.most_exact) return within;
  const auto slope = work_slope(points);
  const bool falls = slope && slope->value + slope->half_width < 0;
  if (!falls || !(error * furthest_beyond >= within.most_exact->error.value)) return within;
  CostAtError found = along_slope(*within.most_exact, *slope, error);
  found.most_exact = within.most_exact;
  return found;
}

}  // namespace slosh
