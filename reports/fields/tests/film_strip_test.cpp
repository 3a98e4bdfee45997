// Tests the picture that holds an animation's frames: what stands where, and what it weighs.
#include "reports/fields/film_strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "reports/fields/indexed_png.hpp"
#include "reports/model/file_formats.hpp"
#include "reports/tests/picture_pixels.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::film_strip_test {
namespace {

PicturePixels decoded(const std::string& png) {
  const ScratchDirectory scratch;
  return picture_pixels(png, scratch.path());
}

TEST(IndexedPng, IsReadBackPixelByPixel) {
  const std::string png =
      indexed_png({3, 2, {"#ff0000", "#00ff00", "#0000ff"}, {0, 1, 2, 2, 1, 0}});
  EXPECT_TRUE(is_whole_png(png));
  const PicturePixels picture = decoded(png);
  ASSERT_EQ(picture.width, 3);
  ASSERT_EQ(picture.height, 2);
  EXPECT_EQ(picture.at(0, 1), (Colour{255, 0, 0}));  // the upper row
  EXPECT_EQ(picture.at(1, 1), (Colour{0, 255, 0}));
  EXPECT_EQ(picture.at(2, 1), (Colour{0, 0, 255}));
  EXPECT_EQ(picture.at(0, 0), (Colour{0, 0, 255}));
}

// Tanks with one square place, of the highest value, in a single panel.
FieldFigure one_place(std::size_t panel) {
  FieldFigure figure = sloshing_film("film", 3, 2, 0.05);
  for (FieldPanel& each : figure.panels) {
    each.x = each.z = each.value = {};
    each.arrow_x = each.arrow_z = each.arrow_u = each.arrow_w = {};
    each.angle = 0;
  }
  figure.value_range = {0, 1};
  figure.panels[panel].x = {0.2};
  figure.panels[panel].z = {0.1};
  figure.panels[panel].value = {1};
  return figure;
}

TEST(FilmStrip, HasEachMomentInItsRowAndEachRunInItsColumn) {
  for (std::size_t panel = 0; panel < 6; ++panel) {
    const FieldFigure figure = one_place(panel);
    const FilmStrip strip = film_strip(figure);
    const PicturePixels picture = decoded(strip.png);
    const FieldLayout& layout = strip.layout;
    EXPECT_EQ(picture.width, 2 * layout.cell_width);
    EXPECT_EQ(picture.height, 3 * layout.cell_height);
    double x = 0, y = 0, count = 0;
    for (int row = 0; row < picture.height; ++row)
      for (int column = 0; column < picture.width; ++column)
        if (picture.at(column, row) == Colour{0xfd, 0xe7, 0x25}) {
          x += column + 0.5;
          y += row + 0.5;
          ++count;
        }
    const Pixel place = layout.in_cell(figure.panels[panel], 0.2, 0.1);
    const auto moment = static_cast<int>(panel) / 2, run = static_cast<int>(panel) % 2;
    EXPECT_NEAR(x / count, run * layout.cell_width + place.x, 1) << panel;
    EXPECT_NEAR(y / count, (2 - moment) * layout.cell_height + place.y, 1) << panel;
    EXPECT_NEAR(count, std::pow(0.05 * layout.scale, 2), 0.1 * std::pow(0.05 * layout.scale, 2));
  }
}

TEST(FilmStrip, DrawsArrowsFromTheirTailToTheirHead) {
  FieldFigure figure = one_place(0);
  const FilmStrip still = film_strip(figure);
  figure.panels[0].arrow_x = {0.3};
  figure.panels[0].arrow_z = {0.2};
  figure.panels[0].arrow_u = {1};
  figure.panels[0].arrow_w = {0};
  const FilmStrip strip = film_strip(figure);
  const PicturePixels before = decoded(still.png), after = decoded(strip.png);
  int left = after.width, right = 0;
  for (int row = 0; row < after.height; ++row)
    for (int column = 0; column < after.width; ++column)
      if (after.at(column, row) != before.at(column, row)) {
        left = std::min(left, column);
        right = std::max(right, column);
      }
  const DrawnArrow& arrow = strip.arrows.panels.at(0).at(0);
  EXPECT_NEAR(left, arrow.tail.x, 1.5);
  EXPECT_NEAR(right, arrow.tail.x + arrow.length.x, 1.5);
  EXPECT_GT(arrow.length.x, 10);
}

TEST(FilmStrip, OfAFewMomentsHasThemAllAtFullSize) {
  const FilmStrip strip = film_strip(sloshing_film("film", 4, 3, 0.03));
  EXPECT_EQ(strip.moments, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(strip.poster, 2u);
  EXPECT_EQ(strip.layout.cell_width, strip.shown_width);
  EXPECT_LE(strip.layout.cell_height, 240);
}

TEST(FilmStrip, ThatIsTooHeavyHasSmallerCellsAndThenFewerMoments) {
  const FieldFigure figure = sloshing_film("film", 7, 3, 0.03);
  const FilmStrip full = film_strip(figure);
  const FilmStrip smaller = film_strip(figure, full.png.size() * 8 / 10);
  EXPECT_EQ(smaller.moments, full.moments);
  EXPECT_LT(smaller.layout.cell_width, full.layout.cell_width);
  EXPECT_EQ(smaller.shown_width, full.shown_width);
  EXPECT_LE(smaller.png.size(), full.png.size() * 8 / 10);
  const FilmStrip fewer = film_strip(figure, full.png.size() / 4);
  EXPECT_LE(fewer.png.size(), full.png.size() / 4);
  EXPECT_LT(fewer.moments.size(), 7u);
  EXPECT_EQ(fewer.moments.at(fewer.poster), 2u) << "the poster is always among them";
  EXPECT_GE(fewer.layout.cell_width, 0.59 * full.layout.cell_width);
  EXPECT_EQ(film_strip(figure, 1).moments, (std::vector<std::size_t>{2}));
}

TEST(FilmPoster, IsTheMomentsRowInTheColoursOfTheFilm) {
  FieldFigure figure = sloshing_film("film", 4, 2, 0.05);
  const FieldFigure poster = poster_of(figure);
  EXPECT_FALSE(poster.film);
  ASSERT_EQ(poster.panels.size(), 2u);
  EXPECT_EQ(poster.panels[0].label, figure.panels[4].label);
  EXPECT_EQ(poster.value_range,
            (std::pair{colour_range(figure).lower, colour_range(figure).upper}));
  EXPECT_EQ(poster.title, "The flow in the rolling tank: t = 250 cs");
}

}  // namespace
}  // namespace slosh::reports::film_strip_test
