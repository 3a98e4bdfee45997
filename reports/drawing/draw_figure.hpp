// Draws a figure with gnuplot, as SVG, or as PNG for whoever needs pixels.
#pragma once

#include <filesystem>
#include <string>

#include "reports/drawing/run_gnuplot.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Where an <svg> element is to stand.
enum class SvgPlace {
  in_page,  // inside an HTML document, which brings the dark colours
  own_file  // a document of its own, with its paper and its dark colours
};

// A drawing, to be framed as often as needed.
struct DrawnFigure {
  std::string markup;  // inside the <svg> element
  int width, height;   // px
};

// Throws ReportError as run_gnuplot() does, and where the output breaks off.
DrawnFigure draw_figure(const Figure& figure, const std::filesystem::path& scratch_directory,
                        const Gnuplot& gnuplot = run_gnuplot);

// The whole file of a PNG picture on white paper. Throws as draw_figure() does.
std::string draw_png(const Figure& figure, const std::filesystem::path& scratch_directory);

// The complete element, named and described for those who do not see it.
std::string svg_element(const Figure& figure, const DrawnFigure& drawn, SvgPlace place);

}  // namespace slosh::reports
