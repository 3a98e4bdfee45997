// Solvers compared as ensembles, counted against known truth: equal solvers name nobody, one that
// is shifted is named, and solvers that all differ are told to. The header has the shares of more
// panels.
#include "verification/gate/distributions/solver_panel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::solver_panel_test {
namespace {

// A solver whose members are normal, or lognormal with a skewness of 1.3, all with the same mean
// and a deviation of its own.
struct KnownSolver {
  std::size_t members;
  double deviation = 1;
  double shift = 0;
};

struct KnownPanel {
  std::vector<KnownSolver> solvers;
  double between = 0;  // the deviation of the solvers' true means
  bool skewed = false;
};

class RandomPanels {
 public:
  explicit RandomPanels(std::uint64_t seed) : peaks_(seed) {}

  // About 10, so that members are far from zero.
  std::vector<SolverMean> draw(const KnownPanel& panel) {
    std::vector<SolverMean> solvers;
    for (const KnownSolver& one : panel.solvers) {
      const double truth = 10 + one.shift + panel.between * normal();
      std::vector<double> values(one.members);
      for (double& value : values)
        value = truth + one.deviation * (panel.skewed ? lognormal() : normal());
      solvers.push_back(solver_mean(values));
    }
    return solvers;
  }

 private:
  // RandomPeaks draws exp(0.3 x) of a normal x.
  double normal() { return std::log(peaks_.sample(1).mean()) / 0.3; }
  double lognormal() {
    constexpr double s2 = 0.16;
    const double mean = std::exp(s2 / 2), deviation = mean * std::sqrt(std::expm1(s2));
    return (std::exp(0.4 * normal()) - mean) / deviation;
  }

  RandomPeaks peaks_;
};

struct Shares {
  double agree = 0;    // panels of which all are told to agree
  double first = 0;    // that name the first solver
  double other = 0;    // that name another one
  double further = 0;  // that name one which a further solver would not be (p below 5 %)
};

Shares count(const KnownPanel& panel, int trials, int draws, std::uint64_t seed) {
  RandomPanels random(seed);
  Shares shares;
  const double share = 1.0 / trials;
  for (int k = 0; k < trials; ++k) {
    const PanelVerdict verdict =
        judge_panel(random.draw(panel), {draws, seed + static_cast<std::uint64_t>(k)});
    if (verdict.all_agree()) shares.agree += share;
    if (!verdict.odd) continue;
    (*verdict.odd == 0 ? shares.first : shares.other) += share;
    if (verdict.each[*verdict.odd].further_solver_p < panel_level) shares.further += share;
  }
  return shares;
}

const KnownPanel equal{{{20}, {8}, {4}, {4}}}, few{{{4}, {4}, {4}, {4}}},
    unequal{{{20, 1}, {8, 2}, {4, 0.5}, {4, 3}}}, skewed{{{20}, {8}, {4}, {4}}, 0, true},
    three{{{20}, {8}, {4}}}, fewest{{{3}, {3}, {3}}};

KnownPanel shifted(double shift, KnownPanel panel = equal, std::size_t odd = 0) {
  panel.solvers[odd].shift = shift;
  std::swap(panel.solvers[0], panel.solvers[odd]);  // the odd one is counted as the first
  return panel;
}

KnownPanel different(double between, KnownPanel panel = equal) {
  panel.between = between;
  return panel;
}

constexpr int trials = 400, draws_of_trial = 299;

TEST(SolverPanel, NamesNobodyOfEqualSolversInNineteenOfTwentyPanels) {
  std::uint64_t seed = 1;
  for (const KnownPanel& panel : {equal, few, unequal, skewed, three, fewest}) {
    const Shares shares = count(panel, trials, draws_of_trial, seed);
    const double allowed = 0.05 + binomial_half_width(0.05, trials);
    EXPECT_LT(shares.first + shares.other, allowed) << seed;
    EXPECT_GT(shares.agree, 1 - 0.08 - binomial_half_width(0.08, trials)) << seed;
    seed += 1000;
  }
}

TEST(SolverPanel, NamesTheOneThatIsShifted) {
  const Shares by_3 = count(shifted(3), trials, draws_of_trial, 11),
               by_5 = count(shifted(5), trials, draws_of_trial, 12),
               few_by_5 = count(shifted(5, equal, 3), trials, draws_of_trial, 13);
  for (const Shares& shares : {by_3, by_5, few_by_5}) EXPECT_LT(shares.other, 0.05);
  EXPECT_GT(by_3.first, 0.75);
  EXPECT_GT(by_5.first, 0.85);
  EXPECT_GT(few_by_5.first, 0.80);
  for (const Shares& shares : {by_3, by_5, few_by_5}) EXPECT_LT(shares.agree, 0.05);
}

// Where the solvers' own means scatter, one of four may lie apart from three that agree by chance.
// It is named then, and as a further solver of their kind it is nothing special.
TEST(SolverPanel, TellsThatSolversDifferWhichHaveNothingInCommon) {
  const Shares far = count(different(5), trials, draws_of_trial, 21);
  EXPECT_LT(far.agree, 0.05);
  EXPECT_LT(far.first + far.other, 0.15);
  const Shares near = count(different(1), trials, draws_of_trial, 22);
  EXPECT_LT(near.first + near.other, 0.35);
  EXPECT_LT(near.further, 0.05 + binomial_half_width(0.05, trials));
}

SolverMean of(double mean, double deviation, std::size_t members) {
  return {mean, deviation, members};
}

TEST(SolverPanel, TellsHowFarTheOddOneIs) {
  const PanelVerdict verdict =
      judge_panel({of(20, 1, 20), of(10, 1, 8), of(10.3, 1, 4), of(9.8, 1, 4)});
  EXPECT_FALSE(verdict.all_agree());
  ASSERT_EQ(verdict.odd, 0U);
  const SolverApart& odd = verdict.each.at(0);
  EXPECT_NEAR(odd.difference.value, 9.97, 0.02);
  EXPECT_LT(odd.difference.half_width, 2.5);
  EXPECT_LT(odd.corrected_p, 0.01);
  EXPECT_GT(odd.others_agree_p, 0.5);
  for (std::size_t j = 1; j < 4; ++j) {
    EXPECT_LT(verdict.each[j].others_agree_p, 0.01);
    EXPECT_GE(verdict.each[j].corrected_p, verdict.each[j].p);
  }
}

TEST(SolverPanel, NamesNobodyOfTwoPairs) {
  const PanelVerdict verdict =
      judge_panel({of(20, 1, 8), of(20.2, 1, 8), of(10, 1, 8), of(10.1, 1, 8)});
  EXPECT_FALSE(verdict.all_agree());
  EXPECT_FALSE(verdict.odd);
  EXPECT_TRUE(verdict.apart.empty());
}

TEST(SolverPanel, LeavesTwoUnnamedThatCouldEachBeTheOddOne) {
  // The two in the middle scatter so much that they agree with either side.
  const PanelVerdict verdict = judge_panel({of(0, 1, 20), of(2, 4, 8), of(2, 4, 8), of(4, 1, 20)});
  EXPECT_FALSE(verdict.all_agree());
  EXPECT_EQ(verdict.apart.size(), 2U);
  EXPECT_FALSE(verdict.odd);
}

TEST(SolverPanel, OfTwoSolversTellsWhetherTheyAgreeAndNoMore) {
  const PanelVerdict verdict = judge_panel({of(20, 1, 8), of(10, 1, 8)});
  EXPECT_LT(verdict.agree_p, 0.01);
  EXPECT_TRUE(verdict.each.empty());
  EXPECT_FALSE(verdict.odd);
  EXPECT_THROW(judge_panel({of(20, 1, 8)}), std::invalid_argument);
}

TEST(SolverPanel, TakesMembersThatDoNotScatter) {
  EXPECT_TRUE(judge_panel({of(3, 0, 4), of(3, 0, 4), of(3, 0, 4)}).all_agree());
  EXPECT_EQ(judge_panel({of(3, 0, 8), of(3, 0, 8), of(4, 0, 8), of(3, 0, 8)}).odd, 2U);
  EXPECT_TRUE(judge_panel({of(0, 0, 4), of(0, 0, 4)}).all_agree());
}

TEST(SolverPanel, HasOneAnswerForOneQuestion) {
  const std::vector<SolverMean> solvers{of(12, 1, 8), of(10, 1, 8), of(10.3, 1, 4)};
  EXPECT_EQ(judge_panel(solvers).agree_p, judge_panel(solvers).agree_p);
}

TEST(SolverMeans, NeedThreeMembers) {
  EXPECT_THROW(solver_mean({1, 2}), std::invalid_argument);
  const Estimate found = solver_mean({1, 2, 3}).estimate();
  EXPECT_DOUBLE_EQ(found.value, 2);
  EXPECT_NEAR(found.half_width, 4.302653 / std::sqrt(3.0), 1e-5);
}

// The intervals of the mean, of a ratio and of a difference hold the truth in 95 to 96 % of all
// draws of normal members and in 92 to 93 % of skewed ones.
TEST(SolverMeans, HaveIntervalsThatHoldTheTruth) {
  for (const bool is_skewed : {false, true}) {
    const KnownPanel panel{{{4, 2}, {8, 1}}, 0, is_skewed};
    RandomPanels random(31);
    int mean_held = 0, ratio_held = 0, difference_held = 0;
    constexpr int draws = 4000;
    for (int k = 0; k < draws; ++k) {
      const auto solvers = random.draw(panel);
      const auto holds = [](const Estimate& found, double truth) {
        return std::abs(found.value - truth) <= found.half_width;
      };
      mean_held += holds(solvers[0].estimate(), 10);
      ratio_held += holds(ratio_less_one(solvers[0], solvers[1]), 0);
      difference_held += holds(difference_of(solvers[0], solvers[1]), 0);
    }
    for (const int held : {mean_held, ratio_held, difference_held}) {
      EXPECT_GT(held / double(draws), is_skewed ? 0.90 : 0.935);
      EXPECT_LT(held / double(draws), 0.975);
    }
  }
}

}  // namespace
}  // namespace slosh::solver_panel_test
