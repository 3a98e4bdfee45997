// The picture of a trend: one small line without axes, in the text's colour, over the tolerance of
// each time, with the intervals as bars and filled dots for the approved values and the present
// one.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Returns an <svg> element whose name is the trend's text, and the text itself where the value has
// changed. Returns "" for a trend without points. The scale holds all values with their intervals,
// and all ends of tolerances.
std::string trend_markup(const Trend& trend);

}  // namespace slosh::reports
