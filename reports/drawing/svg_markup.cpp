#include "reports/drawing/svg_markup.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/drawing/figure_palette.hpp"
#include "reports/model/report_error.hpp"

namespace slosh::reports {
namespace {

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
  std::vector<PaletteColour> colours{paper, ink, faint_ink, grid};
  colours.insert(colours.end(), curve_colours.begin(), curve_colours.end());
  colours.insert(colours.end(), band_colours.begin(), band_colours.end());
  for (const PaletteColour& colour : colours) {
    const auto channel = [&](int position) {
      return std::stoi(std::string(colour.light + position, 2), nullptr, 16);
    };
    const int red = channel(1), green = channel(3), blue = channel(5);
    all.emplace_back(fmt::format("rgb({:3}, {:3}, {:3})", red, green, blue), colour.light);
    all.emplace_back(fmt::format("rgb({},{},{})", red, green, blue), colour.light);
  }
  return all;
}

// Definitions of text boxes that no figure here uses.
void drop_filters(std::string& drawing) {
  for (auto start = drawing.find("<filter"); start != std::string::npos;
       start = drawing.find("<filter")) {
    const std::string closing = "</filter>";
    drawing.erase(start, drawing.find(closing, start) + closing.size() - start);
  }
}

}  // namespace

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
    // Under a point with an error bar gnuplot rubs out the bar in white, whatever the paper and the
    // bands.
    if (boost::starts_with(piece, "<use ") && boost::contains(piece, "'white'")) continue;
    if (is_tag) {
      for (const auto& [from, to] : in_tags) boost::replace_all(piece, from, to);
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

}  // namespace slosh::reports
