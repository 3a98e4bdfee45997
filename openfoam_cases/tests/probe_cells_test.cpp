#include "openfoam_cases/geometry/probe_cells.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::probe_cells_test {
namespace {

double read(const TankMesh& mesh, double x, double z) {
  double sum = 0;
  for (const CellShare& share : cell_shares(mesh, x, z)) {
    const double centre_x = mesh.centre_x(share.cell.column),
                 centre_z = mesh.centre_z(share.cell.row);
    sum += share.weight * (2 + 3 * centre_x - 5 * centre_z);
  }
  return sum;
}

TEST(ProbeCells, ReadALinearFieldWithoutErrorAlsoInTheCorners) {
  const TankMesh mesh(small_tank());
  for (const double x : {0.0, 0.01, 0.4, 0.55, 1.1}) {
    for (const double z : {0.0, 0.05, 0.6, 1.3}) {
      EXPECT_NEAR(read(mesh, x, z), 2 + 3 * x - 5 * z, 1e-12) << x << " " << z;
    }
  }
}

// The obstacle lies right of the probe, whose cell and the one above are left.
TEST(ProbeCells, LeaveOutThoseOfAnObstacle) {
  SloshingTank tank = still_tank();
  tank.obstacles = {{0.33, 0.44, 0.26, 0.39}};
  const TankMesh mesh(tank);
  double sum = 0;
  for (const CellShare& share : cell_shares(mesh, 0.32, 0.33)) {
    EXPECT_TRUE(mesh.is_free(share.cell));
    sum += share.weight;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(ProbeCells, AreRefusedOutsideTheTankAndInAnObstacle) {
  SloshingTank tank = still_tank();
  tank.obstacles = {{0.33, 0.44, 0.26, 0.39}};
  const TankMesh mesh(tank);
  for (const auto& [x, z] : {std::pair{-0.1, 0.1}, {1.2, 0.1}, {0.5, 1.4}, {0.4, 0.3}}) {
    EXPECT_THROW(cell_shares(mesh, x, z), std::invalid_argument) << x << " " << z;
  }
}

}  // namespace
}  // namespace slosh::openfoam::probe_cells_test
