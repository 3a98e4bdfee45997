// The line around a tank in its cell: its outline, moved out by half the line's width, so that the
// line is outside the water.
#pragma once

#include <vector>

#include "reports/fields/field_layout.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Returns its corners [px]; the last one is joined to the first.
std::vector<Pixel> tank_line(const FieldPanel& panel, const FieldLayout& layout);

}  // namespace slosh::reports
