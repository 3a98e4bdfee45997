#include "reports/pages/trend_markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/pages/text_markup.hpp"

namespace slosh::reports {
namespace {

constexpr double width = 120, height = 30, margin = 4;  // px

// From values to pixels.
class Scale {
 public:
  explicit Scale(const Trend& trend) : step_((width - 2 * margin) / (trend.points.size() - 1)) {
    for (const Trend::Point& point : trend.points)
      for (const double edge : {point.value - point.half_width, point.value + point.half_width,
                                point.lower, point.upper})
        if (std::isfinite(edge)) {
          lowest_ = std::min(lowest_, edge);
          highest_ = std::max(highest_, edge);
        }
  }

  double x(std::size_t i) const { return margin + step_ * i; }

  // A value beyond the scale, such as a tolerance without an end, lies on the picture's edge.
  double y(double value) const {
    if (value > highest_) return 0;
    if (value < lowest_) return height;
    if (!(highest_ > lowest_)) return height / 2;
    return height - margin - (height - 2 * margin) * (value - lowest_) / (highest_ - lowest_);
  }

 private:
  double step_;
  double lowest_ = INFINITY, highest_ = -INFINITY;
};

std::string tolerance(const Trend& trend, const Scale& scale) {
  const bool has_ends =
      std::any_of(trend.points.begin(), trend.points.end(), [](const Trend::Point& point) {
        return std::isfinite(point.lower) || std::isfinite(point.upper);
      });
  if (!has_ends) return "";
  std::string upper, lower;
  for (std::size_t i = 0; i < trend.points.size(); ++i) {
    upper += fmt::format("{:.1f},{:.1f} ", scale.x(i), scale.y(trend.points[i].upper));
    lower = fmt::format("{:.1f},{:.1f} ", scale.x(i), scale.y(trend.points[i].lower)) + lower;
  }
  return fmt::format("<polygon class=\"trend-tolerance\" points=\"{}{}\"/>", upper, lower);
}

std::string bars_and_dots(const Trend& trend, const Scale& scale) {
  std::string text;
  for (std::size_t i = 0; i < trend.points.size(); ++i) {
    const Trend::Point& point = trend.points[i];
    const double x = scale.x(i);
    if (point.half_width > 0)
      text += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x,
                          scale.y(point.value - point.half_width),
                          scale.y(point.value + point.half_width));
    if (point.is_approved || i + 1 == trend.points.size())
      text +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>", x, scale.y(point.value));
  }
  return text;
}

}  // namespace

std::string trend_markup(const Trend& trend) {
  if (trend.points.empty()) return "";
  const Scale scale(trend);
  std::string line;
  for (std::size_t i = 0; i < trend.points.size(); ++i)
    line += fmt::format("{:.1f},{:.1f} ", scale.x(i), scale.y(trend.points[i].value));
  const std::string words = html_text(trend.text);
  return fmt::format(
      "<svg class=\"trend\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}<polyline "
      "points=\"{}\"/>{}</svg>{}",
      width, height, words, tolerance(trend, scale), line, bars_and_dots(trend, scale),
      trend.has_changed ? fmt::format("<span class=\"trend-text\">{}</span>", words) : "");
}

}  // namespace slosh::reports
