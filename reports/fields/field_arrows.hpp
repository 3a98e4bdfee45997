// Which velocity arrows of a flow field are drawn, and how long.
#pragma once

#include <string>
#include <vector>

#include "reports/fields/field_layout.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct DrawnArrow {
  Pixel tail, length;  // [px] in the panel's cell
};

struct FieldArrows {
  double pixels_per_speed = 0;  // [px per m/s]; 0 where nothing moves
  double legend_speed = 0;      // [m/s], a round one
  double cut_speed = 0;         // [m/s], faster arrows are cut to this one's length; 0: none was
  std::vector<std::vector<DrawnArrow>> panels;  // in the figure's order
};

// What the legend says of the arrow of legend_speed; empty where nothing moves.
std::string arrow_text(const FieldArrows& arrows);

inline constexpr std::size_t most_arrows = 300;  // in a panel

// Keeps one arrow in each square of a cell, the nearest to its centre. The squares have one size
// in all panels, as small as arrows can be told apart and as most_arrows allows. With an automatic
// scale the 95th percentile of all speeds is a little shorter than two squares. An arrow that would
// end outside its cell, on a neighbour or on a label, is left out.
FieldArrows field_arrows(const FieldFigure& figure, const FieldLayout& layout);

}  // namespace slosh::reports
