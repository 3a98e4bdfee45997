#include "openfoam_cases/geometry/block_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::block_mesh_test {
namespace {

std::ptrdiff_t entries(const std::string& list) {
  return std::count(list.begin(), list.end(), '(');
}

// A step in the left corner leaves an L of three blocks, which share corners where they touch:
// eight corners in each of two planes.
TEST(BlockMesh, LeavesOutTheBlockOfAStep) {
  SloshingTank tank = still_tank();
  tank.obstacles = {{0, 0.11, 0, 0.26}};
  const BlockMesh mesh = block_mesh(TankMesh(tank));
  ASSERT_EQ(mesh.hexahedra.size(), 3u);
  EXPECT_EQ(entries(mesh.vertices), 2 * 8);
  EXPECT_EQ(entries(mesh.wall_faces), 8);
  EXPECT_EQ(entries(mesh.side_faces), 2 * 3);
  EXPECT_EQ(mesh.hexahedra[0].cells_x, 18);
  EXPECT_EQ(mesh.hexahedra[0].cells_z, 2);
  EXPECT_TRUE(mesh.vertices.ends_with("(1.1 0 1.3) (1.1 1 1.3)")) << mesh.vertices;
}

// There are four walls outside and four inside.
TEST(BlockMesh, GivesAnObstacleInTheMiddleItsWalls) {
  SloshingTank tank = still_tank();
  tank.obstacles = {{0.33, 0.44, 0.26, 0.39}};
  const BlockMesh mesh = block_mesh(TankMesh(tank));
  EXPECT_EQ(mesh.hexahedra.size(), 8u);
  EXPECT_EQ(entries(mesh.vertices), 2 * 16);
  EXPECT_EQ(entries(mesh.wall_faces), 4 * 3 + 4);
  for (const char* wall : {"left", "right", "bottom", "roof"}) {
    EXPECT_EQ(entries(mesh.faces_of.at(wall)), 3) << wall;
  }
  EXPECT_EQ(entries(mesh.faces_of.at("obstacles")), 4);
}

}  // namespace
}  // namespace slosh::openfoam::block_mesh_test
