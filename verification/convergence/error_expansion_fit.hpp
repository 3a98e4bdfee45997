// Least-squares fits of error expansions to values at four or more steps, and the choice among them
// of Eca & Hoekstra 2014 (J. Comput. Phys. 262, 104-130, eqs 1 to 18 and appendices A and B):
//   power:  f = f0 + a h^p, p unknown        second: f = f0 + a h^2
//   first:  f = f0 + a h                     mixed:  f = f0 + a1 h + a2 h^2
// each with equal weights and with w_i = (1 / h_i) / sum (1 / h_j), and with the standard deviation
//   sigma = sqrt(sum n w_i (f_i - fit_i)^2 / (n - m)),   m = 3 unknowns (power, mixed) or 2.
// Of p weighted and not the one with the smaller sigma counts, of one above and one below zero the
// one above. 0.5 <= p <= 2: the power law is the fit; p > 2: first or second; p < 0.5, or p < 0 in
// both (anomalous): first, second or mixed; always the one with the smallest sigma. For methods of
// formal order two.
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
  double order;                // p of the power law; of the mixed expansion 1, its leading one
  double extrapolated;         // f0
  std::vector<double> fitted;  // fit(h_i), in the order of the values
  double deviation;            // sigma

  double error_at(std::size_t i) const { return fitted[i] - extrapolated; }
};

struct OrderRange {
  double low, high;
};

// Orders between which a fit can be relied on.
constexpr OrderRange reliable_orders{0.5, 2};

// All of them take four or more values, finest step first, steps distinct.

// p within the range, at whose end it may stop.
ExpansionFit fit_power_law(const std::vector<ValueAtStep>& values, bool weighted, OrderRange range);

// Of an expansion other than the power law.
ExpansionFit fit_fixed_orders(const std::vector<ValueAtStep>& values, bool weighted,
                              Expansion expansion);

struct ChosenExpansion {
  // p of the power law, none where the data are anomalous; 8 stands for all above.
  std::optional<double> observed_order;
  ExpansionFit fit;
};

ChosenExpansion choose_expansion(const std::vector<ValueAtStep>& values);

}  // namespace slosh
