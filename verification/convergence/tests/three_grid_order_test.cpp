#include "verification/convergence/three_grid_order.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::three_grid_order_test {
namespace {

// The sample calculations of Celik et al. 2008, table 1: N1 to N3 cells in a plane, h ~ N^-1/2.
struct SampleCalculation {
  double cells[3], values[3];
  double order, extrapolated, gci;  // as printed; gci of the finest value
};

constexpr SampleCalculation monotone{
    {18000, 8000, 4500}, {6.063, 5.972, 5.863}, 1.53, 6.1685, 0.022};
constexpr SampleCalculation slow{
    {18000, 4500, 980}, {10.7880, 10.7250, 10.6050}, 0.75, 10.8801, 0.011};
constexpr SampleCalculation oscillatory{
    {18000, 4500, 980}, {6.0042, 5.9624, 6.0909}, 1.51, 6.0269, 0.005};

class CeliksSamples : public ::testing::TestWithParam<SampleCalculation> {};

TEST_P(CeliksSamples, HaveThePrintedOrderAndExtrapolatedValue) {
  const SampleCalculation& sample = GetParam();
  ValueAtStep at[3];
  for (int i = 0; i < 3; ++i) at[i] = {1 / std::sqrt(sample.cells[i]), sample.values[i]};
  const auto order = three_grid_order(at[0], at[1], at[2]);
  ASSERT_TRUE(order);
  EXPECT_NEAR(*order, sample.order, 0.005);
  const double extrapolated = extrapolated_value(at[0], at[1], *order);
  EXPECT_NEAR(extrapolated, sample.extrapolated, 5e-4);
  const double gci = reliable_safety_factor * std::abs(extrapolated - at[0].value) / at[0].value;
  EXPECT_NEAR(gci, sample.gci, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(Table1, CeliksSamples, ::testing::Values(monotone, slow, oscillatory));

ValueAtStep power_law(double step, double order) { return {step, 3 - 0.7 * std::pow(step, order)}; }

TEST(ThreeGridOrder, IsTheExponentOfAPowerLawAtUnequalRatios) {
  for (const double order : {0.3, 1.0, 2.0, 4.0}) {
    const ValueAtStep fine = power_law(0.1, order), medium = power_law(0.13, order);
    EXPECT_NEAR(*three_grid_order(fine, medium, power_law(0.31, order)), order, 1e-9);
    EXPECT_NEAR(extrapolated_value(fine, medium, order), 3, 1e-12);
  }
}

TEST(ThreeGridOrder, IsNegativeOfDifferencesThatGrowAsTheStepFalls) {
  EXPECT_NEAR(*three_grid_order(power_law(0.1, -1), power_law(0.2, -1), power_law(0.3, -1)), -1,
              1e-9);
  EXPECT_LT(*three_grid_order({1, 1.3}, {2, 1}, {4, 1.1}), 0);
}

TEST(ThreeGridOrder, IsZeroOfALogarithmAndOfValuesThatSwingAsFarAtEveryStep) {
  EXPECT_NEAR(*three_grid_order({1, 0}, {2, std::log(2)}, {5, std::log(5)}), 0, 1e-9);
  EXPECT_NEAR(*three_grid_order({1, 0}, {2, 1}, {5, 0}), 0, 1e-9);
}

TEST(ThreeGridOrder, IsNoneWhereTwoNeighboursAreEqual) {
  EXPECT_FALSE(three_grid_order({1, 3}, {2, 3}, {4, 5}));
  EXPECT_FALSE(three_grid_order({1, 3}, {2, 4}, {4, 4}));
}

TEST(ThreeGridOrder, StopsAtTen) {
  EXPECT_EQ(*three_grid_order({1, 1}, {2, 1 + 1e-9}, {4, 2}), 10);
  EXPECT_EQ(*three_grid_order({1, 1}, {2, 2}, {4, 2 + 1e-9}), -10);
}

}  // namespace
}  // namespace slosh::three_grid_order_test
