// Bias and scatter of a model over a set of comparisons of one kind of quantity. With M_i the
// predicted and E_i the reference's value, both above zero, M normal about delta times the truth
// and E about the truth, with the relative standard deviations s_M and s_E:
//   m = sum ln(M_i / E_i) / n
//   s_M^2 + s_E^2 = sum (ln(M_i / E_i) - m)^2 / (n - 1)
//   delta = exp(m + s_M^2 / 2 - s_E^2 / 2)
// s_E^2 is limited to half of that variance, because no model can be shown to be better than its
// reference. McGrattan & Toman 2011 (Metrologia 48:173); McGrattan et al., FDS Validation Guide
// (NIST SP 1018-3), chapter 4, without its weights by bins. Valid where s_M and s_E are small
// against 1 and the comparisons are nearly independent.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slosh {

struct PredictedValue {
  double predicted, reference;  // in one unit
  // Relative standard deviation of the reference; zero for an exact solution.
  double reference_deviation = 0;
};

struct ModelBias {
  std::size_t count;
  double bias;                 // delta: 1 where the model is right on average
  double relative_deviation;   // s_M
  double reference_deviation;  // s_E, the rms of the values' own
};

// The 95 % interval of a standard deviation of five values reaches from 0.60 to 2.9 times it
// (chi-squared of four degrees of freedom); fewer values hardly constrain it.
inline constexpr std::size_t fewest_comparisons = 5;

// Returns nullopt for fewer than fewest_comparisons values. Throws std::invalid_argument when a
// value is not finite and above zero, or a deviation is negative or NaN.
std::optional<ModelBias> model_bias(const std::vector<PredictedValue>& values);

}  // namespace slosh
