#include "openfoam_cases/outline/outline.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/outline/filling.hpp"
#include "openfoam_cases/tests/outlines.hpp"

namespace slosh::openfoam::outline_test {
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

std::string refusal(std::vector<Corner> outline) {
  SloshingTank tank = chamfered_tank();
  tank.outline = std::move(outline);
  return message_of<std::invalid_argument>([&] { check_outline(tank); });
}

TEST(Outline, IsRefusedWhereItIsNoSimplePolygonCounterClockwise) {
  EXPECT_EQ(refusal({{0, 0}, {1, 0.8}}),
            "OpenFOAM tank: outline corners = 2: expected three or more");
  EXPECT_NE(refusal({{0, 0}, {0, 0.8}, {1, 0.8}, {1, 0}}).find("corners counter-clockwise"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 0.8}, {1, 0}, {0, 0.8}}).find("cross or touch"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 0}, {1, 0.8}, {0.5, 0}, {0, 0.8}}).find("cross or touch"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 0}, {1, 0}, {1, 0.8}, {0, 0.8}}).find("edges that have a length"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 0}, {1, std::nan("")}, {0, 0.8}}).find("corner z = nan"),
            std::string::npos);
}

TEST(Outline, IsRefusedWhereTheRectangleAroundItIsAnother) {
  EXPECT_NE(refusal({{0.1, 0}, {1, 0}, {1, 0.8}, {0.1, 0.8}}).find("least x of the outline = 0.1"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 0}, {1, 0.7}, {0, 0.7}}).find("largest z of the outline = 0.7"),
            std::string::npos);
}

}  // namespace
}  // namespace slosh::openfoam::outline_test
