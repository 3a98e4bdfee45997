#include "verification/problems/stability/lattice_stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/terms/kernels.hpp"

namespace slosh::lattice_stability_test {
namespace {

const LatticeScheme quintic{&gradient_shape_of<sph::QuinticSpline>, 1.5};

// Many neighbours make the sums integrals: a long wave's gradient is k, and one step of the
// leapfrog turns it by the angle 2 asin(C k / 2), without growing.
TEST(LatticeStability, NeitherDampsNorAmplifiesASoundWaveBelowTheLimit) {
  EXPECT_NEAR(largest_growth(quintic, 0.5), 1, 1e-12);
  EXPECT_NEAR(largest_growth(quintic, 1.5), 1, 1e-12);
}

// The leapfrog's limit is C |G| = 2 at the wave of the steepest gradient, here by hand over the
// waves along a row of the lattice and along its diagonal.
TEST(LatticeStability, HasTheLeapfrogsLimitAtTheSteepestGradient) {
  const auto gradient = [dp = 1 / quintic.ratio](double kx, double kz) {
    double x = 0, z = 0;
    for (int i = -3; i <= 3; ++i)
      for (int j = -3; j <= 3; ++j) {
        if (i == 0 && j == 0) continue;
        const double slope = dp * dp *
                             gradient_shape_of<sph::QuinticSpline>(std::hypot(i, j) * dp) *
                             std::sin(kx * i * dp + kz * j * dp);
        x += slope * i * dp;
        z += slope * j * dp;
      }
    return std::hypot(x, z);
  };
  double steepest = 0;
  for (int n = 1; n < 400; ++n) {
    const double k = n * std::numbers::pi * quintic.ratio / 400;
    steepest = std::max({steepest, gradient(k, 0), gradient(k, k)});
  }
  // The analysis takes 32 waves along a quarter of the zone.
  EXPECT_NEAR(stable_courant_number(quintic), 2 / steepest, 1e-3);
}

// A step of diffusion alone multiplies by 1 - C d, stable to C d = 2: where the sound's share of
// the limit is next to nothing, C delta is a number of the lattice's own.
TEST(LatticeStability, HasAnExplicitDiffusionsLimitWhereTheSoundIsSlow) {
  const double slow = stable_diffusion(quintic, 1e-2) * 1e-2,
               slower = stable_diffusion(quintic, 1e-3) * 1e-3;
  EXPECT_NEAR(slow, slower, 1e-3 * slower);
  EXPECT_NEAR(largest_growth({quintic.gradient_shape, 1.5, 0, 2 * slower / 1e-3}, 1e-3), 3, 1e-2);
}

// 23.1 nu / h^2 is the lattice's largest eigenvalue, which an explicit step follows to 2 / 23.1.
TEST(LatticeStability, HasTheViscousLimitThatTheTimeStepsCommentStates) {
  EXPECT_NEAR(stable_viscosity(quintic, 1e-3) * 1e-3, 0.087, 5e-4);
}

TEST(LatticeStability, IsLostBeyondTheLimit) {
  const double limit = stable_courant_number(quintic);
  EXPECT_LE(largest_growth(quintic, 0.999 * limit), 1 + 1e-9);
  EXPECT_GT(largest_growth(quintic, 1.01 * limit), 1.1);
}

TEST(LatticeStability, FallsWithDiffusionAndViscosity) {
  LatticeScheme diffusive = quintic, viscous = quintic;
  diffusive.diffusion = 0.1;
  viscous.viscosity = 0.05;
  EXPECT_LT(stable_courant_number(diffusive), stable_courant_number(quintic));
  EXPECT_LT(stable_courant_number(viscous), stable_courant_number(quintic));
}

}  // namespace
}  // namespace slosh::lattice_stability_test
