#include "sph/neighbours/pair_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sph/initial_lattice.hpp"
#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/tests/all_pairs_oracle.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {
namespace {

constexpr double spacing = 0.01;
const TankWalls tank_at_rest{
    .left = 0, .right = 0.2, .bottom = 0, .roof = 0.16, .velocity = 0, .acceleration = 0};
const TankWalls moving_tank{.left = 0.137,
                            .right = 0.337,
                            .bottom = 0,
                            .roof = 0.16,
                            .velocity = 0.3,
                            .acceleration = -2.1};

Scene small_scene(double surface_spacing) {
  Scene scene = still_scene(spacing, 0.1);
  scene.tank_length = 0.2;
  scene.tank_height = 0.16;
  scene.fill_depth = 0.16;
  scene.surface_particle_spacing = surface_spacing;
  return scene;
}

class DisorderedLiquid {
 public:
  explicit DisorderedLiquid(const TankWalls& walls) : walls_(walls) {}

  void add(double from_left, double z, double lattice) {
    const double density = 1000 * (1 + 0.01 * disorder());
    particles.x.push_back(walls_.left + from_left);
    particles.z.push_back(z);
    particles.velocity_x.push_back(walls_.velocity + disorder());
    particles.velocity_z.push_back(disorder());
    particles.density.push_back(density);
    particles.mass.push_back(1000 * lattice * lattice * (1 + 0.02 * disorder()));
    particles.spacing.push_back(lattice);
  }

  // A lattice of cells, each particle up to 0.45 of a cell off its centre, in any order.
  void add_block(double bottom, double top, double lattice) {
    const double length = walls_.right - walls_.left;
    for (double z = bottom + 0.5 * lattice; z < top; z += lattice)
      for (double x = 0.5 * lattice; x < length; x += lattice)
        add(x + 0.45 * lattice * disorder(), z + 0.45 * lattice * disorder(), lattice);
  }

  double disorder() { return unit_(random_); }  // -1 to 1

  Particles particles;

 private:
  TankWalls walls_;
  std::mt19937 random_{20100};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

// Fills the whole tank, so that every wall and corner has particles close to it.
Particles full_tank(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(walls.bottom, walls.roof, spacing);
  return liquid.particles;
}

Particles full_tank_of_two_spacings(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(0, 0.1, spacing);
  liquid.add_block(0.1, 0.16, spacing / 2);
  return liquid.particles;
}

// A shallow pool, and a splash high up at the left wall: a single particle in most rows of cells.
Particles splashed_tank(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(0, 0.03, spacing);
  for (double z : {0.075, 0.089, 0.101, 0.107, 0.118, 0.133, 0.148})
    liquid.add(0.006 + 0.004 * liquid.disorder(), z, spacing);
  liquid.add(0.195, 0.115, spacing);
  return liquid.particles;
}

template <class Scheme>
Rates by_all_pairs(const Scheme& scheme, const Particles& particles, const TankWalls& walls) {
  const Medium medium{scheme.setting.gravity, scheme.setting.fill_depth, 1000,
                      scheme.state.speed_of_sound};
  using Kernel = typename Scheme::Kernel;
  if constexpr (std::is_same_v<Kernel, CubicSpline>)
    return li2010_by_all_pairs(particles, walls, medium);
  else
    return recommended_by_all_pairs(
        particles, walls, medium,
        std::is_same_v<Kernel, WendlandC2> ? wendland_slope : quintic_slope);
}

template <class Scheme>
Rates by_neighbours(const Scheme& scheme, NeighbourSources& neighbours, const Particles& particles,
                    const TankWalls& walls, InstructionSet set = widest_instruction_set()) {
  Rates rates;
  rates.resize(particles.size());
  neighbours.refresh_for_momentum(scheme, particles, walls);
  sum_momentum(scheme, neighbours.clusters(), neighbours.sources(), particles, rates, set);
  neighbours.refresh_for_continuity(scheme, particles, walls);
  sum_continuity(scheme, neighbours.clusters(), neighbours.sources(), {}, particles, rates, set);
  return rates;
}

double largest_difference(const Array<double>& a, const Array<double>& b) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
    if (std::isnan(a[i])) return a[i];
  }
  return difference / largest;
}

// The largest of the three rates' differences, each relative to the rate's largest value.
double disagreement(const Rates& a, const Rates& b) {
  return std::max({largest_difference(a.acceleration_x, b.acceleration_x),
                   largest_difference(a.acceleration_z, b.acceleration_z),
                   largest_difference(a.density_rate, b.density_rate)});
}

constexpr double round_off = 1e-12;

template <class Scheme>
class PairSums : public testing::Test {
 protected:
  static constexpr double surface_spacing =
      Scheme::Smoothing::reads_spacing ? spacing / 2 : spacing;
  const Scheme scheme{small_scene(surface_spacing)};
  const double support = kernel_support * *Scheme::numbers.smoothing_length_ratio * spacing;

  void expect_the_sums_over_all_pairs(Particles particles, const TankWalls& walls) {
    NeighbourSources neighbours(walls, spacing, support);
    ASSERT_TRUE(neighbours.rebuild(particles, walls, 0));
    const Rates expected = by_all_pairs(scheme, particles, walls);
    for (const InstructionSet set :
         {InstructionSet::plain, InstructionSet::avx2, InstructionSet::avx512})
      if (has(set)) {
        EXPECT_LE(disagreement(by_neighbours(scheme, neighbours, particles, walls, set), expected),
                  round_off);
      }
  }

  // By how much the sums over lists that were made for steps of `dt`, before the particles moved,
  // differ from those over all pairs. Each particle moves by `distance` against the tank, in a
  // direction of its own, while the tank itself moves on.
  double disagreement_after_moving(double distance, double dt) {
    Particles particles = full_tank(moving_tank);
    NeighbourSources neighbours(moving_tank, spacing, support);
    neighbours.rebuild(particles, moving_tank, dt);
    TankWalls walls = moving_tank;
    walls.left += 0.05;
    walls.right += 0.05;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      particles.x[i] += 0.05 + distance * std::cos(2.4 * static_cast<double>(i));
      particles.z[i] += distance * std::sin(2.4 * static_cast<double>(i));
    }
    EXPECT_EQ(neighbours.stale(particles, walls, 0), !(distance < neighbours.slack()));
    const Rates rates = by_neighbours(scheme, neighbours, particles, walls);
    return disagreement(rates, by_all_pairs(scheme, particles, walls));
  }

  double slack_for_steps_of(double dt) {
    Particles particles = full_tank(moving_tank);
    NeighbourSources neighbours(moving_tank, spacing, support);
    neighbours.rebuild(particles, moving_tank, dt);
    return neighbours.slack();
  }
};

using Schemes = testing::Types<Scheme<Li2010>, Scheme<Li2010TwoSpacings>, Scheme<WithWendlandC2>,
                               Scheme<Recommended>>;
TYPED_TEST_SUITE(PairSums, Schemes);

TYPED_TEST(PairSums, AreThoseOverAllPairsInATankAtRest) {
  this->expect_the_sums_over_all_pairs(full_tank(tank_at_rest), tank_at_rest);
}

TYPED_TEST(PairSums, AreThoseOverAllPairsInAMovingAndAcceleratingTank) {
  this->expect_the_sums_over_all_pairs(full_tank(moving_tank), moving_tank);
}

// Few particles a row: the vectors that read a run of them reach far past its end, and the end of
// one row stands beside the beginning of the next.
TYPED_TEST(PairSums, AreThoseOverAllPairsInASplash) {
  this->expect_the_sums_over_all_pairs(splashed_tank(moving_tank), moving_tank);
}

TYPED_TEST(PairSums, AreThoseOverAllPairsForOneParticleAlone) {
  DisorderedLiquid liquid(moving_tank);
  liquid.add(0.004, 0.15, spacing);
  this->expect_the_sums_over_all_pairs(liquid.particles, moving_tank);
}

TYPED_TEST(PairSums, HoldWithoutARebuildUntilAParticleHasMovedByTheSlack) {
  for (const double dt : {0.0, 2e-4, 1e-3})
    EXPECT_LE(this->disagreement_after_moving(0.99 * this->slack_for_steps_of(dt), dt), round_off)
        << dt;
}

// Shows that the test above can fail: the same motion over lists made for shorter steps.
TYPED_TEST(PairSums, LoseNeighboursOfParticlesThatMovedFartherThanTheSlack) {
  EXPECT_GT(this->disagreement_after_moving(0.99 * this->slack_for_steps_of(1e-3), 0), 1e-9);
}

TYPED_TEST(PairSums, HaveSlackForOneStepHoweverLong) {
  Particles particles = full_tank(tank_at_rest);
  particles.velocity_z[5] = -20;
  NeighbourSources neighbours(tank_at_rest, spacing, this->support);
  neighbours.rebuild(particles, tank_at_rest, 1e-3);
  EXPECT_FALSE(neighbours.stale(particles, tank_at_rest, 1e-3));
}

TYPED_TEST(PairSums, AskForARebuildBeforeAFastParticleLeavesItsSlack) {
  Particles particles = full_tank(tank_at_rest);
  NeighbourSources neighbours(tank_at_rest, spacing, this->support);
  EXPECT_TRUE(neighbours.stale(particles, tank_at_rest, 0));
  neighbours.rebuild(particles, tank_at_rest, 1e-3);
  std::fill(particles.velocity_x.begin(), particles.velocity_x.end(), 0.0);
  std::fill(particles.velocity_z.begin(), particles.velocity_z.end(), 0.0);
  EXPECT_FALSE(neighbours.stale(particles, tank_at_rest, 1e-3));
  particles.velocity_z[5] = 1.01 * neighbours.slack() / 1e-3;
  EXPECT_TRUE(neighbours.stale(particles, tank_at_rest, 1e-3));
}

TEST(PairSumsOfTwoSpacings, AreThoseOverAllPairs) {
  using Scheme = slosh::sph::Scheme<Li2010TwoSpacings>;
  const Scheme scheme(small_scene(spacing / 2));
  for (const TankWalls& walls : {tank_at_rest, moving_tank}) {
    Particles particles = full_tank_of_two_spacings(walls);
    NeighbourSources neighbours(walls, spacing,
                                kernel_support * *Scheme::numbers.smoothing_length_ratio * spacing);
    ASSERT_TRUE(neighbours.rebuild(particles, walls, 0));
    const Rates rates = by_neighbours(scheme, neighbours, particles, walls);
    EXPECT_LE(disagreement(rates, by_all_pairs(scheme, particles, walls)), round_off);
  }
}

// Where columns are narrower than the particle spacing the kernel's support is still the spacing's.
TEST(PairSumsOfANarrowedLattice, HoldUntilAParticleHasMovedByTheSlack) {
  using Scheme = slosh::sph::Scheme<Recommended>;
  Scene scene = small_scene(spacing);
  scene.tank_length = 0.15;
  scene.particle_spacing = scene.surface_particle_spacing = 0.0103;
  const Scheme scheme(scene);
  Liquid<Scheme> liquid(scene, scheme, initial_lattice(scene, [&](double pressure) {
                          return scheme.state.density(pressure);
                        }));
  ASSERT_NEAR(liquid.particles.spacing[0], 0.01, 1e-14);
  const double distance = 0.99 * liquid.neighbours().slack();
  Particles& p = liquid.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = std::sin(1.7 * static_cast<double>(i));
    p.velocity_z[i] = std::cos(1.7 * static_cast<double>(i));
    p.x[i] += distance * std::cos(2.4 * static_cast<double>(i));
    p.z[i] += distance * std::sin(2.4 * static_cast<double>(i));
  }
  ASSERT_FALSE(liquid.neighbours().stale(p, liquid.walls_at(0), 0));
  liquid.accelerate(0);
  liquid.compress(0);
  Particles nominal = p;
  std::fill(nominal.spacing.begin(), nominal.spacing.end(), 0.0103);
  EXPECT_LE(disagreement(liquid.rates, by_all_pairs(scheme, nominal, liquid.walls_at(0))),
            round_off);
}

TEST(NeighbourSources, NameTheParticleThatIsNotInTheTank) {
  for (double x : {0.137, 0.1, 0.4, std::nan("")}) {
    Particles particles = full_tank(moving_tank);
    particles.x[42] = x;
    NeighbourSources neighbours(moving_tank, spacing, 0.03);
    EXPECT_FALSE(neighbours.rebuild(particles, moving_tank, 0)) << x;
    EXPECT_EQ(neighbours.stray(), 42);
  }
}

}  // namespace
}  // namespace slosh::sph
