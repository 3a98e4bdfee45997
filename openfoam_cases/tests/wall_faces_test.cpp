#include "openfoam_cases/geometry/wall_faces.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::wall_faces_test {
namespace {

using Wall = PressureGauge::Wall;

// The cells are of 0.05 m in a tank of 1 x 0.5 m.
TankMesh mesh_with(std::vector<Obstacle> obstacles) {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.5;
  tank.cells_x = 20;
  tank.cells_z = 10;
  tank.obstacles = std::move(obstacles);
  return TankMesh(tank);
}

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

std::string refusal(const PressureGauge& gauge) {
  return message_of<std::invalid_argument>([&] {
    face_shares(mesh_with({{0, 0.1, 0.1, 0.2}}), gauge);
  });
}

TEST(WallFaces, RefuseAGaugeOffItsWall) {
  EXPECT_EQ(refusal({"", Wall::right, 0.51, 0}),
            "OpenFOAM tank: pressure gauge position = 0.51: expected with half the width of 0 m to "
            "both sides between the wall's ends, 0 and 0.5 m");
  EXPECT_NE(refusal({"", Wall::right, 0.49, 0.03}).find("position = 0.49"), std::string::npos);
  EXPECT_NE(refusal({"", Wall::bottom, 0.01, 0.03}).find("position = 0.01"), std::string::npos);
  EXPECT_NE(refusal({"", Wall::bottom, std::nan(""), 0}).find("position = nan"), std::string::npos);
  EXPECT_NE(refusal({"", Wall::bottom, 0.5, -0.01}).find("width = -0.01"), std::string::npos);
  EXPECT_NE(refusal({"", Wall::bottom, 0.5, std::nan("")}).find("width = nan"), std::string::npos);
  EXPECT_EQ(refusal({"", Wall::bottom, 0.99, 0.02}), "") << "up to the corner";
}

TEST(WallFaces, RefuseAGaugeThatAnObstacleCovers) {
  EXPECT_NE(refusal({"", Wall::left, 0.15, 0}).find("no obstacle covers"), std::string::npos);
  EXPECT_NE(refusal({"", Wall::left, 0.22, 0.05}).find("no obstacle covers"), std::string::npos);
  EXPECT_EQ(refusal({"", Wall::left, 0.225, 0.05}), "") << "up to the obstacle";
}

}  // namespace
}  // namespace slosh::openfoam::wall_faces_test
