// Outlines and the meshes that they cut.
#include "openfoam_cases/outline/cut_mesh.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/outline/filling.hpp"
#include "openfoam_cases/outline/outline.hpp"
#include "openfoam_cases/tests/outlines.hpp"

namespace slosh::openfoam::cut_mesh_test {
namespace {

TEST(Outline, HasTheAreaOfItsPartBelowALevel) {
  const Polygon chamfered = chamfered_tank().outline;
  EXPECT_NEAR(area_of(chamfered), 0.8 - 0.13 * 0.13 - 0.23 * 0.23, 1e-15);
  EXPECT_NEAR(area_below(chamfered, 0.31), 0.31 - 0.13 * 0.13, 1e-15);
  EXPECT_NEAR(area_below(chamfered, 0.05), 0.05 * (0.74 + 0.05), 1e-15);
  EXPECT_EQ(area_below(chamfered, 0), 0);
  EXPECT_EQ(area_below(chamfered, 0.8), area_of(chamfered));
  const double regular = 64 * 0.25 * std::sin(2 * std::numbers::pi / 128);
  EXPECT_NEAR(area_of(lying_cylinder().outline), regular, 1e-14);
  EXPECT_NEAR(area_below(lying_cylinder().outline, 0.5), regular / 2, 1e-14);
  EXPECT_NEAR(area_below(inclined_tank().outline, 0.31), 0.31 * (0.6 + 0.31 / 3), 1e-15);
}

TEST(Outline, FillsToTheLevelThatItsAreaCameFrom) {
  for (const SloshingTank& tank : {chamfered_tank(), lying_cylinder(), inclined_tank()}) {
    const Filling filling({tank.outline});
    for (int i = 1; i < 50; ++i) {
      const double level = tank.height * i / 50;
      EXPECT_NEAR(filling.level(area_below(tank.outline, level)), level, 1e-12);
    }
    EXPECT_EQ(filling.level(-1), 0);
    EXPECT_EQ(filling.level(2), tank.height);
  }
}

// A ridge on the bottom, whose tip leaves two parts of one cell.
SloshingTank ridged_tank() {
  SloshingTank tank = inclined_tank();
  tank.outline = {{0, 0}, {0.4, 0}, {0.5, 0.27}, {0.6, 0}, {1, 0}, {1, 0.6}, {0, 0.6}};
  return tank;
}

std::vector<SloshingTank> tanks() {
  SloshingTank low = lying_cylinder(0.3, 31);
  low.gauges = {{"middle", 0.5}, {"beside", 0.05}};
  return {chamfered_tank(), lying_cylinder(), low, inclined_tank(), ridged_tank()};
}

TEST(CutMesh, FillsTheOutlineWithCellsOfAThirdOrMore) {
  for (const SloshingTank& tank : tanks()) {
    const TankMesh mesh(tank);
    double area = 0;
    std::set<std::pair<int, int>> places;
    for (const CutCell& cell : mesh.cut()->cells()) {
      area += cell.area;
      EXPECT_GE(mesh.whole_cells(cell.place), 1.0 / 3);
      EXPECT_LT(mesh.whole_cells(cell.place), 2);
      EXPECT_TRUE(is_inside(cell.polygon, cell.inside));
      EXPECT_TRUE(places.insert({cell.place.column, cell.place.row}).second);
    }
    EXPECT_NEAR(area, area_of(tank.outline), 1e-13);
  }
}

// The sum of a cell's outward normals is zero only where its faces close it.
TEST(CutMesh, ClosesEveryCellWithFacesInUpperTriangularOrder) {
  for (const SloshingTank& tank : tanks()) {
    const TankMesh tank_mesh(tank);
    const CutMesh& mesh = *tank_mesh.cut();
    std::map<int, Corner> sum;
    const auto add = [&](int begin, int end, int cell, double sign) {
      sum[cell].x += sign * (mesh.points()[end].z - mesh.points()[begin].z);
      sum[cell].z -= sign * (mesh.points()[end].x - mesh.points()[begin].x);
    };
    std::pair last{-1, -1};
    for (const InnerFace& face : mesh.faces()) {
      add(face.begin, face.end, face.owner, 1);
      add(face.begin, face.end, face.neighbour, -1);
      EXPECT_LT(face.owner, face.neighbour);
      EXPECT_LE(last, std::pair(face.owner, face.neighbour));
      last = {face.owner, face.neighbour};
    }
    double length = 0;
    for (const WallFace& face : mesh.walls()) {
      add(face.begin, face.end, face.owner, 1);
      EXPECT_NEAR(face.along, length, 1e-12);
      length += face.length;
    }
    for (const auto& [cell, normal] : sum) EXPECT_NEAR(std::hypot(normal.x, normal.z), 0, 1e-14);
  }
}

// cell_order.hpp says why; each process has numbers of its own.
TEST(CutMesh, NumbersCellsWithObliqueFacesEvenlyInEveryProcess) {
  for (const int processes : {1, 2, 3}) {
    for (const SloshingTank& tank : tanks()) {
      const UniformGrid grid{tank.length, tank.height, tank.cells_x, tank.cells_z};
      std::map<int, int> counts;
      int last = 0;
      const CutMesh mesh(tank.outline, grid, processes);
      for (const CutCell& cell : mesh.cells()) {
        EXPECT_GE(cell.process, last);
        last = cell.process;
        const int number = counts[cell.process]++;
        for (std::size_t i = 0; i < cell.polygon.size(); ++i) {
          const Corner a = cell.polygon[i], b = cell.polygon[(i + 1) % cell.polygon.size()];
          if (a.x != b.x && a.z != b.z) {
            EXPECT_EQ(number % 2, 0);
          }
        }
      }
      EXPECT_EQ(static_cast<int>(counts.size()), processes);
    }
  }
}

TEST(CutMesh, StartsWithTheExactVolumeAndALevelSurface) {
  for (const SloshingTank& tank : tanks()) {
    const TankMesh mesh(tank);
    double volume = 0;
    for (const CutCell& cell : mesh.cut()->cells())
      volume += liquid_share(tank, mesh, cell.place) * cell.area;
    const double exact = area_below(tank.outline, tank.fill_depth);
    EXPECT_NEAR(volume / exact, 1, 1e-13);
    EXPECT_EQ(initial_volume(tank, mesh), exact);
    for (const Gauge& gauge : tank.gauges) {
      const GaugeColumns columns = gauge_columns(mesh, gauge.x);
      for (const int column : {columns.left, columns.right})
        EXPECT_NEAR(surface_level(mesh, column, initial_depth(tank, mesh, column)), tank.fill_depth,
                    1e-12)
            << gauge.name;
    }
  }
}

// In a cylinder the odd wave changes no volume. The level at a gauge is the mean over its column.
TEST(CutMesh, StartsUnderAWave) {
  SloshingTank tank = lying_cylinder();
  tank.initial_wave = InitialWave{1, 0.05};
  const TankMesh mesh(tank);
  EXPECT_NEAR(initial_volume(tank, mesh) / area_below(tank.outline, 0.5), 1, 1e-5);
  const double level = surface_level(mesh, 10, initial_depth(tank, mesh, 10));
  EXPECT_NEAR(level, mean_height(tank, 0.25, 0.275), 1e-9);
}

}  // namespace
}  // namespace slosh::openfoam::cut_mesh_test
