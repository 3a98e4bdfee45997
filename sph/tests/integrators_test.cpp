// The order of the integrators, and steps that take over the accelerations of a sample.
#include "sph/integrators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::integrators_test {
namespace {

// One acoustic mode of a column, in the place of a liquid: dv/dt = -b (rho - 1), drho/dt = a v, and
// walls that push with cos(2 t) besides. All is known in closed form.
struct AcousticMode {
  static constexpr double a = 2, b = 1.5, push = 0.3;

  Particles particles;
  Rates rates;
  double time = 0, velocities_behind = 0;
  int renewals = 0, accelerations = 0, compressions = 0;

  AcousticMode() {
    Particles& p = particles;
    p.x = {0.2};
    p.z = {0.0};
    p.velocity_x = {0.4};
    p.velocity_z = {0.0};
    p.density = {1.3};
    p.mass = p.spacing = {1.0};
    rates.resize(1);
  }
  void renew_neighbours(double) { ++renewals; }
  virtual void accelerate(double t) {
    ++accelerations;
    rates.acceleration_x[0] = -b * (particles.density[0] - 1) + push * std::cos(2 * t);
    rates.acceleration_z[0] = 0;
  }
  void compress(double) {
    ++compressions;
    rates.density_rate[0] = a * particles.velocity_x[0];
  }
  void kick(double dt) {
    add_scaled(particles.velocity_x, dt, rates.acceleration_x);
    add_scaled(particles.velocity_z, dt, rates.acceleration_z);
  }
  void drift(double dt) {
    add_scaled(particles.x, dt, particles.velocity_x);
    add_scaled(particles.z, dt, particles.velocity_z);
  }
  void update_density(double dt) { add_scaled(particles.density, dt, rates.density_rate); }
  void kick_and_drift(double kick_dt, double drift_dt) {
    kick(kick_dt);
    drift(drift_dt);
  }
  void update_density_and_drift(double density_dt, double drift_dt) {
    update_density(density_dt);
    drift(drift_dt);
  }
  void save() { saved_ = particles; }
  void restore() { particles = saved_; }
  virtual ~AcousticMode() = default;

 private:
  Particles saved_;
};

// v'' = -a b v - 2 push sin(2 t): v = A cos(omega t) + B sin(omega t) + C sin(2 t).
struct Exact {
  double x, density;
};
Exact exact_at(double t) {
  using M = AcousticMode;
  const double omega = std::sqrt(M::a * M::b), A = 0.4;
  const double C = -2 * M::push / (M::a * M::b - 4);
  const double B = (-M::b * 0.3 + M::push - 2 * C) / omega;
  const double travelled = A * std::sin(omega * t) / omega + B * (1 - std::cos(omega * t)) / omega +
                           C * (1 - std::cos(2 * t)) / 2;
  return {0.2 + travelled, 1.3 + M::a * travelled};
}

// After 3 s, the larger of the errors of position and density. Velocities of the staggered leapfrog
// are those of the half step.
template <class Integrator>
double error_with(int steps) {
  AcousticMode mode;
  Integrator integrator;
  const double dt = 3.0 / steps;
  for (int i = 0; i < steps; ++i) {
    integrator.advance(mode, dt);
    mode.time = (i + 1) * dt;
  }
  const Exact exact = exact_at(3);
  return std::max(std::abs(mode.particles.x[0] - exact.x),
                  std::abs(mode.particles.density[0] - exact.density));
}

template <class Integrator>
class Integrators : public testing::Test {};
using All = testing::Types<StaggeredLeapfrog, PredictorCorrector, Symplectic, Verlet>;
TYPED_TEST_SUITE(Integrators, All);

// Verlet's shows its order later than the others: its Euler steps make two families of states.
TYPED_TEST(Integrators, AreOfSecondOrder) {
  const double coarse = error_with<TypeParam>(3200), fine = error_with<TypeParam>(6400),
               finest = error_with<TypeParam>(12800);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_NEAR(std::log2(fine / finest), 2, 0.1);
  EXPECT_LT(finest, 1e-6);
}

// A step in which nothing acts changes positions alone, and exactly.
struct FreeFlight : AcousticMode {
  void accelerate(double) override { rates.acceleration_x[0] = rates.acceleration_z[0] = 0; }
};

TYPED_TEST(Integrators, CarryAFreeParticleByItsVelocityWhateverTheSteps) {
  FreeFlight flight;
  flight.particles.velocity_z[0] = -0.7;
  TypeParam integrator;
  for (const double dt : {0.1, 0.05, 0.2, 0.2}) {
    integrator.advance(flight, dt);
    flight.time += dt;
  }
  EXPECT_NEAR(flight.particles.x[0], 0.2 + 0.4 * 0.55, 1e-14);
  EXPECT_NEAR(flight.particles.z[0], -0.7 * 0.55, 1e-14);
  EXPECT_NEAR(flight.particles.velocity_x[0], 0.4, 1e-15);
}

// Neighbours are renewed once, at the start: a later renewal would reorder what was saved.
TYPED_TEST(Integrators, RenewTheNeighboursOnceAStep) {
  AcousticMode mode;
  TypeParam integrator;
  for (int i = 0; i < 3; ++i) integrator.advance(mode, 0.01);
  EXPECT_EQ(mode.renewals, 3);
  const bool two =
      std::is_same_v<TypeParam, PredictorCorrector> || std::is_same_v<TypeParam, Symplectic>;
  EXPECT_EQ(mode.accelerations, two ? 6 : 3);
  EXPECT_EQ(mode.compressions, two ? 6 : 3);
}

// A density cannot turn negative, however long the step.
TEST(Symplectic, KeepsTheDensityPositive) {
  struct Expanding : AcousticMode {
    void compress(double) { rates.density_rate[0] = -particles.density[0]; }
  } expanding;
  Symplectic integrator;
  for (int i = 0; i < 5; ++i) integrator.advance(expanding, 1.9);
  EXPECT_GT(expanding.particles.density[0], 0);
}

// The step after a sample takes over its accelerations where it begins with the sample's state.

// The steps of a surging tank from the hydrostatic lattice, with a sample before each of them and
// without any.
template <class Choice>
class Steps {
 public:
  explicit Steps(const Scene& scene)
      : scene_(scene),
        scheme_(scene),
        sampled_(scene_, method_of(scheme_), start()),
        other_(scene_, method_of(scheme_), start()) {}

  // Before each step `disturb` may change the particles.
  template <class Disturb>
  void expect_the_same_bits(const Disturb& disturb) {
    for (int step = 0; step < 6; ++step) {
      sampled_.accelerate_for_sample();
      for (auto* liquid : {&sampled_, &other_}) disturb(step, *liquid);
      advance(sampled_, of_sampled_);
      advance(other_, of_other_);
    }
    EXPECT_EQ(sampled_.particles.velocity_x, other_.particles.velocity_x);
    EXPECT_EQ(sampled_.particles.velocity_z, other_.particles.velocity_z);
    EXPECT_EQ(sampled_.particles.density, other_.particles.density);
  }

 private:
  using Integrator = typename Choice::Integrator;
  static constexpr double dt = 2e-4;

  Particles start() const {
    Particles p = initial_lattice(
        scene_, [this](double pressure) { return scheme_.state.density(pressure); });
    enter(frame_of<typename Choice::Frame>(), scene_, p);
    return p;
  }
  static void advance(Liquid& liquid, Integrator& integrator) {
    integrator.advance(liquid, dt);
    liquid.time += dt;
  }

  Scene scene_;
  Scheme<Choice> scheme_;
  Liquid sampled_, other_;
  Integrator of_sampled_, of_other_;
};

template <class Choice>
class SampledAccelerations : public testing::Test {};
using Choices = testing::Types<Recommended, Li2010, DeltaSph, Zhao2021Moving, WithVerlet>;
TYPED_TEST_SUITE(SampledAccelerations, Choices);

TYPED_TEST(SampledAccelerations, LeaveTheStepsAsTheyAre) {
  Steps<TypeParam>(surging_scene(0.05, 1)).expect_the_same_bits([](int, auto&) {});
}

// Moves the particle to the right of a vertical face, in the tank [m], close to the face before
// step 2 and behind it before step 3, less far than the neighbour lists allow. Step 3 puts it back.
struct Cross {
  double face, z;

  template <class Liquid>
  void operator()(int step, Liquid& liquid) const {
    if (step != 2 && step != 3) return;
    Particles& p = liquid.particles;
    const auto tank = liquid.tank_at(liquid.time);
    const Vector2 at = tank.in_frame(face, z);
    std::size_t nearest = 0;
    const auto distance = [&](std::size_t i) { return std::hypot(p.x[i] - at.x, p.z[i] - at.z); };
    for (std::size_t i = 1; i < p.size(); ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    p.x[nearest] = at.x + (step == 2 ? 5e-4 : -5e-4);
    EXPECT_EQ(liquid.neighbours().stale(p, tank, 2e-4), step == 2);
  }
};

TEST(AccelerationsOfASample, AreNotThoseOfAParticleThatAWallHasPutBack) {
  Steps<Recommended>(surging_scene(0.05, 1)).expect_the_same_bits(Cross{0, 0.125});
}

TEST(AccelerationsOfASample, AreNotThoseOfAParticleThatAnObstacleHasPutBack) {
  Scene scene = surging_scene(0.05, 1);
  scene.obstacles = {{0.4, 0.6, 0, 0.2}};
  Steps<Recommended>(scene).expect_the_same_bits(Cross{0.6, 0.125});
}

}  // namespace
}  // namespace slosh::sph::integrators_test
