// Draws the parts of an animation: its frames, and the history along which a cursor moves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/fields/film_strip.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct DrawnFilm {
  FilmStrip strip;
  DrawnFigure history;          // with the cursor, a line of the class "film-cursor", at the poster
  std::vector<double> cursors;  // [px], from the left of its canvas, of the strip's moments
};

// Throws ReportError as draw_figure() does.
DrawnFilm draw_film(const FieldFigure& figure, const std::filesystem::path& scratch_directory,
                    const Gnuplot& gnuplot = run_gnuplot);

}  // namespace slosh::reports
