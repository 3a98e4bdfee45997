#include "reference/potential_flow/legendre_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace slosh::reference::legendre_grid_test {
namespace {

using Eigen::VectorXd;

VectorXd power(const LegendreGrid& grid, int p) { return grid.nodes.array().pow(p); }

TEST(LegendreGrid, IntegratesUpToTheDegreeTwoNMinusThreeAndNoFurther) {
  const LegendreGrid grid(0, 2, 6);
  for (int p = 0; p <= 9; ++p) {
    const double exact = std::pow(2, p + 1) / (p + 1);
    EXPECT_NEAR(grid.weights.dot(power(grid, p)) / exact, 1, 1e-14) << "degree " << p;
  }
  EXPECT_GT(std::abs(grid.weights.dot(power(grid, 10)) * 11 / 2048 - 1), 1e-5);
}

TEST(LegendreGrid, DifferentiatesAndInterpolatesPolynomialsExactly) {
  const LegendreGrid grid(-0.5, 1.5, 7);
  EXPECT_LT((grid.derivative * power(grid, 6) - 6 * power(grid, 5)).cwiseAbs().maxCoeff(), 1e-12);
  for (const double x : {-0.5, -0.31, 0.2, grid.nodes[3], 1.5}) {
    EXPECT_NEAR(grid.interpolation(x).dot(power(grid, 6)), std::pow(x, 6), 1e-13);
  }
}

// Two polynomials on [-1, 1]: P_5 = (63 x^5 - 70 x^3 + 15 x)/8, and the highest one, whose norm the
// quadrature does not integrate exactly.
TEST(LegendreGrid, FindsTheLegendreCoefficients) {
  for (const int nodes : {6, 9}) {
    const LegendreGrid grid(-1, 1, nodes);
    const VectorXd p5 = (63 * power(grid, 5) - 70 * power(grid, 3) + 15 * power(grid, 1)) / 8;
    const VectorXd expected = 3 * VectorXd::Unit(nodes, 5);
    EXPECT_LT((grid.coefficients * (3 * p5) - expected).cwiseAbs().maxCoeff(), 1e-14 * 10);
  }
}

// A singularity d^2 log d at an end, as in the corners of an accelerated tank, gives fourth-order
// convergence.
TEST(LegendreGrid, InterpolatesAWeakSingularityAtAnEndToTheFourthOrder) {
  const auto error = [](int nodes) {
    const LegendreGrid grid(0, 1, nodes);
    const auto f = [](double x) { return x > 0 ? x * x * std::log(x) : 0; };
    const VectorXd values = grid.nodes.unaryExpr(f);
    double worst = 0;
    for (int i = 0; i <= 2000; ++i) {
      const double x = std::pow(i / 2000.0, 2);
      worst = std::max(worst, std::abs(grid.interpolation(x).dot(values) - f(x)));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4, 0.25);
  EXPECT_NEAR(std::log2(error(32) / error(64)), 4, 0.15);
}

TEST(LegendreGrid, RefusesTooFewNodes) {
  EXPECT_THROW(LegendreGrid(0, 1, 3), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::reference::legendre_grid_test
