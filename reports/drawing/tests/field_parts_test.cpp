// The parts of a field picture that need no gnuplot: the range, grid, raster, arrows and the line
// around the tank.
#include "reports/drawing/field_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/drawing/draw_field.hpp"
#include "reports/tests/sample_report.hpp"

namespace slosh::reports::field_parts_test {
namespace {

FieldFigure one_panel() {
  FieldPanel panel;
  panel.tank_length = 1;
  panel.tank_height = 0.5;
  panel.point_width = panel.point_height = 0.01;
  FieldFigure figure;
  figure.panels = {panel};
  return figure;
}

FieldFigure with_values(std::vector<double> values) {
  FieldFigure figure = one_panel();
  FieldPanel& panel = figure.panels[0];
  panel.x.assign(values.size(), 0.5);
  panel.z.assign(values.size(), 0.25);
  panel.value = std::move(values);
  return figure;
}

// The part of a raster that holds every pixel with a level.
struct Raster {
  std::ptrdiff_t width = 0, height = 0;
  std::vector<int> levels;  // row by row

  std::ptrdiff_t holes() const { return std::count(levels.begin(), levels.end(), no_level); }
};

Raster raster(const FieldFigure& figure) {
  const FieldLayout layout = field_layout(figure);
  const std::vector<int> levels = field_raster(figure.panels[0], layout, colour_range(figure));
  const auto at = [&](int column, int row) {
    return levels[static_cast<std::size_t>(row * layout.cell_width + column)];
  };
  const int rows = static_cast<int>(levels.size()) / layout.cell_width;
  int left = layout.cell_width, right = -1, bottom = rows, top = -1;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < layout.cell_width; ++column) {
      if (at(column, row) == no_level) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      bottom = std::min(bottom, row);
      top = row;
    }
  }
  Raster filled;
  if (right < 0) return filled;
  filled.width = right - left + 1;
  filled.height = top - bottom + 1;
  for (int row = bottom; row <= top; ++row)
    for (int column = left; column <= right; ++column) filled.levels.push_back(at(column, row));
  return filled;
}

// A block of 20 x 10 places, 0.01 m apart. The function gives the shift of each from its number.
template <typename Shift>
FieldFigure block_of_places(const Shift& shift) {
  FieldFigure figure = with_values(std::vector<double>(200, 1.0));
  for (std::size_t i = 0; i < 200; ++i) {
    const auto [x, z] = shift(static_cast<int>(i));
    figure.panels[0].x[i] = 0.305 + 0.01 * static_cast<double>(i % 20) + x;
    figure.panels[0].z[i] = 0.105 + 0.01 * static_cast<double>(i / 20) + z;
  }
  return figure;
}

std::pair<double, double> unmoved(int) { return {0, 0}; }

TEST(ColourRange, HoldsNearlyAllValuesNoOutlierAndIsNeverEmpty) {
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i) values.push_back(i);
  values.push_back(1e9);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  FieldFigure given = with_values({-1, 0, 7});
  given.value_range = {-0.5, 7};
  const auto expect = [](const FieldFigure& figure, const ColourRange& wanted) {
    const ColourRange range = colour_range(figure);
    EXPECT_EQ(range.lower, wanted.lower);
    EXPECT_EQ(range.upper, wanted.upper);
    EXPECT_EQ(range.step, wanted.step);
    EXPECT_EQ(range.lower_label, wanted.lower_label);
    EXPECT_EQ(range.upper_label, wanted.upper_label);
  };
  expect(with_values(values), {0, 1000, 100, "0", "≥ 1000"});
  expect(given, {-0.5, 7, 1, "≤ −0.5", "7"});
  for (const double value : {0.0, 5.0, -1e-30, 1e299}) {
    const ColourRange range = colour_range(with_values({value, value}));
    EXPECT_LT(range.lower, range.upper) << value;
    EXPECT_LE(range.lower, value);
    EXPECT_GE(range.upper, value);
  }
  const ColourRange nothing = colour_range(with_values({}));
  EXPECT_LT(nothing.lower, nothing.upper);
}

TEST(ColourBar, HasTicksWhoseLabelsStayClearOfThoseOfTheEnds) {
  const auto ticks = [](double lower, double upper, double step, const std::string& end) {
    return bar_ticks({lower, upper, step, "≤ −500", end}, 500);
  };
  // 500 px for 5500 Pa: 45 px between ticks, where "4500" beside "≥ 5000" needs 48 px.
  EXPECT_EQ(ticks(-500, 5000, 500, "≥ 5000").last, 4000);
  EXPECT_EQ(ticks(-500, 5000, 500, "5000").last, 4500);
  EXPECT_EQ(ticks(-500, 5000, 500, "5000").first, 0);
  EXPECT_EQ(ticks(-500, 5000, 1000, "≥ 5000").first, 0);
  EXPECT_EQ(ticks(-500, 5000, 1000, "≥ 5000").last, 4000);
  // A bar without room for any label between its ends has no tick there.
  const BarTicks none = bar_ticks({0, 1, 1, "0", "1"}, 500);
  EXPECT_GT(none.first, none.last);
}

TEST(Layout, KeepsEveryTurnedTankInsideItsCellAndTheCellsApart) {
  FieldFigure figure = sloshing_field("layout", 4, 0.05);
  for (const int columns : {1, 2, 3, 50}) {
    figure.columns = columns;
    const FieldLayout layout = field_layout(figure);
    EXPECT_GE(layout.width, 1000);
    EXPECT_LE(layout.width, 1400);
    EXPECT_GE(layout.left, 0);
    EXPECT_GT(layout.column_gap, 0);
    EXPECT_LE(
        layout.left + layout.columns * (layout.cell_width + layout.column_gap) - layout.column_gap,
        layout.width);
    EXPECT_GE(layout.row_top(0), key_height);
    EXPECT_EQ(layout.row_height(), layout.label_lines * label_line + layout.cell_height + row_gap);
    EXPECT_LE(layout.row_top(layout.rows), layout.height);
    EXPECT_GE(layout.columns * layout.rows, static_cast<int>(figure.panels.size()));
    for (const FieldPanel& panel : figure.panels) {
      for (const double x : {0.0, panel.tank_length}) {
        for (const double z : {0.0, panel.tank_height})
          EXPECT_TRUE(layout.holds(layout.in_cell(panel, x, z))) << columns << " columns";
      }
    }
  }
}

TEST(Layout, BreaksALabelThatIsWiderThanItsPanelAfterACommaIfItCan) {
  FieldFigure figure = one_panel();
  figure.panels.resize(4, figure.panels[0]);
  figure.columns = 4;
  figure.panels[1].label = "a label without any comma that is rather long";
  figure.panels[2].label = "zhao2021_moving, dp = 2 mm, t = 3.45 s";
  const FieldLayout layout = field_layout(figure);
  EXPECT_EQ(layout.labels[1],
            (std::vector<std::string>{"a label without any comma that", "is rather long"}));
  EXPECT_EQ(layout.labels[2],
            (std::vector<std::string>{"zhao2021_moving, dp = 2 mm,", "t = 3.45 s"}));
  EXPECT_EQ(layout.label_lines, 2);
}

TEST(Raster, OfAMeshHasNoHolesAndItsExactExtent) {
  const FieldFigure figure = block_of_places(unmoved);
  const Raster drawn = raster(figure);
  const double scale = field_layout(figure).scale;
  EXPECT_EQ(drawn.holes(), 0);
  EXPECT_NEAR(drawn.width, 0.2 * scale, 1);
  EXPECT_NEAR(drawn.height, 0.1 * scale, 1);
}

TEST(Raster, FillsGapsBetweenParticlesWithoutMovingTheEdge) {
  const auto off_lattice = [](int i) {
    return std::pair{0.003 * std::sin(7.0 * i), 0.003 * std::cos(11.0 * i)};
  };
  const FieldFigure figure = block_of_places(off_lattice);
  const Raster drawn = raster(figure);
  const double scale = field_layout(figure).scale;
  EXPECT_LE(drawn.width, 0.206 * scale + 1);
  EXPECT_LE(drawn.height, 0.106 * scale + 1);
  const auto margin = static_cast<std::ptrdiff_t>(0.01 * scale);  // the ragged edge
  int inner_holes = 0;
  for (std::ptrdiff_t row = margin; row < drawn.height - margin; ++row) {
    for (std::ptrdiff_t column = margin; column < drawn.width - margin; ++column)
      inner_holes += drawn.levels[static_cast<std::size_t>(row * drawn.width + column)] == no_level;
  }
  EXPECT_EQ(inner_holes, 0);
}

TEST(Raster, LeavesAVoidOpen) {
  FieldFigure figure = block_of_places(unmoved);
  for (const std::size_t i : {88u, 89u, 90u, 108u, 109u, 110u, 128u, 129u, 130u})
    figure.panels[0].value[i] = std::numeric_limits<double>::quiet_NaN();  // 3 x 3 places
  const double cell = 0.01 * field_layout(figure).scale;
  // The filling narrows the void by less than half a place on each side.
  EXPECT_GE(raster(figure).holes(), std::floor(4 * cell * cell));
  EXPECT_LE(raster(figure).holes(), std::ceil(9 * cell * cell));
}

TEST(Raster, GivesTheSmallestPlaceAPixelAndNoneToOneThatFlewOutOfItsPanel) {
  FieldFigure figure = with_values({1});
  figure.panels[0].point_width = figure.panels[0].point_height = 1e-9;
  for (const double angle : {0.0, 0.5}) {
    figure.panels[0].angle = angle;
    EXPECT_EQ(raster(figure).levels.size(), 1u);
  }
  figure = with_values({1, 1});
  figure.panels[0].x = {1.5, -1e200};
  EXPECT_TRUE(raster(figure).levels.empty());
}

TEST(Arrows, AreThinnedToAFewHundredEvenlySpread) {
  FieldFigure figure = sloshing_field("thinned", 1, 0.002);
  for (const int columns : {1, 3}) {
    figure.columns = columns;
    const FieldLayout layout = field_layout(figure);
    const FieldArrows arrows = field_arrows(figure, layout);
    for (std::size_t panel = 0; panel < 3; ++panel) {
      const auto& drawn = arrows.panels[panel];
      EXPECT_LE(drawn.size(), most_arrows);
      EXPECT_GT(drawn.size(), 50u);
      const double middle = layout.cell_width / 2.0;
      const auto left_half =
          std::count_if(drawn.begin(), drawn.end(),
                        [&](const DrawnArrow& arrow) { return arrow.tail.x < middle; });
      EXPECT_GT(left_half, static_cast<std::ptrdiff_t>(drawn.size() / 4));
    }
  }
}

TEST(Arrows, HaveTheLengthOfTheirScaleUpToTheCut) {
  FieldFigure figure = one_panel();
  FieldPanel& panel = figure.panels[0];
  panel.angle = 0.25;
  panel.arrow_x = {0.2, 0.5, 0.8, 0.2};
  panel.arrow_z = {0.1, 0.1, 0.1, 0.3};
  panel.arrow_u = {1, 0, 100, 1e-6};
  panel.arrow_w = {0, 1, 0, 0};
  figure.arrow_scale = 0.05;
  const FieldLayout layout = field_layout(figure);
  const FieldArrows arrows = field_arrows(figure, layout);
  EXPECT_NEAR(arrows.pixels_per_speed, 0.05 * layout.scale, 1e-9);
  ASSERT_EQ(arrows.panels[0].size(), 3u);  // the slowest would be a dot
  double cut_length = 0;
  for (const DrawnArrow& arrow : arrows.panels[0]) {
    const double length = std::hypot(arrow.length.x, arrow.length.y);
    if (length > 1.01 * arrows.pixels_per_speed) {
      cut_length = length;
      continue;
    }
    EXPECT_NEAR(length, arrows.pixels_per_speed, 1e-9);
  }
  EXPECT_NEAR(cut_length, arrows.cut_speed * arrows.pixels_per_speed, 1e-9);
  EXPECT_NEAR(std::atan2(arrows.panels[0][0].length.y, arrows.panels[0][0].length.x), 0.25, 1e-12);
}

TEST(Arrows, StayInsideTheirPanelsCellAndAreNoneOfWaterAtRest) {
  FieldFigure figure = one_panel();
  FieldPanel& panel = figure.panels[0];
  panel.arrow_x = {0.01, 0.01};
  panel.arrow_z = {0.2, 0.3};
  panel.arrow_u = {1, -1};
  panel.arrow_w = {0, 0};
  FieldArrows arrows = field_arrows(figure, field_layout(figure));
  ASSERT_EQ(arrows.panels[0].size(), 1u);
  EXPECT_GT(arrows.panels[0][0].length.x, 0);
  panel.arrow_u = {0, 0};
  arrows = field_arrows(figure, field_layout(figure));
  EXPECT_EQ(arrows.pixels_per_speed, 0);
  EXPECT_TRUE(arrows.panels[0].empty());
}

// Without an outline a rectangle, half the line's width outside. The hypotenuse from (3, 0) to
// (0, 4) has the normal (0.8, 0.6): 0.75 px away, the line cuts z = -0.75 px at
// x = 300 + (0.75 + 0.6 * 0.75) / 0.8, and x = -0.75 px likewise.
TEST(TankLine, FollowsTheSidesOutsideOfThemAndStaysNearASharpCorner) {
  FieldLayout layout{};  // 100 px/m, level, with the tank's origin at (10, 20) px
  layout.scale = 100;
  layout.axis = {10, 20};
  const auto line = [&](double length, double height, bool is_triangle) {
    FieldPanel panel;
    panel.tank_length = length;
    panel.tank_height = height;
    if (is_triangle) panel.outline = {{0, 0}, {length, 0}, {0, height}};
    return tank_line(panel, layout);
  };
  const auto expect = [](const std::vector<Pixel>& line, const std::vector<Pixel>& wanted) {
    ASSERT_EQ(line.size(), wanted.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_NEAR(line[i].x, wanted[i].x, 1e-9) << "corner " << i;
      EXPECT_NEAR(line[i].y, wanted[i].y, 1e-9) << "corner " << i;
    }
  };
  expect(line(1, 0.5, false), {{9.25, 19.25}, {110.75, 19.25}, {110.75, 70.75}, {9.25, 70.75}});
  expect(line(3, 4, true), {{9.25, 19.25}, {311.5, 19.25}, {9.25, 422.25}});
  for (const Pixel& corner : line(1, 0.001, true)) {
    EXPECT_GT(corner.x, 4);
    EXPECT_LT(corner.x, 116);
  }
}

}  // namespace
}  // namespace slosh::reports::field_parts_test
