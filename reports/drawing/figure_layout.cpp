#include "reports/drawing/figure_layout.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace slosh::reports {
namespace {

// Half the width high, as a time history reads best; with equal axes nearly a square.
constexpr Canvas whole_canvas{560, 300, 56, 13, 1.8}, square_canvas{560, 440, 56, 13, 1.8},
    small_canvas{320, 196, 50, 11, 1.4};

constexpr int foot = 8;  // px, below the legend: its descenders

constexpr double character_width =
    8.5;  // px, of a 13 px sans-serif font, names with digits and underscores
constexpr double plot_width = 440;  // px, the canvas less its margins at their widest
constexpr double key_width =
    420;  // px, on the safe side: gnuplot uses fewer columns where it finds no room
constexpr double key_sample_width =
    55;  // px, the line before a legend entry and the space after it
// px, of a line of a legend entry: 54 characters. The canvas has room for 65 of usual width.
constexpr double longest_line = 460;

template <class Part, class TextOf>
std::vector<std::string> each_once(const std::vector<Part>& parts, TextOf text_of) {
  std::vector<std::string> labels;
  for (const Part& part : parts)
    if (const std::string& label = text_of(part);
        !label.empty() && std::find(labels.begin(), labels.end(), label) == labels.end())
      labels.push_back(label);
  return labels;
}

// The lines of all entries.
std::vector<std::string> legend_texts(const Figure& figure) {
  std::vector<std::string> entries = ribbon_labels(figure);
  for (const Curve& curve : figure.curves)
    if (!curve.label.empty()) entries.push_back(curve.label);
  for (const Band& band : figure.bands) entries.push_back(band.label);
  for (const std::string& label : span_labels(figure)) entries.push_back(label);
  std::vector<std::string> lines;
  for (const std::string& entry : entries)
    for (std::string& line : legend_lines(entry)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

double text_width(const std::string& text, double character_width) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  });
  return character_width * static_cast<double>(characters);
}

std::vector<std::string> wrapped(std::string rest, double width, double character_width) {
  std::vector<std::string> lines;
  while (text_width(rest, character_width) > width) {
    std::size_t end = std::string::npos;
    for (const std::string_view gap : {", ", " "}) {
      for (auto at = rest.find(gap); at != std::string::npos; at = rest.find(gap, at + 1)) {
        const std::size_t blank = at + gap.size() - 1;
        if (text_width(rest.substr(0, blank), character_width) <= width) end = blank;
      }
      if (end != std::string::npos) break;
    }
    if (end == std::string::npos) end = rest.find(' ');
    if (end == std::string::npos) break;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  lines.push_back(rest);
  return lines;
}

Canvas canvas_of(const Figure& figure) {
  if (figure.to_scale) {
    const auto [horizontal, vertical] = plot_ranges(figure);
    const double high =
        plot_width * (vertical.upper - vertical.lower) / (horizontal.upper - horizontal.lower);
    Canvas canvas = whole_canvas;
    constexpr double above_frame = 20, lowest = 90, highest = 400;  // px
    canvas.plot_height =
        canvas.below_frame + static_cast<int>(above_frame + std::clamp(high, lowest, highest));
    return canvas;
  }
  if (figure.is_small) return small_canvas;
  return figure.equal_axes ? square_canvas : whole_canvas;
}

std::vector<std::string> span_labels(const Figure& figure) {
  return each_once(figure.spans, [](const Span& span) -> const std::string& { return span.label; });
}

std::vector<std::string> ribbon_labels(const Figure& figure) {
  return each_once(figure.curves,
                   [](const Curve& curve) -> const std::string& { return curve.ribbon; });
}

std::vector<std::string> legend_lines(const std::string& label) {
  return wrapped(label, longest_line, character_width);
}

KeyLayout key_layout(const Figure& figure) {
  if (figure.is_small) return {1, 0, 0};
  const std::vector<std::string> texts = legend_texts(figure);
  double widest = 0;
  for (const std::string& text : texts)
    widest = std::max(widest, text_width(text, character_width));
  const int columns = std::max(1, static_cast<int>(key_width / (widest + key_sample_width)));
  const double reckoned_width = 0.7 * whole_canvas.font_size;
  return {columns, (static_cast<int>(texts.size()) + columns - 1) / columns,
          widest * (1 / character_width - 1 / reckoned_width)};
}

std::vector<PlacedMarker> placed_markers(const Figure& figure, const AxisRange& range) {
  std::vector<PlacedMarker> placed;
  for (const Marker& marker : figure.markers) {
    if (marker.x >= range.lower && marker.x <= range.upper) placed.push_back({&marker, 0});
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedMarker& a, const PlacedMarker& b) {
    return a.marker->x < b.marker->x;
  });
  const auto scale = [&](double x) { return figure.log_x ? std::log(x) : x; };
  std::vector<double> row_ends;
  for (PlacedMarker& label : placed) {
    const double centre = plot_width * (scale(label.marker->x) - scale(range.lower)) /
                          (scale(range.upper) - scale(range.lower));
    const double half = text_width(label.marker->label, character_width) / 2 + character_width / 2;
    const auto free_row = std::find_if(row_ends.begin(), row_ends.end(),
                                       [&](double end) { return end <= centre - half; });
    label.row = static_cast<int>(free_row - row_ends.begin());
    if (free_row == row_ends.end()) row_ends.push_back(0);
    row_ends[static_cast<std::size_t>(label.row)] = centre + half;
  }
  return placed;
}

int marker_rows(const std::vector<PlacedMarker>& placed) {
  int rows = 0;
  for (const PlacedMarker& label : placed) rows = std::max(rows, label.row + 1);
  return rows;
}

int legend_height(const Figure& figure) {
  return figure.is_small ? 0 : legend_row_height * key_layout(figure).rows + foot;
}

int canvas_height(const Figure& figure) {
  const int rows =
      key_layout(figure).rows + marker_rows(placed_markers(figure, plot_ranges(figure).horizontal));
  return canvas_of(figure).plot_height + legend_row_height * rows;
}

}  // namespace slosh::reports
