#include "reports/fields/field_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh::reports {
namespace {

// In half sizes of a place: how far it may fill a gap, and within which distance there must be
// others beyond the gap.
constexpr double filling_reach = 1.8, reach = 2.4;

int colour_level(double value, const ColourRange& range) {
  // Halved first: the difference of two finite ends may overflow.
  const double fraction = (value / 2 - range.lower / 2) / (range.upper / 2 - range.lower / 2);
  return static_cast<int>(std::clamp(fraction * colour_levels, 0.0, colour_levels - 1.0));
}

// All pixels of a panel's cell.
class CellPixels {
 public:
  CellPixels(const FieldPanel& panel, const PlacedPanel& placed)
      : placed_(placed),
        width_(static_cast<int>(placed.width)),
        height_(static_cast<int>(placed.height)),
        half_width_(panel.point_width * placed.scale / 2),
        half_height_(panel.point_height * placed.scale / 2),
        pixels_(static_cast<std::size_t>(width_ * height_)) {
    const double cosine = std::abs(placed.cosine), sine = std::abs(placed.sine);
    reach_x_ = reach * (cosine * half_width_ + sine * half_height_);
    reach_y_ = reach * (sine * half_width_ + cosine * half_height_);
  }

  void add(const Pixel& centre, int level) {
    const double x = centre.x - placed_.left, y = centre.y - placed_.bottom;
    const int last_column = static_cast<int>(std::min(width_ - 1.0, x + reach_x_)),
              last_row = static_cast<int>(std::min(height_ - 1.0, y + reach_y_));
    for (int row = static_cast<int>(std::max(0.0, y - reach_y_)); row <= last_row; ++row) {
      for (int column = static_cast<int>(std::max(0.0, x - reach_x_)); column <= last_column;
           ++column) {
        offer(at(column, row), column + 0.5 - x, row + 0.5 - y, level);
      }
    }
    PixelState& own = at(static_cast<int>(x), static_cast<int>(y));
    if (own.distance > 1) own = {1, level, own.sides};
  }

  FieldRaster raster() const {
    int left = width_, right = -1, bottom = height_, top = -1;
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        if (!shown(at(column, row))) continue;
        left = std::min(left, column);
        right = std::max(right, column);
        bottom = std::min(bottom, row);
        top = row;
      }
    }
    if (right < 0) return {};
    FieldRaster drawn{static_cast<int>(placed_.left) + left,
                      static_cast<int>(placed_.bottom) + bottom,
                      right - left + 1,
                      top - bottom + 1,
                      {}};
    for (int row = bottom; row <= top; ++row) {
      for (int column = left; column <= right; ++column)
        drawn.levels.push_back(shown(at(column, row)) ? at(column, row).level : no_level);
    }
    return drawn;
  }

 private:
  struct PixelState {
    double distance = std::numeric_limits<double>::infinity();  // to its place, in half sizes
    int level = no_level;
    unsigned sides = 0;  // a bit a quarter of the plane: where places that reach the pixel lie
  };

  PixelState& at(int column, int row) {
    return pixels_[static_cast<std::size_t>(row * width_ + column)];
  }
  const PixelState& at(int column, int row) const {
    return pixels_[static_cast<std::size_t>(row * width_ + column)];
  }

  // The pixel's centre lies (from_x, from_y) from the place's.
  void offer(PixelState& pixel, double from_x, double from_y, int level) const {
    const double along = placed_.cosine * from_x + placed_.sine * from_y,
                 across = placed_.cosine * from_y - placed_.sine * from_x;
    const double distance =
        std::max(std::abs(along) / half_width_, std::abs(across) / half_height_);
    if (!(distance <= reach)) return;
    pixel.sides |= 1U << ((along > 0 ? 1 : 0) + (across > 0 ? 2 : 0));
    if (distance <= filling_reach && distance < pixel.distance) {
      pixel.distance = distance;
      pixel.level = level;
    }
  }

  // Under a rectangle, or in a gap: with places on opposite sides, which no pixel beyond a straight
  // edge of the water has.
  static bool shown(const PixelState& pixel) {
    constexpr unsigned one_diagonal = 0b1001, other_diagonal = 0b0110;
    if (pixel.distance <= 1) return true;
    if (pixel.level == no_level) return false;
    return (pixel.sides & one_diagonal) == one_diagonal ||
           (pixel.sides & other_diagonal) == other_diagonal;
  }

  const PlacedPanel& placed_;
  int width_, height_;
  double half_width_, half_height_, reach_x_, reach_y_;  // px
  std::vector<PixelState> pixels_;
};

}  // namespace

FieldRaster field_raster(const FieldPanel& panel, const PlacedPanel& placed,
                         const ColourRange& range) {
  CellPixels pixels(panel, placed);
  for (std::size_t i = 0; i < panel.x.size(); ++i) {
    if (!is_drawn(panel.x[i]) || !is_drawn(panel.z[i]) || !is_drawn(panel.value[i])) continue;
    const Pixel centre = placed.on_canvas(panel.x[i], panel.z[i]);
    if (placed.holds(centre)) pixels.add(centre, colour_level(panel.value[i], range));
  }
  return pixels.raster();
}

}  // namespace slosh::reports
