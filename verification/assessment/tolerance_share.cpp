#include "verification/assessment/tolerance_share.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace slosh {
namespace {

// Of a distance to what is best, where that much is allowed; no distance takes nothing of nothing.
ToleranceShare share(double distance, double allowed, double half_width) {
  if (distance == 0) return {0, half_width > 0 ? half_width / allowed : 0};
  return {std::abs(distance) / allowed, half_width / allowed};
}

ToleranceShare share_of_range(double value, std::pair<double, double> range, double half_width) {
  const auto [lower, upper] = range;
  return share(value - (lower + upper) / 2, (upper - lower) / 2, half_width);
}

}  // namespace

std::optional<ToleranceShare> tolerance_share(const GateOutcome& outcome) {
  const double value = outcome.value.value;
  if (!std::isfinite(value)) return {};
  const double half_width = outcome.judgement ? outcome.judgement->uncertainty : 0;
  if (outcome.row.limit) return share(value, *outcome.row.limit, half_width);
  if (outcome.row.between) return share_of_range(value, *outcome.row.between, half_width);
  return {};
}

std::optional<ToleranceShare> tolerance_share(const ProblemGateOutcome& outcome) {
  if (!std::isfinite(outcome.value)) return {};
  if (outcome.row.between) return share_of_range(outcome.value, *outcome.row.between, 0);
  const double limit = outcome.row.limit.value();
  if (outcome.row.metric != ProblemMetric::order_at_least) return share(outcome.value, limit, 0);
  if (outcome.value > 0) return ToleranceShare{limit / outcome.value, 0};
  return ToleranceShare{std::numeric_limits<double>::infinity(), 0};
}

int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::not_selected:
      return 0;
    case Verdict::not_supplied:
      return 1;
    case Verdict::pass:
      return 2;
    case Verdict::inconclusive:
      return 3;
    case Verdict::not_compared:
      return 4;
    case Verdict::violated:
      return 5;
    case Verdict::solver_failed:
      return 6;
  }
  throw std::logic_error("a verdict without a severity");
}

}  // namespace slosh
