#include "verification/convergence/power_law_line.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

PowerLawLine::OnLine PowerLawLine::at(double step) const {
  const double away = std::log(step) - middle;
  const double line = level + order.value * away;
  const double half = scatter * std::sqrt(1 / count + away * away / spread);
  return {std::exp(line), std::exp(line - half), std::exp(line + half)};
}

PowerLawLine fit_power_law_line(const std::vector<ValueAtStep>& errors) {
  if (errors.size() < 3)
    throw ComparisonError(fmt::format("errors at {} steps; expected at least 3", errors.size()));
  std::vector<double> x, y;
  for (const auto& [step, error, noise] : errors) {
    if (!(step > 0) || !(error > 0) || !std::isfinite(step) || !std::isfinite(error))
      throw ComparisonError(
          fmt::format("error {} at step {}: expected both finite and above zero", error, step));
    x.push_back(std::log(step));
    y.push_back(std::log(error));
  }
  PowerLawLine line{.order = {},
                    .middle = mean(x),
                    .level = mean(y),
                    .scatter = 0,
                    .count = static_cast<double>(x.size()),
                    .spread = 0};
  double product = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    line.spread += (x[i] - line.middle) * (x[i] - line.middle);
    product += (x[i] - line.middle) * (y[i] - line.level);
  }
  if (!(line.spread > 0)) throw ComparisonError("errors at one step alone; expected several");
  line.order.value = product / line.spread;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = y[i] - line.level - line.order.value * (x[i] - line.middle);
    squares += residual * residual;
  }
  const double freedom = line.count - 2;
  line.scatter = t95(freedom) * std::sqrt(squares / freedom);
  line.order.half_width = line.scatter / std::sqrt(line.spread);
  return line;
}

}  // namespace slosh
