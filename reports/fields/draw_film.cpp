#include "reports/fields/draw_film.hpp"

#include <fmt/format.h>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/figure_palette.hpp"

namespace slosh::reports {

DrawnFilm draw_film(const FieldFigure& figure, const std::filesystem::path& scratch_directory,
                    const Gnuplot& gnuplot) {
  const Film& film = *figure.film;
  DrawnFilm drawn{film_strip(figure), draw_figure(film.history, scratch_directory, gnuplot), {}};
  const CursorFrame frame = cursor_frame(film.history);
  const AxisRange axis = plot_ranges(film.history).horizontal;
  for (const std::size_t row : drawn.strip.moments)
    drawn.cursors.push_back(frame.place(film.times[row], axis));
  drawn.history.markup += fmt::format(
      "<line class=\"film-cursor\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1:.2f}\" y2=\"{2:.2f}\" "
      "stroke=\"{3}\" stroke-width=\"1.5\"/>\n",
      drawn.cursors[drawn.strip.poster], frame.top, frame.bottom, ink.light);
  return drawn;
}

}  // namespace slosh::reports
