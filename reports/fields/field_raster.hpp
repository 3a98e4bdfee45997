// A panel's places as pixels: each pixel shows the nearest place whose rectangle is over it.
//
// Rectangles by the ten thousand, most of them one or two pixels wide, cannot be left to gnuplot's
// own drawing: it smooths every edge, so that neighbours show seams, and the thousands of mixed
// colours make a picture of 12 panels three times as large as one may be (0.9 MB, measured).
#pragma once

#include <vector>

#include "reports/fields/field_layout.hpp"
#include "reports/fields/field_range.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

inline constexpr int colour_levels = 64;  // a smooth bar; 128 make the file a tenth larger
inline constexpr int no_level = -1;

struct FieldRaster {
  int left = 0, bottom = 0, width = 0, height = 0;  // px on the canvas: what holds all places drawn
  std::vector<int> levels;  // of the pixels, row by row from the bottom: 0 to colour_levels - 1, or
                            // no_level where nothing is
};

// Values beyond the range take its end's colour. A place that is not finite or outside the panel's
// cell is not drawn; any other has a pixel at least. Gaps between particles, of a fraction of their
// spacing, are no voids and are filled from the nearest; the water's edge stays where it is.
FieldRaster field_raster(const FieldPanel& panel, const PlacedPanel& placed,
                         const ColourRange& range);

}  // namespace slosh::reports
