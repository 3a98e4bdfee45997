// The step after a sample takes over its accelerations where it begins with the sample's state.
#include <gtest/gtest.h>

#include <cmath>

#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::sampled_accelerations_test {
namespace {

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
}  // namespace slosh::sph::sampled_accelerations_test
