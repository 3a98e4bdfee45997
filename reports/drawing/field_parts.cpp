#include "reports/drawing/field_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "reports/drawing/figure_layout.hpp"

namespace slosh::reports {
namespace {

constexpr double largest_drawn_value = 1e300;
constexpr double robust_fraction = 0.01;  // of the values, left out at either end
constexpr double narrowest_range = 1e-9;  // of the values: more uniform fields get a wider range
constexpr int fewest_steps = 5;           // between the ticks of a bar
constexpr double letter_width = 7.6;      // [px], of gnuplot's 'sans,12'
constexpr double label_gap = 10;          // [px], between the labels of two ticks

// Whether a quantity of a field can be drawn: it is finite and not a diverged 1e300, which
// overflows in sums.
bool is_drawn(double value) { return std::abs(value) < largest_drawn_value; }

// The value below which the given fraction of the samples lies. Reorders the samples, of which
// there must be at least one.
double percentile(std::vector<double>& samples, double fraction) {
  const auto rank = std::llround(fraction * static_cast<double>(samples.size() - 1));
  const auto place = samples.begin() + rank;
  std::nth_element(samples.begin(), place, samples.end());
  return *place;
}

// The smallest range that holds both values and ends at multiples of its step.
ColourRange rounded(double lower, double upper) {
  const double step = round_tick((upper - lower) / fewest_steps, false);
  // A value that differs from a multiple by rounding errors alone is that multiple.
  const double slack = 1e-6;
  return {step * std::floor(lower / step + slack), step * std::ceil(upper / step - slack), step, "",
          ""};
}

ColourRange automatic_range(std::vector<double>& samples) {
  if (samples.empty()) return rounded(0, 1);
  const double lower = percentile(samples, robust_fraction),
               upper = percentile(samples, 1 - robust_fraction);
  if (is_range(lower, upper)) return rounded(lower, upper);
  const double size = std::max(std::abs(lower), std::abs(upper));
  const double half = size > 1 / largest_drawn_value ? size / 2 : 0.5;
  return rounded(lower - half, upper + half);
}

constexpr int widest_canvas = 1200;      // [px]: a page's column has 1112
constexpr int narrowest_canvas = 1000;   // [px]: the key's parts stand side by side
constexpr int tallest_cell = 560;        // [px]: two rows of the tallest tanks fit one screen
constexpr int widest_frame = 340;        // [px], a cell of an animation: dozens of them are drawn
constexpr int smallest_gap = 28;         // [px], between two columns; half of it at the sides
constexpr double wall = 3;               // [px], between a tank and its cell's edge
constexpr double round_off = 1e-9;       // [px]
constexpr double label_character = 8.8;  // [px], of gnuplot's 'sans,12' on average (measured)

// The rectangle that holds all tanks as they are rolled [m from the axis].
struct PlotExtent {
  double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;
};

PlotExtent rolled_tanks(const FieldFigure& figure) {
  PlotExtent extent;
  for (const FieldPanel& panel : figure.panels) {
    const double cosine = std::cos(panel.angle), sine = std::sin(panel.angle);
    for (const double x : {-panel.axis_x, panel.tank_length - panel.axis_x}) {
      for (const double z : {-panel.axis_z, panel.tank_height - panel.axis_z}) {
        extent.left = std::min(extent.left, cosine * x - sine * z);
        extent.right = std::max(extent.right, cosine * x - sine * z);
        extent.bottom = std::min(extent.bottom, sine * x + cosine * z);
        extent.top = std::max(extent.top, sine * x + cosine * z);
      }
    }
  }
  return extent;
}

// The grid, and the cells as large as they may be.
FieldLayout grid_of_cells(const FieldFigure& figure, double highest_tank, double widest_tank) {
  FieldLayout layout{};
  const int panels = static_cast<int>(figure.panels.size());
  layout.columns = std::min(figure.columns, panels);
  layout.rows = (panels + layout.columns - 1) / layout.columns;
  const PlotExtent extent = rolled_tanks(figure);
  const double width = extent.right - extent.left, height = extent.top - extent.bottom;
  layout.scale = std::min(widest_tank / width, highest_tank / height);
  layout.cell_width = static_cast<int>(std::ceil(layout.scale * width + 2 * wall - round_off));
  layout.cell_height = static_cast<int>(std::ceil(layout.scale * height + 2 * wall - round_off));
  layout.axis = {wall - layout.scale * extent.left, wall - layout.scale * extent.bottom};
  return layout;
}

constexpr double smallest_square = 26;  // [px]
constexpr double typical_length = 1.8;  // squares
constexpr double longest_arrow = 3;     // squares: longer ones of a jet would hide its surroundings
constexpr double shortest_arrow = 2;    // [px]: a dot shows no direction
constexpr double slowest = 1e-200;      // [m/s]: water at rest; the inverse does not overflow
constexpr double legend_length = 75;    // [px], at most

double length_of(const Pixel& vector) { return std::hypot(vector.x, vector.y); }

// The arrows of a panel at 1 px per tank's pixel and second.
std::vector<DrawnArrow> drawable_arrows(const FieldPanel& panel, const FieldLayout& layout) {
  std::vector<DrawnArrow> arrows;
  for (std::size_t i = 0; i < panel.arrow_x.size(); ++i) {
    if (!is_drawn(panel.arrow_x[i]) || !is_drawn(panel.arrow_z[i]) || !is_drawn(panel.arrow_u[i]) ||
        !is_drawn(panel.arrow_w[i])) {
      continue;
    }
    const Pixel tail = layout.in_cell(panel, panel.arrow_x[i], panel.arrow_z[i]);
    if (layout.holds(tail))
      arrows.push_back({tail, layout.turned(panel, panel.arrow_u[i], panel.arrow_w[i])});
  }
  return arrows;
}

std::vector<DrawnArrow> one_per_square(const std::vector<DrawnArrow>& arrows, double square) {
  std::map<std::pair<double, double>, std::pair<double, DrawnArrow>> nearest;
  for (const DrawnArrow& arrow : arrows) {
    const double column = std::floor(arrow.tail.x / square),
                 row = std::floor(arrow.tail.y / square);
    const double distance =
        length_of({arrow.tail.x - (column + 0.5) * square, arrow.tail.y - (row + 0.5) * square});
    const auto [kept, is_new] = nearest.try_emplace({column, row}, distance, arrow);
    if (!is_new && distance < kept->second.first) kept->second = {distance, arrow};
  }
  std::vector<DrawnArrow> kept;
  for (const auto& [place, arrow] : nearest) kept.push_back(arrow.second);
  return kept;
}

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

bool is_range(double lower, double upper) {
  const double size = std::max(std::abs(lower), std::abs(upper));
  return is_drawn(lower) && is_drawn(upper) &&
         upper - lower > std::max(narrowest_range * size, 1 / largest_drawn_value);
}

std::string bar_label(double value) {
  return boost::replace_all_copy(fmt::format("{:.6g}", value), "-", "−");
}

BarTicks bar_ticks(const ColourRange& range, double bar_length) {
  const double value_of_pixel = (range.upper - range.lower) / bar_length;
  // Half of both labels beside each other and a gap, as a difference of values.
  const auto room = [&](const std::string& end, double neighbour) {
    const double labels = text_width(end + bar_label(neighbour), letter_width);
    return (labels / 2 + label_gap) * value_of_pixel;
  };
  const auto multiple = [&](double steps) { return range.step * steps; };
  BarTicks ticks{multiple(std::floor(range.lower / range.step) + 1),
                 multiple(std::ceil(range.upper / range.step) - 1)};
  while (ticks.first - range.lower < room(range.lower_label, ticks.first) &&
         ticks.first < range.upper)
    ticks.first += range.step;
  while (range.upper - ticks.last < room(range.upper_label, ticks.last) && ticks.last > range.lower)
    ticks.last -= range.step;
  return ticks;
}

ColourRange colour_range(const FieldFigure& figure) {
  std::vector<double> samples;
  for (const FieldPanel& panel : figure.panels)
    std::copy_if(panel.value.begin(), panel.value.end(), std::back_inserter(samples), is_drawn);
  const auto [lower, upper] = figure.value_range;
  ColourRange range =
      lower == upper
          ? automatic_range(samples)
          : ColourRange{lower, upper, round_tick((upper - lower) / fewest_steps, false), "", ""};
  const auto is_below = [&](double value) { return value < range.lower; };
  const auto is_above = [&](double value) { return value > range.upper; };
  range.lower_label =
      (std::any_of(samples.begin(), samples.end(), is_below) ? "≤ " : "") + bar_label(range.lower);
  range.upper_label =
      (std::any_of(samples.begin(), samples.end(), is_above) ? "≥ " : "") + bar_label(range.upper);
  return range;
}

double scale_bar_length(const FieldLayout& layout, double longest) {
  return round_tick(longest / layout.scale, false);
}

std::string scale_bar_text(double length) {
  return length < 1 ? fmt::format("{:.6g} mm", 1000 * length) : fmt::format("{:.6g} m", length);
}

int most_columns() { return widest_canvas / (smallest_gap + 2 * static_cast<int>(wall) + 1); }

int FieldLayout::row_height() const { return label_lines * label_line + cell_height + row_gap; }

int FieldLayout::row_top(int row) const { return key_height + row * row_height(); }

Pixel FieldLayout::turned(const FieldPanel& panel, double along_x, double along_z) const {
  const double cosine = std::cos(panel.angle), sine = std::sin(panel.angle);
  return {scale * (cosine * along_x - sine * along_z), scale * (sine * along_x + cosine * along_z)};
}

Pixel FieldLayout::in_cell(const FieldPanel& panel, double x, double z) const {
  const Pixel from_axis = turned(panel, x - panel.axis_x, z - panel.axis_z);
  return {axis.x + from_axis.x, axis.y + from_axis.y};
}

bool FieldLayout::holds(const Pixel& place) const {
  return place.x >= 0 && place.x < cell_width && place.y >= 0 && place.y < cell_height;
}

FieldLayout field_layout(const FieldFigure& figure) {
  const int columns = std::min(figure.columns, static_cast<int>(figure.panels.size()));
  const int widest = widest_canvas / columns - smallest_gap;
  FieldLayout layout =
      grid_of_cells(figure, tallest_cell - 2 * wall,
                    (figure.is_animation ? std::min(widest, widest_frame) : widest) - 2 * wall);
  layout.width = std::clamp(layout.columns * (layout.cell_width + smallest_gap), narrowest_canvas,
                            widest_canvas);
  layout.column_gap = layout.width / layout.columns - layout.cell_width;
  layout.left = layout.column_gap / 2;
  for (const FieldPanel& panel : figure.panels) {
    layout.labels.push_back(wrapped(panel.label, layout.cell_width, label_character));
    layout.label_lines =
        std::max(layout.label_lines, static_cast<int>(layout.labels.back().size()));
  }
  layout.height = layout.row_top(layout.rows);
  return layout;
}

std::string arrow_text(const FieldArrows& arrows) {
  if (!(arrows.pixels_per_speed > 0)) return "";
  return fmt::format("{:.6g} m/s", arrows.legend_speed) +
         (arrows.cut_speed > 0 ? fmt::format(" (cut at {:.2g} m/s)", arrows.cut_speed) : "");
}

FieldArrows field_arrows(const FieldFigure& figure, const FieldLayout& layout) {
  std::vector<std::vector<DrawnArrow>> drawable;
  std::vector<double> speeds;  // [m/s]
  for (const FieldPanel& panel : figure.panels) {
    drawable.push_back(drawable_arrows(panel, layout));
    for (const DrawnArrow& arrow : drawable.back())
      speeds.push_back(length_of(arrow.length) / layout.scale);
  }
  FieldArrows arrows;
  arrows.panels.resize(drawable.size());
  const double typical_speed = speeds.empty() ? 0 : percentile(speeds, 0.95);
  if (!(typical_speed > slowest)) return arrows;

  double square = smallest_square;
  for (std::size_t i = 0; i < drawable.size();) {
    arrows.panels[i] = one_per_square(drawable[i], square);
    if (arrows.panels[i++].size() <= most_arrows) continue;
    square *= 1.1;
    i = 0;  // the squares have one size in all panels
  }

  arrows.pixels_per_speed = figure.arrow_scale > 0 ? figure.arrow_scale * layout.scale
                                                   : typical_length * square / typical_speed;
  arrows.legend_speed = round_tick(legend_length / arrows.pixels_per_speed, false);
  const double longest = std::max(longest_arrow * square, legend_length);
  for (auto& panel : arrows.panels) {
    for (DrawnArrow& arrow : panel) {
      double factor = arrows.pixels_per_speed / layout.scale;
      const double length = factor * length_of(arrow.length);
      if (length > longest) {
        factor *= longest / length;
        arrows.cut_speed = longest / arrows.pixels_per_speed;
      }
      arrow.length = {factor * arrow.length.x, factor * arrow.length.y};
    }
    std::erase_if(panel, [&](const DrawnArrow& arrow) {
      const Pixel head{arrow.tail.x + arrow.length.x, arrow.tail.y + arrow.length.y};
      return !(length_of(arrow.length) >= shortest_arrow) || !layout.holds(head);
    });
  }
  return arrows;
}

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
