// An animation inside a page: one picture with all frames, of which the page shows a part at a
// time, and the script that plays them. Nothing moves until the reader starts it, so that those who
// want no motion have none (WCAG 2.2, 2.2.2 and 2.3.3); without the script the first frame stands.
#pragma once

#include <string>

#include "reports/fields/draw_field.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// The elements of a figure with frames.
std::string film_element(const FieldFigure& figure, const DrawnField& drawn);

// The whole <script> element.
std::string film_script_element();

// What a page's Content-Security-Policy allows for it: "script-src 'sha256-...'" (CSP Level 3).
std::string film_script_policy();

}  // namespace slosh::reports
