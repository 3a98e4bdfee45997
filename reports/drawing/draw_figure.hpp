// Draws a figure with gnuplot, as SVG or as PNG.
#pragma once

#include <filesystem>
#include <string>

#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Writes the long lines of an SVG drawing in a third of their length: figures of long histories are
// most of a report's weight.

// Returns the tag of a <path> or a <polygon> with its places rounded to a tenth of a pixel and each
// place relative to the one before it. Rounding does not add up, since the rounded places are
// subtracted. A polygon becomes a closed path. Short lines, other tags and paths of other commands
// than M and L are returned as they are: gnuplot scales its symbols, which tenths would deform.
std::string with_relative_places(const std::string& tag);

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
