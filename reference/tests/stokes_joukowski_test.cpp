#include "reference/stokes_joukowski.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/quadrature.hpp"

namespace slosh::reference::stokes_joukowski_test {
namespace {

constexpr RollAxis axis{0.11, zhao_axis_z};
constexpr double a = zhao_tank.length / 2, h = zhao_tank.fill_depth;

const StokesJoukowski& psi() {
  static const StokesJoukowski potential(zhao_tank, axis.x, axis.z);
  return potential;
}

// Solves the same problem by least squares on the boundary. The functions are harmonic polynomials
// about the middle and, in each corner, the singularity w^2 log w that a linear boundary condition
// has there (w = x + i z from the corner, with the cut outside). The remaining solution is regular,
// and the polynomials converge geometrically.
class ByCollocation {
 public:
  explicit ByCollocation(int degree) : degree_(degree) {
    const int points = 60, unknowns = 2 * degree + 8;
    Eigen::MatrixXd matrix(4 * points, unknowns);
    Eigen::VectorXd wanted(4 * points);
    for (int i = 0; i < points; ++i) {
      // The points are Chebyshev points, which are dense in the corners.
      const double s = std::cos(std::numbers::pi * (i + 0.5) / points);
      const double x = a * s, z = h * (s - 1) / 2;
      const std::pair<double, double> places[] = {{a, z}, {-a, z}, {x, 0}, {x, -h}};
      for (int side = 0; side < 4; ++side) {
        const auto [px, pz] = places[side];
        for (int k = 0; k < unknowns; ++k) {
          // d/dx of the real part of f is Re f', d/dz is -Im f'.
          const auto slope = term(k, px, pz).slope;
          matrix(4 * i + side, k) = side < 2 ? slope.real() : -slope.imag();
        }
        wanted(4 * i + side) = side < 2 ? -(pz - axis.z) : px - axis.x;
      }
    }
    coefficients_ = matrix.colPivHouseholderQr().solve(wanted);
    residual = (matrix * coefficients_ - wanted).lpNorm<Eigen::Infinity>();
  }

  double potential(double x, double z) const {
    double sum = 0;
    for (int k = 0; k < coefficients_.size(); ++k) {
      sum += coefficients_(k) * (term(k, x, z).value.real() - term(k, 0, 0).value.real());
    }
    return sum;
  }

  double residual;

 private:
  using Complex = std::complex<double>;
  struct Term {
    Complex value, slope;
  };

  // Returns the k-th function and its derivative. Even k have the factor 1 and odd k the factor -i,
  // whose real part is the imaginary part.
  Term term(int k, double x, double z) const {
    const Complex factor = k % 2 == 0 ? Complex(1, 0) : Complex(0, -1);
    const Complex place(x, z);
    if (k < 2 * degree_) {
      const int power = k / 2 + 1;
      const Complex w = (place - Complex(0, -h / 2)) / a;
      const Complex lower = std::pow(w, power - 1);
      return {factor * lower * w, factor * static_cast<double>(power) * lower / a};
    }
    const int corner = (k - 2 * degree_) / 2;
    const Complex at(corner % 2 == 0 ? a : -a, corner < 2 ? 0 : -h);
    const Complex inward(-at.real(), corner < 2 ? -a : a);
    const Complex w = place - at;
    if (w == 0.0) return {0, 0};
    const Complex log = std::log(w / inward);
    return {factor * w * w * log, factor * w * (2.0 * log + 1.0)};
  }

  int degree_;
  Eigen::VectorXd coefficients_;
};

TEST(StokesJoukowski, IsWhatCollocationOnTheBoundaryFinds) {
  const ByCollocation solution(24);
  ASSERT_LT(solution.residual, 1e-10);
  for (const double x : {-a, -0.4, -0.13, 0.0, 0.31, a}) {
    for (const double z : {0.0, -0.07, -0.2325, -0.45, -h}) {
      const bool corner = std::abs(x) == a && (z == 0 || z == -h);
      EXPECT_NEAR(psi().potential(x, z), solution.potential(x, z), corner ? 4e-9 : 1e-11)
          << x << " " << z;
    }
  }
}

// Returns the gradient, to second order in the step, from points in the liquid only.
TEST(StokesJoukowski, TurnsWallsBottomAndLidAsOne) {
  const double d = 1e-4;
  const auto slope = [&](double x, double z, double dx, double dz) {
    return (-3 * psi().potential(x, z) + 4 * psi().potential(x + dx, z + dz) -
            psi().potential(x + 2 * dx, z + 2 * dz)) /
           (2 * d);
  };
  for (const double z : {-0.05, -0.2, -0.4}) {
    EXPECT_NEAR(-slope(a, z, -d, 0), -(z - axis.z), 1e-7);
    EXPECT_NEAR(slope(-a, z, d, 0), -(z - axis.z), 1e-7);
  }
  for (const double x : {-0.4, 0.0, 0.3}) {
    EXPECT_NEAR(-slope(x, 0, 0, -d), x - axis.x, 1e-6);
    EXPECT_NEAR(slope(x, -h, 0, d), x - axis.x, 1e-6);
  }
}

TEST(StokesJoukowski, IsHarmonic) {
  const double d = 3e-4;
  for (const auto& [x, z] : {std::pair{0.1, -0.1}, {-0.4, -0.3}, {0.44, -0.02}}) {
    const double laplacian =
        (psi().potential(x + d, z) + psi().potential(x - d, z) + psi().potential(x, z + d) +
         psi().potential(x, z - d) - 4 * psi().potential(x, z)) /
        (d * d);
    EXPECT_NEAR(laplacian, 0, 1e-6);
  }
}

// The pressure -rho theta'' Psi acts outwards on walls and bottom. Divided by rho theta'', its
// counter-clockwise moment is the integral of Psi times the lever arm.
TEST(StokesJoukowski, HasTheMomentOfItsOwnWallPressure) {
  // The points are graded, as the slope is logarithmic in the corners.
  const auto grade = [](double s) { return s * s * (3 - 2 * s); };
  const auto density = [](double s) { return 6 * s * (1 - s); };
  const double walls = integral(0, 1, 400, [&](double s) {
    const double z = -h * grade(s);
    return (z - axis.z) * (psi().potential(a, z) - psi().potential(-a, z)) * h * density(s);
  });
  const double bottom = integral(0, 1, 400, [&](double s) {
    const double x = a * (2 * grade(s) - 1);
    return (x - axis.x) * psi().potential(x, -h) * 2 * a * density(s);
  });
  EXPECT_NEAR(walls + bottom, psi().wall_moment(), 1e-8);
  EXPECT_LT(psi().wall_moment(), 0);
}

}  // namespace
}  // namespace slosh::reference::stokes_joukowski_test
