#include "reports/fields/film_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "reports/drawing/figure_palette.hpp"
#include "reports/fields/field_raster.hpp"
#include "reports/fields/indexed_png.hpp"
#include "reports/fields/tank_line.hpp"

namespace slosh::reports {
namespace {

constexpr int page_width = 1208;           // [px], of a column of text at a desk
constexpr int highest_cell = 240;          // [px]: panels, controls and history fit one screen
constexpr double smallest_size = 0.6;      // of a cell's full size
constexpr int levels = colour_levels / 2;  // a quarter lighter than with all of them
constexpr double head_length = 5;          // [px], of an arrow
constexpr double head_angle = 22 * std::numbers::pi / 180;

enum Colour : std::uint8_t { air = levels, outline, dark };

std::string mixed(const std::string& from, const std::string& to, double share) {
  std::string colour = "#";
  for (const std::size_t channel : {1, 3, 5}) {
    const auto value = [&](const std::string& text) {
      return std::stoi(text.substr(channel, 2), nullptr, 16);
    };
    colour += fmt::format("{:02x}", std::lround(value(from) + share * (value(to) - value(from))));
  }
  return colour;
}

// A cell of the picture, whose pixels are counted from its lower left corner.
class Cell {
 public:
  Cell(IndexedPicture& picture, const FieldLayout& layout, std::size_t number)
      : picture_(picture),
        layout_(layout),
        left_(static_cast<int>(number) % layout.columns * layout.cell_width),
        bottom_((static_cast<int>(number) / layout.columns + 1) * layout.cell_height - 1) {}

  void set(int x, int y, int colour) {
    if (x < 0 || x >= layout_.cell_width || y < 0 || y >= layout_.cell_height) return;
    const int place = (bottom_ - y) * picture_.width + left_ + x;
    picture_.pixels[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(colour);
  }

  // `thickness` is 1 or 3 px.
  void line(const Pixel& from, const Pixel& to, int thickness, int colour) {
    const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const int steps = std::max(1, static_cast<int>(std::ceil(length)));
    const int reach = thickness / 2;
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const int x = static_cast<int>(std::floor(from.x + share * (to.x - from.x))),
                y = static_cast<int>(std::floor(from.y + share * (to.y - from.y)));
      for (int across = -reach; across <= reach; ++across)
        for (int up = -reach; up <= reach; ++up) set(x + across, y + up, colour);
    }
  }

  void arrow(const DrawnArrow& arrow, int thickness, int colour) {
    const Pixel head{arrow.tail.x + arrow.length.x, arrow.tail.y + arrow.length.y};
    line(arrow.tail, head, thickness, colour);
    const double back = std::atan2(-arrow.length.y, -arrow.length.x);
    for (const double angle : {back - head_angle, back + head_angle})
      line(head, {head.x + head_length * std::cos(angle), head.y + head_length * std::sin(angle)},
           thickness, colour);
  }

 private:
  IndexedPicture& picture_;
  const FieldLayout& layout_;
  int left_, bottom_;
};

void draw_tank(const FieldPanel& panel, const FieldLayout& layout, Cell& cell) {
  const std::vector<Pixel> corners = tank_line(panel, layout);
  for (std::size_t i = 0; i < corners.size(); ++i)
    cell.line(corners[i], corners[(i + 1) % corners.size()], 1, outline);
}

// An arrow is dark above a white edge, so that it shows on every colour.
void draw_panel(const FieldPanel& panel, const std::vector<DrawnArrow>& arrows,
                const FieldLayout& layout, const ColourRange& range, Cell cell) {
  const std::vector<int> raster = field_raster(panel, layout, range);
  for (std::size_t i = 0; i < raster.size(); ++i)
    if (raster[i] != no_level)
      cell.set(static_cast<int>(i) % layout.cell_width, static_cast<int>(i) / layout.cell_width,
               raster[i] * levels / colour_levels);
  draw_tank(panel, layout, cell);
  for (const DrawnArrow& arrow : arrows) cell.arrow(arrow, 3, air);
  for (const DrawnArrow& arrow : arrows) cell.arrow(arrow, 1, dark);
}

IndexedPicture picture_of(const FieldFigure& figure, const FilmStrip& strip) {
  const FieldLayout& layout = strip.layout;
  IndexedPicture picture{layout.width, layout.height, film_colours(), {}};
  for (const PaletteColour& colour : {paper, faint_ink, ink})
    picture.palette.push_back(colour.light);
  picture.pixels.assign(static_cast<std::size_t>(layout.width * layout.height), air);
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    draw_panel(figure.panels[i], strip.arrows.panels[i], layout, strip.range,
               Cell(picture, layout, i));
  return picture;
}

FieldFigure with_rows(FieldFigure figure, const std::vector<std::size_t>& rows) {
  const auto columns = static_cast<std::size_t>(figure.columns);
  std::vector<FieldPanel> kept;
  for (const std::size_t row : rows)
    for (std::size_t column = 0; column < columns; ++column)
      kept.push_back(std::move(figure.panels[row * columns + column]));
  figure.panels = std::move(kept);
  return figure;
}

// Every stride-th row, the poster among them.
std::vector<std::size_t> every(std::size_t stride, const Film& film) {
  std::vector<std::size_t> rows;
  for (std::size_t row = film.poster % stride; row < film.times.size(); row += stride)
    rows.push_back(row);
  return rows;
}

}  // namespace

std::vector<std::string> film_colours() {
  std::vector<std::string> colours;
  for (int level = 0; level < levels; ++level) {
    const double place = (field_colours.size() - 1.0) * level / (levels - 1);
    const auto below = std::min(static_cast<std::size_t>(place), field_colours.size() - 2);
    colours.push_back(
        mixed(field_colours[below], field_colours[below + 1], place - static_cast<double>(below)));
  }
  return colours;
}

FilmStrip film_strip(const FieldFigure& figure, std::size_t heaviest) {
  const int across = std::min(figure.columns, film_columns);
  const int widest_cell = (page_width - (across - 1) * film_gap) / across;
  FilmStrip strip{};
  strip.range = colour_range(figure);
  strip.shown_width = bare_layout(figure, highest_cell, widest_cell).cell_width;
  for (std::size_t stride = 1;; ++stride) {
    strip.moments = every(stride, *figure.film);
    strip.poster = figure.film->poster / stride;
    const FieldFigure shown = with_rows(figure, strip.moments);
    for (double size = 1;;) {
      strip.layout = bare_layout(shown, static_cast<int>(size * highest_cell),
                                 static_cast<int>(size * widest_cell));
      strip.arrows = field_arrows(shown, strip.layout);
      strip.png = indexed_png(picture_of(shown, strip));
      if (strip.png.size() <= heaviest || strip.moments.size() == 1) return strip;
      if (size == smallest_size) break;
      const double lighter =
          std::sqrt(static_cast<double>(heaviest) / static_cast<double>(strip.png.size()));
      size = std::max(smallest_size, size * std::min(0.95, lighter));
    }
  }
}

FieldFigure poster_of(const FieldFigure& figure) {
  FieldFigure still = with_rows(figure, {figure.film->poster});
  const ColourRange range = colour_range(figure);
  still.value_range = {range.lower, range.upper};
  still.title += ": " + figure.film->labels[figure.film->poster];
  still.film.reset();
  return still;
}

}  // namespace slosh::reports
