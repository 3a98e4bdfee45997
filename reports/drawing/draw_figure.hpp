// Draws a figure with gnuplot, as SVG or as PNG.
#pragma once

#include <filesystem>
#include <string>

#include "reports/drawing/run_gnuplot.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Where an <svg> element stands.
enum class SvgPlace {
  in_page,  // inside an HTML document, which brings the dark colours
  own_file  // in a document of its own, with its paper and its dark colours
};

// A drawing, from which svg_element() makes as many elements as needed.
struct DrawnFigure {
  std::string markup;  // inside the <svg> element
  int width, height;   // [px]
};

// Throws ReportError as run_gnuplot() does, and when the output breaks off.
DrawnFigure draw_figure(const Figure& figure, const std::filesystem::path& scratch_directory,
                        const Gnuplot& gnuplot = run_gnuplot);

// Returns the whole file of a PNG picture on white paper. Throws ReportError as draw_figure() does.
std::string draw_png(const Figure& figure, const std::filesystem::path& scratch_directory);

// Returns the complete element, with a title and a description for readers who do not see it.
std::string svg_element(const Figure& figure, const DrawnFigure& drawn, SvgPlace place);

// CSS rules for use under a media query, one for each colour, that repaint a figure drawn in the
// light colours with the dark ones.
std::string dark_rules();

}  // namespace slosh::reports
