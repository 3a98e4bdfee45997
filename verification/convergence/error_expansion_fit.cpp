#include "verification/convergence/error_expansion_fit.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <initializer_list>

#include "verification/fits/dense_algebra.hpp"

namespace slosh {
namespace {

// A negative order only has to be told from a positive one; no discretisation here exceeds 8.
constexpr OrderRange searched_orders{-1, 8};
constexpr int scanned_orders = 45;

struct LinearFit {
  Eigen::VectorXd coefficients;  // of the constant, then of the problem's columns
  Eigen::VectorXd fitted;
  double weighted_squares;  // sum n w_i residual_i^2
};

// The steps over the finest one.
Eigen::VectorXd relative_steps(const std::vector<ValueAtStep>& values) {
  Eigen::VectorXd steps(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < steps.size(); ++i)
    steps[i] = values[static_cast<std::size_t>(i)].step / values.front().step;
  return steps;
}

LinearFit solve(const std::vector<ValueAtStep>& values, bool weighted,
                const Eigen::MatrixXd& columns) {
  const Eigen::VectorXd steps = relative_steps(values);
  const Eigen::Index n = steps.size();
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(n), data(n);
  if (weighted)
    weights = steps.cwiseInverse() * (static_cast<double>(n) / steps.cwiseInverse().sum());
  for (Eigen::Index i = 0; i < n; ++i) data[i] = values[static_cast<std::size_t>(i)].value;
  Eigen::MatrixXd basis(n, columns.cols() + 1);
  basis << Eigen::VectorXd::Ones(n), columns;
  const Eigen::VectorXd roots = weights.cwiseSqrt();
  LinearFit fit;
  fit.coefficients = least_squares(roots.asDiagonal() * basis, roots.cwiseProduct(data));
  fit.fitted = basis * fit.coefficients;
  fit.weighted_squares = weights.dot((data - fit.fitted).cwiseAbs2());
  return fit;
}

double deviation(const LinearFit& fit, int unknowns) {
  return std::sqrt(fit.weighted_squares / static_cast<double>(fit.fitted.size() - unknowns));
}

// (h^p - 1) / p, which tends to ln h at p = 0 instead of to a second constant.
Eigen::VectorXd power_column(const Eigen::VectorXd& steps, double p) {
  return steps.unaryExpr(
      [p](double h) { return std::abs(p) < 1e-9 ? std::log(h) : std::expm1(p * std::log(h)) / p; });
}

double best_order(const std::vector<ValueAtStep>& values, bool weighted, OrderRange range) {
  const Eigen::VectorXd steps = relative_steps(values);
  const auto squares = [&](double p) {
    return solve(values, weighted, power_column(steps, p)).weighted_squares;
  };
  const auto scanned = [&](int i) {
    return std::lerp(range.low, range.high, static_cast<double>(i) / scanned_orders);
  };
  int best = 0;
  double least = squares(range.low);
  for (int i = 1; i <= scanned_orders; ++i) {
    if (const double here = squares(scanned(i)); here < least) {
      least = here;
      best = i;
    }
  }
  if (best == 0) return range.low;
  if (best == scanned_orders) return range.high;
  constexpr int bits = 26;  // half of a double's, the attainable accuracy of a minimum
  return boost::math::tools::brent_find_minima(squares, scanned(best - 1), scanned(best + 1), bits)
      .first;
}

ExpansionFit smallest_deviation(const std::vector<ValueAtStep>& values,
                                std::initializer_list<Expansion> expansions) {
  std::vector<ExpansionFit> fits;
  for (const Expansion expansion : expansions)
    for (const bool weighted : {false, true})
      fits.push_back(fit_fixed_orders(values, weighted, expansion));
  return *std::min_element(
      fits.begin(), fits.end(),
      [](const ExpansionFit& a, const ExpansionFit& b) { return a.deviation < b.deviation; });
}

}  // namespace

ExpansionFit fit_power_law(const std::vector<ValueAtStep>& values, bool weighted,
                           OrderRange range) {
  const double p = best_order(values, weighted, range);
  const LinearFit fit = solve(values, weighted, power_column(relative_steps(values), p));
  const double error = fit.coefficients[1] / p;  // a h^p at h = 1
  return {Expansion::power,
          weighted,
          p,
          fit.coefficients[0] - error,
          {fit.fitted.begin(), fit.fitted.end()},
          deviation(fit, 3)};
}

ExpansionFit fit_fixed_orders(const std::vector<ValueAtStep>& values, bool weighted,
                              Expansion expansion) {
  const Eigen::VectorXd steps = relative_steps(values);
  Eigen::MatrixXd columns = steps;
  if (expansion == Expansion::second) columns = steps.cwiseAbs2();
  if (expansion == Expansion::mixed) {
    columns.conservativeResize(Eigen::NoChange, 2);
    columns.col(1) = steps.cwiseAbs2();
  }
  const LinearFit fit = solve(values, weighted, columns);
  return {expansion,
          weighted,
          expansion == Expansion::second ? 2.0 : 1.0,
          fit.coefficients[0],
          {fit.fitted.begin(), fit.fitted.end()},
          deviation(fit, expansion == Expansion::mixed ? 3 : 2)};
}

ChosenExpansion choose_expansion(const std::vector<ValueAtStep>& values) {
  const ExpansionFit plain = fit_power_law(values, false, searched_orders);
  const ExpansionFit weighted = fit_power_law(values, true, searched_orders);
  if (!(plain.order > 0) && !(weighted.order > 0))
    return {std::nullopt,
            smallest_deviation(values, {Expansion::first, Expansion::second, Expansion::mixed})};
  const bool take_plain =
      !(weighted.order > 0) || (plain.order > 0 && plain.deviation <= weighted.deviation);
  const ExpansionFit& power = take_plain ? plain : weighted;
  if (power.order > reliable_orders.high)
    return {power.order, smallest_deviation(values, {Expansion::first, Expansion::second})};
  if (power.order < reliable_orders.low)
    return {power.order,
            smallest_deviation(values, {Expansion::first, Expansion::second, Expansion::mixed})};
  return {power.order, power};
}

}  // namespace slosh
