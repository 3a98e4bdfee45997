#include "sph/neighbours/pair_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/all_pairs_oracle.hpp"
#include "sph/tests/disordered_liquid.hpp"
#include "sph/tests/formulas_of_choice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::pair_sums_test {
namespace {

constexpr double spacing = small_spacing;

// The neighbour search of a liquid between walls, and the walls' particles.
template <class Choice>
struct Neighbourhood {
  static constexpr double support =
      kernel_support * *Choice::numbers.smoothing_length_ratio * spacing;
  Scheme<Choice> scheme;
  NeighbourSources sources;
  typename Choice::Solids solids;

  explicit Neighbourhood(const TankWalls& walls, const Scene& scene = small_scene())
      : scheme(small_scene(Choice::Smoothing::reads_spacing ? spacing / 2 : spacing)),
        sources(walls, spacing, support),
        solids(scene, !Choice::Mirror::exists, support) {
    sources.add_solids(solids.places(), obstacles_on_lattice(scene, support));
    solids.initialise(scheme);
    if constexpr (Choice::Solids::has_density) {
      Array<double> density = solids.density();
      for (std::size_t i = 0; i < density.size(); ++i)
        density[i] = 1000 * (1.015 + 0.01 * std::sin(2.4 * static_cast<double>(i)));
      solids.set_density(density);
    }
  }

  bool rebuild(Particles& particles, const TankWalls& walls, double dt) {
    return sources.rebuild(particles, walls, dt, Choice::Mirror::exists);
  }

  Rates rates(const Particles& particles, const TankWalls& walls,
              InstructionSet set = widest_instruction_set()) {
    const Tank tank = tank_of<typename Choice::Frame>(walls);
    Rates rates;
    rates.resize(particles.size());
    sources.refresh_for_momentum(scheme, particles, tank);
    solids.refresh_for_momentum(scheme, sources, tank, set);
    sum_momentum(scheme, tank, sources.clusters(), sources.sources(), particles, rates, set);
    sources.refresh_for_continuity(scheme, particles, tank);
    solids.refresh_for_continuity(scheme, sources, tank, set);
    DensityGradient gradient;
    if constexpr (Choice::DensityDiffusion::reads_gradient)
      sum_density_gradient(scheme, sources, particles, tank, gradient, set);
    sum_continuity(scheme, tank, sources.clusters(), sources.sources(), gradient, particles, rates,
                   set);
    return rates;
  }

  AllPairs all_pairs(const Particles& particles, const TankWalls& walls) {
    AllPairs oracle(scheme.setting, formulas_of<Choice>(), particles, walls);
    if constexpr (Choice::Solids::has_density)
      oracle.add_solids(solids.places(), solids.density());
    else
      oracle.add_solids(solids.places(), {});
    return oracle;
  }
};

double largest_difference(const Array<double>& a, const Array<double>& b) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
    if (std::isnan(a[i])) return a[i];
  }
  return largest > 0 ? difference / largest : difference;
}

// The largest of the three rates' differences, each relative to the rate's largest value, or as it
// is where the rate is zero.
double disagreement(const Rates& a, const Rates& b) {
  return std::max({largest_difference(a.acceleration_x, b.acceleration_x),
                   largest_difference(a.acceleration_z, b.acceleration_z),
                   largest_difference(a.density_rate, b.density_rate)});
}

constexpr double round_off = 1e-12;

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set :
       {InstructionSet::plain, InstructionSet::avx2, InstructionSet::avx512})
    if (has(set)) sets.push_back(set);
  return sets;
}

template <class Choice>
void expect_the_sums_over_all_pairs(Particles particles) {
  Neighbourhood<Choice> neighbourhood(moving_tank);
  ASSERT_TRUE(neighbourhood.rebuild(particles, moving_tank, 0));
  const Rates expected = neighbourhood.all_pairs(particles, moving_tank).rates();
  for (const InstructionSet set : instruction_sets())
    EXPECT_LE(disagreement(neighbourhood.rates(particles, moving_tank, set), expected), round_off);
}

// All but the variants whose difference is not in the sums: the integrators.
using Choices =
    testing::Types<Li2010, Li2010TwoSpacings, Recommended, DeltaSph, WithCubicSpline,
                   WithWendlandC2, WithWendlandC4, WithWendlandC6, WithSymmetricPressure,
                   WithLinearState, WithoutViscosity, WithLinearViscosity, WithMonaghanViscosity,
                   WithLaminarViscosity, WithoutDiffusion, WithMolteniColagrossi, WithAntuono,
                   WithStickingWalls, WithRepulsiveWalls, WithGhostWalls, WithStickingGhostWalls,
                   WithDynamicWalls>;
using ChoicesWithObstacles =
    testing::Types<Recommended, DeltaSph, WithWendlandC6, WithAntuono, WithStickingWalls,
                   WithGhostWalls, WithStickingGhostWalls, WithDynamicWalls>;

template <class Choice>
class PairSums : public testing::Test {};
TYPED_TEST_SUITE(PairSums, Choices);

TYPED_TEST(PairSums, AreThoseOverAllPairsInAMovingAndAcceleratingTank) {
  expect_the_sums_over_all_pairs<TypeParam>(full_tank(moving_tank));
}

// Few particles a row: the vectors that read a run of them reach far past its end, and the end of
// one row stands beside the beginning of the next.
TYPED_TEST(PairSums, AreThoseOverAllPairsInASplashAndForOneParticleAlone) {
  expect_the_sums_over_all_pairs<TypeParam>(splashed_tank(moving_tank));
  DisorderedLiquid liquid(moving_tank);
  liquid.add(0.004, 0.15, spacing);
  expect_the_sums_over_all_pairs<TypeParam>(liquid.particles);
}

// An upright plate on the bottom, one spacing thick. The sums are exact, although the particles of
// a cluster share their list.
template <class Choice>
struct BesideAPlate {
  static constexpr Rectangle plate{0.1, 0.11, 0, 0.08};
  TankWalls walls;
  Particles particles;
  Neighbourhood<Choice> neighbourhood{walls, scene()};

  explicit BesideAPlate(const TankWalls& in) : walls(in) {
    const Particles full = full_tank(walls);
    const auto left = [&](std::size_t i) {
      return !holds(plate, full.x[i] - walls.left, full.z[i]);
    };
    particles = full;
    particles.for_each_field([&](Array<double>& field) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < full.size(); ++i)
        if (left(i)) field[kept++] = field[i];
      field.resize(kept);
    });
    EXPECT_LT(particles.size(), full.size());
    EXPECT_TRUE(neighbourhood.rebuild(particles, walls, 0));
  }
  static Scene scene() {
    Scene scene = small_scene();
    scene.obstacles = {plate};
    return scene;
  }
  Rates expected(const AllPairs::HidingFace& hiding_face) {
    AllPairs oracle(neighbourhood.scheme.setting, formulas_of<Choice>(), particles, walls);
    oracle.hide(hiding_face);
    if constexpr (Choice::Solids::has_density)
      oracle.add_solids(neighbourhood.solids.places(), neighbourhood.solids.density());
    else
      oracle.add_solids(neighbourhood.solids.places(), {});
    return oracle.rates();
  }
};

// Faces 0, 1 and 3 are the left and the right one and the top.
int hidden_by_plate(Vector2 from, Vector2 to) {
  const bool to_is_low = to.z < 0.08;
  if (from.z > 0.08) return to_is_low && to.x > 0.1 && to.x < 0.11 ? 3 : -1;
  if (from.x < 0.1) return to_is_low && to.x > 0.1 ? 0 : -1;
  return to_is_low && to.x < 0.11 ? 1 : -1;
}

template <class Choice>
class PairSumsBesideAPlate : public testing::Test {};
TYPED_TEST_SUITE(PairSumsBesideAPlate, ChoicesWithObstacles);

TYPED_TEST(PairSumsBesideAPlate, AreThoseOverAllPairsThatThePlateDoesNotHide) {
  BesideAPlate<TypeParam> beside(moving_tank);
  const Rates expected = beside.expected(hidden_by_plate);
  for (const InstructionSet set : instruction_sets())
    EXPECT_LE(
        disagreement(beside.neighbourhood.rates(beside.particles, moving_tank, set), expected),
        round_off);
}

// Shows that the test above can fail: the plate's left face is left out.
TYPED_TEST(PairSumsBesideAPlate, DifferWhereOneFaceHidesNothing) {
  BesideAPlate<TypeParam> beside(tank_at_rest);
  const Rates wrong = beside.expected([](Vector2 from, Vector2 to) {
    const int face = hidden_by_plate(from, to);
    return face == 0 ? -1 : face;
  });
  EXPECT_GT(disagreement(beside.neighbourhood.rates(beside.particles, tank_at_rest), wrong), 1e-3);
}

// The lists know the kernel's support, the images and the solids of a scheme, and none of its
// terms.
template <class Choice>
class ListsOf : public testing::Test {
 protected:
  // By how much the sums over lists that were made for steps of `dt`, before the particles moved,
  // differ from those over all pairs. Each particle moves by nearly the slack of lists for steps of
  // `of_slack` against the tank, in a direction of its own, while the tank itself moves on.
  double disagreement_after_moving(double of_slack, double dt) {
    Particles particles = full_tank(moving_tank);
    Neighbourhood<Choice> neighbourhood(moving_tank);
    neighbourhood.rebuild(particles, moving_tank, of_slack);
    const double distance = 0.99 * neighbourhood.sources.slack();
    neighbourhood.rebuild(particles, moving_tank, dt);
    TankWalls walls = moving_tank;
    walls.left += 0.05;
    walls.right += 0.05;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      particles.x[i] += 0.05 + distance * std::cos(2.4 * static_cast<double>(i));
      particles.z[i] += distance * std::sin(2.4 * static_cast<double>(i));
    }
    const NeighbourSources& sources = neighbourhood.sources;
    EXPECT_EQ(sources.stale(particles, walls, 0), !(distance < sources.slack()));
    return disagreement(neighbourhood.rates(particles, walls),
                        neighbourhood.all_pairs(particles, walls).rates());
  }
};
using Supports = testing::Types<Recommended, DeltaSph, Li2010, WithGhostWalls>;
TYPED_TEST_SUITE(ListsOf, Supports);

// The last shows that it can fail: the same motion over lists made for shorter steps.
TYPED_TEST(ListsOf, HoldWithoutARebuildUntilAParticleHasMovedByTheSlack) {
  for (const double dt : {2e-4, 1e-3})
    EXPECT_LE(this->disagreement_after_moving(dt, dt), round_off) << dt;
  EXPECT_GT(this->disagreement_after_moving(1e-3, 0), 1e-9);
}

// The density of dynamic particles after a step: its own continuity equation, not below rest.
TEST(DynamicSolids, FollowTheContinuityEquationOverAllPairs) {
  for (const auto& liquid : {full_tank, splashed_tank}) {
    Particles particles = liquid(moving_tank);
    Neighbourhood<WithDynamicWalls> walls(moving_tank);
    ASSERT_TRUE(walls.rebuild(particles, moving_tank, 0));
    const AllPairs oracle = walls.all_pairs(particles, moving_tank);
    const Array<double> start = walls.solids.density();
    walls.rates(particles, moving_tank);
    const double dt = 1e-4, rest = walls.scheme.setting.rest_density;
    walls.solids.advance_density(walls.scheme, dt);
    double largest_change = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const double expected = std::max(rest, start[i] + dt * oracle.density_rate_of_solid(i));
      EXPECT_NEAR(walls.solids.density()[i], expected, 1e-10);
      largest_change = std::max(largest_change, std::abs(expected - start[i]));
    }
    EXPECT_GT(largest_change, 1);  // [kg/m3]
    walls.solids.advance_density(walls.scheme, 1e6);
    EXPECT_EQ(*std::min_element(walls.solids.density().begin(), walls.solids.density().end()),
              rest);
  }
}

class NeighbourLists : public testing::Test {
 protected:
  Neighbourhood<Recommended> neighbourhood{tank_at_rest};
  Particles particles = full_tank(tank_at_rest);
  bool stale(double dt) { return neighbourhood.sources.stale(particles, tank_at_rest, dt); }
};

TEST_F(NeighbourLists, HaveSlackForOneStepHoweverLong) {
  particles.velocity_z[5] = -20;
  neighbourhood.rebuild(particles, tank_at_rest, 1e-3);
  EXPECT_FALSE(stale(1e-3));
}

TEST_F(NeighbourLists, AskForARebuildBeforeAFastParticleLeavesItsSlack) {
  EXPECT_TRUE(stale(0));
  neighbourhood.rebuild(particles, tank_at_rest, 1e-3);
  std::fill(particles.velocity_x.begin(), particles.velocity_x.end(), 0.0);
  std::fill(particles.velocity_z.begin(), particles.velocity_z.end(), 0.0);
  EXPECT_FALSE(stale(1e-3));
  particles.velocity_z[5] = 1.01 * neighbourhood.sources.slack() / 1e-3;
  EXPECT_TRUE(stale(1e-3));
}

TEST(PairSumsOfTwoSpacings, AreThoseOverAllPairs) {
  for (const TankWalls& walls : {tank_at_rest, moving_tank}) {
    Particles particles = full_tank_of_two_spacings(walls);
    Neighbourhood<Li2010TwoSpacings> neighbourhood(walls);
    ASSERT_TRUE(neighbourhood.rebuild(particles, walls, 0));
    EXPECT_LE(disagreement(neighbourhood.rates(particles, walls),
                           neighbourhood.all_pairs(particles, walls).rates()),
              round_off);
  }
}

// Where columns are narrower than the particle spacing the kernel's support is still the spacing's.
TEST(PairSumsOfANarrowedLattice, HoldUntilAParticleHasMovedByTheSlack) {
  Scene scene = small_scene();
  scene.tank_length = 0.15;
  scene.particle_spacing = scene.surface_particle_spacing = 0.0103;
  const Scheme<Recommended> scheme(scene);
  Liquid liquid(scene, method_of(scheme), initial_lattice(scene, [&](double pressure) {
                  return scheme.state.density(pressure);
                }));
  ASSERT_NEAR(liquid.particles.spacing_of(0), 0.01, 1e-14);
  const double distance = 0.99 * liquid.neighbours().slack();
  Particles& p = liquid.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = std::sin(1.7 * static_cast<double>(i));
    p.velocity_z[i] = std::cos(1.7 * static_cast<double>(i));
    p.x[i] += distance * std::cos(2.4 * static_cast<double>(i));
    p.z[i] += distance * std::sin(2.4 * static_cast<double>(i));
  }
  ASSERT_FALSE(liquid.neighbours().stale(p, liquid.tank_at(0), 0));
  liquid.accelerate(0);
  liquid.compress(0);
  Particles nominal = p;
  nominal.lattice_spacing = 0.0103;
  AllPairs oracle(scheme.setting, formulas_of<Recommended>(), nominal, liquid.tank_at(0).walls);
  EXPECT_LE(disagreement(liquid.rates, oracle.rates()), round_off);
}

TEST(NeighbourSources, NameTheParticleThatIsNotInTheTank) {
  for (double x : {0.137, 0.1, 0.4, std::nan("")}) {
    Particles particles = full_tank(moving_tank);
    particles.x[42] = x;
    NeighbourSources neighbours(moving_tank, spacing, 0.03);
    EXPECT_FALSE(neighbours.rebuild(particles, moving_tank, 0, true)) << x;
    EXPECT_EQ(neighbours.stray(), 42);
  }
}

}  // namespace
}  // namespace slosh::sph::pair_sums_test
