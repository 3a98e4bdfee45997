// Several solvers compared as samples where none of them is the reference: do they agree, and is
// one of them apart? With m_i the mean of the n_i members of solver i, s_i their standard deviation
// and v_i = s_i^2 / n_i:
//
// Do all agree within their sampling scatter?
//   Q = sum_i w_i (m_i - m)^2,   w_i = 1/v_i,   m = sum w_i m_i / sum w_i
// with its distribution by the parametric bootstrap (Krishnamoorthy, Lu & Mathew 2007, Comput.
// Stat. Data Anal. 51:5731): the means are drawn from normal distributions of the variances v_i and
// equal means, the v_i anew from chi-squared ones. Of 20, 8, 4 and 4 members of unequal scatter or
// skewed it rejects 5.7 and 5.8 % of equal solvers, where Welch's test rejects 6.7 and 7.2 % (1500
// panels).
//
// Is one apart while the others agree? The others are a sample of solvers, so that their means
// scatter by tau beside the v_i (random effects; Hedges 1983, Psychol. Bull. 93:388):
//   tau^2 = max(0, variance of the others' m_i - mean of their v_i),
//   m_o = sum w_i m_i / sum w_i,   w_i = 1 / (tau^2 + v_i),   i over the others
//   T_j = |m_j - m_o| / sqrt(tau^2 + v_j + 1 / sum w_i)
// with its distribution by the same bootstrap, tau estimated anew from each draw. The p-values of
// all solvers are corrected together (Holm 1979, Scand. J. Stat. 6:65). Solver j is named where not
// all agree, the others agree, and it alone differs from them by its corrected p-value, each at
// 5 %. Two that could each be the odd one leave both unnamed.
//
// That one is apart from these others is less than that it is unlike solvers in general. With M the
// unweighted mean of the others' m_i, S^2 the variance of these m_i but no less than the mean of
// their v_i, below which tau cannot be told, and k solvers,
//   t = |m_j - M| / sqrt(S^2 (1 + 1 / (k - 1)) + v_j)
// has Student's distribution of k - 2 degrees of freedom, one or two, if j is one more solver of
// the others' kind (a prediction, as of Higgins, Thompson & Spiegelhalter 2009, J. R. Stat. Soc. A
// 172:137). Its p-value is told beside the name, corrected by Holm too, and names nobody.
//
// Counted against known truth (4000 panels each of 999 draws; shifts and scatters in standard
// deviations of the members), part of which tests/solver_panel_test.cpp repeats. Of equal solvers
// all agree in 94 to 97 % of the panels and one is named in 2 to 3 %: of 20, 8, 4 and 4 members, of
// 4 each, of unequal scatter (1, 2, 0.5 and 3), of skewed members, of three solvers, of 3 members
// each. One of four that is shifted is named in
//   20 members among 8, 4 and 4, shifted by 2, 3 and 5:  72, 83 and 92 %
//   4 members among 20, 8 and 4, shifted by 3 and 5:     72 and 92 %
//   4 members among 4, 4 and 4, shifted by 3 and 5:      61 and 89 %
// and another one in 0.1 % or less. Where the solvers' true means all differ, by normal errors of
// the deviation 1, 2 or 5, one of four is named in 19, 15 and 6 %, one of three in 32, 37 and 26 %:
// two of them agree by chance. The p-value of one more solver is then below 5 % as well
// in 2.1 % of four or less and in 0.1 % of three; of one that is shifted by 5 in 9 to 34 % of four.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "verification/series/seeded_draws.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// With fewer members a run has no scatter that a test could rest on.
inline constexpr std::size_t fewest_members = 3;
// With two solvers a difference does not tell which of them is apart.
inline constexpr std::size_t fewest_solvers = 3;
inline constexpr SeededTrials panel_draws{4999, 2007};
inline constexpr double panel_level = 0.05;

// The mean of one solver's members.
struct SolverMean {
  double mean;
  double deviation;     // of the members, with n - 1
  std::size_t members;  // fewest_members or more

  // With the half width t_(0.975, n-1) s / sqrt(n) of its 95 % interval.
  Estimate estimate() const;
};

// Throws std::invalid_argument for fewer than fewest_members values.
SolverMean solver_mean(const std::vector<double>& values);

// A solver against the others.
struct SolverApart {
  Estimate difference;      // m_j - m_o, with the interval of T_j's bootstrap
  double p;                 // of T_j
  double corrected_p;       // by Holm
  double others_agree_p;    // of Q of the others
  double further_solver_p;  // of t, corrected likewise
};

struct PanelVerdict {
  double agree_p;                  // of Q of all
  std::vector<SolverApart> each;   // in the order of the solvers; empty for fewer than three
  std::vector<std::size_t> apart;  // those that each could be the odd one
  std::optional<std::size_t> odd;  // the one that is named

  bool all_agree() const { return agree_p >= panel_level; }
};

// Throws std::invalid_argument for fewer than two solvers.
PanelVerdict judge_panel(const std::vector<SolverMean>& solvers,
                         const SeededTrials& draws = panel_draws);

// The first mean over the second, less 1, with a 95 % interval to first order in the means' errors:
//   u^2 = (m_1/m_2)^2 (v_1/m_1^2 + v_2/m_2^2),   half width = t_(0.975, nu) u,
// nu by Welch and Satterthwaite.
Estimate ratio_less_one(const SolverMean& one, const SolverMean& other);
// The first mean less the second, with Welch's 95 % interval.
Estimate difference_of(const SolverMean& one, const SolverMean& other);

}  // namespace slosh
