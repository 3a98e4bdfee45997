#include "sph/walls/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/disordered_liquid.hpp"
#include "sph/tests/formulas_of_choice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::solids_test {
namespace {

constexpr double dp = 0.025, fill_depth = 0.35;

template <class Choice>
struct Still {
  Scene scene;
  Scheme<Choice> scheme;
  Liquid liquid;

  explicit Still(const Scene& in)
      : scene(in),
        scheme(scene),
        liquid(scene, method_of(scheme), initial_lattice(scene, [&](double pressure) {
                 return scheme.state.density(pressure);
               })) {}
};

// A solid and its sources beside a liquid, as a Liquid would hold them.
template <class Choice>
struct Beside {
  Scene scene;
  Scheme<Choice> scheme;
  double support = kernel_support * scheme.setting.smoothing_length();
  Tank walls;
  NeighbourSources sources;
  typename Choice::Solids solids;
  Particles particles;

  Beside(const Scene& in, const TankWalls& walls_in, Particles liquid)
      : scene(in),
        scheme(scene),
        walls(tank_of<typename Choice::Frame>(walls_in)),
        sources(walls, scene.particle_spacing, support),
        solids(scene, !Choice::Mirror::exists, support),
        particles(std::move(liquid)) {
    sources.add_solids(solids.places(), obstacles_on_lattice(scene, support));
    solids.initialise(scheme);
    EXPECT_TRUE(sources.rebuild(particles, walls, 0, Choice::Mirror::exists));
  }
  void refresh_for_momentum() {
    sources.refresh_for_momentum(scheme, particles, walls);
    solids.refresh_for_momentum(scheme, sources, walls, widest_instruction_set());
  }
  void refresh_for_continuity() {
    sources.refresh_for_continuity(scheme, particles, walls);
    solids.refresh_for_continuity(scheme, sources, walls, widest_instruction_set());
  }
};

// The still liquid with the pressure rho_0 g depth, which the solids continue.
template <class Choice>
Particles lattice(const Scene& scene) {
  const Scheme<Choice> scheme(scene);
  return initial_lattice(scene, [&](double pressure) {
    return scheme.state.density(pressure * scheme.setting.rest_density / scene.rest_density);
  });
}

template <class Choice>
double rest_density_in(const Scene& scene) {
  return Scheme<Choice>(scene).setting.rest_density;
}

constexpr TankWalls still_walls{0, 1, 0, 1, 0, 0};

TEST(GhostSolids, ContinueTheHydrostaticPressureExactly) {
  Scene scene = still_scene(dp, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.2}};
  Beside<WithGhostWalls> beside(scene, still_walls, lattice<WithGhostWalls>(scene));
  beside.refresh_for_momentum();
  int below_surface = 0;
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    if (source.z > fill_depth - dp) return;
    ++below_surface;
    EXPECT_NEAR(source.strength, 9.81 * (fill_depth - source.z), 1e-10);  // p / rho_0
  });
  // Bottom, sides and the obstacle's three layers behind its faces.
  EXPECT_GT(below_surface, 250);
}

// The sides' nodes stand a quarter of a spacing below and above the liquid's rows. The outermost
// row is half a spacing below the surface.
TEST(GhostSolids, OfTheTanksWallsCountAsFarAsThereIsLiquidAtTheirNodes) {
  const Scene scene = still_scene(dp, 0);
  Beside<WithGhostWalls> beside(scene, still_walls, lattice<WithGhostWalls>(scene));
  beside.refresh_for_momentum();
  int above = 0;
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    const bool side = source.x < 0 || source.x > 1;
    if (!side || source.z < 0) return;
    const double share = source.weight / (0.5 * dp * dp);
    const double above_surface = (source.z - fill_depth) / dp;
    above += above_surface > 0;
    const double expected = std::clamp(0.5 - above_surface, 0.0, 1.0);
    EXPECT_NEAR(share, expected, std::abs(above_surface) < 1 ? 0.05 : 1e-12) << above_surface;
  });
  EXPECT_GT(above, 50);
}

// The particles of an obstacle count whole, also above the surface.
TEST(GhostSolids, OfAnObstacleCountWhole) {
  Scene scene = still_scene(dp, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.5}};
  Beside<Recommended> beside(scene, still_walls, lattice<Recommended>(scene));
  beside.refresh_for_momentum();
  beside.sources.for_each_solid_source(
      [&](Source& source, std::size_t) { EXPECT_NEAR(source.weight, dp * dp, 1e-18); });
}

// Also in a tank that accelerates along x with the liquid leaning against its walls accordingly.
TEST(GhostSolids, ContinueThePressureOfAnAcceleratedLiquidExactly) {
  const double acceleration = 1.7;
  const Scene scene = still_scene(dp, 0);
  Particles leaning = lattice<WithGhostWalls>(scene);
  const Scheme<WithGhostWalls> scheme(scene);
  const double rest = scheme.setting.rest_density;
  const auto pressure = [&](double x, double z) {
    return rest * (9.81 * (fill_depth - z) + acceleration * (1 - x));
  };
  for (std::size_t i = 0; i < leaning.size(); ++i)
    leaning.density[i] = scheme.state.density(pressure(leaning.x[i], leaning.z[i]));
  Beside<WithGhostWalls> beside(scene, {0, 1, 0, 1, 0, acceleration}, leaning);
  beside.refresh_for_momentum();
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    if (source.z > fill_depth - dp) return;
    EXPECT_NEAR(rest * source.strength, pressure(source.x, source.z), 1e-7);
  });
}

// Mirror particles of liquid of density rho, 0.5 % above rho_0 at the bottom, have rho g where
// ghost particles have rho_0 g: 0.5 % of g from each of the two walls of a corner. The sum over two
// particles in place of one adds 1 %, and the shares at the surface up to 3 %.
TEST(GhostSolids, PushTheStillLatticeAsMirrorParticlesDo) {
  const Scene scene = still_scene(dp, 0);
  Still<Recommended> mirror(scene);
  Still<WithGhostWalls> ghost(scene);
  mirror.liquid.accelerate(0);
  ghost.liquid.accelerate(0);
  double largest = 0;
  for (std::size_t i = 0; i < mirror.liquid.particles.size(); ++i) {
    ASSERT_EQ(mirror.liquid.particles.x[i], ghost.liquid.particles.x[i]);
    ASSERT_EQ(mirror.liquid.particles.z[i], ghost.liquid.particles.z[i]);
    largest = std::max(
        largest,
        std::hypot(mirror.liquid.rates.acceleration_x[i] - ghost.liquid.rates.acceleration_x[i],
                   mirror.liquid.rates.acceleration_z[i] - ghost.liquid.rates.acceleration_z[i]));
  }
  EXPECT_LE(largest, 0.03 * 9.81);
  EXPECT_GT(largest, 0);
}

// Around an obstacle too: what is left is the kernel's own error.
TEST(GhostSolids, HoldTheStillLiquidAroundAnObstacle) {
  Scene scene = still_scene(dp, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.2}};
  Still<Recommended> still(scene);
  still.liquid.accelerate(0);
  const Particles& p = still.liquid.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.z[i] > fill_depth - 3 * dp) continue;  // the free surface truncates the kernel
    EXPECT_LE(
        std::hypot(still.liquid.rates.acceleration_x[i], still.liquid.rates.acceleration_z[i]),
        0.01 * 9.81)
        << p.x[i] << ' ' << p.z[i];
  }
}

// The liquid of a uniform velocity (0.3, -0.2) m/s and a wall of 0.5 m/s.
template <class Choice>
void expect_velocities(double side_u, double side_w, double bottom_u, double bottom_w) {
  Scene scene = still_scene(dp, 0);
  Particles liquid = lattice<Choice>(scene);
  std::fill(liquid.velocity_x.begin(), liquid.velocity_x.end(), 0.3);
  std::fill(liquid.velocity_z.begin(), liquid.velocity_z.end(), -0.2);
  Beside<Choice> beside(scene, {0, 1, 0, 1, 0.5, 0}, liquid);
  beside.refresh_for_momentum();
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    if (source.z > fill_depth - dp) return;
    const bool side = source.x < 0 || source.x > 1, bottom = source.z < 0;
    if (side && bottom) return;
    EXPECT_NEAR(source.velocity_x, side ? side_u : bottom_u, 1e-12);
    EXPECT_NEAR(source.velocity_z, side ? side_w : bottom_w, 1e-12);
  });
  // In the continuity equation the walls let slip in any case.
  beside.refresh_for_continuity();
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    if (source.z > fill_depth - dp) return;
    const bool side = source.x < 0 || source.x > 1, bottom = source.z < 0;
    if (side && bottom) return;
    EXPECT_NEAR(source.velocity_x, side ? 0.7 : 0.3, 1e-12);
    EXPECT_NEAR(source.velocity_z, side ? -0.2 : 0.2, 1e-12);
  });
}

TEST(GhostSolids, OfAnObstacleHaveTheWallsVelocityInTheContinuityEquation) {
  Scene scene = still_scene(dp, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.2}};
  Particles liquid = lattice<Recommended>(scene);
  std::fill(liquid.velocity_x.begin(), liquid.velocity_x.end(), 0.3);
  Beside<Recommended> beside(scene, {0, 1, 0, 1, 0.5, 0}, liquid);
  beside.refresh_for_continuity();
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    EXPECT_EQ(source.velocity_x, 0.5);
    EXPECT_EQ(source.velocity_z, 0);
  });
}

TEST(GhostSolids, LetTheLiquidSlipWithFreeSlip) {
  expect_velocities<WithGhostWalls>(0.7, -0.2, 0.3, 0.2);
}

TEST(GhostSolids, HoldTheLiquidWithNoSlip) {
  expect_velocities<WithStickingGhostWalls>(0.7, 0.2, 0.7, 0.2);
}

Particles one_particle(double x, double z, double density) {
  Particles p;
  p.x = {x};
  p.z = {z};
  p.velocity_x = p.velocity_z = {0.0};
  p.density = {density};
  p.mass = {density * dp * dp};
  p.spacing = {dp};
  return p;
}

// Beside an obstacle's corner a particle reaches solids that look across another face and find no
// liquid there. These are as of a liquid without pressure.
template <class Choice>
struct BesideTheCorner : Beside<Choice> {
  static constexpr double x = 0.395;
  double z;

  explicit BesideTheCorner(double height)
      : Beside<Choice>(scene_with_a_step(), still_walls,
                       one_particle(x, height, rest_density_in<Choice>(scene_with_a_step()))),
        z(height) {
    this->refresh_for_continuity();
  }

  static Scene scene_with_a_step() {
    Scene scene = still_scene(dp, 0);
    scene.obstacles = {{0.4, 0.7, 0, 0.5}};
    return scene;
  }

  // Returns the particle's rate of density [kg/m3/s].
  double rate() {
    Rates rates;
    rates.resize(1);
    DensityGradient gradient;
    if constexpr (Choice::DensityDiffusion::reads_gradient)
      sum_density_gradient(this->scheme, this->sources, this->particles, this->walls, gradient,
                           InstructionSet::plain);
    sum_continuity(this->scheme, this->walls, this->sources.clusters(), this->sources.sources(),
                   gradient, this->particles, rates, InstructionSet::plain);
    return rates.density_rate[0];
  }

  // Returns the sum of dp^2 2 delta h c0 difference (dW/dr)/r over the solids in reach, the
  // diffusion of the differences d_a - d_b [kg/m3]. difference(b, found) has b's source; b has
  // found the particle where its node is in reach.
  template <class Difference>
  double diffusion_of(const Difference& difference) {
    const Setting& s = this->scheme.setting;
    const double h = s.smoothing_length();
    const KernelFormula kernel = kernel_formula<typename Choice::Kernel>();
    double sum = 0;
    this->sources.for_each_solid_source([&](Source& b, std::size_t i) {
      const SolidPlace& place = this->solids.places()[i];
      const double r = std::hypot(x - b.x, z - b.z);
      if (!(r < this->support)) return;
      const bool found = std::hypot(x - place.node_x, z - place.node_z) < this->support;
      sum += dp * dp * 2 * s.density_diffusion * h * s.speed_of_sound * difference(b, found) *
             kernel.slope(r / h) / (h * h * h * r);
    });
    return sum;
  }

  // The density that the hydrostatic pressure adds per depth [kg/m4].
  double hydrostatic_gradient() const {
    const Setting& s = this->scheme.setting;
    return s.rest_density * s.gravity / (s.speed_of_sound * s.speed_of_sound);
  }

  // Returns the rate that a density of 0 in place of the rest density would cause in the solids
  // that find no liquid.
  double rate_of_no_density() {
    const double rest = this->scheme.setting.rest_density;
    return diffusion_of([=](const Source&, bool found) { return found ? 0.0 : rest; });
  }
};

// The rounding of the densities and of sums of some ten terms, relative to what a density of 0
// would cause. Measured: 1.2e-14.
constexpr double rounding = 1e-13;

// The particle has no pressure either, so that no density differs.
TEST(GhostSolids, DiffuseNoDensityFromWhereTheyFindNoLiquid) {
  BesideTheCorner<WithMolteniColagrossi> corner(0.43);
  const double without = corner.rate_of_no_density();
  EXPECT_LT(without, -100);
  EXPECT_NEAR(corner.rate(), 0, -rounding * without);
}

// What diffuses is the density less the hydrostatic one of the same height. That of a liquid
// without pressure rises with the height, d_a - d_b = rho_0 g (z_a - z_b) / c0^2; solids that find
// the particle have its own.
TEST(GhostSolids, HaveTheDynamicDensityOfALiquidWithoutPressureWhereTheyFindNone) {
  BesideTheCorner<Recommended> corner(0.43);
  const double expected = corner.diffusion_of([&](const Source& b, bool found) {
    return found ? 0.0 : corner.hydrostatic_gradient() * (corner.z - b.z);
  });
  EXPECT_GT(expected, 0.1);
  EXPECT_NEAR(corner.rate(), expected, -rounding * corner.rate_of_no_density());
}

// Antuono's term takes (grad rho_a + grad rho_b) . r_ab / 2 from a pair's difference. The densities
// are equal, the particle's gradient is 0 and the solids' is the hydrostatic one, which leaves half
// of rho_0 g (z_a - z_b) / c0^2 from each, whatever it finds. The particle is so low that only
// solids at their nodes' height find it, whose density has no hydrostatic rise.
TEST(GhostSolids, DiffuseTheirHydrostaticGradientAloneByAntuonosTerm) {
  BesideTheCorner<DeltaSph> corner(0.41);
  const double expected = corner.diffusion_of([&](const Source& b, bool) {
    return 0.5 * corner.hydrostatic_gradient() * (corner.z - b.z);
  });
  EXPECT_GT(std::abs(expected), 0.01);
  EXPECT_NEAR(corner.rate(), expected, -rounding * corner.rate_of_no_density());
}

TEST(DynamicSolids, StartWithTheDensityOfTheStillLiquid) {
  const Scene scene = still_scene(dp, 0);
  Beside<WithDynamicWalls> beside(scene, still_walls, lattice<WithDynamicWalls>(scene));
  beside.solids.initialise(beside.scheme);
  beside.refresh_for_momentum();
  const double rest = beside.scheme.setting.rest_density;
  beside.sources.for_each_solid_source([&](Source& source, std::size_t) {
    EXPECT_NEAR(rest * source.strength, 1000 * 9.81 * std::max(0.0, fill_depth - source.z), 1e-7);
    EXPECT_EQ(source.velocity_x, 0);
  });
}

// One particle before the left wall, running at it with 0.2 m/s, in a tank where the hydrostatic
// pressure is none: drho/dt = rho_a V_b v_ab . grad W, a the solid's.
TEST(DynamicSolids, AreCompressedByAParticleThatComesNearer) {
  Scene scene = still_scene(dp, 0);
  scene.gravity = 1e-12;
  Particles particle = one_particle(0.01, 0.5125, rest_density_in<WithDynamicWalls>(scene));
  particle.velocity_x = {-0.2};
  Beside<WithDynamicWalls> beside(scene, still_walls, particle);
  beside.solids.initialise(beside.scheme);
  const auto solid = [&](double x, double z) {
    const auto& places = beside.solids.places();
    return std::find_if(places.begin(), places.end(),
                        [&](const SolidPlace& place) {
                          return std::abs(place.x - x) < 1e-9 && std::abs(place.z - z) < 1e-9;
                        }) -
           places.begin();
  };
  beside.refresh_for_continuity();
  beside.solids.advance_density(beside.scheme, 0.01);
  // The slope of the Kaiser-Bessel kernel, which the solver's polynomial fits to 1.5e-6 of its
  // largest.
  const double q = (0.01 + 0.5 * dp) / (1.5 * dp), root = std::sqrt(1 - q * q / 4), beta = 18;
  const double integral = 4 * std::numbers::pi * (2 * std::cyl_bessel_i(1, beta) / beta - 1);
  const double slope =
      -beta * q * std::cyl_bessel_i(1, beta * root) / (4 * root * integral * std::pow(1.5 * dp, 3));
  const double rest = beside.scheme.setting.rest_density, rate = rest * dp * dp * 0.2 * -slope;
  EXPECT_NEAR(beside.solids.density()[solid(-0.5 * dp, 0.5125)], rest + 0.01 * rate,
              1e-5 * 0.01 * rate);
  // Behind the other wall there is nothing to feel, and a receding particle leaves the rest
  // density.
  EXPECT_EQ(beside.solids.density()[solid(1 + 0.5 * dp, 0.5125)], rest);
  beside.solids.initialise(beside.scheme);
  beside.particles.velocity_x = {0.2};
  beside.refresh_for_continuity();
  beside.solids.advance_density(beside.scheme, 0.01);
  EXPECT_EQ(beside.solids.density()[solid(-0.5 * dp, 0.5125)], rest);
}

TEST(NoSolids, TakeNoObstacles) {
  Scene scene = still_scene(dp, 0.1);
  EXPECT_NO_THROW(NoSolids(scene, false, 0.1));
  scene.obstacles = {{0.4, 0.6, 0, 0.2}};
  EXPECT_THROW(NoSolids(scene, false, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::solids_test
