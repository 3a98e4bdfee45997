#include "verification/convergence/three_grid_order.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace slosh {
namespace {

constexpr double highest_order = 10;

// ln of r21^p (r32^p - s) / (r21^p - s) with a = ln r21, b = ln r32, and its limit at p = 0.
double log_difference_ratio(double p, double a, double b, bool same_sign) {
  if (!same_sign) return a * p + std::log((std::exp(b * p) + 1) / (std::exp(a * p) + 1));
  return a * p + (p == 0 ? std::log(b / a) : std::log(std::expm1(b * p) / std::expm1(a * p)));
}

}  // namespace

std::optional<double> three_grid_order(const ValueAtStep& fine, const ValueAtStep& medium,
                                       const ValueAtStep& coarse) {
  const double e21 = medium.value - fine.value, e32 = coarse.value - medium.value;
  if (e21 == 0 || e32 == 0) return std::nullopt;
  const double a = std::log(medium.step / fine.step), b = std::log(coarse.step / medium.step);
  const auto excess = [&, target = std::log(std::abs(e32 / e21))](double p) {
    return log_difference_ratio(p, a, b, e32 / e21 > 0) - target;
  };
  if (excess(-highest_order) >= 0) return -highest_order;
  if (excess(highest_order) <= 0) return highest_order;
  std::uintmax_t most_iterations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, -highest_order, highest_order, boost::math::tools::eps_tolerance<double>(),
      most_iterations);
  return (low + high) / 2;
}

double extrapolated_value(const ValueAtStep& fine, const ValueAtStep& medium, double order) {
  return fine.value -
         (medium.value - fine.value) / std::expm1(order * std::log(medium.step / fine.step));
}

}  // namespace slosh
