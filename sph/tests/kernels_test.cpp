#include "sph/terms/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sph/terms/kernel_share.hpp"

namespace slosh::sph::kernels_test {
namespace {

template <class Kernel>
class Kernels : public testing::Test {};
using AllKernels =
    testing::Types<CubicSpline, WendlandC2, WendlandC4, WendlandC6, QuinticSpline, KaiserBessel>;
TYPED_TEST_SUITE(Kernels, AllKernels);

// Midpoint rule for 2 pi q W dq over the support, in units of the smoothing length.
TYPED_TEST(Kernels, IntegrateToOneOverThePlane) {
  const int steps = 20000;
  const double dq = kernel_support / steps;
  double integral = 0;
  for (int i = 0; i < steps; ++i) {
    const double q = (i + 0.5) * dq;
    integral += 2 * std::numbers::pi * q * TypeParam::normalisation * TypeParam::shape(q) * dq;
  }
  EXPECT_NEAR(integral, 1, 1e-6);
}

TYPED_TEST(Kernels, HaveTheDerivativeOfTheirShapeOverTheDistance) {
  const double step = 1e-5;
  for (double q = 0.013; q < 2.2; q += 0.047) {
    const double slope = (TypeParam::shape(q + step) - TypeParam::shape(q - step)) / (2 * step);
    // The quintic's shape is 66 at its centre.
    EXPECT_NEAR(TypeParam::gradient_shape(q), slope / q, 1e-8 * TypeParam::shape(0.0) / q) << q;
  }
}

TYPED_TEST(Kernels, VanishFromTheSupportOnwards) {
  for (double q : {2.0, 2.0 + 1e-12, 2.5, 10.0, 1e6}) {
    EXPECT_EQ(TypeParam::shape(q), 0) << q;
    EXPECT_EQ(TypeParam::gradient_shape(q), 0) << q;
  }
  EXPECT_GT(TypeParam::shape(1.9), 0);
  EXPECT_LT(TypeParam::gradient_shape(1.9), 0);
}

// The limit of (dW/dq)/q is the second derivative at the centre.
TYPED_TEST(Kernels, AreFiniteWhereTwoParticlesCoincide) {
  EXPECT_GT(TypeParam::shape(0.0), 0);
  EXPECT_TRUE(std::isfinite(TypeParam::gradient_shape(0.0)));
  const double step = 1e-3;
  const double curvature = 2 * (TypeParam::shape(step) - TypeParam::shape(0.0)) / (step * step);
  EXPECT_NEAR(TypeParam::gradient_shape(1e-3), curvature, 2e-3 * std::abs(curvature));
}

TYPED_TEST(Kernels, FallTowardsTheirSupport) {
  for (double q = 0.01; q < 1.99; q += 0.01) EXPECT_LT(TypeParam::gradient_shape(q), 0) << q;
}

// Against the sum over a fine lattice of the half plane below the surface.
TYPED_TEST(Kernels, HaveTheShareOfTheirIntegralThatLiesBelowASurface) {
  const double dq = 0.005;
  for (const double depth : {-0.7, 0.2, 0.9, 1.6}) {
    double below = 0;
    for (double z = -kernel_support + 0.5 * dq; z < depth; z += dq)
      for (double x = 0.5 * dq; x < kernel_support; x += dq)
        below += 2 * TypeParam::normalisation * TypeParam::shape(std::hypot(x, z)) * dq * dq;
    EXPECT_NEAR(kernel_share_below(function_of<TypeParam>(), depth), below, 1e-4) << depth;
  }
  EXPECT_NEAR(kernel_share_below(function_of<TypeParam>(), 0), 0.5, 1e-5);
  EXPECT_EQ(kernel_share_below(function_of<TypeParam>(), 2.5), 1);
  EXPECT_EQ(kernel_share_below(function_of<TypeParam>(), -2.5), 0);
}

TEST(CubicSpline, IsTheOneThatLiPrints) {
  // W h^2 = 10 / (7 pi) (1 - 1.5 q^2 + 0.75 q^3) inside 1, 10 / (28 pi) (2 - q)^3 outside.
  EXPECT_NEAR(CubicSpline::shape(0.6), 1 - 1.5 * 0.36 + 0.75 * 0.216, 1e-15);
  EXPECT_NEAR(CubicSpline::shape(1.4), 0.25 * 0.216, 1e-15);
}

// I0(18 sqrt(s)) - 1 over its value at the centre, and its slope, which is I1 of the same.
TEST(KaiserBessel, IsTheBesselFunctionToTheErrorOfItsFit) {
  const double beta = 18, centre = std::cyl_bessel_i(0, beta) - 1;
  for (double q = 0.01; q < 2; q += 0.01) {
    const double root = std::sqrt(1 - q * q / 4);
    const double slope = -beta * std::cyl_bessel_i(1, beta * root) / (4 * root * centre);
    EXPECT_NEAR(KaiserBessel::shape(q), (std::cyl_bessel_i(0, beta * root) - 1) / centre, 1e-7)
        << q;
    EXPECT_NEAR(KaiserBessel::gradient_shape(q), slope, 1.5e-6 * beta / 4) << q;
    EXPECT_NEAR(gradient_shape_of_pair<KaiserBessel>(q * q * 0.04, 5.0), slope, 1.5e-6 * beta / 4)
        << q;
  }
  const double integral = 2 * std::cyl_bessel_i(1, beta) / beta - 1;
  EXPECT_NEAR(KaiserBessel::normalisation, centre / (4 * std::numbers::pi * integral), 1e-7);
}

}  // namespace
}  // namespace slosh::sph::kernels_test
