#include "sph/terms/gap_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace slosh::sph::gap_layers_test {
namespace {

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

}  // namespace
}  // namespace slosh::sph::gap_layers_test
