// The 95 % interval of a figure of two samples by the percentile bootstrap (Efron & Tibshirani
// 1993, chapter 13): each sample is drawn anew from its own values, with replacement, and the
// interval is that of the quantiles 2.5 and 97.5 % of the figure. The draws are seeded: the same
// samples have the same interval everywhere.
//
// Measured against known truth (20 values against 102, of normal, lognormal and gamma distributions
// with a deviation of 30 %, equal or scaled by 1.25; 1000 pairs of each, and 4000 of the lognormal,
// part of which tests/distributions_test.cpp repeats): the interval holds the true ratio of
// the medians in 95 to 96 %, the basic bootstrap in 87 and the symmetric one in 95 %. The gate
// takes the wider side to both sides (wider_side()), which holds it in 97 %.
#pragma once

#include <functional>

#include "verification/gate/distributions/seeded_draws.hpp"
#include "verification/series/distribution.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

inline constexpr SeededTrials bootstrap_draws{1999, 1993};

using TwoSampleFigure = std::function<double(const Distribution& one, const Distribution& other)>;

Interval bootstrap_interval(const Distribution& one, const Distribution& other,
                            const TwoSampleFigure& figure,
                            const SeededTrials& draws = bootstrap_draws);

// The value with the larger of its distances from the interval's ends as its half width.
Estimate wider_side(double value, const Interval& interval);

}  // namespace slosh
