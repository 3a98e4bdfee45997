#include "openfoam_cases/geometry/tank_mesh.hpp"

#include <gtest/gtest.h>

#include <set>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::tank_mesh_test {
namespace {

SloshingTank tank_with(std::vector<Obstacle> obstacles) {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.5;
  tank.cells_x = 20;
  tank.cells_z = 10;
  tank.obstacles = std::move(obstacles);
  return tank;
}

std::string refusal(std::vector<Obstacle> obstacles) {
  return message_of<std::invalid_argument>([&] { TankMesh mesh(tank_with(obstacles)); });
}

TEST(TankMesh, OfAPlainTankIsOneBlockNumberedRowByRow) {
  const TankMesh mesh(tank_with({}));
  ASSERT_EQ(mesh.blocks().size(), 1u);
  EXPECT_EQ(mesh.free_cells(), 200);
  EXPECT_EQ(mesh.cells()[21].column, 1);
  EXPECT_EQ(mesh.cells()[21].row, 1);
  EXPECT_EQ(mesh.face_x(20), 1);
}

TEST(TankMesh, HasEveryFreeCellOnceAndNoOther) {
  const TankMesh mesh(tank_with({{0.2, 0.4, 0, 0.1}, {0.3, 0.5, 0.05, 0.2}, {0.9, 1, 0.4, 0.5}}));
  std::set<std::pair<int, int>> cells;
  for (const Cell cell : mesh.cells()) {
    EXPECT_TRUE(mesh.is_free(cell));
    EXPECT_TRUE(cells.insert({cell.column, cell.row}).second);
  }
  EXPECT_EQ(static_cast<int>(cells.size()), mesh.free_cells());
  EXPECT_EQ(mesh.free_cells(), 200 - 8 - 12 + 2 - 4);
  EXPECT_EQ(mesh.free_cells(4), 8);
  EXPECT_EQ(mesh.free_cells(6), 6);
  EXPECT_TRUE(mesh.are_alike(4, 5));
  EXPECT_FALSE(mesh.are_alike(5, 6));
}

TEST(TankMesh, SnapsAnEdgeThatWasRoundedAndRefusesOneOffTheFaces) {
  const TankMesh mesh(tank_with({{0.2004, 0.4, 0.0003, 0.0997}}));
  EXPECT_EQ(mesh.free_cells(), 200 - 8);
  EXPECT_EQ(
      refusal({{0.21, 0.4, 0, 0.1}}),
      "OpenFOAM tank: obstacle left = 0.21: expected a multiple of the cells' 0.05 m, to 0.01 "
      "of a cell (the nearest is 0.2 m)");
  EXPECT_NE(refusal({{0.2, 0.4, 0, 0.1006}}).find("obstacle top = 0.1006"), std::string::npos);
}

TEST(TankMesh, RefusesAnObstacleThatIsNone) {
  EXPECT_NE(refusal({{0.9, 1.1, 0, 0.1}}).find("right = 1.1: expected between the tank's walls"),
            std::string::npos);
  EXPECT_NE(refusal({{0.2, 0.4, -0.1, 0.1}}).find("bottom = -0.1"), std::string::npos);
  EXPECT_NE(refusal({{0.2, std::nan(""), 0, 0.1}}).find("right = nan"), std::string::npos);
  EXPECT_NE(refusal({{0.4, 0.2, 0, 0.1}}).find("a cell or more beyond the left edge at 0.4 m"),
            std::string::npos);
  EXPECT_NE(refusal({{0.2, 0.4, 0.1, 0.1}}).find("a cell or more above"), std::string::npos);
}

TEST(TankMesh, RefusesObstaclesThatLeaveNotOneRoom) {
  EXPECT_NE(refusal({{0, 1, 0, 0.5}}).find("fill the tank"), std::string::npos);
  EXPECT_NE(refusal({{0.4, 0.5, 0, 0.5}}).find("rooms without a connection"), std::string::npos);
  EXPECT_NE(refusal({{0.4, 0.5, 0, 0.2}, {0.5, 0.6, 0.2, 0.5}}).find("rooms"), std::string::npos)
      << "a corner is no connection";
  EXPECT_EQ(refusal({{0, 0.5, 0, 0.5}}), "") << "a shorter tank";
}

TEST(TankMesh, TakesTheReferencePressureUnderTheRoofOutsideTheObstacles) {
  EXPECT_EQ(TankMesh(tank_with({})).reference_cell().column, 10);
  EXPECT_EQ(TankMesh(tank_with({})).reference_cell().row, 9);
  EXPECT_EQ(TankMesh(tank_with({{0.4, 0.6, 0.3, 0.5}})).reference_cell().column, 12);
  EXPECT_EQ(TankMesh(tank_with({{0.4, 1, 0.3, 0.5}})).reference_cell().column, 7);
  EXPECT_EQ(TankMesh(tank_with({{0, 1, 0.45, 0.5}})).reference_cell().row, 8);
}

}  // namespace
}  // namespace slosh::openfoam::tank_mesh_test
