#include "reports/drawing/draw_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <kainjow/mustache.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_files.hpp"
#include "reports/templates.hpp"
#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {
namespace {

constexpr std::size_t fewest = 32;  // places of a line that is worth it

struct Place {
  char command;  // M, L, or 0 in a polygon
  long x, z;     // [0.1 px]
};

// Reads "M1.20,3.40", "L1.20,3.40" or, of a polygon, "1.20,3.40".
std::optional<Place> place_of(const std::string& text) {
  const bool has_command = text.front() == 'M' || text.front() == 'L';
  const char *begin = text.data() + has_command, *end = text.data() + text.size();
  double x = 0, z = 0;
  const auto first = std::from_chars(begin, end, x);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, z);
  if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
  return Place{has_command ? text.front() : '\0', std::lround(10 * x), std::lround(10 * z)};
}

std::string pixels(long tenths) {
  const long whole = std::abs(tenths) / 10, rest = std::abs(tenths) % 10;
  std::string text = tenths < 0 ? "-" : "";
  if (whole != 0 || rest == 0) text += fmt::format("{}", whole);
  return rest == 0 ? text : text + fmt::format(".{}", rest);
}

// A minus separates two numbers as a blank does.
std::string pair(long x, long z) { return pixels(x) + (z < 0 ? "" : " ") + pixels(z); }

// Returns "" where the places are few or not all of M and L.
std::string relative(const std::string& places) {
  std::vector<std::string> texts;
  const std::string trimmed = boost::trim_copy(places);
  boost::split(texts, trimmed, boost::is_space(), boost::token_compress_on);
  if (texts.size() < fewest) return "";
  std::string path;
  Place last{};
  bool at_beginning = true;
  for (const std::string& text : texts) {
    const auto place = place_of(text);
    if (!place) return "";
    if (path.empty() || place->command == 'M') {
      path += "M" + pair(place->x, place->z);
      at_beginning = true;
    } else {
      const long x = place->x - last.x;
      path += (at_beginning ? "l" : x < 0 ? "" : " ") + pair(x, place->z - last.z);
      at_beginning = false;
    }
    last = *place;
  }
  return path;
}

// Every colour of a figure of curves.
std::vector<PaletteColour> figure_colours() {
  std::vector<PaletteColour> colours{paper, ink, faint_ink, grid};
  colours.insert(colours.end(), hues.begin(), hues.end());
  colours.insert(colours.end(), band_colours.begin(), band_colours.end());
  return colours;
}

using Replacements = std::vector<std::pair<std::string, std::string>>;

// gnuplot writes colours as "rgb(  0, 114, 178)", in text as "rgb(0,114,178)", and its own defaults
// by name.
Replacements replacements(const std::string& figure_id) {
  Replacements all{{" id='", fmt::format(" id='plot-{}-", figure_id)},
                   {" id=\"", fmt::format(" id=\"plot-{}-", figure_id)},
                   {"xlink:href='#", fmt::format("href='#plot-{}-", figure_id)},
                   {" font-family=\"sans-serif\"", ""},
                   {"'black'", fmt::format("'{}'", ink.light)},
                   {"\"black\"", fmt::format("\"{}\"", ink.light)}};
  for (const PaletteColour& colour : figure_colours()) {
    const auto channel = [&](int position) {
      return std::stoi(std::string(colour.light + position, 2), nullptr, 16);
    };
    const int red = channel(1), green = channel(3), blue = channel(5);
    all.emplace_back(fmt::format("rgb({:3}, {:3}, {:3})", red, green, blue), colour.light);
    all.emplace_back(fmt::format("rgb({},{},{})", red, green, blue), colour.light);
  }
  return all;
}

// Removes the definitions of text boxes, which no figure here uses.
void drop_filters(std::string& drawing) {
  for (auto start = drawing.find("<filter"); start != std::string::npos;
       start = drawing.find("<filter")) {
    const std::string closing = "</filter>";
    drawing.erase(start, drawing.find(closing, start) + closing.size() - start);
  }
}

// Returns the drawing inside gnuplot's <svg> element as markup that many figures of one page can
// share: every id and every reference to one starts with "plot-<figure_id>-", the palette's colours
// are #rrggbb (so that dark_rules() match them), the font is the page's, no group is empty, and
// long lines are short text. Text between tags is left as it is. Throws ReportError where there is
// no drawing.
std::string shared_markup(const std::string& gnuplot_svg, const std::string& figure_id) {
  const auto start = gnuplot_svg.find("<g id=\"gnuplot_canvas\"");
  const auto end = gnuplot_svg.rfind("</svg>");
  const bool is_whole = start != std::string::npos && end != std::string::npos && start < end &&
                        gnuplot_svg.rfind('<', end - 1) < gnuplot_svg.rfind('>', end - 1);
  if (!is_whole) {
    throw ReportError("figure '" + figure_id +
                      "': gnuplot's output is not a complete SVG document");
  }
  std::string drawing = gnuplot_svg.substr(start, end - start);
  drop_filters(drawing);

  const Replacements in_tags = replacements(figure_id);
  std::string markup;
  std::string
      opened_group;  // a <g> tag and the blanks after it, held back until something is drawn in it
  for (std::size_t position = 0; position < drawing.size();) {
    const bool is_tag = drawing[position] == '<';
    const auto stop = is_tag ? drawing.find('>', position) + 1
                             : std::min(drawing.find('<', position), drawing.size());
    std::string piece = drawing.substr(position, stop - position);
    position = stop;
    if (!opened_group.empty() && piece == "</g>") {
      opened_group.clear();
      continue;
    }
    // gnuplot erases the error bar under a point in white, whatever the colour below.
    if (boost::starts_with(piece, "<use ") && boost::contains(piece, "'white'")) continue;
    if (is_tag) {
      for (const auto& [from, to] : in_tags) boost::replace_all(piece, from, to);
      piece = with_relative_places(piece);
    }
    if (is_tag && boost::starts_with(piece, "<g ")) {
      markup += std::exchange(opened_group, piece);
    } else if (!opened_group.empty() && boost::trim_copy(piece).empty()) {
      opened_group += piece;
    } else {
      markup += std::exchange(opened_group, "") + piece;
    }
  }
  return markup;
}

// Describes the axes and what is drawn in words, for the <desc> element.
std::string description(const Figure& figure) {
  std::vector<std::string> names;
  for (const Curve& curve : figure.curves)
    if (!curve.label.empty()) names.push_back(curve.label);
  for (const Band& band : figure.bands) names.push_back(band.label + " (band)");
  for (const Marker& marker : figure.markers) names.push_back(marker.label + " (vertical line)");
  for (const Span& span : figure.spans)
    names.push_back(
        fmt::format("{} from {:.4g} to {:.4g} (shaded)", span.label, span.begin, span.end));
  return fmt::format("Horizontal axis: {}. Vertical axis: {}. Shown: {}.", figure.x_label,
                     figure.y_label, fmt::join(names, "; "));
}

}  // namespace

std::string with_relative_places(const std::string& tag) {
  const bool is_polygon = boost::starts_with(tag, "<polygon ");
  if (!is_polygon && !boost::starts_with(tag, "<path ")) return tag;
  const std::string key = is_polygon ? " points = '" : " d='";
  if (!boost::contains(tag, key)) return tag;
  const auto start = tag.find(key) + key.size(), end = tag.find('\'', start);
  const std::string path = relative(tag.substr(start, end - start));
  if (path.empty()) return tag;
  if (!is_polygon) return tag.substr(0, start) + path + tag.substr(end);
  const auto name_end = std::string("<polygon").size();
  return "<path" + tag.substr(name_end, start - key.size() - name_end) + " d='" + path + "z" +
         tag.substr(end);
}

DrawnFigure draw_figure(const Figure& figure, const std::filesystem::path& scratch_directory,
                        const Gnuplot& gnuplot) {
  const std::string output = gnuplot(gnuplot_script(figure), figure.id, scratch_directory);
  if (output.find("</svg>") == output.npos)
    throw ReportError(broken_output(figure.id, "SVG document", scratch_directory));
  return {shared_markup(output, figure.id), canvas_of(figure).width, canvas_height(figure)};
}

std::string draw_png(const Figure& figure, const std::filesystem::path& scratch_directory) {
  std::string png =
      run_gnuplot(gnuplot_script(figure, Terminal::png), figure.id, scratch_directory);
  if (!is_whole_png(png))
    throw ReportError(broken_output(figure.id, "PNG file", scratch_directory));
  return png;
}

std::string svg_element(const Figure& figure, const DrawnFigure& drawn, SvgPlace place) {
  kainjow::mustache::mustache frame(figure_template);
  kainjow::mustache::data data;
  data.set("own_file", place == SvgPlace::own_file);
  data.set("id", figure.id);
  data.set("title", legible(figure.title));
  data.set("description", legible(description(figure)));
  data.set("width", std::to_string(drawn.width));
  data.set("height", std::to_string(drawn.height));
  data.set("paper", paper.light);
  data.set("dark_rules", dark_rules());
  data.set("markup", drawn.markup);
  return frame.render(data);
}

std::string dark_rules() {
  std::string rules;
  for (const auto& [light, dark] : figure_colours()) {
    for (const char* property : {"fill", "stroke", "color"}) {
      rules += fmt::format(".plot [{0}=\"{1}\"]{{{0}:{2}}}\n", property, light, dark);
    }
  }
  return rules;
}

}  // namespace slosh::reports
