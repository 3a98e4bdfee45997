#include <gtest/gtest.h>

#include "reports/fields/draw_field.hpp"

namespace slosh::reports::tank_line_test {
namespace {

// 100 px/m, level, with the tank's origin at (10, 20) px.
FieldLayout layout() {
  FieldLayout layout{};
  layout.scale = 100;
  layout.axis = {10, 20};
  return layout;
}

void expect_line(const FieldPanel& panel, const std::vector<Pixel>& wanted) {
  const std::vector<Pixel> line = tank_line(panel, layout());
  ASSERT_EQ(line.size(), wanted.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_NEAR(line[i].x, wanted[i].x, 1e-9) << "corner " << i;
    EXPECT_NEAR(line[i].y, wanted[i].y, 1e-9) << "corner " << i;
  }
}

TEST(TankLine, OfARectangleIsHalfItsWidthOutside) {
  FieldPanel panel;
  panel.tank_length = 1;
  panel.tank_height = 0.5;
  expect_line(panel, {{9.25, 19.25}, {110.75, 19.25}, {110.75, 70.75}, {9.25, 70.75}});
}

// The hypotenuse from (3, 0) to (0, 4) has the normal (0.8, 0.6): 0.75 px away, the line cuts
// z = -0.75 px at x = 300 + (0.75 + 0.6 * 0.75) / 0.8, and x = -0.75 px likewise.
TEST(TankLine, OfAnOutlineFollowsItsSides) {
  FieldPanel panel;
  panel.tank_length = 3;
  panel.tank_height = 4;
  panel.outline = {{0, 0}, {3, 0}, {0, 4}};
  expect_line(panel, {{9.25, 19.25}, {311.5, 19.25}, {9.25, 422.25}});
}

TEST(TankLine, OfASharpCornerStaysNearIt) {
  FieldPanel panel;
  panel.tank_length = 1;
  panel.tank_height = 0.001;
  panel.outline = {{0, 0}, {1, 0}, {0, 0.001}};
  for (const Pixel& corner : tank_line(panel, layout())) {
    EXPECT_GT(corner.x, 4);
    EXPECT_LT(corner.x, 116);
  }
}

}  // namespace
}  // namespace slosh::reports::tank_line_test
