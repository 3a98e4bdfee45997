// Draws a picture of flow fields with gnuplot, as PNG; an animation as GIF, which is the animated
// format of gnuplot 5.4 and 6.0 alike.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/drawing/field_parts.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// The line around a tank in its cell: its outline, moved out by half the line's width, so that the
// line is outside the water.

// Returns its corners [px]; the last one is joined to the first.
std::vector<Pixel> tank_line(const FieldPanel& panel, const FieldLayout& layout);

struct DrawnField {
  std::string picture;  // the whole file
  int width, height;    // [px]
};

// Throws ReportError as draw_figure() does.
DrawnField draw_field(const FieldFigure& figure, const std::filesystem::path& scratch_directory,
                      const Gnuplot& gnuplot = run_gnuplot);

// Describes the picture for readers who do not see it: its title, its panels, and what the colours
// and the arrows show.
std::string description(const FieldFigure& figure);

// Returns "<id>.png", or "<id>.gif" of an animation.
std::string picture_file(const FieldFigure& figure);

// The data URL (RFC 2397) for an <img> of a page that holds its pictures itself.
std::string data_address(const FieldFigure& figure, const DrawnField& drawn);

}  // namespace slosh::reports
