// What a study of spacings shows against an experiment: whether the impacts come nearer to it as
// the spacing falls, and which of two ways changes less. Single histories of a chaotic flow cannot
// tell, as their rms difference saturates near that of strangers; ensembles can. With m_n the mean
// over the members of impact n, of its arrival [s] or of the logarithm of its peak:
//   distance to the experiment  d = mean over n of |m_n - e_n|, e_n published
//   change with the spacing     c = mean over the coarser spacings and n of |m_n - f_n|, f_n of the
//                                   finest
// Both differences below are tested by exchanging whole members: if the spacing (or the way) does
// not matter, the members of both sides are alike, and every division of them is as likely. The
// p-value is exact at any number of members (permutation_test.hpp); of n members on each side it is
// no smaller than two over the number of divisions, 2 n!^2 / (2 n)!: 0.1 of three, 0.03 of four.
// Single runs decide nothing, and three repeats do not decide at 5 %. Means and not medians, as the
// median of four hardly moves where one member is exchanged: it found p = 0.08 where the mean finds
// 0.03.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/series/seeded_draws.hpp"

namespace slosh {

inline constexpr SeededTrials exchanges{9999, 2021};

// impact_numbers() of each member of an ensemble.
using ImpactEnsemble = std::vector<std::vector<ImpactNumbers>>;
// The ensembles of one way of modelling, from the coarsest spacing to the finest.
using SpacingStudy = std::vector<ImpactEnsemble>;

enum class ImpactFigure {
  arrival,  // in s, against the published arrivals
  peak      // |ln ratio|, against the median of the repeats, or the published mean without them
};

// `difference` is above zero where the sentence of the function holds, in the figure's unit; it is
// not chance where p < 5 %, the two-sided p-value.
struct ExchangeTest {
  double difference, p;
};

// All throw ComparisonError where a study has fewer than two spacings, an ensemble is empty or an
// impact does not occur in a member; the first two where the case publishes no arrivals.

// The mean distance d of an ensemble to the experiment of the case.
double distance_to_experiment(const ImpactEnsemble& ensemble, ImpactFigure figure,
                              const CaseDefinition& definition);

// "The finest spacing is nearer to the experiment than the coarsest": d of the coarsest less d of
// the finest.
ExchangeTest nearer_when_finer(const SpacingStudy& study, ImpactFigure figure,
                               const CaseDefinition& definition,
                               const SeededTrials& trials = exchanges);

// "The first way changes less with the spacing than the second": c of the second less c of the
// first. Both have the same spacings.
ExchangeTest changes_less(const SpacingStudy& first, const SpacingStudy& second,
                          ImpactFigure figure, const SeededTrials& trials = exchanges);

}  // namespace slosh
