// Pressure gauges and probes in tanks with an outline.
#include <gtest/gtest.h>

#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/tests/outlines.hpp"

namespace slosh::openfoam::outline_sensors_test {
namespace {

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

std::string refusal(const SloshingTank& tank, const PressureGauge& gauge) {
  return message_of<std::invalid_argument>([&] { face_shares(TankMesh(tank), gauge); });
}

TEST(OutlineGauge, IsRefusedOffTheOutline) {
  const SloshingTank tank = chamfered_tank();
  EXPECT_NE(refusal(tank, gauge_at({0.5, 0.1}, 0)).find("x = 0.5: expected with z = 0.1 a place"),
            std::string::npos);
  EXPECT_NE(refusal(tank, {"", PressureGauge::Wall::bottom, 0.05, 0}).find("on the tank's outline"),
            std::string::npos);
  EXPECT_NE(refusal(tank, gauge_at({0.5, 0}, -1)).find("width = -1"), std::string::npos);
  EXPECT_NE(refusal(still_tank(), gauge_at({0, 0.1}, 0)).find("without an outline"),
            std::string::npos);
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

TEST(OutlineProbe, IsRefusedOutside) {
  const TankMesh mesh((chamfered_tank()));
  const std::string refused =
      message_of<std::invalid_argument>([&] { cell_shares(mesh, 0.05, 0.05); });
  EXPECT_NE(refused.find("a place inside the tank's outline"), std::string::npos) << refused;
}

}  // namespace
}  // namespace slosh::openfoam::outline_sensors_test
