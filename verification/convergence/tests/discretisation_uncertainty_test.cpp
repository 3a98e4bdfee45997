#include "verification/convergence/discretisation_uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "verification/series/time_series.hpp"

namespace slosh::discretisation_uncertainty_test {
namespace {

using Values = std::vector<ValueAtStep>;

// The values at steps 1, 1.5, 2.25, ...
Values at_steps(std::size_t count, const std::function<double(double)>& value, double noise = 0) {
  Values values;
  for (double h = 1; values.size() < count; h *= 1.5) values.push_back({h, value(h), noise});
  return values;
}

Values of_order(double order, std::size_t count, double noise = 0) {
  return at_steps(
      count, [order](double h) { return 5 + 0.2 * std::pow(h, order); }, noise);
}

StepBehaviour behaviour(const Values& values) {
  return discretisation_uncertainty(values).behaviour;
}

TEST(DiscretisationUncertainty, IsTheGridConvergenceIndexOfExactDataOfAReliableOrder) {
  for (const std::size_t count : {3, 4, 6})
    for (const double order : {0.6, 1.0, 1.5, 2.0}) {
      const auto result = discretisation_uncertainty(of_order(order, count));
      EXPECT_EQ(result.behaviour, StepBehaviour::monotone);
      EXPECT_NEAR(*result.order, order, 1e-3);
      EXPECT_NEAR(result.extrapolated, 5, 1e-4);
      EXPECT_NEAR(result.uncertainty, 1.25 * 0.2, 1e-3);
      EXPECT_NE(result.explanation.find("observed order"), std::string::npos);
    }
}

TEST(DiscretisationUncertainty, IsCeliksForHisMonotoneSample) {
  const auto result = discretisation_uncertainty(
      {{1 / std::sqrt(4500), 5.863}, {1 / std::sqrt(18000), 6.063}, {1 / std::sqrt(8000), 5.972}});
  EXPECT_EQ(result.behaviour, StepBehaviour::monotone);
  EXPECT_NEAR(*result.order, 1.53, 0.005);
  EXPECT_NEAR(result.extrapolated, 6.1685, 5e-4);
  EXPECT_NEAR(result.uncertainty / 6.063, 0.022, 5e-4);
}

TEST(DiscretisationUncertainty, RefusesAnOrderToCeliksOscillatingSample) {
  const auto result = discretisation_uncertainty({{1 / std::sqrt(18000), 6.0042},
                                                  {1 / std::sqrt(4500), 5.9624},
                                                  {1 / std::sqrt(980), 6.0909}});
  EXPECT_EQ(result.behaviour, StepBehaviour::oscillatory);
  EXPECT_FALSE(result.order);
  EXPECT_EQ(result.extrapolated, 6.0042);
  EXPECT_NEAR(result.uncertainty, 3 * 0.1285, 1e-9);
}

TEST(DiscretisationUncertainty, IsCautiousOutsideTheReliableOrders) {
  const auto high = discretisation_uncertainty(of_order(3, 3));
  EXPECT_EQ(high.behaviour, StepBehaviour::superconvergent);
  EXPECT_NEAR(*high.order, 3, 1e-9);
  const double e21 = 0.2 * (std::pow(1.5, 3) - 1);
  EXPECT_NEAR(high.uncertainty, 3 * e21 / (1.5 * 1.5 - 1), 1e-12);
  EXPECT_EQ(behaviour(of_order(3, 5)), StepBehaviour::superconvergent);
  EXPECT_GT(discretisation_uncertainty(of_order(3, 5)).uncertainty, 2 * 0.2);
  const auto low = discretisation_uncertainty(of_order(0.3, 3));
  EXPECT_EQ(low.behaviour, StepBehaviour::monotone);
  EXPECT_NEAR(*low.order, 0.3, 1e-9);
  EXPECT_GE(low.uncertainty, 0.2);
}

TEST(DiscretisationUncertainty, SaysWhichOrderTheExtrapolationTakesInPlaceOfTheObservedOne) {
  const auto of_three = discretisation_uncertainty(of_order(0.3, 3));
  EXPECT_EQ(of_three.order_used, 0.5);
  EXPECT_NE(of_three.explanation.find("order of 0.30"), std::string::npos);
  EXPECT_NE(of_three.explanation.find("takes the order 0.5 instead"), std::string::npos)
      << of_three.explanation;
  EXPECT_EQ(observed_order_text(of_three), "0.30 (extrapolated with 0.5)");
  const auto of_five = discretisation_uncertainty(of_order(0.3, 5));
  EXPECT_NE(of_five.explanation.find("takes the order 1 instead"), std::string::npos)
      << of_five.explanation;
  const auto high = discretisation_uncertainty(of_order(3, 3));
  EXPECT_NE(high.explanation.find("takes the order 2 instead"), std::string::npos);
  for (const std::size_t count : {3, 5}) {
    const auto reliable = discretisation_uncertainty(of_order(1.5, count));
    EXPECT_EQ(reliable.explanation.find("instead"), std::string::npos);
    EXPECT_EQ(observed_order_text(reliable), "1.50");
  }
}

TEST(DiscretisationUncertainty, HoldsTheErrorOfAMixedExpansion) {
  for (const std::size_t count : {3, 4, 5}) {
    const auto result = discretisation_uncertainty(
        at_steps(count, [](double h) { return 5 + 0.2 * h + 0.1 * h * h; }));
    EXPECT_EQ(result.behaviour, StepBehaviour::monotone);
    EXPECT_GT(*result.order, 1);
    EXPECT_LT(*result.order, 2);
    EXPECT_GE(result.uncertainty, 0.3 * 0.8);  // eps falls short of the mixed error by design
  }
}

TEST(DiscretisationUncertainty, CallsADifferenceWithinTheNoiseAFloorAndNeverConvergence) {
  const double last = 0.2 * 0.5, before = 0.2 * 0.75;  // of order one: |e21|, |e32|
  for (const std::size_t count : {3, 4, 6}) {
    EXPECT_EQ(behaviour(of_order(1, count, 0.99 * last / std::sqrt(2))), StepBehaviour::monotone);
    const auto result = discretisation_uncertainty(of_order(1, count, 1.01 * last / std::sqrt(2)));
    EXPECT_EQ(result.behaviour, StepBehaviour::floor);
    EXPECT_FALSE(result.order);
    EXPECT_GE(result.uncertainty, 3 * before);
    EXPECT_NE(result.explanation.find("within its noise"), std::string::npos);
  }
}

TEST(DiscretisationUncertainty, FindsTheFloorAtWhichConvergenceStops) {
  const Values values{{1, 5.13}, {1.5, 5.08}, {2.25, 5.1}, {3.375, 5.23}, {5.0625, 5.5}};
  const auto result = discretisation_uncertainty(values);
  EXPECT_EQ(result.behaviour, StepBehaviour::floor);
  EXPECT_NE(result.explanation.find("does not fall"), std::string::npos);
  EXPECT_EQ(result.extrapolated, values[0].value);
}

TEST(DiscretisationUncertainty, CallsEqualValuesAFloorWithNothingButTheirNoise) {
  for (const std::size_t count : {3, 5}) {
    const auto exact = discretisation_uncertainty(at_steps(count, [](double) { return 5; }));
    EXPECT_EQ(exact.behaviour, StepBehaviour::floor);
    EXPECT_EQ(exact.uncertainty, 0);
    const auto noisy = discretisation_uncertainty(at_steps(
        count, [](double) { return 5; }, 0.1));
    EXPECT_EQ(noisy.behaviour, StepBehaviour::floor);
    EXPECT_NEAR(noisy.uncertainty, 3 * 0.1 * std::sqrt(2), 1e-12);
  }
}

TEST(DiscretisationUncertainty, TellsOscillationAndDivergenceFromConvergence) {
  for (const std::size_t count : {3, 4, 5}) {
    const auto swinging = at_steps(count, [](double h) {
      return 5 + 0.2 * h * h * std::cos(std::numbers::pi * std::log(h) / std::log(1.5));
    });
    const auto oscillatory = discretisation_uncertainty(swinging);
    EXPECT_EQ(oscillatory.behaviour, StepBehaviour::oscillatory);
    EXPECT_FALSE(oscillatory.order);
    EXPECT_GE(oscillatory.uncertainty, 0.2);
    const auto diverging = discretisation_uncertainty(of_order(-1, count));
    EXPECT_EQ(diverging.behaviour, StepBehaviour::diverging);
    EXPECT_FALSE(diverging.order);
    EXPECT_GE(diverging.uncertainty, std::abs(of_order(-1, 3)[0].value - of_order(-1, 3)[1].value));
  }
}

TEST(DiscretisationUncertainty, GrowsWithTheNoiseOfTheValues) {
  for (const std::size_t count : {3, 5}) {
    const double quiet = discretisation_uncertainty(of_order(1.5, count)).uncertainty;
    const double noisy = discretisation_uncertainty(of_order(1.5, count, 0.02)).uncertainty;
    EXPECT_GT(noisy, quiet + 0.01);
  }
}

TEST(DiscretisationUncertainty, RefusesWhatCannotBeRanked) {
  const Values good = of_order(1, 3);
  const auto refuses = [&](std::size_t i, ValueAtStep value) {
    Values bad = good;
    bad[i] = value;
    EXPECT_THROW(discretisation_uncertainty(bad), ComparisonError);
  };
  EXPECT_THROW(discretisation_uncertainty({good[0], good[1]}), ComparisonError);
  EXPECT_THROW(discretisation_uncertainty({}), ComparisonError);
  refuses(0, {0, 5});
  refuses(0, {-1, 5});
  refuses(1, {1, 5});     // a step twice
  refuses(1, {1.09, 5});  // and nearly
  refuses(1, {1.5, std::nan("")});
  refuses(1, {std::nan(""), 5});
  refuses(2, {2, std::numeric_limits<double>::infinity()});
  refuses(2, {2, 5, -0.1});
  refuses(2, {2, 5, std::nan("")});
}

TEST(DiscretisationUncertainty, OfACoarserStepIsItsWholeErrorByTheOrderOfAll) {
  for (const std::size_t count : {3, 4, 6})
    for (const double order : {0.6, 1.0, 1.5, 2.0})
      for (std::size_t asked = 0; asked < count; ++asked) {
        const Values values = of_order(order, count);
        const auto result = discretisation_uncertainty(values, values[asked].step);
        EXPECT_NEAR(result.extrapolated, 5, 1e-4);
        EXPECT_NEAR(result.uncertainty, 1.25 * (values[asked].value - 5), 2e-3);
      }
  EXPECT_THROW(discretisation_uncertainty(of_order(1, 3), 1.1), ComparisonError);
}

TEST(DiscretisationUncertainty, NamesEveryBehaviour) {
  EXPECT_EQ(behaviour_name(StepBehaviour::monotone), "monotone");
  EXPECT_EQ(behaviour_name(StepBehaviour::superconvergent), "superconvergent");
  EXPECT_EQ(behaviour_name(StepBehaviour::oscillatory), "oscillatory");
  EXPECT_EQ(behaviour_name(StepBehaviour::diverging), "diverging");
  EXPECT_EQ(behaviour_name(StepBehaviour::floor), "floor");
}

}  // namespace
}  // namespace slosh::discretisation_uncertainty_test
