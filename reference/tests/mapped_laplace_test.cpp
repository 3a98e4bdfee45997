#include "reference/potential_flow/mapped_laplace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/potential_flow/legendre_grid.hpp"

namespace slosh::reference::mapped_laplace_test {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double length = 1.2, depth = 0.4, k = 2 * std::numbers::pi / length;

// An asymmetric wave, 0.24 m from trough to crest and with a slope of up to 0.7.
VectorXd wave(const LegendreGrid& grid) {
  const ArrayXd s = std::numbers::pi * (grid.nodes.array() / length + 0.5);
  return 0.1 * s.cos() + 0.05 * (3 * s).sin();
}

// Phi = x z + exp(k z) sin(k x + 0.3) flows through all four sides.
struct Exact {
  static ArrayXd u(const ArrayXd& x, const ArrayXd& z) {
    return z + k * (k * z).exp() * (k * x + 0.3).cos();
  }
  static ArrayXd w(const ArrayXd& x, const ArrayXd& z) {
    return x + k * (k * z).exp() * (k * x + 0.3).sin();
  }
};

struct Errors {
  double flux, field;
};

Errors errors(int nodes_x, int nodes_z) {
  MappedLaplace laplace(length, depth, nodes_x, nodes_z);
  const VectorXd eta = wave(laplace.x());
  laplace.set_surface(eta);
  const MatrixXd z = laplace.heights();
  const ArrayXd x = laplace.x().nodes, a = ArrayXd::Constant(nodes_z, length / 2);
  const auto potential = [](double x, double z) {
    return x * z + std::exp(k * z) * std::sin(k * x + 0.3);
  };
  const VectorXd on_surface = laplace.x().nodes.binaryExpr(eta, potential);
  const auto solution =
      laplace.solve(on_surface,
                    {Exact::u(-a, z.row(0).transpose()),
                     Exact::u(a, z.row(nodes_x - 1).transpose()), Exact::w(x, z.col(0))},
                    MatrixXd::Zero(nodes_x, nodes_z));
  const ArrayXd flux = Exact::w(x, eta) - laplace.slope().array() * Exact::u(x, eta);
  double field = 0;
  for (int j = 0; j < nodes_z; ++j) {
    for (int i = 0; i < nodes_x; ++i) {
      field = std::max(field, std::abs(solution.potential(i, j) - potential(x[i], z(i, j))));
    }
  }
  return {(solution.surface_flux.array() - flux).abs().maxCoeff(), field};
}

// The measured errors are 0.26, 1.6e-3 and 6.7e-6 of a flux of about 8, and 1.9e-3, 6.5e-6 and
// 1.4e-8 of a potential of about 1.3: a factor of 150 or more for every eight nodes.
TEST(MappedLaplace, ConvergesSpectrallyUnderACurvedSurface) {
  const Errors coarse = errors(12, 10), middle = errors(20, 14), fine = errors(28, 20);
  EXPECT_LT(fine.flux, 2e-5);
  EXPECT_LT(fine.field, 5e-8);
  EXPECT_GT(coarse.flux / middle.flux, 100);
  EXPECT_GT(middle.flux / fine.flux, 100);
}

// The entries are up to 1.6, and the iteration stops at 1e-11. Measured: 4.5e-12 and 1.0e-11.
TEST(MappedLaplace, GivesASymmetricFluxOperator) {
  MappedLaplace laplace(length, depth, 16, 12);
  laplace.set_surface(wave(laplace.x()));
  const MappedLaplace::WallData still{VectorXd::Zero(12), VectorXd::Zero(12), VectorXd::Zero(16)};
  MatrixXd flux(16, 16);
  for (int i = 0; i < 16; ++i) {
    flux.col(i) = laplace.x().weights.cwiseProduct(
        laplace.solve(VectorXd::Unit(16, i), still, MatrixXd::Zero(16, 12)).surface_flux);
  }
  EXPECT_LT((flux - flux.transpose()).cwiseAbs().maxCoeff(), 2e-11);
  EXPECT_LT(flux.colwise().sum().cwiseAbs().maxCoeff(), 4e-11);
}

TEST(MappedLaplace, IntegratesOverTheLiquid) {
  MappedLaplace laplace(length, depth, 24, 10);
  laplace.set_surface(wave(laplace.x()));
  const double volume = laplace.integral(MatrixXd::Ones(24, 10));
  EXPECT_NEAR(volume, length * depth + 0.05 * length * 2 / (3 * std::numbers::pi), 1e-12);
}

TEST(MappedLaplace, SaysWhyThereIsNoSolution) {
  MappedLaplace laplace(length, depth, 12, 10);
  const auto message = [&](auto attempt) -> std::string {
    try {
      attempt();
    } catch (const NoLaplaceSolution& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(message([&] { laplace.set_surface(VectorXd::Constant(12, -0.41)); }),
            "the depth falls to -0.01 m");
  laplace.set_surface(VectorXd::Zero(12));
  const MappedLaplace::WallData still{VectorXd::Zero(10), VectorXd::Zero(10), VectorXd::Zero(12)};
  VectorXd values = laplace.x().nodes;
  values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([&] { laplace.solve(values, still, MatrixXd::Zero(12, 10)); }),
            "Laplace's equation has data that are not finite");
}

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
}  // namespace slosh::reference::mapped_laplace_test
