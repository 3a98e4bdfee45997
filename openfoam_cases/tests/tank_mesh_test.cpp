// The cells of a rectangular tank: blocks beside obstacles, grading and layers across a gap.
#include "openfoam_cases/geometry/tank_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "openfoam_cases/geometry/block_mesh.hpp"
#include "openfoam_cases/geometry/cell_faces.hpp"
#include "openfoam_cases/geometry/layers.hpp"
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

TEST(TankMesh, SnapsAnEdgeThatWasRounded) {
  const TankMesh mesh(tank_with({{0.2004, 0.4, 0.0003, 0.0997}}));
  EXPECT_EQ(mesh.free_cells(), 200 - 8);
}

TEST(TankMesh, TakesTheReferencePressureUnderTheRoofOutsideTheObstacles) {
  EXPECT_EQ(TankMesh(tank_with({})).reference_cell().column, 10);
  EXPECT_EQ(TankMesh(tank_with({})).reference_cell().row, 9);
  EXPECT_EQ(TankMesh(tank_with({{0.4, 0.6, 0.3, 0.5}})).reference_cell().column, 12);
  EXPECT_EQ(TankMesh(tank_with({{0.4, 1, 0.3, 0.5}})).reference_cell().column, 7);
  EXPECT_EQ(TankMesh(tank_with({{0, 1, 0.45, 0.5}})).reference_cell().row, 8);
}

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

TEST(CellFaces, AreUniformWithoutAWallCell) {
  const CellFaces faces(1.1, 20);
  EXPECT_FALSE(faces.is_graded());
  EXPECT_EQ(faces.face(20), 1.1);
  EXPECT_EQ(faces.graded_part().cells, 0);
  EXPECT_NEAR(faces.centres_to(0.055), 0.5, 1e-14);
}

TEST(CellFaces, GrowFromBothWallsByAFifthAtMostToAUniformMiddle) {
  const CellFaces faces(0.9, 180, 0.001, "cells_x");
  EXPECT_TRUE(faces.is_graded());
  EXPECT_EQ(faces.face(0), 0);
  EXPECT_EQ(faces.face(180), 0.9);
  EXPECT_NEAR(faces.size(0), 0.001, 1e-12);
  EXPECT_NEAR(faces.size(179), 0.001, 1e-12);
  for (int i = 0; i + 1 < 180; ++i) {
    const double ratio = faces.size(i + 1) / faces.size(i);
    EXPECT_LE(std::max(ratio, 1 / ratio), 1.2 + 1e-9) << i;
    EXPECT_NEAR(faces.size(i), faces.size(179 - i), 1e-12) << i;
  }
  EXPECT_NEAR(faces.size(80), faces.size(90), 1e-12);
  EXPECT_LT(faces.size(90), 0.0055) << "the middle stays near the 5 mm of uniform cells";
  const CellFaces::Part end = faces.graded_part();
  EXPECT_NEAR(end.length, faces.face(end.cells), 1e-15);
  EXPECT_NEAR(end.ratio, faces.size(end.cells - 1) / faces.size(0), 1e-9);
}

TEST(CellFaces, TellPlacesInCellsAndInCentresAndBack) {
  const CellFaces faces(1.3, 21, 0.03, "cells_z");
  for (int i = 0; i <= 200; ++i) {
    const double place = 1.3 * i / 200;
    const double cells = faces.cells_to(place);
    const int cell = std::min(static_cast<int>(cells), 20);
    EXPECT_NEAR(faces.face(cell) + (cells - cell) * faces.size(cell), place, 1e-12);
    EXPECT_NEAR(faces.at_centres(faces.centres_to(place)), place, 1e-12);
  }
}

TEST(CellFaces, TakeTheUniformCellItself) {
  const CellFaces faces(1.1, 20, 1.1 / 20, "cells_x");
  EXPECT_EQ(faces.graded_part().cells, 0);
  EXPECT_NEAR(faces.face(7), 7 * 0.055, 1e-12);
}

SloshingTank narrow_tank(int cells, std::optional<double> wall_cell = {}) {
  SloshingTank tank = still_tank();
  tank.gap = Gap{0.062, cells};
  tank.wall_cell = wall_cell;
  return tank;
}

TEST(Layers, AreOneOfAMetreInTwoDimensions) {
  const Layers layers(still_tank());
  EXPECT_FALSE(layers.is_half_gap());
  EXPECT_EQ(layers.count(), 1);
  EXPECT_EQ(layers.depth(), 1);
  EXPECT_EQ(layers.share(0), 1);
  EXPECT_EQ(layers.expansion(), 1);
  EXPECT_EQ(layers.measured_y(), 0.5);
}

TEST(Layers, FillHalfOfTheGapAndAreThinnestAtTheWall) {
  const Layers layers(narrow_tank(8));
  EXPECT_TRUE(layers.is_half_gap());
  EXPECT_DOUBLE_EQ(layers.depth(), 0.031);
  EXPECT_NEAR(layers.expansion(), 7, 1e-12);
  double sum = 0;
  for (int layer = 0; layer < layers.count(); ++layer) sum += layers.share(layer);
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(layers.share(7) / layers.share(0), 7, 1e-12);
  EXPECT_NEAR(layers.measured_y(), 0.031 * (1 - layers.share(7) / 2), 1e-15);
}

TEST(Layers, BeginWithAGivenCellAtTheWall) {
  const Layers layers(narrow_tank(8, 0.0015));
  EXPECT_NEAR(layers.at_wall(), 0.0015, 1e-12);
  EXPECT_NEAR(layers.expansion(), std::pow(layers.share(1) / layers.share(0), 7), 1e-9);
  const Layers uniform(narrow_tank(8, 0.005));
  EXPECT_EQ(uniform.expansion(), 1);
  EXPECT_DOUBLE_EQ(uniform.at_wall(), 0.031 / 8);
}

}  // namespace
}  // namespace slosh::openfoam::tank_mesh_test
