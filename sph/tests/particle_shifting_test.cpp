#include "sph/terms/particle_shifting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/tests/disordered_liquid.hpp"
#include "sph/tests/formulas_of_choice.hpp"

namespace slosh::sph::particle_shifting_test {
namespace {

constexpr double dp = small_spacing, h = 1.5 * dp;

// A lattice of equal volumes in a tank of 0.2 m by 0.16 m, filled up to `top`(x), each particle at
// random up to `disorder` spacings off its place, with a speed of 1 m/s.
template <class Top>
Particles lattice(double disorder, const Top& top) {
  std::mt19937 random(2017);
  std::uniform_real_distribution<double> off(-disorder * dp, disorder * dp);
  Particles p;
  for (double z = 0.5 * dp; z < 0.16; z += dp)
    for (double x = 0.5 * dp; x < 0.2; x += dp) {
      if (z > top(x)) continue;
      p.x.push_back(x + off(random));
      p.z.push_back(z + off(random));
    }
  p.velocity_x.assign(p.x.size(), 1.0);
  p.velocity_z.assign(p.x.size(), 0.0);
  p.density.assign(p.x.size(), 1000.0);
  p.mass.assign(p.x.size(), 1000 * dp * dp);
  p.spacing.assign(p.x.size(), dp);
  return p;
}
double full(double) { return 1; }

class Shifting : public testing::Test {
 protected:
  Shifts shifts_of(Particles& p, InstructionSet set = widest_instruction_set()) {
    EXPECT_TRUE(neighbours.rebuild(p, tank_at_rest, 0));
    neighbours.refresh_for_continuity(scheme, p, tank_at_rest);
    Shifts shifts;
    sum_shifts(scheme, neighbours, p, tank_at_rest, shifts, set);
    return shifts;
  }

  // Standard deviation of sum_b V_b W_ab over the particles, images included.
  double spread(Particles& p) {
    shifts_of(p);  // puts the sources in their places
    double sum = 0, sum2 = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      double concentration = 0;
      for (std::size_t k = 0; k < neighbours.source_count(); ++k) {
        const Source& b = neighbours.sources()[k];
        const double r = std::hypot(p.x[i] - b.x, p.z[i] - b.z);
        if (r < 2 * h) concentration += b.weight * quintic_formula.value(r / h) / (h * h);
      }
      sum += concentration;
      sum2 += concentration * concentration;
    }
    const double n = static_cast<double>(p.size());
    return std::sqrt(sum2 / n - sum / n * (sum / n));
  }

  const Scheme<WithShifting> scheme{small_scene()};
  NeighbourSources neighbours{tank_at_rest, dp, kernel_support* h};
};

TEST_F(Shifting, LowersTheSpreadOfTheConcentrationInADisorderedTank) {
  Particles p = lattice(0.2, full);
  const double before = spread(p);
  for (int step = 0; step < 20; ++step) {
    const Shifts shifts = shifts_of(p);
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.x[i] += shifts.x[i];
      p.z[i] += shifts.z[i];
    }
  }
  EXPECT_GT(before, 0.005);
  EXPECT_LT(spread(p), 0.7 * before);
}

TEST_F(Shifting, LeavesARegularLatticeAlone) {
  Particles p = lattice(0, full);
  const Shifts shifts = shifts_of(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(shifts.x[i], 0, 1e-14);
    EXPECT_NEAR(shifts.z[i], 0, 1e-14);
    EXPECT_NEAR(shifts.fullness[i], 1, 0.005);
  }
}

TEST_F(Shifting, LeavesALiquidAtRestInItsTankAlone) {
  Particles p = lattice(0.2, full);
  std::fill(p.velocity_x.begin(), p.velocity_x.end(), 0.0);
  const Shifts shifts = shifts_of(p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(std::hypot(shifts.x[i], shifts.z[i]), 0);
}

// Sun et al. 2017, eq. 12, over all particles; those whose kernel reaches no wall.
TEST_F(Shifting, HasThePublishedSizeInsideTheLiquid) {
  for (const InstructionSet set :
       {InstructionSet::plain, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has(set)) continue;
    Particles p = lattice(0.1, full);
    std::fill(p.velocity_x.begin(), p.velocity_x.end(), 0.05);  // no shift is near the limit
    const Shifts shifts = shifts_of(p, set);
    const double mach = 0.05 / scheme.setting.speed_of_sound;
    int compared = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.x[i] < 2 * h || p.x[i] > 0.2 - 2 * h || p.z[i] < 2 * h || p.z[i] > 0.16 - 2 * h)
        continue;
      double x = 0, z = 0;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double dx = p.x[i] - p.x[k], dz = p.z[i] - p.z[k], r = std::hypot(dx, dz);
        if (k == i || r >= 2 * h) continue;
        const double ratio = quintic_formula.value(r / h) / quintic_formula.value(dp / h);
        const double weight = dp * dp / 2 * (1 + 0.2 * std::pow(ratio, 4)) *
                              quintic_formula.slope(r / h) / (h * h * h) / r;
        x -= 0.8 * mach * 4 * h * h * weight * dx;
        z -= 0.8 * mach * 4 * h * h * weight * dz;
      }
      EXPECT_NEAR(shifts.x[i], x, 1e-16);
      EXPECT_NEAR(shifts.z[i], z, 1e-16);
      ++compared;
    }
    EXPECT_GT(compared, 100);
  }
}

TEST_F(Shifting, IsNeverFartherThanATwentiethOfASpacing) {
  Particles p = lattice(0.3, full);
  std::fill(p.velocity_x.begin(), p.velocity_x.end(), 300.0);
  const Shifts shifts = shifts_of(p);
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    farthest = std::max(farthest, std::hypot(shifts.x[i], shifts.z[i]));
  EXPECT_NEAR(farthest, 0.05 * dp, 1e-12);
}

TEST_F(Shifting, KnowsTheFullnessOfAFlatSurface) {
  Particles p = lattice(0, [](double) { return 0.1; });
  const Shifts shifts = shifts_of(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double depth = (0.1 - p.z[i]) / dp;
    if (depth > 1 && depth < 2) continue;
    EXPECT_NEAR(shifts.fullness[i], depth < 1 ? 0.5 : 1, 0.005);
  }
}

// Under a surface that slopes by 1 in 2 too: what is near to it moves along it, what is on it
// stays.
TEST_F(Shifting, MovesParticlesAlongTheFreeSurfaceAndThoseOnItNotAtAll) {
  for (const double slope : {0.0, 0.5}) {
    const auto top = [=](double x) { return 0.1 + slope * (x - 0.1); };
    Particles p = lattice(slope == 0 ? 0.02 : 0, top);
    const Shifts shifts = shifts_of(p);
    const double length = std::hypot(1, slope);
    int on = 0, near = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.x[i] < 0.05 || p.x[i] > 0.15) continue;  // the images fold a sloping surface
      const double depth = (top(p.x[i]) - p.z[i]) / length / dp;
      if (shifts.fullness[i] <= fullness_of_surface) {
        ++on;
        EXPECT_EQ(shifts.x[i], 0);
        EXPECT_EQ(shifts.z[i], 0);
        EXPECT_LT(depth, 1.5);
      } else if (depth < 2) {
        ++near;
        const double across = (shifts.z[i] - slope * shifts.x[i]) / length;
        const double along = (shifts.x[i] + slope * shifts.z[i]) / length;
        // The normal is as exact as the lattice's steps let it be.
        EXPECT_LE(std::abs(across), 0.3 * std::abs(along) + 1e-7 * dp) << depth;
      }
    }
    EXPECT_GE(on, 10);
    EXPECT_GE(near, 10);
  }
}

}  // namespace
}  // namespace slosh::sph::particle_shifting_test
