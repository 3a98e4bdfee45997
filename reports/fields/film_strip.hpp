// The frames of an animation as one picture: a row for each moment, a column for each run. A page
// shows one row of it at a time.
//
// A page with several solvers must not get heavy, so the picture has a largest weight. A picture
// that exceeds it is made of smaller cells, down to 60 % of their full size; if that is not enough,
// it has every second of the moments, every third, and so on, the poster always among them.
#pragma once

#include <string>
#include <vector>

#include "reports/drawing/field_range.hpp"
#include "reports/fields/field_arrows.hpp"
#include "reports/fields/field_layout.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

inline constexpr std::size_t heaviest_strip = 450'000;  // [byte]: 600 kB of a page of 1.5 MB
inline constexpr int film_columns = 4;                  // of panels in a row on a desk
inline constexpr int film_gap = 16;                     // [px], between two of them

struct FilmStrip {
  std::string png;                   // the whole file
  FieldLayout layout;                // of its cells
  int shown_width;                   // [px] of a cell on a page: its full size
  std::vector<std::size_t> moments;  // the figure's rows that it has, increasing
  std::size_t poster;                // among them
  FieldArrows arrows;                // in its pixels
  ColourRange range;                 // of all rows
};

// The figure is an animation.
FilmStrip film_strip(const FieldFigure& figure, std::size_t heaviest = heaviest_strip);

// Returns the colours of the values from low to high, as "#rrggbb".
std::vector<std::string> film_colours();

// Returns the row of the poster as a still picture in the film's colours.
FieldFigure poster_of(const FieldFigure& figure);

}  // namespace slosh::reports
