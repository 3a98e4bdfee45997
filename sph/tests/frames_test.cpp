// The frames in which a flow is solved, and one flow in both.
#include "sph/walls/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sph/liquid.hpp"
#include "sph/schemes.hpp"
#include "sph/simulation.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/start/initial_state.hpp"
#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::frames_test {
namespace {

// Returns the acceleration of a free fall in the tank, by differences of the rolling tank's map.
Vector2 acceleration_in_tank(const Scene& scene, double t, Vector2 start, Vector2 velocity) {
  constexpr double step = 1e-4;
  const auto place = [&](double s) {
    return RollingEarthFrame::tank(scene, s).in_tank(
        start.x + velocity.x * (s - t),
        start.z + velocity.z * (s - t) - 0.5 * scene.gravity * (s - t) * (s - t));
  };
  const Vector2 before = place(t - step), now = place(t), after = place(t + step);
  return {(after.x - 2 * now.x + before.x) / (step * step),
          (after.z - 2 * now.z + before.z) / (step * step)};
}

TEST(TankFrame, PullsAFreeParticleAsItsFallLooksFromTheTank) {
  const Scene scene = surging_and_rolling_scene(0.02, 1);
  for (const double t : {0.1, 0.37, 0.9}) {
    const Vector2 start{0.7, 0.1}, velocity{0.6, -0.4};
    const Tank tank = RollingEarthFrame::tank(scene, t);
    const Vector2 wall = tank.wall_velocity(start.x, start.z),
                  place = tank.in_tank(start.x, start.z),
                  relative = tank.along_tank(velocity.x - wall.x, velocity.z - wall.z);
    const Vector2 pulled =
        TankFrame::tank(scene, t).pull(scene.gravity, place.x, place.z, relative.x, relative.z);
    const Vector2 expected = acceleration_in_tank(scene, t, start, velocity);
    EXPECT_NEAR(pulled.x, expected.x, 1e-5) << t;
    EXPECT_NEAR(pulled.z, expected.z, 1e-5) << t;
  }
}

TEST(RollingEarthFrame, CarriesAPlaceInTheTankByItsWallVelocity) {
  const Scene scene = surging_and_rolling_scene(0.02, 1);
  constexpr double t = 0.4, step = 1e-5;
  const auto place = [&](double s) {
    return RollingEarthFrame::tank(scene, s).in_frame(0.8, 0.05);
  };
  const Vector2 at = place(t), before = place(t - step), after = place(t + step);
  const Vector2 wall = RollingEarthFrame::tank(scene, t).wall_velocity(at.x, at.z);
  EXPECT_NEAR(wall.x, (after.x - before.x) / (2 * step), 1e-8);
  EXPECT_NEAR(wall.z, (after.z - before.z) / (2 * step), 1e-8);
}

TEST(RollingEarthFrame, FindsAPlaceAgainAndTurnsCounterClockwise) {
  const Scene scene = surging_and_rolling_scene(0.02, 1);
  const Tank tank = RollingEarthFrame::tank(scene, 0.4);
  const Vector2 there = tank.in_frame(0.8, 0.05), back = tank.in_tank(there.x, there.z);
  EXPECT_NEAR(back.x, 0.8, 1e-14);
  EXPECT_NEAR(back.z, 0.05, 1e-14);
  ASSERT_GT(tank.rolling->sine, 0);
  EXPECT_GT(tank.along_frame(1, 0).z, 0);  // x turns towards z
}

// The liquid's start by both frames, as the tank sees it.
TEST(Enter, GivesBothFramesTheSameLiquidOfEitherStart) {
  for (const Start start : {Start::earth, Start::tank}) {
    Scene scene = surging_and_rolling_scene(0.02, 1);
    scene.start = start;
    const TankMotion motion(scene, 0);
    const Particles lattice = initial_lattice(scene, [](double) { return 1000.0; });
    Particles in_earth = lattice, in_tank = lattice;
    enter(frame_of<RollingEarthFrame>(), scene, in_earth);
    enter(frame_of<TankFrame>(), scene, in_tank);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const Vector2 wall = motion.velocity(lattice.x[i], lattice.z[i]);
      const bool moves = start == Start::tank;
      EXPECT_NEAR(in_earth.velocity_x[i], moves ? wall.x : 0, 1e-14);
      EXPECT_NEAR(in_earth.velocity_z[i], moves ? wall.z : 0, 1e-14);
      EXPECT_NEAR(in_tank.velocity_x[i], moves ? 0 : -wall.x, 1e-14);
      EXPECT_NEAR(in_tank.velocity_z[i], moves ? 0 : -wall.z, 1e-14);
      EXPECT_EQ(in_tank.x[i], lattice.x[i]);
    }
  }
}

// One particle far from walls and others, without gravity, integrated by the scheme itself.
template <class Choice>
double largest_stray_from_a_line(double dt) {
  Scene scene = surging_and_rolling_scene(0.02, 1);
  scene.gravity = 1e-12;
  const Scheme<Choice> scheme(scene);
  Particles one;
  const Vector2 velocity{0.3, 0.2};  // against the earth
  const Vector2 place{0.3, 0.25};
  const Vector2 wall = TankMotion(scene, 0).velocity(place.x, place.z);
  one.x = {place.x};
  one.z = {place.z};
  one.velocity_x = {velocity.x - wall.x};
  one.velocity_z = {velocity.z - wall.z};
  one.density = {scene.rest_density};
  one.mass = {scene.rest_density * 4e-4};
  one.spacing = {scene.particle_spacing};
  Liquid liquid(scene, method_of(scheme), one);
  typename Choice::Integrator integrator;
  const Vector2 start = RollingEarthFrame::tank(scene, 0).in_frame(place.x, place.z);
  double stray = 0;
  while (liquid.time < 0.8) {
    integrator.advance(liquid, dt);
    liquid.time += dt;
    const Vector2 at = RollingEarthFrame::tank(scene, liquid.time)
                           .in_frame(liquid.particles.x[0], liquid.particles.z[0]);
    stray = std::max({stray, std::abs(at.x - start.x - velocity.x * liquid.time),
                      std::abs(at.z - start.z - velocity.z * liquid.time)});
  }
  return stray;
}

TEST(TankFrame, LetsAParticleFreeOfForcesMoveStraightInTheEarthToTheSecondOrderOfTheStep) {
  const double coarse = largest_stray_from_a_line<Zhao2021Fixed>(2e-3),
               fine = largest_stray_from_a_line<Zhao2021Fixed>(1e-3);
  EXPECT_LE(fine, 2e-6);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
}

// Coriolis by the leapfrog's velocity of half a step before.
TEST(TankFrame, DoesSoInTheRecommendedSchemeToTheFirstOrderOfTheStep) {
  EXPECT_LE(largest_stray_from_a_line<InTank<Recommended>>(1e-3), 1e-3);
}

// Returns the largest acceleration by viscosity of the shear flow u = speed + rate z over a bottom
// that moves at this speed, far from the side walls and the surface.
template <class Choice>
double viscous_acceleration_of_shear(double speed, double rate) {
  Scene scene = carried_scene(0.025, 1, speed);
  scene.kinematic_viscosity = 0.1;
  const Scheme<Choice> scheme(scene);
  Liquid liquid(scene, method_of(scheme), initial_lattice(scene, [](double) { return 1000.0; }));
  Particles& p = liquid.particles;
  const auto accelerate = [&](double shear) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.velocity_x[i] = speed + shear * p.z[i];
      p.velocity_z[i] = 0;
    }
    liquid.accelerate(0);
    return liquid.rates.acceleration_x;
  };
  const Array<double> uniform = accelerate(0), sheared = accelerate(rate);
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::abs(p.x[i] - 0.5) < 0.3 && p.z[i] < 0.2)
      largest = std::max(largest, std::abs(sheared[i] - uniform[i]));
  return largest;
}

// Plane Couette flow has the same stress everywhere, up to a wall that does not let slip.
TEST(NoSlipLaminar, LeavesPlaneCouetteFlowAsItIsInBothFrames) {
  using NoSlipLaminar = WithStickingWallsAndLaminarViscosity;
  EXPECT_LE(viscous_acceleration_of_shear<NoSlipLaminar>(0.3, 2), 1e-9);
  EXPECT_LE(viscous_acceleration_of_shear<InTank<NoSlipLaminar>>(0, 2), 1e-9);
  EXPECT_GE(viscous_acceleration_of_shear<InTank<WithLaminarViscosity>>(0, 2), 1);
}

// A tank's flow is the same whether it is solved in the frame of the earth or in the tank's.

double swing(const History& history) {
  const auto [low, high] = std::minmax_element(history.value.begin(), history.value.end());
  return *high - *low;
}

// Surge and roll together, half a second, the liquid at rest in the tank or in the earth first.
TEST(Zhao2021, GivesTheSameFlowWithMovingWallsAndInTheTanksFrame) {
  for (const Start start : {Start::tank, Start::earth}) {
    Scene scene = surging_and_rolling_scene(0.02, 0.5);
    scene.start = start;
    const RunOutput moving = run("zhao2021_moving", scene, {}),
                    fixed = run("zhao2021_fixed", scene, {});
    EXPECT_LE(largest_difference(moving.elevation.at("left"), fixed.elevation.at("left")),
              1e-3 * swing(fixed.elevation.at("left")));
    EXPECT_LE(largest_difference(moving.wall_pressure.at("B"), fixed.wall_pressure.at("B")),
              1e-2 * swing(fixed.wall_pressure.at("B")));
    EXPECT_LE(largest_difference(moving.force_x, fixed.force_x), 1e-2 * swing(fixed.force_x));
    EXPECT_LE(largest_difference(moving.force_z, fixed.force_z), 1e-2 * swing(fixed.force_z));
    EXPECT_LE(largest_difference(moving.moment, fixed.moment), 1e-2 * swing(fixed.moment));
    EXPECT_LE(largest_difference(moving.kinetic_energy, fixed.kinetic_energy),
              1e-3 * swing(fixed.kinetic_energy));
    EXPECT_LE(largest_difference(moving.momentum_x, fixed.momentum_x),
              1e-3 * swing(fixed.momentum_x));
  }
}

class MirrorScheme : public testing::TestWithParam<std::string> {
 protected:
  static Scene with_variant(Scene scene) {
    scene.variant = GetParam();
    scene.kinematic_viscosity = 1e-3;  // a Stokes layer as thick as a spacing
    return scene;
  }
};
INSTANTIATE_TEST_SUITE_P(Variant, MirrorScheme,
                         testing::Values("", "laminar_viscosity", "no_slip_mirror",
                                         "no_slip_laminar"),
                         [](const auto& variant) {
                           return variant.param.empty() ? "recommended" : variant.param;
                         });

// A mirror scheme has its surge in the frame of the earth, and in the tank's where that rolls too.
// The walls move in the one and stand in the other, and the images' velocities with them.
TEST_P(MirrorScheme, GivesTheSameSurgeInBothFrames) {
  Scene scene = with_variant(surging_scene(0.025, 0.5));
  scene.pressure_gauges = {{"B", Wall::left, 0.1, 0}};
  const RunOutput earth = run("recommended", scene, {});
  scene.roll = no_roll();
  const RunOutput tank = run("recommended", scene, {});
  EXPECT_LE(largest_difference(earth.elevation.at("left"), tank.elevation.at("left")),
            1e-3 * swing(earth.elevation.at("left")));
  EXPECT_LE(largest_difference(earth.wall_pressure.at("B"), tank.wall_pressure.at("B")),
            1e-2 * swing(earth.wall_pressure.at("B")));
  EXPECT_LE(largest_difference(earth.force_x, tank.force_x), 1e-2 * swing(earth.force_x));
}

TEST_P(MirrorScheme, Rolls) {
  const Scene scene = with_variant(surging_and_rolling_scene(0.02, 0.1));
  const RunOutput output = run("recommended", scene, {});
  EXPECT_GT(swing(output.elevation.at("left")), 1e-4);
}

}  // namespace
}  // namespace slosh::sph::frames_test
