#include "sph/walls/line_of_sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slosh::sph::line_of_sight_test {
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

}  // namespace
}  // namespace slosh::sph::line_of_sight_test
