// The discretisation uncertainty of a value at one of three or more steps (the finest unless told
// otherwise): how far it may be from the limit at step zero, and how the values behave as the step
// falls. With f1 the finest value, n_i the noise of value i and e_ij = f_i - f_j, the behaviours
// are tested in this order:
//   floor: |e21| or |e32| within the noise of the two values, sqrt(n_i^2 + n_j^2), or the finest
//     three do not converge where the next three did
//   diverging: the finest three, or (four or more values) the fitted power law, have no order > 0
//   oscillatory: differences of both signs beyond their noise
//   superconvergent: order >= 2.1;   monotone: the rest
// Three values (three_grid_order.hpp), monotone or superconvergent, with the order p limited to
// 0.5 to 2: eps = e21 / (r21^p - 1), U = F |eps|, with F = 1.25 (Celik et al. 2008) where p itself
// was 0.5 to 2.1 and F = 3 elsewhere (after Oberkampf & Roy 2010, Verification and Validation in
// Scientific Computing, chapter 8). Four or more (error_expansion_fit.hpp; Eca & Hoekstra 2014,
// appendix A), D = (max f - min f) / (n - 1), F = 1.25 where 0.5 <= p < 2.1 and sigma < D, else 3:
//   U = F |eps| + sigma + |f1 - fit|                  where sigma < D     (eq. 20)
//   U = 3 sigma / D (|eps| + sigma + |f1 - fit|)      elsewhere           (eq. 21)
// For the value fk at a coarser step hk the finer ones count as well: eps = fk - f0 for three
// values, and for more the error and residual of the fitted expansion at hk; F and the order are
// those of all values together.
//
// The values' noise adds sqrt(sum d_i^2) to both, where d_i is the largest change of eps as f_i
// moves up or down by n_i. It is added linearly: added in quadrature, 88 % instead of 95 % of the
// intervals over three noisy values of order one held the truth. At a floor U has the lower bound,
// and for three values that oscillate or diverge U is,
//   3 M max(1, hk / (h3 - h1)),   M the largest difference of the finest three, or of all down to
// fk, in which case h3 is hk; M is at least the noise
// (F = 3 on an error of first order over the data's range, after Eca & Hoekstra 2009, Comput.
// Fluids 38, 1580-1591). Valid for errors of order 0.5 to 2 whose leading term dominates at every
// step: where two terms of opposite sign cancel at a coarse step, values can seem to converge to a
// wrong limit. A floor shows that the step no longer matters, but not how far the floor is from the
// truth: parameters that are held fixed (h / dp, the speed of sound) have an uncertainty of their
// own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/convergence/three_grid_order.hpp"

namespace slosh {

enum class StepBehaviour { monotone, superconvergent, oscillatory, diverging, floor };

struct DiscretisationUncertainty {
  StepBehaviour behaviour;
  std::optional<double> order;  // only for monotone and superconvergent values
  // The leading order of the expansion that was extrapolated, which is not the observed one where
  // that is below 0.5 or above 2; only for values with an order.
  std::optional<double> order_used;
  // f at step zero; for values without an order, the value at the step asked for.
  double extrapolated;
  // Half width of the 95 % interval about the value at the step asked for, in the values' unit, for
  // the discretisation alone. The value's own noise must be added.
  double uncertainty;
  std::string explanation;  // a sentence
};

// Half width of the 95 % interval about the value at `step`, for values that differ by `difference`
// between the finest and the coarsest step. It assumes an error of first order and a safety factor
// of 3, and is at least three times the difference:
// 3 difference max(1, step / (coarsest - finest)).
double first_order_uncertainty(double difference, double step, double finest, double coarsest);

// Takes values in any order; `at_step` is the step of the value asked for, the finest by default.
// Throws ComparisonError for fewer than three values, when there is no value at that step, when a
// step is not above zero or two steps differ by less than least_refinement_ratio, when a value or
// its noise is not finite, and when the noise is negative.
DiscretisationUncertainty discretisation_uncertainty(std::vector<ValueAtStep> values,
                                                     std::optional<double> at_step = {});

// Whether the observed order lies outside the reliable ones, so that the extrapolation takes
// another.
bool takes_other_order(const DiscretisationUncertainty& found);

// "1.46"; "0.21 (extrapolated with 0.5)" where the extrapolation takes another order; "" without an
// order.
std::string observed_order_text(const DiscretisationUncertainty& found);

// "monotone", "superconvergent", "oscillatory", "diverging", "floor"
std::string behaviour_name(StepBehaviour behaviour);

}  // namespace slosh
