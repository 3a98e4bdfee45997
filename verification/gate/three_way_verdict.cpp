#include "verification/gate/three_way_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double work_exponent = 3;  // work ~ h^-3: two dimensions and the time step

// The distance to the nearest bound: positive inside, negative outside, NaN where the error is not
// finite or a bound is NaN.
double margin(double error, const AllowedRange& allowed) {
  const double above = error - allowed.lower, below = allowed.upper - error;
  if (!std::isfinite(error) || std::isnan(above) || std::isnan(below)) return not_a_number;
  return std::min(above, below);
}

ThreeWayVerdict verdict_of(double margin, double uncertainty) {
  if (std::isnan(margin)) return ThreeWayVerdict::fail;
  if (!std::isfinite(uncertainty)) return ThreeWayVerdict::inconclusive;
  if (uncertainty <= margin) return ThreeWayVerdict::pass;
  return uncertainty < -margin ? ThreeWayVerdict::fail : ThreeWayVerdict::inconclusive;
}

// The half width that the others leave to one contribution. Returns nullopt where they leave none.
std::optional<double> left_beside(const ThreeWayOutcome& outcome,
                                  Contribution UncertaintyContributions::*one) {
  if (outcome.verdict != ThreeWayVerdict::inconclusive || !std::isfinite(outcome.uncertainty))
    return std::nullopt;
  UncertaintyContributions others = outcome.contributions;
  others.*one = {};
  const double other = validation_uncertainty(others), needed = outcome.conclusive_uncertainty;
  if (!(other < needed)) return std::nullopt;
  return std::sqrt((needed - other) * (needed + other));
}

}  // namespace

Contribution Contribution::unknown(std::string missing) {
  Contribution contribution;
  contribution.half_width.reset();
  contribution.basis = std::move(missing);
  return contribution;
}

double validation_uncertainty(const UncertaintyContributions& contributions) {
  double squares = 0;
  for (const double one : {contributions.discretisation.known(), contributions.time_series.known(),
                           contributions.input.known(), contributions.reference.known()}) {
    if (!(one >= 0)) return not_a_number;
    squares += one * one;
  }
  return std::min(std::sqrt(squares), contributions.at_most);
}

std::string missing_for_validation(const UncertaintyContributions& contributions) {
  std::string missing;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) missing += (missing.empty() ? "" : "; ") + text;
  };
  for (const Contribution* one : {&contributions.discretisation, &contributions.reference})
    if (!one->half_width) add(one->basis);
  for (const Contribution* one : {&contributions.discretisation, &contributions.time_series,
                                  &contributions.input, &contributions.reference})
    add(one->not_counted);
  return missing;
}

std::string dominant_contribution(const UncertaintyContributions& contributions) {
  const auto named = {std::pair{contributions.discretisation.known(), "discretisation"},
                      std::pair{contributions.time_series.known(), "time series"},
                      std::pair{contributions.input.known(), "input"},
                      std::pair{contributions.reference.known(), "reference"}};
  return std::max_element(named.begin(), named.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

ThreeWayOutcome judge_error(double error, const UncertaintyContributions& contributions,
                            const AllowedRange& allowed) {
  const double uncertainty = validation_uncertainty(contributions);
  const double to_bound = margin(error, allowed);
  return {verdict_of(to_bound, uncertainty), error, contributions, uncertainty, std::abs(to_bound)};
}

std::optional<Remedy> finer_step(const ThreeWayOutcome& outcome, double order) {
  const auto left = left_beside(outcome, &UncertaintyContributions::discretisation);
  if (!left || !(order > 0)) return std::nullopt;
  const double ratio = std::pow(outcome.contributions.discretisation.known() / *left, 1 / order);
  return Remedy{*left, ratio, std::pow(ratio, work_exponent)};
}

std::optional<Remedy> longer_window(const ThreeWayOutcome& outcome) {
  const auto left = left_beside(outcome, &UncertaintyContributions::time_series);
  if (!left) return std::nullopt;
  const double ratio = std::pow(outcome.contributions.time_series.known() / *left, 2);
  return Remedy{*left, ratio, ratio};
}

}  // namespace slosh
