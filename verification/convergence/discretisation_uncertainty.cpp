#include "verification/convergence/discretisation_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "verification/convergence/error_expansion_fit.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using Values = std::vector<ValueAtStep>;

constexpr std::size_t fewest_values = 3, fewest_values_to_fit = 4;
constexpr double cautious_safety_factor = 3;  // Eca & Hoekstra 2014, appendix A
constexpr double order_too_high = 2.1;        // same source: 5 % above the formal order

void require_sound(const Values& values) {
  if (values.size() < fewest_values)
    throw ComparisonError(
        fmt::format("values at {} steps; expected at least {}", values.size(), fewest_values));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& [step, value, noise] = values[i];
    if (!(step > 0) || !std::isfinite(step) || !std::isfinite(value) || !(noise >= 0) ||
        !std::isfinite(noise))
      throw ComparisonError(
          fmt::format("value {} +- {} at step {}: expected finite numbers, a step above zero and a "
                      "half width that is not negative",
                      value, noise, step));
    if (i > 0 && step < least_refinement_ratio * values[i - 1].step)
      throw ComparisonError(
          fmt::format("values at the steps {} and {}; expected a factor of {} "
                      "or more between two steps",
                      values[i - 1].step, step, least_refinement_ratio));
  }
}

std::size_t index_of_step(const Values& values, double step) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].step == step) return i;
  throw ComparisonError(fmt::format("no value at step {}; expected the step of one of them", step));
}

double difference(const ValueAtStep& fine, const ValueAtStep& coarse) {
  return coarse.value - fine.value;
}

double noise_of_difference(const ValueAtStep& a, const ValueAtStep& b) {
  return std::hypot(a.noise, b.noise);
}

bool within_noise(const ValueAtStep& a, const ValueAtStep& b) {
  return std::abs(difference(a, b)) <= noise_of_difference(a, b);
}

// The order of the three values that begin with the i-th.
double order_of_three(const Values& values, std::size_t i) {
  return three_grid_order(values[i], values[i + 1], values[i + 2]).value_or(0);
}

bool stopped_converging(const Values& values) {
  return values.size() > fewest_values && order_of_three(values, 0) <= 0 &&
         order_of_three(values, 1) > 0 &&
         difference(values[1], values[2]) * difference(values[2], values[3]) > 0;
}

bool of_both_signs(const Values& values) {
  bool rises = false, falls = false;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (within_noise(values[i - 1], values[i])) continue;
    (difference(values[i - 1], values[i]) > 0 ? rises : falls) = true;
  }
  return rises && falls;
}

StepBehaviour behaviour_of(const Values& values, std::optional<double> order) {
  if (within_noise(values[0], values[1]) || within_noise(values[1], values[2]) ||
      stopped_converging(values))
    return StepBehaviour::floor;
  if (order_of_three(values, 0) <= 0 || !order) return StepBehaviour::diverging;
  if (of_both_signs(values)) return StepBehaviour::oscillatory;
  return *order >= order_too_high ? StepBehaviour::superconvergent : StepBehaviour::monotone;
}

struct ErrorEstimate {
  std::optional<double> order;
  double order_used;    // of the extrapolation
  double extrapolated;  // f0
  double uncertainty;   // half width of the 95 % interval about the value asked about
};

// sqrt(sum_i d_i^2), d_i the largest change of the error as value i moves up or down by its noise.
double moved_by_noise(const Values& values, const std::function<double(const Values&)>& error) {
  const double unmoved = error(values);
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double largest = 0;
    for (const double sign : {-1, 1}) {
      Values moved = values;
      moved[i].value += sign * moved[i].noise;
      largest = std::max(largest, std::abs(error(moved) - unmoved));
    }
    squares += largest * largest;
  }
  return std::sqrt(squares);
}

double reliable_order(double order) {
  return std::clamp(order, reliable_orders.low, reliable_orders.high);
}

double safety_factor(std::optional<double> order) {
  const bool reliable = order && *order >= reliable_orders.low && *order < order_too_high;
  return reliable ? reliable_safety_factor : cautious_safety_factor;
}

double three_grid_limit(const Values& values) {
  const double order = reliable_order(order_of_three(values, 0));
  return extrapolated_value(values[0], values[1], order);
}

ErrorEstimate from_three(const Values& values, std::size_t asked) {
  const auto error = [asked](const Values& moved) {
    return moved[asked].value - three_grid_limit(moved);
  };
  const double order = order_of_three(values, 0);
  return {order, reliable_order(order), three_grid_limit(values),
          safety_factor(order) * std::abs(error(values)) + moved_by_noise(values, error)};
}

// The mean difference D of the header.
double data_range(const Values& values) {
  const auto [low, high] = std::minmax_element(
      values.begin(), values.end(),
      [](const ValueAtStep& a, const ValueAtStep& b) { return a.value < b.value; });
  return (high->value - low->value) / static_cast<double>(values.size() - 1);
}

ErrorEstimate from_fit(const Values& values, std::size_t asked) {
  const double range = data_range(values);
  if (range == 0) return {std::nullopt, 0, values[asked].value, 0};
  const auto [order, fit] = choose_expansion(values);
  const double error = std::abs(fit.error_at(asked));
  const double residual = std::abs(values[asked].value - fit.fitted[asked]);
  const double uncertainty =
      fit.deviation < range
          ? safety_factor(order) * error + fit.deviation + residual
          : cautious_safety_factor * fit.deviation / range * (error + fit.deviation + residual);
  const auto refitted = [&fit = fit, asked](const Values& moved) {
    return (fit.expansion == Expansion::power
                ? fit_power_law(moved, fit.weighted, reliable_orders)
                : fit_fixed_orders(moved, fit.weighted, fit.expansion))
        .error_at(asked);
  };
  return {order, fit.order, fit.extrapolated, uncertainty + moved_by_noise(values, refitted)};
}

// The uncertainty where no order is reliable.
double from_range(const Values& values, std::size_t asked) {
  const std::size_t last = std::max<std::size_t>(2, asked);
  double largest = 0;
  for (std::size_t i = 0; i <= last; ++i)
    for (std::size_t j = i + 1; j <= last; ++j)
      largest = std::max({largest, std::abs(difference(values[i], values[j])),
                          noise_of_difference(values[i], values[j])});
  return first_order_uncertainty(largest, values[asked].step, values[0].step, values[last].step);
}

// A sentence, after a space, where the extrapolation takes another order than the observed one.
std::string of_other_order(const DiscretisationUncertainty& result) {
  if (!takes_other_order(result)) return "";
  return fmt::format(
      " The extrapolation takes the order {:.2g} instead: it is reliable from {} to {} only.",
      *result.order_used, reliable_orders.low, reliable_orders.high);
}

std::string explanation_of(const DiscretisationUncertainty& result, const Values& values) {
  const double last = std::abs(difference(values[0], values[1]));
  const double noise = noise_of_difference(values[0], values[1]);
  switch (result.behaviour) {
    case StepBehaviour::monotone:
      return fmt::format(
          "The values approach {:.4g} from one side with an observed order of {:.2f}.{}",
          result.extrapolated, *result.order, of_other_order(result));
    case StepBehaviour::superconvergent:
      return fmt::format(
          "The differences fall with an order of {:.2f}, above the method's formal order of 2; the "
          "safety factor is therefore {:.0f}.{}",
          *result.order, cautious_safety_factor, of_other_order(result));
    case StepBehaviour::oscillatory:
      return "The differences fall, but have both signs: the values have no order, and the "
             "uncertainty rests on their range and scatter.";
    case StepBehaviour::diverging:
      return "The differences do not fall with the step: the values show no convergence, and the "
             "uncertainty rests on their range and scatter.";
    case StepBehaviour::floor:
      return fmt::format(
          "The last difference, {:.3g}, {}: the values have reached a floor, whose distance from "
          "the truth is unknown.",
          last,
          within_noise(values[0], values[1]) ? fmt::format("lies within its noise of {:.3g}", noise)
                                             : "does not fall with the step as the ones before");
  }
  throw std::logic_error("a behaviour without an explanation");
}

}  // namespace

double first_order_uncertainty(double difference, double step, double finest, double coarsest) {
  return cautious_safety_factor * difference * std::max(1.0, step / (coarsest - finest));
}

DiscretisationUncertainty discretisation_uncertainty(Values values, std::optional<double> at_step) {
  std::sort(values.begin(), values.end(),
            [](const ValueAtStep& a, const ValueAtStep& b) { return a.step < b.step; });
  require_sound(values);
  const std::size_t asked = at_step ? index_of_step(values, *at_step) : 0;
  const bool fitted = values.size() >= fewest_values_to_fit;
  const ErrorEstimate estimate = fitted ? from_fit(values, asked) : from_three(values, asked);
  DiscretisationUncertainty result{.behaviour = behaviour_of(values, estimate.order),
                                   .order = {},
                                   .order_used = {},
                                   .extrapolated = values[asked].value,
                                   .uncertainty = estimate.uncertainty,
                                   .explanation = ""};
  const bool has_order = result.behaviour == StepBehaviour::monotone ||
                         result.behaviour == StepBehaviour::superconvergent;
  if (has_order) {
    result.order = estimate.order;
    result.order_used = estimate.order_used;
    result.extrapolated = estimate.extrapolated;
  } else if (!fitted) {
    result.uncertainty = from_range(values, asked);
  } else if (result.behaviour == StepBehaviour::floor) {
    result.uncertainty = std::max(estimate.uncertainty, from_range(values, asked));
  }
  result.explanation = explanation_of(result, values);
  return result;
}

bool takes_other_order(const DiscretisationUncertainty& found) {
  return found.order && (*found.order < reliable_orders.low || *found.order > reliable_orders.high);
}

std::string observed_order_text(const DiscretisationUncertainty& found) {
  if (!found.order) return "";
  return fmt::format("{:.2f}", *found.order) +
         (takes_other_order(found) ? fmt::format(" (extrapolated with {:.2g})", *found.order_used)
                                   : "");
}

std::string behaviour_name(StepBehaviour behaviour) {
  switch (behaviour) {
    case StepBehaviour::monotone:
      return "monotone";
    case StepBehaviour::superconvergent:
      return "superconvergent";
    case StepBehaviour::oscillatory:
      return "oscillatory";
    case StepBehaviour::diverging:
      return "diverging";
    case StepBehaviour::floor:
      return "floor";
  }
  throw std::logic_error("a behaviour without a name");
}

}  // namespace slosh
