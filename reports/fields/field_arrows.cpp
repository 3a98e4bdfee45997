#include "reports/fields/field_arrows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/field_range.hpp"

namespace slosh::reports {
namespace {

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

}  // namespace

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

}  // namespace slosh::reports
