#include "sph/walls/thin_obstacles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>

#include "sph/tests/surging_scene.hpp"
#include "sph/walls/line_of_sight.hpp"
#include "sph/walls/solid_particles.hpp"

namespace slosh::sph::thin_obstacles_test {
namespace {

// An upright plate from the bottom up, a lying one, and a block that hangs free.
const Rectangle plate{0.5, 0.51, -0.03, 0.2}, shelf{0.3, 0.45, 0.1, 0.11},
    block{0.7, 0.72, 0.3, 0.32};
const LineOfSight sight({plate, shelf, block});

TEST(LineOfSight, HidesWhatIsOnTheOtherSideOfAPlate) {
  EXPECT_EQ(sight.hiding_face({0.495, 0.15}, {0.515, 0.15}), left_side);
  EXPECT_EQ(sight.hiding_face({0.515, 0.15}, {0.495, 0.15}), right_side);
  EXPECT_EQ(sight.hiding_face({0.4, 0.115}, {0.4, 0.095}), 4 + top_side);
  EXPECT_EQ(sight.hiding_face({0.4, 0.095}, {0.4, 0.115}), 4 + bottom_side);
  EXPECT_EQ(sight.hiding_face({0.495, 0.15}, {0.505, 0.15}), left_side);
  EXPECT_EQ(sight.hiding_face({0.505, 0.205}, {0.505, 0.195}), top_side);
}

TEST(LineOfSight, HidesNothingOnTheSameSideAndPastTheEnd) {
  EXPECT_EQ(sight.hiding_face({0.495, 0.15}, {0.485, 0.17}), no_face);
  EXPECT_EQ(sight.hiding_face({0.495, 0.205}, {0.515, 0.205}), no_face);
  EXPECT_EQ(sight.hiding_face({0.495, 0.195}, {0.515, 0.205}), no_face);
}

TEST(LineOfSight, HidesTheOppositeEndOfABlockThatIsThinBothWays) {
  EXPECT_EQ(sight.hiding_face({0.71, 0.325}, {0.71, 0.295}), 8 + top_side);
  EXPECT_EQ(sight.hiding_face({0.71, 0.295}, {0.71, 0.325}), 8 + bottom_side);
  EXPECT_EQ(sight.hiding_face({0.695, 0.31}, {0.725, 0.31}), 8 + left_side);
}

// Momentum is conserved because of this.
TEST(LineOfSight, HidesTwoPlacesInTheLiquidFromOneAnotherOrNeither) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0.2, 0.8), z(0, 0.4), near(-0.03, 0.03);
  const auto in_liquid = [](Vector2 at) {
    for (const Rectangle& r : sight.rectangles())
      if (at.x > r.left && at.x < r.right && at.z > r.bottom && at.z < r.top) return false;
    return true;
  };
  int hidden = 0;
  for (int k = 0; k < 200000; ++k) {
    const Vector2 a{x(random), z(random)}, b{a.x + near(random), a.z + near(random)};
    if (!in_liquid(a) || !in_liquid(b)) continue;
    const bool there = sight.hiding_face(a, b) == no_face,
               back = sight.hiding_face(b, a) == no_face;
    ASSERT_EQ(there, back) << a.x << ' ' << a.z << ' ' << b.x << ' ' << b.z;
    hidden += !there;
  }
  EXPECT_GT(hidden, 1000);
}

// Clusters share their lists by this.
TEST(LineOfSight, HidesTheSameFromThePlacesOfAGroup) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(0.2, 0.8), z(0, 0.4), near(-0.03, 0.03);
  const double reach = 0.03;
  int compared = 0;
  for (int k = 0; k < 200000; ++k) {
    const Vector2 a{x(random), z(random)}, b{a.x + near(random), a.z + near(random)},
        to{a.x + near(random), a.z + near(random)};
    const int group = sight.group(a, reach);
    if (group == LineOfSight::its_own_group || group != sight.group(b, reach)) continue;
    if (std::hypot(to.x - a.x, to.z - a.z) > reach || std::hypot(to.x - b.x, to.z - b.z) > reach)
      continue;
    ++compared;
    ASSERT_EQ(sight.hiding_face(a, to), sight.hiding_face(b, to));
    ASSERT_TRUE(group != LineOfSight::no_group || sight.hiding_face(a, to) == no_face);
  }
  EXPECT_GT(compared, 10000);
}

TEST(LineOfSight, SeesAlongSegmentsThatEnterNoRectangle) {
  EXPECT_FALSE(sight.sees({0.48, 0.15}, {0.53, 0.15}));
  EXPECT_TRUE(sight.sees({0.48, 0.15}, {0.49, 0.19}));
  EXPECT_TRUE(sight.sees({0.48, 0.21}, {0.53, 0.205}));
  EXPECT_FALSE(sight.sees({0.48, 0.21}, {0.53, 0.18}));
  EXPECT_TRUE(LineOfSight().sees({0.48, 0.15}, {0.53, 0.15}));
  EXPECT_EQ(sight.entered({0.48, 0.15}, {0.53, 0.15}), left_side);
  EXPECT_EQ(sight.entered({0.53, 0.15}, {0.48, 0.15}), right_side);
}

TEST(LineOfSight, TellsWhatHasPiercedAPlateFromWhatHasPassedItsCorner) {
  EXPECT_EQ(sight.pierced({0.495, 0.1}, {0.505, 0.1}), left_side);
  EXPECT_EQ(sight.pierced({0.495, 0.1}, {0.512, 0.1}), left_side);
  EXPECT_EQ(sight.pierced({0.515, 0.1}, {0.3, 0.1}), right_side);
  EXPECT_EQ(sight.pierced({0.497, 0.199}, {0.503, 0.202}), no_face);
  EXPECT_EQ(sight.pierced({0.495, 0.1}, {0.499, 0.1}), no_face);
}

TEST(ThinObstacles, AreThoseWithLiquidOnTwoSidesNearEachOther) {
  const auto count = [](Rectangle r) { return thin_obstacles({r}, 0.03, 1, 0.5).size(); };
  EXPECT_EQ(count({0.5, 0.51, 0, 0.2}), 1);
  EXPECT_EQ(count({0.5, 0.52, -0.03, 0.53}), 1);
  EXPECT_EQ(count({0.5, 0.53, 0, 0.2}), 0);
  EXPECT_EQ(count({0.2, 0.6, -0.03, 0.01}), 0) << "on the bottom";
  EXPECT_EQ(count({-0.03, 0.01, 0.1, 0.3}), 0) << "on the left wall";
  EXPECT_EQ(count({-0.03, 0.4, 0.1, 0.11}), 1) << "a shelf";
}

constexpr double dp = 0.05, depth = 0.15;  // three layers

Scene scene_with(std::vector<Rectangle> obstacles) {
  Scene scene = still_scene(dp, 0);
  scene.tank_height = 0.5;
  scene.obstacles = std::move(obstacles);
  return scene;
}

struct Laid {
  Scene scene;
  std::vector<SolidPlace> places;
  LineOfSight sight;

  explicit Laid(std::vector<Rectangle> obstacles)
      : scene(scene_with(std::move(obstacles))),
        places(solid_places(scene, false, depth, 1)),
        sight(thin_obstacles(obstacles_on_lattice(scene, depth), depth, 1, 0.5)) {}
};

const std::vector<std::vector<Rectangle>> plates{{{0.5, 0.55, 0, 0.3}},
                                                 {{0.5, 0.6, 0, 0.3}},
                                                 {{0.5, 0.55, 0, 0.5}},
                                                 {{0.5, 0.55, 0.2, 0.5}},
                                                 {{0.3, 0.6, 0.2, 0.25}},
                                                 {{0, 0.4, 0.2, 0.25}},
                                                 {{0.5, 0.55, 0.25, 0.35}},
                                                 {{0.5, 0.6, 0.2, 0.3}},
                                                 {{0.5, 0.55, 0, 0.3}, {0.3, 0.5, 0.2, 0.25}},
                                                 {{0.5, 0.55, 0, 0.3}, {0.55, 0.8, 0, 0.2}}};

// From every cell of the liquid, each place within reach is either seen or hidden with one ghost
// there.
TEST(PlacesBehindFaces, StandOnceAtEachPlaceThatIsHidden) {
  for (const auto& obstacles : plates) {
    const Laid laid(obstacles);
    std::map<std::pair<int, int>, std::map<int, int>> ghosts;  // of a cell and a face
    const auto cell = [](double at) { return static_cast<int>(std::lround(at / dp - 0.5)); };
    for (const SolidPlace& place : laid.places)
      if (place.face != no_face) ++ghosts[{cell(place.x), cell(place.z)}][place.face];
    const std::vector<Rectangle> on_lattice = obstacles_on_lattice(laid.scene, depth);
    int hidden = 0;
    for (int column = 0; column < 20; ++column)
      for (int row = 0; row < 10; ++row) {
        const Vector2 from{(column + 0.5) * dp, (row + 0.5) * dp};
        const auto in_obstacle = [&](const Rectangle& r) { return holds(r, from.x, from.z); };
        if (std::any_of(on_lattice.begin(), on_lattice.end(), in_obstacle)) continue;
        for (int i = -3; i <= 3; ++i)
          for (int k = -3; k <= 3; ++k) {
            if (i * i + k * k >= 9) continue;
            const Vector2 to{from.x + i * dp, from.z + k * dp};
            const int face = laid.sight.hiding_face(from, to);
            if (face == no_face) continue;
            const bool in_thick =
                std::any_of(on_lattice.begin(), on_lattice.end(), [&](const Rectangle& r) {
                  return holds(r, to.x, to.z) && thin_obstacles({r}, depth, 1, 0.5).empty();
                });
            ++hidden;
            EXPECT_EQ((ghosts[{column + i, row + k}][face]), in_thick ? 0 : 1)
                << from.x << ' ' << from.z << " to " << to.x << ' ' << to.z;
          }
      }
    EXPECT_GT(hidden, 50);
  }
}

TEST(PlacesBehindFaces, HaveTheirNodesBeforeTheirFaceInTheTank) {
  for (const auto& obstacles : plates) {
    const Laid laid(obstacles);
    for (const SolidPlace& place : laid.places) {
      if (place.face == no_face) continue;
      EXPECT_TRUE(place.in_obstacle);
      EXPECT_TRUE(place.node_x > 0 && place.node_x < 1 && place.node_z > 0 && place.node_z < 0.5);
      const Rectangle& r = laid.sight.rectangles()[static_cast<std::size_t>(place.face / 4)];
      const int side = place.face % 4;
      const double before_face = side == left_side     ? r.left - place.node_x
                                 : side == right_side  ? place.node_x - r.right
                                 : side == bottom_side ? r.bottom - place.node_z
                                                       : place.node_z - r.top;
      EXPECT_GT(before_face, 0) << place.node_x << ' ' << place.node_z;
    }
  }
}

TEST(PlacesBehindFaces, DoNotExistWhereObstaclesAreAsThickAsTheSupport) {
  for (const SolidPlace& place : Laid({{0.5, 0.65, 0, 0.3}}).places) EXPECT_EQ(place.face, no_face);
}

// The node of the plate's cell just below the step's top would lie in the step.
TEST(PlacesBehindFaces, LookAtTheLiquidAboveAStepBesideThem) {
  const Laid laid({{0.5, 0.55, 0, 0.3}, {0.55, 0.8, 0, 0.2}});
  int found = 0;
  for (const SolidPlace& place : laid.places)
    if (place.face == right_side && std::abs(place.x - 0.525) < 1e-9 &&
        std::abs(place.z - 0.175) < 1e-9) {
      ++found;
      EXPECT_NEAR(place.node_x, 0.575, 1e-12);
      EXPECT_NEAR(place.node_z, 0.225, 1e-12);
      EXPECT_EQ(place.turn.zz, -1);
    }
  EXPECT_EQ(found, 1);
}

// Beyond the other plate there is liquid of another room.
TEST(PlacesBehindFaces, LookAtTheLiquidBetweenTwoPlatesNearEachOther) {
  const Laid laid({{0.4, 0.45, 0, 0.5}, {0.55, 0.6, 0, 0.5}});
  for (const SolidPlace& place : laid.places) {
    if (place.face == right_side || place.face == 4 + left_side) {
      EXPECT_TRUE(place.node_x > 0.45 && place.node_x < 0.55) << place.node_x;
    }
  }
}

constexpr TankWalls walls{0.2, 1.2, 0, 0.5, 0.5, 0};  // left, right, bottom, roof, X', X''

struct Moved {
  double x, z, u, w;
  std::size_t count;
};

// Turns a particle of (0.7, -0.4) m/s at a place in the tank back that was at `before`.
Moved turned(std::optional<Vector2> before, Vector2 now, Vector2 velocity = {0.7, -0.4}) {
  Particles p;
  p.x = {0.2 + now.x};
  p.z = {now.z};
  p.velocity_x = {velocity.x};
  p.velocity_z = {velocity.z};
  const LineOfSight sight({{0.5, 0.51, -0.03, 0.2}});
  const std::size_t count = turn_back(p, walls, sight, [&](std::size_t) { return before; });
  return {p.x[0] - 0.2, p.z[0], p.velocity_x[0], p.velocity_z[0], count};
}

TEST(TurnBack, BringsAParticleBackToTheSideItCameFrom) {
  // It is nearer to the other face.
  const Moved one = turned(Vector2{0.495, 0.1}, {0.508, 0.1});
  EXPECT_EQ(one.count, 1);
  EXPECT_NEAR(one.x, 0.492, 1e-12);
  EXPECT_NEAR(one.u, 2 * 0.5 - 0.7, 1e-12);
  EXPECT_EQ(one.w, -0.4);
}

TEST(TurnBack, BringsAParticleBackThatHasPassedAllThroughAPlate) {
  EXPECT_NEAR(turned(Vector2{0.495, 0.1}, {0.514, 0.1}).x, 0.486, 1e-12);
  EXPECT_NEAR(turned(Vector2{0.515, 0.1}, {0.496, 0.1}).x, 0.524, 1e-12);
  EXPECT_NEAR(turned(Vector2{0.505, 0.203}, {0.505, 0.198}).z, 0.202, 1e-12);
}

TEST(TurnBack, LetsAParticleRoundTheEdge) {
  EXPECT_EQ(turned(Vector2{0.497, 0.199}, {0.503, 0.202}).count, 0);
  EXPECT_EQ(turned(Vector2{0.495, 0.1}, {0.498, 0.1}).count, 0);
}

// After a restart, when the place before is not known.
TEST(TurnBack, BringsAParticleBackAgainstItsVelocity) {
  EXPECT_NEAR(turned({}, {0.508, 0.1}, {0.9, 0}).x, 0.492, 1e-12);
  EXPECT_NEAR(turned({}, {0.502, 0.1}, {0.1, 0}).x, 0.518, 1e-12) << "slower than the tank";
  EXPECT_NEAR(turned({}, {0.508, 0.1}, {0.5, 0}).x, 0.512, 1e-12) << "at rest in the tank";
  EXPECT_EQ(turned({}, {0.512, 0.1}, {0.9, 0}).count, 0);
  EXPECT_GT(turned({}, {0.505, 0.01}, {0.5, 0.3}).z, 0) << "never out through the bottom";
}

}  // namespace
}  // namespace slosh::sph::thin_obstacles_test
