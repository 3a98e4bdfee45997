// Studies of spacings with known truth: what the tests of exchanged members say of ensembles that
// are alike, that approach the experiment, that leave it, and that are too few.
#include "verification/gate/distributions/spacing_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/gate/tests/random_peaks.hpp"
#include "verification/tests/impact_results.hpp"

namespace slosh::spacing_study_test {
namespace {

const CaseDefinition& with_arrivals() {
  static const CaseDefinition definition = [] {
    CaseDefinition made = impact_case();
    made.impacts->arrivals = ArrivalsDefinition{0.1, made.impacts->times, 0.001};
    return made;
  }();
  return definition;
}

// Members that are late by `late` [s] and have peaks of `scale` times the experiment's, both with a
// scatter that no two impacts share.
ImpactEnsemble ensemble(RandomPeaks& random, std::size_t members, double late, double scale = 1) {
  const ImpactsDefinition& published = *with_arrivals().impacts;
  ImpactEnsemble made;
  for (std::size_t k = 0; k < members; ++k) {
    made.emplace_back();
    for (std::size_t n = 0; n < published.times.size(); ++n) {
      const double factor = random.sample(1).sorted().front();
      ImpactNumbers one;
      one.arrival = published.times[n] + late + 0.03 * std::log(factor);  // 9 ms of scatter
      one.peak = ImpactPeak{*one.arrival, scale * factor * published.peak_means[n]};
      made.back().push_back(one);
    }
  }
  return made;
}

constexpr ImpactFigure both[] = {ImpactFigure::arrival, ImpactFigure::peak};
constexpr SeededTrials few{999, 1};

TEST(SpacingStudy, MeasuresTheDistanceOfTheMeansToTheExperiment) {
  RandomPeaks random(3);
  const ImpactEnsemble late = ensemble(random, 201, 0.05, 2);
  EXPECT_NEAR(distance_to_experiment(late, ImpactFigure::arrival, with_arrivals()), 0.05, 0.003);
  EXPECT_NEAR(distance_to_experiment(late, ImpactFigure::peak, with_arrivals()), std::log(2), 0.06);
}

TEST(SpacingStudy, FindsFourRepeatsThatComeNearerAndThatLeave) {
  RandomPeaks random(4);
  const ImpactEnsemble far = ensemble(random, 4, -0.1, 3), near = ensemble(random, 4, 0.01, 1.1);
  for (const ImpactFigure figure : both) {
    const ExchangeTest found = nearer_when_finer({far, near}, figure, with_arrivals());
    EXPECT_GT(found.difference, 0.05);
    EXPECT_LT(found.p, 0.05);
    const ExchangeTest away = nearer_when_finer({near, far}, figure, with_arrivals());
    EXPECT_NEAR(away.difference, -found.difference, 1e-12);
    EXPECT_LT(away.p, 0.05);
  }
}

TEST(SpacingStudy, FindsTheWayThatChangesLessWithTheSpacing) {
  RandomPeaks random(5);
  const auto study = [&](double late, double scale) {
    return SpacingStudy{ensemble(random, 4, late, scale),
                        ensemble(random, 4, late / 2, std::sqrt(scale)), ensemble(random, 4, 0)};
  };
  const SpacingStudy steady = study(0.005, 1.05), unsteady = study(0.15, 4);
  for (const ImpactFigure figure : both) {
    const ExchangeTest found = changes_less(steady, unsteady, figure);
    EXPECT_GT(found.difference, 0.05);
    EXPECT_LT(found.p, 0.05);
    EXPECT_LT(changes_less(unsteady, steady, figure).difference, -0.05);
  }
}

TEST(SpacingStudy, RejectsEnsemblesThatAreAlikeInFivePercentAtMost) {
  RandomPeaks random(6);
  constexpr int trials = 300;
  int nearer = 0, less = 0;
  for (int k = 0; k < trials; ++k) {
    const SpacingStudy one{ensemble(random, 4, 0.02), ensemble(random, 4, 0.02)},
        other{ensemble(random, 4, 0.02), ensemble(random, 4, 0.02)};
    nearer += nearer_when_finer(one, ImpactFigure::peak, with_arrivals(), few).p < 0.05;
    less += changes_less(one, other, ImpactFigure::arrival, few).p < 0.05;
  }
  const double most = trials * (0.05 + binomial_half_width(0.05, trials));
  EXPECT_LE(nearer, most);
  EXPECT_LE(less, most);
}

TEST(SpacingStudy, DecidesNothingBySingleRunsNorByThreeRepeats) {
  RandomPeaks random(7);
  for (const std::size_t members : {std::size_t{1}, std::size_t{3}}) {
    const SpacingStudy study{ensemble(random, members, 0.3, 9), ensemble(random, members, 0)};
    for (const ImpactFigure figure : both)
      EXPECT_GT(nearer_when_finer(study, figure, with_arrivals()).p, 0.05) << members;
  }
}

TEST(SpacingStudy, RefusesWhatItCannotCompare) {
  RandomPeaks random(8);
  const ImpactEnsemble sound = ensemble(random, 4, 0);
  ImpactEnsemble lacking = sound;
  lacking[2][3] = {};
  for (const ImpactFigure figure : both) {
    EXPECT_THROW(nearer_when_finer({sound}, figure, with_arrivals()), ComparisonError);
    EXPECT_THROW(nearer_when_finer({sound, {}}, figure, with_arrivals()), ComparisonError);
    EXPECT_THROW(nearer_when_finer({sound, lacking}, figure, with_arrivals()), ComparisonError);
    EXPECT_THROW(nearer_when_finer({sound, sound}, figure, impact_case()), ComparisonError);
    EXPECT_THROW(changes_less({sound, sound}, {sound}, figure), ComparisonError);
  }
}

}  // namespace
}  // namespace slosh::spacing_study_test
