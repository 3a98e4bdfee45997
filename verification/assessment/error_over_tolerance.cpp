#include "verification/assessment/error_over_tolerance.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace slosh {
namespace {

// `distance` from the best value over the allowed distance. The ratio of a zero distance is zero,
// even where nothing is allowed.
ErrorOverTolerance ratio_to(double distance, double allowed, double half_width) {
  if (distance == 0) return {0, half_width > 0 ? half_width / allowed : 0};
  return {std::abs(distance) / allowed, half_width / allowed};
}

ErrorOverTolerance ratio_in_range(double value, std::pair<double, double> range,
                                  double half_width) {
  const auto [lower, upper] = range;
  return ratio_to(value - (lower + upper) / 2, (upper - lower) / 2, half_width);
}

// Both forms meet at the level. A p-value of zero is one tolerance beyond it, as how far it lies
// below tells how many repeats there are and not how large the difference is.
ErrorOverTolerance ratio_of_p_value(double p, double level, double half_width) {
  if (p >= level) return {level / p, 0};
  return {2 - p / level, half_width / level};
}

}  // namespace

double half_width_of(const GateOutcome& outcome) {
  return outcome.judgement ? outcome.judgement->uncertainty : outcome.value.half_width;
}

std::optional<ErrorOverTolerance> error_over_tolerance(const GateOutcome& outcome) {
  const double value = outcome.value.value;
  if (!std::isfinite(value)) return {};
  const double half_width = outcome.judgement ? outcome.judgement->uncertainty : 0;
  if (outcome.row.limit) return ratio_to(value, *outcome.row.limit, half_width);
  if (is_p_value(outcome.row.metric))
    return ratio_of_p_value(value, allowed_by(outcome.row).lower, half_width);
  if (outcome.row.between) return ratio_in_range(value, *outcome.row.between, half_width);
  return {};
}

std::optional<ErrorOverTolerance> error_over_tolerance(const ProblemGateOutcome& outcome) {
  if (!std::isfinite(outcome.value)) return {};
  if (outcome.row.between) return ratio_in_range(outcome.value, *outcome.row.between, 0);
  const double limit = outcome.row.limit.value();
  if (outcome.row.metric != ProblemMetric::order_at_least) return ratio_to(outcome.value, limit, 0);
  if (outcome.value > 0) return ErrorOverTolerance{limit / outcome.value, 0};
  return ErrorOverTolerance{std::numeric_limits<double>::infinity(), 0};
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
