// Where the parts of a picture of flow fields stand: all in px from the canvas' lower left corner.
//
// All panels have one scale and cells of one size, which hold every tank as it is turned; a tank's
// axis stands at the same place of each cell, so that a roll shows from panel to panel.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct Pixel {
  double x, y;
};

// A panel's cell, and the way from its tank to the canvas: turned by the roll about the axis.
struct PlacedPanel {
  double left, bottom, width, height;  // the cell
  std::vector<std::string> label;      // its lines, above the cell
  double scale;                        // px per m
  double tank_axis_x, tank_axis_z;     // [m]
  Pixel axis;
  double cosine, sine;  // of the roll

  Pixel turned(double along_x, double along_z) const {  // a vector [m], without the shift
    return {scale * (cosine * along_x - sine * along_z),
            scale * (sine * along_x + cosine * along_z)};
  }
  Pixel on_canvas(double x, double z) const {
    const Pixel from_axis = turned(x - tank_axis_x, z - tank_axis_z);
    return {axis.x + from_axis.x, axis.y + from_axis.y};
  }
  bool holds(const Pixel& place) const {
    return place.x >= left && place.x < left + width && place.y >= bottom &&
           place.y < bottom + height;
  }
};

struct FieldLayout {
  int width, height;
  double scale;                     // px per m
  std::vector<PlacedPanel> panels;  // as the figure's
};

inline constexpr int key_height = 96;           // px, at the top: colour bar, arrow and scale bar
inline constexpr int canvas_margin = 16;        // px
inline constexpr int label_line = 21;           // px, of the font
inline constexpr double label_character = 8.8;  // px, of gnuplot's 'sans,12' on average (measured)

FieldLayout field_layout(const FieldFigure& figure);

// Where the rows of an animation stand [px from the canvas' top], and the tallest one's height.
struct FilmFrames {
  std::vector<double> tops;
  double height;
};

FilmFrames film_frames(const FieldFigure& figure, const FieldLayout& layout);

}  // namespace slosh::reports
