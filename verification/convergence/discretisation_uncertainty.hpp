// How far the value at one of three or more steps, the finest unless told otherwise, may be from
// the one at no step at all, and how the values behave as the step falls. With f1 the finest value,
// n_i the noise of value i and e_ij = f_i - f_j, tested in this order:
//   floor: |e21| or |e32| within the noise of the two values, sqrt(n_i^2 + n_j^2), or the finest
//     three do not converge where the next three did
//   diverging: the finest three, or (four or more values) the fitted power law, have no order > 0
//   oscillatory: differences of both signs beyond their noise
//   superconvergent: order >= 2.1;   monotone: the rest
// Three values (three_grid_order.hpp), monotone or superconvergent, with the order p brought into
// 0.5 to 2: eps = e21 / (r21^p - 1), U = F |eps|, with F = 1.25 (Celik et al. 2008) where p itself
// was 0.5 to 2.1 and F = 3 elsewhere (after Oberkampf & Roy 2010, Verification and Validation in
// Scientific Computing, chapter 8). Four or more (error_expansion_fit.hpp; Eca & Hoekstra 2014,
// appendix A), D = (max f - min f) / (n - 1), F = 1.25 where 0.5 <= p < 2.1 and sigma < D, else 3:
//   U = F |eps| + sigma + |f1 - fit|                  where sigma < D     (eq. 20)
//   U = 3 sigma / D (|eps| + sigma + |f1 - fit|)      elsewhere           (eq. 21)
// About the value fk at a coarser step hk, of which the finer ones tell as much: eps = fk - f0 of
// three values, the fitted expansion's at hk and the residual there of more; F and the order are
// those of all values together.
// The values' noise adds sqrt(sum d_i^2) to both, d_i the most that eps changes as f_i is moved up
// or down by n_i, in one sum: added in quadrature, 88 % instead of 95 % of the intervals over three
// noisy values of order one held the truth. At a floor U is not below, and of three values that
// oscillate or diverge it is,
//   3 M max(1, hk / (h3 - h1)),   M the largest difference of the finest three, or of all down to
// fk, h3 then being hk, not below its noise
// (F = 3 on an error of first order over the data's range, after Eca & Hoekstra 2009, Comput.
// Fluids 38, 1580-1591). Valid for errors of order 0.5 to 2 whose leading term leads at every step:
// where two terms of opposite sign cancel at a coarse one, values can seem to converge to what is
// not their limit. A floor says that the step no longer matters, and nothing of how far from the
// truth the floor lies: what is held fixed there (h / dp, the speed of sound) has an uncertainty of
// its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/convergence/three_grid_order.hpp"

namespace slosh {

enum class StepBehaviour { monotone, superconvergent, oscillatory, diverging, floor };

struct DiscretisationUncertainty {
  StepBehaviour behaviour;
  std::optional<double> order;  // of monotone and superconvergent values alone
  // f at no step; of values that have no order the value asked about itself.
  double extrapolated;
  // Half width of the 95 % interval about the value asked about, in the values' unit, of the
  // discretisation alone: that value's own noise is to be added by whoever judges by it.
  double uncertainty;
  std::string explanation;  // a sentence
};

// Half width of the 95 % interval about the value at `step` of values that differ by `difference`
// between the finest and the coarsest step, of an error of first order with a safety factor of 3,
// not below three times the difference itself: 3 difference max(1, step / (coarsest - finest)).
double first_order_uncertainty(double difference, double step, double finest, double coarsest);

// Values in any order; `at_step` is the step of the value asked about, none for the finest. Throws
// ComparisonError of fewer than three values, where there is none at that step, and where a step is
// not above zero, two steps are equal, or a value or its noise is not finite or the noise is
// negative.
DiscretisationUncertainty discretisation_uncertainty(std::vector<ValueAtStep> values,
                                                     std::optional<double> at_step = {});

// "monotone", "superconvergent", "oscillatory", "diverging", "floor"
std::string behaviour_name(StepBehaviour behaviour);

}  // namespace slosh
