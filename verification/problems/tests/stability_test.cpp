#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/schemes.hpp"
#include "sph/terms/kernels.hpp"
#include "verification/problems/stability/lattice_buckling.hpp"
#include "verification/problems/stability/stability_map.hpp"

namespace slosh::stability_test {
namespace {

const LatticeScheme narrow_quintic{&gradient_shape_of<sph::QuinticSpline>, 1.5};

// Many neighbours make the sums integrals: a long wave's gradient is k, and one step of the
// leapfrog turns it by the angle 2 asin(C k / 2), without growing.
TEST(LatticeStability, NeitherDampsNorAmplifiesASoundWaveBelowTheLimit) {
  EXPECT_NEAR(largest_growth(narrow_quintic, 0.5), 1, 1e-12);
  EXPECT_NEAR(largest_growth(narrow_quintic, 1.5), 1, 1e-12);
}

// The leapfrog's limit is C |G| = 2 at the wave of the steepest gradient, here by hand over the
// waves along a row of the lattice and along its diagonal.
TEST(LatticeStability, HasTheLeapfrogsLimitAtTheSteepestGradient) {
  const auto gradient = [dp = 1 / narrow_quintic.ratio](double kx, double kz) {
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
    const double k = n * std::numbers::pi * narrow_quintic.ratio / 400;
    steepest = std::max({steepest, gradient(k, 0), gradient(k, k)});
  }
  // The analysis takes 32 waves along a quarter of the zone.
  EXPECT_NEAR(stable_courant_number(narrow_quintic), 2 / steepest, 1e-3);
}

// A step of diffusion alone multiplies by 1 - C d, stable to C d = 2: where the sound's share of
// the limit is next to nothing, C delta is a number of the lattice's own.
TEST(LatticeStability, HasAnExplicitDiffusionsLimitWhereTheSoundIsSlow) {
  const double slow = stable_diffusion(narrow_quintic, 1e-2) * 1e-2,
               slower = stable_diffusion(narrow_quintic, 1e-3) * 1e-3;
  EXPECT_NEAR(slow, slower, 1e-3 * slower);
  EXPECT_NEAR(largest_growth({narrow_quintic.gradient_shape, 1.5, 0, 2 * slower / 1e-3}, 1e-3), 3,
              1e-2);
}

// 23.1 nu / h^2 is the lattice's largest eigenvalue, which an explicit step follows to 2 / 23.1.
TEST(LatticeStability, HasTheViscousLimitThatTheTimeStepsCommentStates) {
  EXPECT_NEAR(stable_viscosity(narrow_quintic, 1e-3) * 1e-3, 0.087, 5e-4);
}

TEST(LatticeStability, IsLostBeyondTheLimit) {
  const double limit = stable_courant_number(narrow_quintic);
  EXPECT_LE(largest_growth(narrow_quintic, 0.999 * limit), 1 + 1e-9);
  EXPECT_GT(largest_growth(narrow_quintic, 1.01 * limit), 1.1);
}

TEST(LatticeStability, FallsWithDiffusionAndViscosity) {
  LatticeScheme diffusive = narrow_quintic, viscous = narrow_quintic;
  diffusive.diffusion = 0.1;
  viscous.viscosity = 0.05;
  EXPECT_LT(stable_courant_number(diffusive), stable_courant_number(narrow_quintic));
  EXPECT_LT(stable_courant_number(viscous), stable_courant_number(narrow_quintic));
}

constexpr double tank = 0.35 * std::numbers::pi;  // k depth of the first mode

LatticeScheme quintic(double ratio) { return {&gradient_shape_of<sph::QuinticSpline>, ratio}; }

TEST(LatticeBuckling, FindsTheWindowsOfTheQuinticOnTheSquareLattice) {
  const auto windows = windows_that_hold(quintic(0), Lattice::square);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_NEAR(windows[0].low, 1.269, 2e-3);
  EXPECT_NEAR(windows[0].high, 1.421, 2e-3);
  EXPECT_NEAR(windows[1].low, 1.788, 2e-3);
  EXPECT_NEAR(windows[1].high, 1.970, 2e-3);
}

TEST(LatticeBuckling, FindsOtherWindowsOnTheHexagonalLattice) {
  const auto windows = windows_that_hold(quintic(0), Lattice::hexagonal);
  ASSERT_EQ(windows.size(), 3u);
  EXPECT_NEAR(windows[2].low, 1.58, 2e-3);
  EXPECT_NEAR(windows[2].high, 1.838, 2e-3);
  EXPECT_EQ(windows[0].low, searched_ratios.low) << "cut off by the search";
}

TEST(LatticeBuckling, FindsNoWindowOfWendlandC4OnTheSquareLattice) {
  const LatticeScheme c4{&gradient_shape_of<sph::WendlandC4>, 0};
  EXPECT_TRUE(windows_that_hold(c4, Lattice::square).empty());
  EXPECT_EQ(windows_that_hold(c4, Lattice::hexagonal).size(), 3u);
}

TEST(LatticeBuckling, IntersectsWindows) {
  const auto both = common_windows({{1, 2}, {3, 4}}, {{1.5, 3.5}, {5, 6}});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].low, 1.5);
  EXPECT_EQ(both[0].high, 2);
  EXPECT_EQ(both[1].low, 3);
  EXPECT_EQ(both[1].high, 3.5);
  EXPECT_TRUE(common_windows({{1, 2}}, {{2, 3}}).empty()) << "they only touch";
}

TEST(LatticeBuckling, GrowsWhereTheLatticeDoesNotHoldAndNowhereElse) {
  for (const double ratio : {1.2, 1.3, 1.42, 1.5, 1.7, 1.8, 1.96, 2.1}) {
    EXPECT_EQ(buckling_growth(quintic(ratio), Lattice::square) > 0,
              !holds(quintic(ratio), Lattice::square))
        << ratio;
  }
}

// At h = 1.5 dp the fastest wave moves the rows against each other, (0, pi / dp), where the
// gradient is 0: s^2 = -2 H_zz, here by hand.
TEST(LatticeBuckling, HasTheGrowthOfColumnsThatMoveAlongEachOther) {
  const double h = 1.5;
  double hessian = 0;
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      if (i % 2 == 0) continue;
      const auto force = [&](double x, double z) {  // dW/dz
        return z * gradient_shape_of<sph::QuinticSpline>(std::hypot(x, z) / h) / std::pow(h, 4);
      };
      hessian += 2 * (force(i, j + 1e-4) - force(i, j - 1e-4)) / 2e-4;
    }
  EXPECT_LT(hessian, 0);
  EXPECT_NEAR(buckling_growth(quintic(h), Lattice::square), std::sqrt(-2 * hessian), 1e-5);
}

TEST(LatticeBuckling, IsSlowerInABoxAndTendsToThatOfTheEndlessLattice) {
  const double endless = buckling_growth(quintic(1.5), Lattice::square),
               small = buckling_growth_in_box(quintic(1.5), 10),
               large = buckling_growth_in_box(quintic(1.5), 200);
  EXPECT_LT(small, large);
  EXPECT_LT(large, endless);
  EXPECT_NEAR(large, endless, 0.02 * endless);
  EXPECT_EQ(buckling_growth_in_box(quintic(1.42), 50), 0);
}

TEST(LatticeBuckling, IsSlowedByViscosity) {
  LatticeScheme viscous = quintic(1.5);
  viscous.viscosity = 0.01;
  const double free = buckling_growth(quintic(1.5), Lattice::square),
               slowed = buckling_growth(viscous, Lattice::square);
  EXPECT_GT(slowed, 0);
  EXPECT_LT(slowed, 0.7 * free);
}

// The kernel's Fourier transform ends before the lattices' wave numbers (terms/kernels.hpp).
TEST(LatticeBuckling, NearlyVanishesForTheKaiserBesselKernelAtItsSmoothingLength) {
  const LatticeScheme own{&gradient_shape_of<sph::KaiserBessel>, 1.5};
  const double of_quintic = buckling_growth(quintic(1.5), Lattice::square);
  EXPECT_LT(buckling_growth(own, Lattice::square), 0.02 * of_quintic);
  EXPECT_LT(buckling_growth(own, Lattice::hexagonal), 0.1 * of_quintic);
  EXPECT_NEAR(frequency_shift_of_lattice(own, tank), 0, 1.5e-4);
  const LatticeScheme narrow{&gradient_shape_of<sph::KaiserBessel>, 1.3};
  EXPECT_GT(buckling_growth(narrow, Lattice::square), of_quintic);
}

// A kernel that covers very many particles sums as an integral does.
TEST(FrequencyShiftOfLattice, VanishesForManyNeighbours) {
  EXPECT_NEAR(frequency_shift_of_lattice(quintic(8), tank), 0, 5e-5);
}

TEST(FrequencyShiftOfLattice, IsLargeForWendlandC2AndSmallForTheQuintic) {
  EXPECT_NEAR(frequency_shift_of_lattice({&gradient_shape_of<sph::WendlandC2>, 2}, tank), 0.0085,
              1e-4);
  EXPECT_NEAR(frequency_shift_of_lattice(quintic(1.42), tank), 0.0020, 1e-4);
}

TEST(FrequencyShiftOfSound, IsThatOfTheExactSolution) {
  // A liquid with rho' = -rho g / c^2 at rest: phi'' - e phi' - (k^2 - w^2 / c^2) phi = 0 with
  // e = g / c^2, phi' = 0 at the bottom and g phi' = w^2 phi at the surface; g = depth = 1.
  const double k = tank, ratio = 30, c2 = ratio * ratio, e = 1 / c2;
  const auto surface = [&](double w2) {
    const double root = std::sqrt(0.25 * e * e + k * k - w2 / c2), a = 0.5 * e + root,
                 b = 0.5 * e - root;
    // phi = b exp(a z) - a exp(b z), which has no slope at z = 0.
    return a * b * (std::exp(a) - std::exp(b)) - w2 * (b * std::exp(a) - a * std::exp(b));
  };
  const double linear = k * std::tanh(k);
  double low = 0.9 * linear, high = 1.1 * linear;
  ASSERT_LT(surface(low) * surface(high), 0);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (surface(low) * surface(middle) > 0 ? low : high) = middle;
  }
  const double exact = std::sqrt(low / linear) - 1;
  EXPECT_NEAR(frequency_shift_of_sound(ratio, tank) / exact, 1, 0.01);
}

// Stable below 3 + up; beyond 5 no guard tells.
StabilityMap invented() {
  return {.id = "invented",
          .title = "Invented",
          .caption = "",
          .across = {"a", {1, 2, 4, 6}},
          .up = {"b", {0, 0.5, 10}},
          .probe =
              [](double a, double b) {
                if (a < 3 + b) return Probe{Stability::stable, ""};
                if (a > 5) return Probe{Stability::unnoticed, ""};
                return Probe{Stability::unstable, "particle 7"};
              },
          .theory = [](double b) { return 3 + b; }};
}

TEST(StabilityMap, FindsTheLimitOfEachRowToTwoPerCent) {
  const MapOutcome found = explore(invented());
  ASSERT_EQ(found.measured.size(), 3u);
  EXPECT_NEAR(found.measured[0], 3, 0.06);
  EXPECT_NEAR(found.measured[1], 3.5, 0.07);
  EXPECT_TRUE(std::isnan(found.measured[2])) << "no limit in the map";
}

TEST(StabilityMap, CountsTheRunsThatGainEnergyUnnoticed) {
  EXPECT_EQ(explore(invented()).unnoticed, 2);
}

TEST(StabilityMap, TellsHowTheFirstUnstableRunOfEachRowWasFound) {
  const MapOutcome found = explore(invented());
  EXPECT_EQ(found.table.rows[0][3], "4");
  EXPECT_EQ(found.table.rows[0][4], "particle 7");
  EXPECT_EQ(found.table.rows[2][3], "");
}

TEST(StabilityMap, LeavesTheErrorOfTheTheorysLimitAndTheShareThatTheSchemeUses) {
  const StabilityMap map = invented();
  const auto measures = measures_of(map, explore(map), [](double) { return 1.5; });
  EXPECT_NEAR(measures[0].errors[0].error, 0, 0.02);
  EXPECT_NEAR(measures[1].errors[0].error, 0.5, 0.01);
  EXPECT_TRUE(std::isnan(measures[0].errors[2].error)) << "a map without a limit passes no gate";
  EXPECT_EQ(measures.at(2).errors[0].error, 2);
}

TEST(StabilityMap, CountsNothingUnnoticedWhereNoGuardWatches) {
  const StabilityMap map = invented();
  EXPECT_EQ(measures_of(
                map, explore(map), [](double) { return 1.5; }, Guarded::no)
                .size(),
            2u);
  EXPECT_EQ(map_measures("b", Guarded::no).size(), 2u);
  EXPECT_EQ(map_measures("b").size(), 3u);
}

TEST(ProbeOfWave, TellsAStableStepFromAnUnstableOne) {
  EXPECT_EQ(probe_of_wave(wave_scene(sph::recommended_at(0.8), 400)).stability, Stability::stable);
  const Probe stopped = probe_of_wave(wave_scene(sph::recommended_at(2.0), 2000));
  EXPECT_EQ(stopped.stability, Stability::unstable);
  EXPECT_NE(stopped.message.find("particle "), std::string::npos);
}

}  // namespace
}  // namespace slosh::stability_test
