// Kernels, equations of state, the layers of a gap and the time step.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/terms/gap_layers.hpp"
#include "sph/terms/kernel_share.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/terms/time_step.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::terms_test {
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

const Tait water(1000, 20);

TEST(Tait, HasNoPressureAtTheRestDensity) {
  EXPECT_EQ(water.pressure(1000), 0);
  EXPECT_EQ(water.density(0), 1000);
}

TEST(Tait, GivesKnownPressures) {
  // B = 1000 * 400 / 7 Pa; 1.01^7 and 2^7 by hand.
  EXPECT_NEAR(water.pressure(1010), 400000.0 / 7 * 0.0721353521070100, 1e-8);
  EXPECT_NEAR(water.pressure(2000), 400000.0 / 7 * 127, 1e-6);
  EXPECT_LT(water.pressure(999), 0);
}

TEST(Tait, ReturnsTheDensityThatItsPressureCameFrom) {
  for (double density : {900.0, 999.0, 1000.0, 1000.001, 1008.0, 1100.0}) {
    EXPECT_NEAR(water.density(water.pressure(density)), density, 1e-10 * density);
  }
}

TEST(Tait, HasItsSpeedOfSoundAtTheRestDensity) {
  const double slope = (water.pressure(1000.01) - water.pressure(999.99)) / 0.02;
  EXPECT_NEAR(std::sqrt(slope), 20, 1e-6);
}

template <class State>
void expect_the_energy_of_compression(const State& state) {
  EXPECT_EQ(state.energy(1000), 0);
  for (const double density : {600.0, 990.0, 1001.0, 1005.0, 1080.0}) {
    const double step = 1e-3;
    const double slope = (state.energy(density + step) - state.energy(density - step)) / (2 * step);
    const double expected = state.pressure(density) / (density * density);
    EXPECT_NEAR(slope, expected, 1e-7 * std::abs(expected)) << density;
  }
  // To second order, c0^2 / 2 (rho / rho_0 - 1)^2, with every digit that this leaves.
  EXPECT_NEAR(state.energy(1000 * (1 + 1e-7)) / (200 * 1e-14), 1, 1e-6);
}

TEST(Energy, IsZeroAtRestAndGrowsByThePressureOverTheDensitySquared) {
  expect_the_energy_of_compression(water);
  Setting setting{};
  setting.rest_density = 1000;
  setting.speed_of_sound = 20;
  expect_the_energy_of_compression(LinearState(setting));
  expect_the_energy_of_compression(CubicState(setting));
  expect_the_energy_of_compression(QuinticState(setting));
}

TEST(PowerLawStates, AreThatPower) {
  EXPECT_NEAR(CubicState(1000, 20).pressure(1010), 400000.0 / 3 * 0.030301, 1e-8);
  EXPECT_NEAR(QuinticState(1000, 20).pressure(1010), 400000.0 / 5 * 0.0510100501, 1e-8);
  EXPECT_NEAR(CubicState(1000, 20).density(400000.0 / 3 * 7), 2000, 1e-9);
}

using Complex = std::complex<double>;

// The walls' stress of laminar flow between plates (Landau & Lifshitz 1987, section 24), [1/s].
Complex exact(double breadth, double viscosity, double frequency) {
  const Complex s{0, frequency}, k = 0.5 * breadth * std::sqrt(s / viscosity);
  const Complex share = std::tanh(k) / k;
  return s * share / (1.0 - share);
}

Complex summed(const GapLayers& gap, double frequency) {
  const Complex s{0, frequency};
  Complex sum = gap.steady_friction;
  for (const GapLayer& layer : gap.layers) sum += layer.friction * s / (s + layer.rate);
  return sum;
}

// From Poiseuille flow in a gap of 1 mm to Stokes layers that fill a hundredth of one of 1 m.
TEST(GapLayers, SlowAnOscillationAsTheExactSolutionDoes) {
  for (const double breadth : {0.001, 0.01, 0.062, 1.0})
    for (const double viscosity : {1e-6, 5e-5})
      for (const double frequency : {0.1, 1.0, 4.0, 30.0}) {
        const Complex expected = exact(breadth, viscosity, frequency);
        EXPECT_LE(std::abs(summed(gap_layers(breadth, viscosity, 1e4), frequency) - expected),
                  0.025 * std::abs(expected))
            << breadth << " " << viscosity << " " << frequency;
      }
}

// The sum over all roots of 2 / y_n^2 is 1/5 (Rayleigh), and the layers that are left out carry
// what is missing.
TEST(GapLayers, AddAFifthOfTheMassToASlowFlow) {
  double added_mass = 0;
  for (const GapLayer& layer : gap_layers(0.01, 1e-6, 1e5).layers)
    added_mass += layer.friction / layer.rate;
  EXPECT_NEAR(added_mass, 0.2, 2e-3);
  EXPECT_DOUBLE_EQ(gap_layers(0.01, 1e-6, 1).steady_friction, 12 * 1e-6 / 1e-4);
}

TEST(GapLayers, SolveTheirEquation) {
  for (const int n : {1, 2, 50}) EXPECT_NEAR(std::tan(layer_root(n)), layer_root(n), 1e-6) << n;
  EXPECT_NEAR(layer_root(1), 4.493409457909064, 1e-12);
}

TEST(GapLayers, AreAtMostSixteen) {
  EXPECT_EQ(gap_layers(10, 1e-9, 1e6).layers.size(), 16);
  EXPECT_EQ(gap_layers(0.001, 1e-3, 1).layers.size(), 1);
}

Setting setting_with(double viscosity, double breadth) {
  Setting setting{};
  setting.kinematic_viscosity = viscosity;
  setting.breadth = breadth;
  return setting;
}

TEST(GapLayers, AreAbsentWithoutWallsOrViscosity) {
  EXPECT_TRUE(gap_layers(setting_with(1e-6, 0)).layers.empty());
  EXPECT_EQ(gap_layers(setting_with(0, 0.1)).largest_friction(), 0);
}

const Setting setting = setting_of(still_scene(0.01, 1), Recommended::numbers);
const double h = setting.smoothing_length(), c0 = setting.speed_of_sound;

TEST(AdaptiveStep, IsTheCourantNumberTimesHOverTheLargestSpeedOfSound) {
  const AdaptiveStep step(setting);
  EXPECT_NEAR(step(0, c0), 0.8 * h / c0, 1e-12 * h / c0);
  EXPECT_NEAR(step(0, 1.6 * c0), 0.8 * h / (1.6 * c0), 1e-12 * h / c0);
  EXPECT_EQ(step(0, 0.5 * c0), step(0, c0));  // a liquid that is stretched does not lengthen it
}

TEST(AdaptiveStep, IsShortEnoughForTheLargestAcceleration) {
  const double acceleration = 1e6;
  EXPECT_NEAR(AdaptiveStep(setting)(acceleration, c0), 0.25 * std::sqrt(h / acceleration), 1e-15);
}

TEST(EquationsOfState, GiveTheSpeedOfSoundOfTheirOwnPressure) {
  const auto slope = [](const auto& state, double density) {
    return std::sqrt((state.pressure(density + 0.01) - state.pressure(density - 0.01)) / 0.02);
  };
  for (const double density : {900.0, 1000.0, 1200.0}) {
    const Tait tait(1000, c0);
    EXPECT_NEAR(tait.speed_of_sound_at(density), slope(tait, density), 1e-6 * c0);
    const LinearState linear(setting);
    EXPECT_NEAR(linear.speed_of_sound_at(density), slope(linear, density), 1e-6 * c0);
  }
}

}  // namespace
}  // namespace slosh::sph::terms_test
