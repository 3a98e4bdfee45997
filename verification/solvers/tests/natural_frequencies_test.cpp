#include "verification/solvers/theory/natural_frequencies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/tests/sample_case.hpp"

namespace slosh::natural_frequencies_test {
namespace {

double of_rectangle(int half_waves) {
  const double k = half_waves * std::numbers::pi;
  return std::sqrt(9.81 * k * std::tanh(0.35 * k));
}

TEST(NaturalFrequencies, OfARectangleAreThoseOfLinearTheory) {
  const std::vector<double> found = natural_frequencies(sample_case(), 3);
  ASSERT_EQ(found.size(), 3u);
  for (int n = 1; n <= 3; ++n)
    EXPECT_NEAR(found[static_cast<std::size_t>(n) - 1], of_rectangle(n), 1e-12);
}

TEST(NaturalFrequencies, ThatTheMotionExcitesAreThoseOfTheOddModes) {
  const std::map<int, double> found = excited_frequencies(sample_case(), 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found.at(1), of_rectangle(1), 1e-12);
  EXPECT_NEAR(found.at(3), of_rectangle(3), 1e-12);
}

TEST(NaturalFrequencies, AreNoneWithoutGravity) {
  CaseDefinition definition = sample_case();
  definition.gravity = 0;
  EXPECT_TRUE(natural_frequencies(definition, 2).empty());
  EXPECT_TRUE(excited_frequencies(definition, 2).empty());
}

TEST(NaturalFrequencies, OfAnOutlineAreThoseOfItsSection) {
  CaseDefinition definition = sample_case();
  definition.tank.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<double> found = natural_frequencies(definition, 3);
  ASSERT_EQ(found.size(), 3u);
  for (int n = 1; n <= 3; ++n)
    EXPECT_NEAR(found[static_cast<std::size_t>(n) - 1], of_rectangle(n), 1e-7);
}

TEST(NaturalFrequencies, AreNotKnownOfATankWithALedgeUnderTheStillSurface) {
  CaseDefinition definition = sample_case();
  definition.tank.outline = {{0.2, 0}, {0.8, 0}, {0.8, 0.1}, {1, 0.1},
                             {1, 1},   {0, 1},   {0, 0.1},   {0.2, 0.1}};
  EXPECT_TRUE(natural_frequencies(definition, 2).empty());
  EXPECT_TRUE(excited_frequencies(definition, 2).empty());
}

// A vertical middle line makes every second mode symmetric, which no surge or roll about it
// excites.
TEST(NaturalFrequencies, ThatTheMotionExcitesAreAllOfASkewSection) {
  CaseDefinition definition = sample_case();
  definition.tank.outline = {{0.3, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(excited_frequencies(definition, 2).at(2), natural_frequencies(definition, 2)[1]);
  definition.tank.outline = {{0.2, 0}, {0.8, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(excited_frequencies(definition, 2).at(3), natural_frequencies(definition, 3)[2]);
}

}  // namespace
}  // namespace slosh::natural_frequencies_test
