// What is measured and what a case starts from in cells that are graded towards the walls.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/geometry/liquid_edge.hpp"
#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/output/uniform_cells.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "openfoam_cases/write_case.hpp"

namespace slosh::openfoam::graded_tank_test {
namespace {

SloshingTank graded_tank() {
  SloshingTank tank = still_tank();
  tank.cells_x = 30;
  tank.cells_z = 26;
  tank.wall_cell = 0.015;
  return tank;
}

double volume_of_cells(const SloshingTank& tank) {
  const TankMesh mesh(tank);
  double volume = 0;
  for (const Cell cell : mesh.cells())
    volume += liquid_share(tank, mesh, cell) * mesh.whole_cells(cell);
  return volume * mesh.cell_width() * mesh.cell_height();
}

TEST(GradedTank, StartsWithTheExactVolumeOfALevelAWaveAndAColumn) {
  SloshingTank tank = graded_tank();
  EXPECT_NEAR(volume_of_cells(tank), 1.1 * 0.357, 1e-12);
  EXPECT_NEAR(initial_volume(tank, TankMesh(tank)), 1.1 * 0.357, 1e-12);
  EXPECT_NEAR(TankMesh(tank).room(), 1.1 * 1.3, 1e-12);
  tank.initial_wave = InitialWave{1, 0.03};
  EXPECT_NEAR(volume_of_cells(tank), 1.1 * 0.357, 1e-12);
  tank.initial_wave = {};
  tank.column_width = 0.413;
  EXPECT_NEAR(volume_of_cells(tank), 0.413 * 0.357, 1e-12);
}

TEST(GradedTank, HasGaugesAndProbesAndSensorsThatReadALinearFieldRight) {
  const TankMesh mesh(graded_tank());
  for (int i = 0; i <= 50; ++i) {
    const double x = 1.1 * i / 50, z = 1.3 * i / 50;
    const GaugeColumns columns = gauge_columns(mesh, x);
    EXPECT_NEAR(
        std::lerp(mesh.centre_x(columns.left), mesh.centre_x(columns.right), columns.right_weight),
        x, 1e-12);
    double read_x = 0, read_z = 0;
    for (const CellShare& share : cell_shares(mesh, x, z)) {
      read_x += share.weight * mesh.centre(share.cell).x;
      read_z += share.weight * mesh.centre(share.cell).z;
    }
    EXPECT_NEAR(read_x, x, 1e-12);
    EXPECT_NEAR(read_z, z, 1e-12);
    for (const double width : {0.0, 0.005, 0.2}) {
      const double position = width / 2 + (1.3 - width) * i / 50;
      double read = 0, sum = 0;
      for (const FaceShare& face :
           face_shares(mesh, {"", PressureGauge::Wall::left, position, width})) {
        read += face.weight * face.z;
        sum += face.weight;
      }
      EXPECT_NEAR(sum, 1, 1e-12);
      EXPECT_NEAR(read, position, 1e-12);
    }
  }
}

TEST(GradedTank, HasItsEdgeOfTheLiquidWhereItIs) {
  SloshingTank tank = graded_tank();
  tank.column_width = 0.413;
  const TankMesh mesh(tank);
  std::vector<double> along, up;
  for (const int column : bottom_columns(mesh))
    along.push_back(liquid_share(tank, mesh, {column, 0}));
  for (const int row : free_rows(mesh, 3)) up.push_back(liquid_share(tank, mesh, {3, row}));
  // A sharp edge is located to 0.13 of a cell where cells grow by a fifth. Those at the edges are
  // 4.2 and 6.5 cm thick.
  EXPECT_NEAR(front_position(mesh, along), 0.413, 0.13 * 0.042);
  EXPECT_NEAR(highest_surface(mesh, 3, up), 0.357, 0.13 * 0.065);
  EXPECT_NEAR(surface_level(mesh, 3, mesh.depth_of(3, 0.357 / 1.3)), 0.357, 1e-12);
}

TEST(GradedTank, GivesFieldsOnUniformCellsWithTheSameSums) {
  const SloshingTank tank = graded_tank();
  const TankMesh mesh(tank);
  std::vector<double> liquid;
  for (const Cell cell : mesh.cells()) liquid.push_back(liquid_share(tank, mesh, cell));
  const std::vector<double> uniform = means_over_uniform_cells(mesh, liquid);
  ASSERT_EQ(uniform.size(), liquid.size());
  double sum = 0;
  for (const double share : uniform) sum += share * mesh.cell_width() * mesh.cell_height();
  EXPECT_NEAR(sum, 1.1 * 0.357, 1e-12);
  for (const double one : means_over_uniform_cells(mesh, std::vector(liquid.size(), 3.0)))
    EXPECT_NEAR(one, 3, 1e-12);
}

TEST(GradedTank, IsWrittenWithItsGradingAndItsWalls) {
  SloshingTank tank = graded_tank();
  tank.no_slip = true;
  const TemporaryDirectory directory;
  write_case(tank, template_directory, directory.path());
  const std::string mesh = contents(directory.path() / "system/blockMeshDict");
  EXPECT_TRUE(holds(mesh, "(30 1 26) simpleGrading ((("));
  EXPECT_TRUE(holds(contents(directory.path() / "0/U"), "walls        { type noSlip; }"));
}

}  // namespace
}  // namespace slosh::openfoam::graded_tank_test
