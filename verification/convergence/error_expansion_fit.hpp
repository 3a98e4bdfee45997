// Least-squares fits of error expansions to values at four or more steps, and the choice among them
// by Eca & Hoekstra 2014 (J. Comput. Phys. 262, 104-130, eqs 1 to 18 and appendices A and B):
//   power:  f = f0 + a h^p, p unknown        second: f = f0 + a h^2
//   first:  f = f0 + a h                     mixed:  f = f0 + a1 h + a2 h^2
// each with equal weights and with w_i = (1 / h_i) / sum (1 / h_j), and with the standard deviation
//   sigma = sqrt(sum n w_i (f_i - fit_i)^2 / (n - m)),   m = 3 unknowns (power, mixed) or 2.
// The order p is that of the power law, weighted or not, with the smaller sigma; if only one of the
// two is positive, it is that one. For 0.5 <= p <= 2 the power law is the fit; for p > 2 it is
// first or second; for p < 0.5, or both p < 0 (anomalous), it is first, second or mixed. Among
// these the one with the smallest sigma is taken. Valid for methods of formal order two.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "verification/convergence/three_grid_order.hpp"

namespace slosh {

enum class Expansion { power, first, second, mixed };

struct ExpansionFit {
  Expansion expansion;
  bool weighted;
  double order;                // p of the power law; 1, the leading one, for the mixed expansion
  double extrapolated;         // f0
  std::vector<double> fitted;  // fit(h_i), in the order of the values
  double deviation;            // sigma

  double error_at(std::size_t i) const { return fitted[i] - extrapolated; }
};

struct OrderRange {
  double low, high;
};

// The range of orders in which a fit is reliable.
constexpr OrderRange reliable_orders{0.5, 2};

// All functions below take four or more values, finest step first, with distinct steps.

// The fit of the power law with p within the range; p may lie at the range's end.
ExpansionFit fit_power_law(const std::vector<ValueAtStep>& values, bool weighted, OrderRange range);

// The fit of an expansion other than the power law.
ExpansionFit fit_fixed_orders(const std::vector<ValueAtStep>& values, bool weighted,
                              Expansion expansion);

struct ChosenExpansion {
  // p of the power law, at most 8; nullopt where the data are anomalous.
  std::optional<double> observed_order;
  ExpansionFit fit;
};

ChosenExpansion choose_expansion(const std::vector<ValueAtStep>& values);

}  // namespace slosh
