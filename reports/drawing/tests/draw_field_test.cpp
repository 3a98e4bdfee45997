#include "reports/drawing/draw_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <utility>

#include "reports/drawing/field_parts.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/picture_pixels.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::draw_field_test {
namespace {

constexpr Colour lowest{0x44, 0x01, 0x54}, highest{0xfd, 0xe7, 0x25};  // of the palette

// A tank with one place of the lowest value and one of the highest, 0.4 m apart, and three empty
// tanks, which keep the picture small.
FieldFigure two_places(double angle, bool upright) {
  FieldPanel panel;
  panel.label = "panel";
  panel.angle = angle;
  panel.axis_x = 0.2;
  panel.tank_length = 1;
  panel.tank_height = 0.6;
  panel.point_width = panel.point_height = 0.08;
  panel.x = {0.4, upright ? 0.4 : 0.8};
  panel.z = {0.1, upright ? 0.5 : 0.1};
  panel.value = {0, 1};
  FieldFigure figure;
  figure.id = "two-places";
  figure.title = "title";
  figure.value_label = "speed (m/s)";
  figure.value_range = {0, 1};
  figure.columns = 4;
  figure.panels.assign(4, panel);
  for (std::size_t i = 1; i < 4; ++i)
    figure.panels[i].x = figure.panels[i].z = figure.panels[i].value = {};
  return figure;
}

DrawnField drawn(const FieldFigure& figure) {
  const ScratchDirectory scratch;
  return draw_field(figure, scratch.path());
}

bool alike(const Colour& a, const Colour& b) {
  // The outermost of 64 levels differ from the palette's ends by less than 8 of 255.
  return std::abs(a[0] - b[0]) < 8 && std::abs(a[1] - b[1]) < 8 && std::abs(a[2] - b[2]) < 8;
}

struct Patch {
  double x = 0, y = 0;  // the middle, px
  int pixels = 0;
};

// Finds the pixels of one colour below the key, which holds the colour bar.
Patch patch(const PicturePixels& picture, const Colour& colour) {
  Patch found;
  for (int y = 0; y < picture.height - 100; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!alike(picture.at(x, y), colour)) continue;
      found.x += x;
      found.y += y;
      ++found.pixels;
    }
  }
  found.x /= found.pixels;
  found.y /= found.pixels;
  return found;
}

// Returns the vector [px] from the place of the lowest value to that of the highest.
std::pair<double, double> lowest_to_highest(const FieldFigure& figure) {
  const ScratchDirectory scratch;
  const PicturePixels picture =
      picture_pixels(draw_field(figure, scratch.path()).picture, scratch.path());
  const Patch from = patch(picture, lowest), to = patch(picture, highest);
  return {to.x - from.x, to.y - from.y};
}

TEST(DrawnFieldPicture, HasTheSizeThatItStates) {
  const ScratchDirectory scratch;
  const DrawnField field = draw_field(sloshing_field("size", 1, 0.01), scratch.path());
  const PicturePixels picture = picture_pixels(field.picture, scratch.path());
  EXPECT_EQ(picture.width, field.width);
  EXPECT_EQ(picture.height, field.height);
  EXPECT_GE(field.width, 1000);
  EXPECT_LE(field.width, 1400);
}

TEST(DrawnFieldPicture, HasOneScaleOnBothAxes) {
  const auto [right, no_rise] = lowest_to_highest(two_places(0, false));
  const auto [no_shift, up] = lowest_to_highest(two_places(0, true));
  EXPECT_GT(right, 100);
  EXPECT_NEAR(up, right, 1);
  EXPECT_NEAR(no_rise, 0, 1);
  EXPECT_NEAR(no_shift, 0, 1);
}

TEST(DrawnFieldPicture, TurnsATankCounterClockwiseByItsRoll) {
  for (const double angle : {-0.2, 0.15, 1.2}) {
    const auto [right, rise] = lowest_to_highest(two_places(angle, false));
    EXPECT_NEAR(std::atan2(rise, right), angle, 0.01);  // 1 px in 110
    const auto [shift, up] = lowest_to_highest(two_places(angle, true));
    EXPECT_NEAR(std::atan2(up, shift), angle + std::numbers::pi / 2, 0.01);
  }
}

TEST(DrawnFieldPicture, GivesEachPlaceItsRectangle) {
  for (const double angle : {0.0, 0.3}) {
    FieldFigure figure = two_places(angle, false);
    const double pixels_per_metre =
        std::hypot(lowest_to_highest(figure).first, lowest_to_highest(figure).second) / 0.4;
    figure.panels[0].point_width = 0.16;
    const ScratchDirectory scratch;
    const PicturePixels picture =
        picture_pixels(draw_field(figure, scratch.path()).picture, scratch.path());
    const double area = 0.16 * 0.08 * pixels_per_metre * pixels_per_metre;
    EXPECT_NEAR(patch(picture, highest).pixels, area, 0.05 * area);
    EXPECT_NEAR(patch(picture, lowest).pixels, area, 0.05 * area);
  }
}

// The places of one panel at a time in a grid of two by two, against the layout: gnuplot puts each
// panel where the layout says.
TEST(DrawnFieldPicture, HasEachPanelInItsRowAndColumn) {
  const FieldFigure empty = [] {
    FieldFigure figure = two_places(0, false);
    figure.panels[0].x = figure.panels[0].z = figure.panels[0].value = {};
    figure.columns = 2;
    return figure;
  }();
  for (int panel = 0; panel < 4; ++panel) {
    FieldFigure figure = empty;
    FieldPanel& filled = figure.panels[static_cast<std::size_t>(panel)];
    filled.x = {0.4};
    filled.z = {0.1};
    filled.value = {1};
    const FieldLayout layout = field_layout(figure);
    const ScratchDirectory scratch;
    const Patch found =
        patch(picture_pixels(draw_field(figure, scratch.path()).picture, scratch.path()), highest);
    const Pixel place = layout.in_cell(filled, 0.4, 0.1);
    const int row = panel / 2, column = panel % 2;
    EXPECT_NEAR(found.x, layout.left + column * (layout.cell_width + layout.column_gap) + place.x,
                2)
        << panel;
    const int bottom_of_cell =
        layout.height - layout.row_top(row) - layout.label_lines * label_line - layout.cell_height;
    EXPECT_NEAR(found.y, bottom_of_cell + place.y, 2) << panel;
  }
}

TEST(DrawnFieldPicture, ChangesWithItsValues) {
  FieldFigure figure = two_places(0.1, false);
  const std::string before = drawn(figure).picture;
  figure.panels[0].value = {0, 2};  // beyond the range's end: the bar says so
  EXPECT_NE(drawn(figure).picture, before);
  figure.panels[0].value = {0, 0.5};
  EXPECT_NE(drawn(figure).picture, before);
}

TEST(DrawnFieldPicture, LeavesOutWhatIsNotFinite) {
  const std::string before = drawn(two_places(0.1, false)).picture;
  for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1e301}) {
    FieldFigure figure = two_places(0.1, false);
    FieldPanel& panel = figure.panels[0];
    panel.x.insert(panel.x.end(), {0.1, value, 0.1});
    panel.z.insert(panel.z.end(), {0.2, 0.2, value});
    panel.value.insert(panel.value.end(), {value, 0.5, 0.5});
    panel.arrow_x = {0.1, value, 0.1, 0.1};
    panel.arrow_z = {0.1, 0.1, value, 0.1};
    panel.arrow_u = {value, 1, 1, 1};
    panel.arrow_w = {1, 1, 1, value};
    EXPECT_EQ(drawn(figure).picture, before) << value;
  }
}

TEST(DrawnFieldPicture, ShowsArrowsInTheTanksDirections) {
  FieldFigure still = two_places(0, false);
  still.panels[0].x = still.panels[0].z = still.panels[0].value = {};
  still.arrow_scale = 0.2;
  FieldFigure moving = still;
  moving.panels[0].arrow_x = {0.5};
  moving.panels[0].arrow_z = {0.25};
  moving.panels[0].arrow_u = {-1};
  moving.panels[0].arrow_w = {0};
  const ScratchDirectory scratch;
  const PicturePixels without =
                          picture_pixels(draw_field(still, scratch.path()).picture, scratch.path()),
                      with = picture_pixels(draw_field(moving, scratch.path()).picture,
                                            scratch.path());
  int leftmost = with.width, rightmost = 0, lowest_row = with.height, highest_row = 0;
  for (int y = 0; y < with.height - 100; ++y) {
    for (int x = 0; x < with.width; ++x) {
      if (with.at(x, y) == without.at(x, y)) continue;
      leftmost = std::min(leftmost, x);
      rightmost = std::max(rightmost, x);
      lowest_row = std::min(lowest_row, y);
      highest_row = std::max(highest_row, y);
    }
  }
  const FieldLayout layout = field_layout(moving);
  const Pixel tail = layout.in_cell(moving.panels[0], 0.5, 0.25);
  EXPECT_NEAR(rightmost - leftmost, 0.2 * layout.scale, 4);
  EXPECT_NEAR(rightmost, layout.left + tail.x, 3);
  EXPECT_NEAR(highest_row + lowest_row, 2 * (row_gap + tail.y), 6);
  EXPECT_LT(highest_row - lowest_row, 12);
}

TEST(DrawnFieldPicture, SurvivesValuesThatAreNearlyEqualHugeTinyOrNoneAndRunsNothingInALabel) {
  const ScratchDirectory scratch;
  const auto trap = scratch / "trap";
  for (const std::vector<double>& values : std::vector<std::vector<double>>{{1000.0, 1000 + 1e-9},
                                                                            {-9e299, 9e299},
                                                                            {1e-320, 1e-310},
                                                                            {0.0, 1e-320},
                                                                            {-5.0, -5.0},
                                                                            {}}) {
    FieldFigure figure = two_places(0, false);
    FieldPanel& panel = figure.panels[0];
    panel.x.resize(values.size());
    panel.z.resize(values.size());
    panel.value = panel.arrow_u = panel.arrow_w = values;
    panel.arrow_x = panel.arrow_z = std::vector<double>(values.size(), 0.1);
    figure.value_range = {0, 0};
    figure.value_label = panel.label =
        "it's `touch " + trap.string() + "` @x \"black\" {a}_b^c\n\x01";
    EXPECT_GT(draw_field(figure, scratch.path()).picture.size(), 1000u);
    EXPECT_FALSE(std::filesystem::exists(trap));
  }
}

TEST(FieldDescription, NamesThePanelsTheQuantityAndItsRange) {
  FieldFigure figure = two_places(0, false);
  figure.panels[0].value = {-3, 0.5};
  EXPECT_EQ(description(figure),
            "title. Panels: panel; panel; panel; panel. Colour: speed (m/s) from ≤ 0 to 1.");
}

TEST(DataAddress, IsBase64OfThePictureOfItsKind) {
  FieldFigure figure = two_places(0, false);
  EXPECT_EQ(data_address(figure, {"foobar", 1, 1}), "data:image/png;base64,Zm9vYmFy");
  figure.is_animation = true;
  EXPECT_EQ(data_address(figure, {"\xff\xfe\x80", 1, 1}), "data:image/gif;base64,//6A");
}

std::size_t frames_of(const std::string& gif) {  // each has a graphic control extension
  std::size_t count = 0;
  const std::string control = "\x21\xf9\x04";
  for (auto at = gif.find(control); at != gif.npos; at = gif.find(control, at + 1)) ++count;
  return count;
}

TEST(DrawnAnimation, HasAFrameForEachRowInOneFile) {
  const FieldFigure animation = sloshing_animation("flow", 5, 2, 0.02);
  const DrawnField picture = drawn(animation);
  EXPECT_EQ(frames_of(picture.picture), 5u);
  const auto size = [&](std::size_t place) {  // little-endian, of the logical screen
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(picture.picture[i]); };
    return byte(place) + 256 * byte(place + 1);
  };
  EXPECT_EQ(size(6), picture.width);
  EXPECT_EQ(size(8), picture.height);
  EXPECT_EQ(picture_file(animation), "flow.gif");
  EXPECT_FALSE(holds(description(animation), "225 cs"));
}

TEST(IncompletePicture, IsAnErrorThatNamesTheFigure) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "gnuplot") << "#!/bin/sh\nprintf '\\211PNG\\r\\n\\032\\n'\n";
  std::filesystem::permissions(scratch / "gnuplot", std::filesystem::perms::owner_all);
  const PathVariable path(scratch.path().string());
  FieldFigure figure = two_places(0, false);
  for (const char* kind : {"complete PNG file", "complete GIF file"}) {
    const std::string error = message_of<ReportError>([&] { draw_field(figure, scratch.path()); });
    EXPECT_TRUE(holds(error, "'two-places'"));
    EXPECT_TRUE(holds(error, kind));
    figure.is_animation = true;
  }
}

}  // namespace
}  // namespace slosh::reports::draw_field_test
