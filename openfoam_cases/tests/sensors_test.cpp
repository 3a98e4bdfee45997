// What gauges, pressure gauges and probes read of the cells, also in tanks with an outline.
#include <gtest/gtest.h>

#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/tests/outlines.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::sensors_test {
namespace {

SloshingTank metre_tank(int cells_x) {
  SloshingTank tank = small_tank();
  tank.length = 1;
  tank.cells_x = cells_x;
  return tank;
}

TEST(GaugeColumns, ReadOneColumnWhereTheGaugeIsAtItsCentre) {
  const GaugeColumns columns = gauge_columns(TankMesh(metre_tank(50)), 0.95);
  EXPECT_NEAR(columns.left + columns.right_weight, 47, 1e-12);
}

TEST(GaugeColumns, ReadTheMeanOfTwoWhereTheGaugeIsOnTheirEdge) {
  const GaugeColumns columns = gauge_columns(TankMesh(metre_tank(100)), 0.95);
  EXPECT_EQ(columns.left, 94);
  EXPECT_NEAR(columns.right_weight, 0.5, 1e-12);
}

// A linear profile is reproduced everywhere, also at the walls.
TEST(GaugeColumns, ReproduceALinearSurfaceFromWallToWall) {
  const TankMesh mesh(metre_tank(7));
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    const GaugeColumns columns = gauge_columns(mesh, x);
    ASSERT_GE(columns.left, 0);
    ASSERT_LE(columns.left + 1, 6);
    const auto centre = [](int column) { return (column + 0.5) / 7; };
    EXPECT_NEAR(std::lerp(centre(columns.left), centre(columns.left + 1), columns.right_weight), x,
                1e-14);
  }
}

TEST(GaugeColumns, AreListedOnceEach) {
  SloshingTank tank = metre_tank(100);
  tank.gauges = {{"a", 0.95}, {"b", 0.941}, {"c", 0.95}};
  EXPECT_EQ(columns_read(tank, TankMesh(tank)), (std::vector<int>{93, 94, 95}));
}

// The cells are of 0.05 m in a tank of 1 x 0.5 m.
TankMesh mesh_with(std::vector<Obstacle> obstacles) {
  SloshingTank tank = metre_tank(20);
  tank.height = 0.5;
  tank.obstacles = std::move(obstacles);
  return TankMesh(tank);
}

TEST(GaugeColumns, ReadNothingBeyondAnObstaclesSide) {
  const TankMesh mesh = mesh_with({{0.4, 0.5, 0, 0.2}});
  const GaugeColumns before = gauge_columns(mesh, 0.39);
  EXPECT_EQ(before.left, 6);
  EXPECT_EQ(before.right, 7);
  EXPECT_NEAR(before.right_weight, 1.3, 1e-12);
  const GaugeColumns over = gauge_columns(mesh, 0.41);
  EXPECT_EQ(over.left, 8);
  EXPECT_NEAR(over.right_weight, -0.3, 1e-12);
}

TEST(GaugeColumns, ReadTheOneColumnOfANarrowGap) {
  const TankMesh mesh = mesh_with({{0.3, 0.4, 0, 0.2}, {0.45, 0.5, 0, 0.2}});
  const GaugeColumns gap = gauge_columns(mesh, 0.41);
  EXPECT_EQ(gap.left, 8);
  EXPECT_EQ(gap.right, 8);
}

TEST(SurfaceLevel, IsTheDepthWithoutObstacles) {
  EXPECT_EQ(surface_level(mesh_with({}), 3, 0.123), 0.123);
}

TEST(SurfaceLevel, IsLiftedByWhatIsBelowIt) {
  const TankMesh mesh =
      mesh_with({{0.4, 0.5, 0, 0.1}, {0.4, 0.5, 0.2, 0.3}, {0.4, 0.5, 0.45, 0.5}});
  EXPECT_NEAR(surface_level(mesh, 8, 0), 0.1, 1e-15) << "the top of a dry step";
  EXPECT_NEAR(surface_level(mesh, 8, 0.05), 0.15, 1e-15);
  EXPECT_NEAR(surface_level(mesh, 8, 0.1 + 1e-8), 0.2, 1e-7) << "up to an underside";
  EXPECT_NEAR(surface_level(mesh, 8, 0.15), 0.35, 1e-15);
  EXPECT_NEAR(surface_level(mesh, 8, 0.25), 0.45, 1e-15) << "full";
}

using Wall = PressureGauge::Wall;

TEST(WallFaces, ReadALinearPressureRightAtEveryPlaceAndWidth) {
  const TankMesh mesh = mesh_with({});
  for (const Wall wall : {Wall::left, Wall::right, Wall::bottom}) {
    const double length = wall == Wall::bottom ? 1 : 0.5;
    for (const double width : {0.0, 0.004, 0.07, 0.31}) {
      for (int i = 0; i <= 100; ++i) {
        const double position = width / 2 + (length - width) * i / 100;
        double sum = 0, pressure = 0;
        for (const FaceShare& face : face_shares(mesh, {"", wall, position, width})) {
          EXPECT_EQ(wall == Wall::bottom ? face.z : face.x, wall == Wall::right ? 1 : 0);
          sum += face.weight;
          pressure += face.weight * (3 - 2 * (wall == Wall::bottom ? face.x : face.z));
        }
        ASSERT_NEAR(sum, 1, 1e-12);
        ASSERT_NEAR(pressure, 3 - 2 * position, 1e-12);
      }
    }
  }
}

// The gauge reaches from 0.08 to 0.28 m, and the faces' centres are at 0.075, 0.125, ... m. Each
// weight is the integral of the face's hat function over the gauge.
TEST(WallFaces, AverageOverTheWidth) {
  const auto shares = face_shares(mesh_with({}), {"", Wall::left, 0.18, 0.2});
  const std::vector<double> expected{0.10125, 0.24875, 0.25, 0.25, 0.14875, 0.00125};
  ASSERT_EQ(shares.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(shares[i].z, 0.075 + 0.05 * i, 1e-12);
    EXPECT_NEAR(shares[i].weight, expected[i], 1e-12);
  }
}

TEST(WallFaces, ReadNothingBeyondAnObstacle) {
  const TankMesh mesh = mesh_with({{0, 0.1, 0.1, 0.2}, {0, 0.1, 0.25, 0.3}, {0.4, 0.5, 0, 0.1}});
  const auto below = face_shares(mesh, {"", Wall::left, 0.09, 0});
  ASSERT_EQ(below.size(), 2u);
  EXPECT_NEAR(below[0].weight, -0.3, 1e-12);
  EXPECT_NEAR(below[1].z, 0.075, 1e-12);
  const auto gap = face_shares(mesh, {"", Wall::left, 0.21, 0});
  ASSERT_EQ(gap.size(), 1u);
  EXPECT_NEAR(gap[0].z, 0.225, 1e-12);
  EXPECT_EQ(gap[0].weight, 1);
}

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

// Pressure gauges and probes in tanks with an outline.

double linear(double x, double z) { return 3 + 2 * x - 5 * z; }

double read(const TankMesh& mesh, const PressureGauge& gauge) {
  double sum = 0, pressure = 0;
  for (const FaceShare& face : face_shares(mesh, gauge)) {
    sum += face.weight;
    pressure += face.weight * linear(face.x, face.z);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  return pressure;
}

PressureGauge gauge_at(Corner place, double width) {
  return {"", PressureGauge::Wall::left, 0, width, place};
}

TEST(OutlineGauge, ReadsALinearPressureRightOnEveryEdge) {
  const SloshingTank tank = chamfered_tank();
  const TankMesh mesh(tank);
  for (std::size_t i = 0; i < tank.outline.size(); ++i) {
    const Corner a = tank.outline[i], b = tank.outline[(i + 1) % tank.outline.size()];
    const double length = std::hypot(b.x - a.x, b.z - a.z);
    for (const double width : {0.0, 0.004, 0.07}) {
      for (int k = 0; k <= 20; ++k) {
        const double share = std::lerp(width / 2, length - width / 2, k / 20.0) / length;
        const Corner place{std::lerp(a.x, b.x, share), std::lerp(a.z, b.z, share)};
        EXPECT_NEAR(read(mesh, gauge_at(place, width)), linear(place.x, place.z), 1e-10);
      }
    }
  }
}

// Around the corner each half of the gauge has its own mean.
TEST(OutlineGauge, GoesOnAlongTheNextEdgeBeyondACorner) {
  const TankMesh mesh((chamfered_tank()));
  const double along = 0.1 / 4, down = along / std::sqrt(2.0);
  const double expected = (linear(0.87 - along, 0) + linear(0.87 + down, down)) / 2;
  EXPECT_NEAR(read(mesh, gauge_at({0.87, 0}, 0.1)), expected, 1e-12);
}

// The polygon's edges are as long as a cell, so that many have one face; the error is that of the
// bend between two of them.
TEST(OutlineGauge, ReadsALinearPressureOnACylinder) {
  const SloshingTank tank = lying_cylinder();
  const TankMesh mesh(tank);
  for (const Corner& corner : tank.outline)
    EXPECT_NEAR(read(mesh, gauge_at(corner, 0)), linear(corner.x, corner.z), 5 * 0.025 * 0.05);
}

TEST(OutlineGauge, TakesAWallForThePlaceOnTheOutline) {
  const TankMesh mesh((chamfered_tank()));
  using Wall = PressureGauge::Wall;
  EXPECT_NEAR(read(mesh, {"", Wall::right, 0.3, 0.03}), linear(1, 0.3), 1e-12);
  EXPECT_NEAR(read(mesh, {"", Wall::roof, 0.4, 0}), linear(0.4, 0.8), 1e-12);
}

TEST(OutlineProbe, ReadsALinearFieldRightEverywhereInside) {
  for (const SloshingTank& tank : {chamfered_tank(), lying_cylinder(), inclined_tank()}) {
    const TankMesh mesh(tank);
    for (int i = 1; i < 40; ++i) {
      for (int k = 1; k < 40; ++k) {
        const double x = tank.length * (i + 0.3) / 40.5, z = tank.height * (k + 0.2) / 40.5;
        if (!is_inside(tank.outline, {x, z})) continue;
        double value = 0;
        for (const CellShare& share : cell_shares(mesh, x, z)) {
          const Corner centre = mesh.centre(share.cell);
          value += share.weight * linear(centre.x, centre.z);
        }
        ASSERT_NEAR(value, linear(x, z), 1e-9) << x << " " << z;
      }
    }
  }
}

}  // namespace
}  // namespace slosh::openfoam::sensors_test
