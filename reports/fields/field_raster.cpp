#include "reports/fields/field_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh::reports {
namespace {

// In half sizes of a place: how far it may fill a gap, and within which distance there must be
// others beyond the gap.
constexpr double filling_reach = 1.8, reach = 2.4;

constexpr std::ptrdiff_t fewest_rows = 2;  // of an image that gnuplot draws

int colour_level(double value, const ColourRange& range) {
  const double fraction = (value - range.lower) / (range.upper - range.lower);
  return static_cast<int>(std::clamp(fraction * colour_levels, 0.0, colour_levels - 1.0));
}

struct PixelState {
  double distance = std::numeric_limits<double>::infinity();  // to its place, in half sizes
  int level = no_level;
  unsigned sides = 0;  // one bit per quadrant in which a place within reach lies

  // The pixel is under a rectangle, or in a gap: places lie on opposite sides of it, which is
  // never so beyond a straight edge of the water.
  bool is_shown() const {
    constexpr unsigned one_diagonal = 0b1001, other_diagonal = 0b0110;
    return distance <= 1 || (level != no_level && ((sides & one_diagonal) == one_diagonal ||
                                                   (sides & other_diagonal) == other_diagonal));
  }
};

}  // namespace

std::vector<int> field_raster(const FieldPanel& panel, const FieldLayout& layout,
                              const ColourRange& range) {
  const int width = layout.cell_width, height = layout.cell_height;
  std::vector<PixelState> pixels(static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
  const auto at = [&](int column, int row) -> PixelState& {
    const int place = row * width + column;
    return pixels[static_cast<std::size_t>(place)];
  };
  const double cosine = std::cos(panel.angle), sine = std::sin(panel.angle);
  const double half_width = panel.point_width * layout.scale / 2,
               half_height = panel.point_height * layout.scale / 2;
  const double reach_x = reach * (std::abs(cosine) * half_width + std::abs(sine) * half_height),
               reach_y = reach * (std::abs(sine) * half_width + std::abs(cosine) * half_height);
  for (std::size_t i = 0; i < panel.x.size(); ++i) {
    if (!is_drawn(panel.x[i]) || !is_drawn(panel.z[i]) || !is_drawn(panel.value[i])) continue;
    const auto [x, y] = layout.in_cell(panel, panel.x[i], panel.z[i]);
    if (!layout.holds({x, y})) continue;
    const int level = colour_level(panel.value[i], range);
    const int last_column = static_cast<int>(std::min(width - 1.0, x + reach_x)),
              last_row = static_cast<int>(std::min(height - 1.0, y + reach_y)),
              first_column = static_cast<int>(std::max(0.0, x - reach_x));
    for (int row = static_cast<int>(std::max(0.0, y - reach_y)); row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const double from_x = column + 0.5 - x, from_y = row + 0.5 - y;
        const double along = cosine * from_x + sine * from_y,
                     across = cosine * from_y - sine * from_x;
        const double distance =
            std::max(std::abs(along) / half_width, std::abs(across) / half_height);
        if (!(distance <= reach)) continue;
        PixelState& pixel = at(column, row);
        pixel.sides |= 1U << ((along > 0 ? 1 : 0) + (across > 0 ? 2 : 0));
        if (distance > filling_reach || distance >= pixel.distance) continue;
        pixel.distance = distance;
        pixel.level = level;
      }
    }
    PixelState& own = at(static_cast<int>(x), static_cast<int>(y));
    if (own.distance > 1) own = {1, level, own.sides};
  }
  std::vector<int> levels;
  for (const PixelState& pixel : pixels)
    levels.push_back(pixel.is_shown() ? pixel.level : no_level);
  const auto is_level = [](int level) { return level != no_level; };
  const auto filled = std::find_if(levels.rbegin(), levels.rend(), is_level).base();
  const auto rows = (filled - levels.begin() + width - 1) / width;
  levels.resize(static_cast<std::size_t>(width * std::max(rows, fewest_rows)));
  return levels;
}

}  // namespace slosh::reports
