#include "verification/convergence/error_expansion_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slosh::error_expansion_fit_test {
namespace {

using Values = std::vector<ValueAtStep>;

Values at_steps(const std::vector<double>& steps, const std::function<double(double)>& value) {
  Values values;
  for (const double h : steps) values.push_back({h, value(h)});
  return values;
}

const std::vector<double> steps{0.1, 0.15, 0.2, 0.4, 0.5};

Values power_law(double order) {
  return at_steps(steps, [order](double h) { return 3 - 0.7 * std::pow(h, order); });
}

TEST(PowerLawFit, FindsTheOrderLimitAndErrorOfExactData) {
  for (const bool weighted : {false, true}) {
    const ExpansionFit fit = fit_power_law(power_law(1.37), weighted, {-1, 8});
    EXPECT_NEAR(fit.order, 1.37, 1e-5);
    EXPECT_NEAR(fit.extrapolated, 3, 1e-5);
    EXPECT_NEAR(fit.error_at(0), -0.7 * std::pow(0.1, 1.37), 1e-5);
    EXPECT_NEAR(fit.fitted[0], power_law(1.37)[0].value, 1e-6);
    EXPECT_NEAR(fit.error_at(4), -0.7 * std::pow(0.5, 1.37), 1e-5);
    EXPECT_NEAR(fit.deviation, 0, 1e-6);
  }
}

TEST(PowerLawFit, StopsAtTheEndsOfItsRange) {
  EXPECT_EQ(fit_power_law(power_law(3), false, reliable_orders).order, 2);
  EXPECT_EQ(fit_power_law(power_law(0.2), false, reliable_orders).order, 0.5);
}

TEST(PowerLawFit, GivesTheFinerStepsTheirWeight) {
  Values values = power_law(1);
  values.back().value += 0.02;
  const ExpansionFit plain = fit_fixed_orders(values, false, Expansion::first);
  const ExpansionFit weighted = fit_fixed_orders(values, true, Expansion::first);
  EXPECT_LT(std::abs(weighted.extrapolated - 3), std::abs(plain.extrapolated - 3));
  const double finest = values.front().value;
  EXPECT_LT(std::abs(finest - weighted.fitted[0]), std::abs(finest - plain.fitted[0]));
}

TEST(FixedOrderFits, FindTheirOwnExpansionExactly) {
  const Values mixed = at_steps(steps, [](double h) { return 3 + 0.7 * h - 0.4 * h * h; });
  for (const bool weighted : {false, true}) {
    EXPECT_NEAR(fit_fixed_orders(power_law(1), weighted, Expansion::first).extrapolated, 3, 1e-12);
    EXPECT_NEAR(fit_fixed_orders(power_law(2), weighted, Expansion::second).extrapolated, 3, 1e-12);
    const ExpansionFit fit = fit_fixed_orders(mixed, weighted, Expansion::mixed);
    EXPECT_NEAR(fit.extrapolated, 3, 1e-12);
    EXPECT_NEAR(fit.error_at(0), 0.07 - 0.004, 1e-12);
    EXPECT_NEAR(fit.deviation, 0, 1e-12);
  }
}

// A first-order fit through (1, 0), (2, 1), (3, 0), (4, 1) worked by hand: slope 0.2, mean 0.5,
// residuals -0.2, 0.6, -0.6, 0.2, and four values less two unknowns.
TEST(FixedOrderFits, StateTheStandardDeviationOfTheirResiduals) {
  const Values values{{1, 0}, {2, 1}, {3, 0}, {4, 1}};
  const ExpansionFit fit = fit_fixed_orders(values, false, Expansion::first);
  EXPECT_NEAR(fit.extrapolated, 0, 1e-12);
  EXPECT_NEAR(fit.error_at(0), 0.2, 1e-12);
  EXPECT_NEAR(fit.fitted[0], 0.2, 1e-12);  // a residual of -0.2
  EXPECT_NEAR(fit.deviation, std::sqrt(0.8 / 2), 1e-12);
}

TEST(ChosenExpansion, IsThePowerLawWhereItsOrderCanBeReliedOn) {
  for (const double order : {0.55, 1.0, 1.5, 1.95}) {
    const ChosenExpansion chosen = choose_expansion(power_law(order));
    EXPECT_NEAR(*chosen.observed_order, order, 1e-4);
    EXPECT_EQ(chosen.fit.expansion, Expansion::power);
  }
}

TEST(ChosenExpansion, IsOfFirstOrSecondOrderAboveTheFormalOne) {
  const ChosenExpansion chosen = choose_expansion(power_law(3));
  EXPECT_NEAR(*chosen.observed_order, 3, 1e-4);
  EXPECT_EQ(chosen.fit.expansion, Expansion::second);
}

TEST(ChosenExpansion, MayMixBothOrdersWhereTheObservedOneIsLow) {
  const ChosenExpansion chosen = choose_expansion(power_law(0.3));
  EXPECT_NEAR(*chosen.observed_order, 0.3, 1e-4);
  EXPECT_EQ(chosen.fit.expansion, Expansion::mixed);
}

TEST(ChosenExpansion, HasNoOrderOfAnomalousData) {
  const ChosenExpansion chosen = choose_expansion(power_law(-0.5));
  EXPECT_FALSE(chosen.observed_order);
  EXPECT_NE(chosen.fit.expansion, Expansion::power);
}

}  // namespace
}  // namespace slosh::error_expansion_fit_test
