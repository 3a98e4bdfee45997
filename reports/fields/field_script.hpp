// The gnuplot program that draws the panels of a flow field as PNG on its standard output.
//
// Its axes are the canvas' pixels, without ticks: the places come from field_layout, the colours
// from field_raster, the arrows from field_arrows. All data goes in inline datablocks.
#pragma once

#include <string>

#include "reports/fields/field_layout.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

std::string field_script(const FieldFigure& figure, const FieldLayout& layout);

}  // namespace slosh::reports
