#include "reference/potential_flow/mapped_laplace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

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

}  // namespace
}  // namespace slosh::reference::mapped_laplace_test
