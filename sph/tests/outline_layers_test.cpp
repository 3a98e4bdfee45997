#include "sph/walls/outline_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/terms/kernels.hpp"
#include "sph/tests/outlined_tanks.hpp"
#include "sph/walls/solid_particles.hpp"

namespace slosh::sph::outline_layers_test {
namespace {

constexpr double dp = 0.02, depth = 3 * dp;

std::vector<SolidPlace> layers_of(const std::vector<Corner>& corners) {
  return outline_layers(TankOutline(corners), dp, depth, 2);
}

TEST(OutlineLayers, StandBehindTheSidesHalfASpacingOffAndFartherBack) {
  const TankOutline outline(chamfered_outline(0.15));
  for (const SolidPlace& place : layers_of(chamfered_outline(0.15))) {
    EXPECT_FALSE(outline.contains(place.x, place.z));
    const OutlinePoint wall = outline.nearest(place.x, place.z);
    const double behind = std::hypot(wall.at.x - place.x, wall.at.z - place.z);
    EXPECT_GE(behind, 0.5 * dp - 1e-12);
    EXPECT_LE(behind, depth);
  }
}

// A tank with a side turned into two has the same walls.
TEST(OutlineLayers, OfARectangleAreThoseOfItsLattice) {
  const auto round = layers_of({{0, 0}, {1, 0}, {1, 0.7}, {0, 0.7}});
  Scene scene = still_scene(dp, 0);
  scene.tank_height = 0.7;
  double outline_volume = 0, lattice_volume = 0;
  for (const SolidPlace& place : round) outline_volume += place.cell_share;
  for (const SolidPlace& place : solid_places(scene, true, depth, 2)) {
    // What lies beyond the kernel's reach of a corner is left out here.
    const double off_x = std::max({-place.x, place.x - 1, 0.0}),
                 off_z = std::max({-place.z, place.z - 0.7, 0.0});
    if (std::hypot(off_x, off_z) <= depth) lattice_volume += place.cell_share;
  }
  EXPECT_NEAR(outline_volume, lattice_volume, 0.01 * lattice_volume);
}

TEST(OutlineLayers, LookAtTheirMirrorImagesInTheirSide) {
  const TankOutline outline(chamfered_outline(0.15));
  int in_chamfers = 0;
  for (const SolidPlace& place : layers_of(chamfered_outline(0.15))) {
    EXPECT_TRUE(outline.contains(place.node_x, place.node_z)) << place.x << ' ' << place.z;
    if (place.x + place.z > 0.14 || place.x < 0 || place.z < 0) continue;
    // Behind the lower left chamfer a reflection turns (1, 0) into (0, -1).
    ++in_chamfers;
    EXPECT_NEAR(place.node_x, 0.15 - place.z, 1e-12);
    EXPECT_NEAR(place.node_z, 0.15 - place.x, 1e-12);
    const Vector2 turned = place.turn.of({1, 0}, 0);
    EXPECT_NEAR(turned.x, 0, 1e-12);
    EXPECT_NEAR(turned.z, -1, 1e-12);
  }
  EXPECT_GT(in_chamfers, 10);
}

// Liquid on one side and layers on the other fill a kernel about a point of the wall.
TEST(OutlineLayers, FillTheSpaceBehindSidesAndCorners) {
  for (const auto& corners : {chamfered_outline(0.15), cylinder_outline()}) {
    const TankOutline outline(corners);
    const auto places = layers_of(corners);
    const double h = depth / kernel_support, fine = dp / 10;
    for (const OutlineSide& side : outline.sides())
      for (const Vector2 at :
           {side.from, Vector2{0.5 * (side.from.x + side.to.x), 0.5 * (side.from.z + side.to.z)}}) {
        double filled = 0;
        for (const SolidPlace& b : places)
          filled +=
              b.cell_share * dp * dp * KaiserBessel::shape(std::hypot(b.x - at.x, b.z - at.z) / h);
        for (double x = at.x - depth; x < at.x + depth; x += fine)
          for (double z = at.z - depth; z < at.z + depth; z += fine)
            if (outline.contains(x, z))
              filled += fine * fine * KaiserBessel::shape(std::hypot(x - at.x, z - at.z) / h);
        EXPECT_NEAR(filled * KaiserBessel::normalisation / (h * h), 1, 0.06) << at.x << ' ' << at.z;
      }
  }
}

TEST(Turn, OfBothComponentsIsTheReflectionInAPoint) {
  const Vector2 turned = Turn::both().of({0.3, -0.2}, 0.5);
  EXPECT_NEAR(turned.x, 2 * 0.5 - 0.3, 1e-15);
  EXPECT_NEAR(turned.z, 0.2, 1e-15);
}

TEST(Turn, LeavesWhatMovesWithTheWallAlone) {
  const Vector2 turned = Turn::along(std::sqrt(0.5), std::sqrt(0.5)).of({0.5, 0}, 0.5);
  EXPECT_NEAR(turned.x, 0.5, 1e-15);
  EXPECT_NEAR(turned.z, 0, 1e-15);
}

}  // namespace
}  // namespace slosh::sph::outline_layers_test
