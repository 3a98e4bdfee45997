// An animation inside a page: one picture with all frames, of which the page shows one at a time,
// and the script that plays them. Nothing moves until the reader starts it (WCAG 2.2, 2.2.2 and
// 2.3.3). Without the script the page shows the first frame.
#pragma once

#include <string>

#include "reports/fields/draw_field.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Returns the HTML elements of a figure with frames.
std::string film_element(const FieldFigure& figure, const DrawnField& drawn);

// Returns the whole <script> element.
std::string film_script_element();

// Returns the part of a page's Content-Security-Policy that allows the script:
// "script-src 'sha256-...'" (CSP Level 3).
std::string film_script_policy();

}  // namespace slosh::reports
