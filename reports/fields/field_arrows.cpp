#include "reports/fields/field_arrows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reports/drawing/axes.hpp"
#include "reports/fields/field_range.hpp"

namespace slosh::reports {
namespace {

constexpr double smallest_square = 26;  // px
constexpr double typical_length = 1.8;  // squares
constexpr double longest_arrow = 3;   // squares: longer ones, of a jet, would hide its surroundings
constexpr double shortest_arrow = 2;  // px: a dot tells no direction
constexpr double slowest = 1e-200;    // m/s: water at rest, and no overflow of its inverse
constexpr double legend_length = 75;  // px, at most

// Velocities turned with the tank: [px] of the tank's scale per second.
std::vector<DrawnArrow> drawable_arrows(const FieldPanel& panel, const PlacedPanel& placed) {
  std::vector<DrawnArrow> arrows;
  for (std::size_t i = 0; i < panel.arrow_x.size(); ++i) {
    if (!is_drawn(panel.arrow_x[i]) || !is_drawn(panel.arrow_z[i]) || !is_drawn(panel.arrow_u[i]) ||
        !is_drawn(panel.arrow_w[i])) {
      continue;
    }
    const Pixel tail = placed.on_canvas(panel.arrow_x[i], panel.arrow_z[i]);
    if (placed.holds(tail))
      arrows.push_back({tail, placed.turned(panel.arrow_u[i], panel.arrow_w[i])});
  }
  return arrows;
}

std::vector<DrawnArrow> one_a_square(const std::vector<DrawnArrow>& arrows, double square) {
  std::map<std::pair<int, int>, std::pair<double, const DrawnArrow*>> nearest;
  for (const DrawnArrow& arrow : arrows) {
    const double column = std::floor(arrow.tail.x / square),
                 row = std::floor(arrow.tail.y / square);
    const double distance =
        std::hypot(arrow.tail.x - (column + 0.5) * square, arrow.tail.y - (row + 0.5) * square);
    const auto [found, is_new] =
        nearest.try_emplace({static_cast<int>(column), static_cast<int>(row)}, distance, &arrow);
    if (!is_new && distance < found->second.first) found->second = {distance, &arrow};
  }
  std::vector<DrawnArrow> kept;
  for (const auto& [place, arrow] : nearest) kept.push_back(*arrow.second);
  return kept;
}

}  // namespace

FieldArrows field_arrows(const FieldFigure& figure, const FieldLayout& layout) {
  FieldArrows arrows;
  std::vector<double> speeds;  // [m/s]
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    arrows.panels.push_back(drawable_arrows(figure.panels[i], layout.panels[i]));
    for (const DrawnArrow& arrow : arrows.panels.back())
      speeds.push_back(std::hypot(arrow.length.x, arrow.length.y) / layout.scale);
  }
  double square = smallest_square;
  const auto thinned = [&] {
    std::vector<std::vector<DrawnArrow>> panels;
    for (const auto& panel : arrows.panels) panels.push_back(one_a_square(panel, square));
    return panels;
  };
  auto kept = thinned();
  const auto too_many = [](const auto& panel) { return panel.size() > most_arrows; };
  while (std::any_of(kept.begin(), kept.end(), too_many)) {
    square *= 1.1;
    kept = thinned();
  }
  arrows.panels = std::move(kept);

  const double typical_speed = speeds.empty() ? 0 : percentile(speeds, 0.95);
  if (!(typical_speed > slowest)) {
    for (auto& panel : arrows.panels) panel.clear();
    return arrows;
  }
  arrows.pixels_per_speed = figure.arrow_scale > 0 ? figure.arrow_scale * layout.scale
                                                   : typical_length * square / typical_speed;
  arrows.legend_speed = round_tick(legend_length / arrows.pixels_per_speed, false);
  const double longest = std::max(longest_arrow * square, legend_length);
  for (std::size_t i = 0; i < arrows.panels.size(); ++i) {
    auto& panel = arrows.panels[i];
    const PlacedPanel& placed = layout.panels[i];
    for (DrawnArrow& arrow : panel) {
      double factor = arrows.pixels_per_speed / layout.scale;
      const double length = factor * std::hypot(arrow.length.x, arrow.length.y);
      if (length > longest) {
        factor *= longest / length;
        arrows.cut_speed = longest / arrows.pixels_per_speed;
      }
      arrow.length = {factor * arrow.length.x, factor * arrow.length.y};
    }
    std::erase_if(panel, [&](const DrawnArrow& arrow) {
      const Pixel head{arrow.tail.x + arrow.length.x, arrow.tail.y + arrow.length.y};
      return !(std::hypot(arrow.length.x, arrow.length.y) >= shortest_arrow) || !placed.holds(head);
    });
  }
  return arrows;
}

}  // namespace slosh::reports
