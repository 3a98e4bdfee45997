#include <gtest/gtest.h>

#include "sph/recording/free_surface.hpp"

namespace slosh::sph::front_position_test {
namespace {

constexpr double dp = 0.01;

// A layer of particles dp apart on the bottom from the left wall, the last one's edge at `front`.
Particles layer(double front) {
  Particles particles;
  for (double x = 0.5 * dp; x < front; x += dp) {
    particles.x.push_back(x);
    particles.z.push_back(0.5 * dp);
  }
  return particles;
}

void add(Particles& particles, double x, double z) {
  particles.x.push_back(x);
  particles.z.push_back(z);
}

double front(const Particles& particles) { return front_position(particles, dp); }

TEST(FrontPosition, IsTheEdgeOfAColumnAtRest) {
  Particles column = layer(0.2);
  for (double x = 0.5 * dp; x < 0.2; x += dp) add(column, x, 1.5 * dp);
  EXPECT_NEAR(front(column), 0.2, 1e-12);
}

TEST(FrontPosition, FollowsATongueUntilItIsHalfASpacingDeep) {
  Particles tongue = layer(0.2);
  for (double gap : {1.2, 1.5, 1.9}) add(tongue, tongue.x.back() + gap * dp, 0.5 * dp);
  const double last = tongue.x.back();
  add(tongue, last + 2.1 * dp, 0.5 * dp);
  EXPECT_NEAR(front(tongue), last + 0.5 * dp, 1e-12);
}

TEST(FrontPosition, TakesNoParticleThatRunsAheadForTheFront) {
  Particles liquid = layer(0.2);
  add(liquid, 0.23, 0.4 * dp);
  add(liquid, 0.31, 0.4 * dp);
  add(liquid, 0.315, 0.4 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, TakesNoJetAboveTheBottomForTheFront) {
  Particles liquid = layer(0.2);
  for (double x = 0.205; x < 0.3; x += dp) add(liquid, x, 2.1 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, PassesAGapOfTheLowestLayerUnderLiquid) {
  Particles liquid = layer(0.1);
  for (double x = 0.095; x < 0.2; x += dp) add(liquid, x, 1.5 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, DoesNotDependOnTheOrderOfTheParticles) {
  Particles forward = layer(0.2), backward;
  for (std::size_t i = forward.size(); i-- > 0;) add(backward, forward.x[i], forward.z[i]);
  EXPECT_EQ(front(backward), front(forward));
}

TEST(FrontPosition, IsTheWallWhereNothingStandsBeforeIt) {
  EXPECT_EQ(front(Particles{}), 0);
  Particles liquid;
  add(liquid, 0.1, 0.5 * dp);
  EXPECT_EQ(front(liquid), 0);
}

}  // namespace
}  // namespace slosh::sph::front_position_test
