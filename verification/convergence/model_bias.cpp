#include "verification/convergence/model_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

void require_usable(const PredictedValue& value) {
  const auto positive = [](double number) { return number > 0 && std::isfinite(number); };
  const bool known = value.reference_deviation >= 0 && std::isfinite(value.reference_deviation);
  if (positive(value.predicted) && positive(value.reference) && known) return;
  throw std::invalid_argument(fmt::format(
      "predicted {}, reference {}, its relative deviation {}: expected finite values above zero",
      value.predicted, value.reference, value.reference_deviation));
}

}  // namespace

std::optional<ModelBias> model_bias(const std::vector<PredictedValue>& values) {
  std::vector<double> logarithms, deviations;
  for (const PredictedValue& value : values) {
    require_usable(value);
    logarithms.push_back(std::log(value.predicted / value.reference));
    deviations.push_back(value.reference_deviation);
  }
  const std::size_t n = values.size();
  if (n < fewest_comparisons) return {};
  const double scatter = rms(without_mean(logarithms));
  const double variance = scatter * scatter * static_cast<double>(n) / static_cast<double>(n - 1);
  const double of_reference = std::min(std::pow(rms(deviations), 2), variance / 2);
  const double of_model = variance - of_reference;
  return ModelBias{.count = n,
                   .bias = std::exp(mean(logarithms) + of_model / 2 - of_reference / 2),
                   .relative_deviation = std::sqrt(of_model),
                   .reference_deviation = std::sqrt(of_reference)};
}

}  // namespace slosh
