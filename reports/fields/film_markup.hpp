// An animation inside a page: the panels of all runs side by side in step, one key, the controls
// and the history with its cursor, and the script that plays them. Nothing moves until the reader
// starts it (WCAG 2.2, 2.2.2 and 2.3.3). Until then, without the script and in print the page shows
// the poster.
#pragma once

#include <string>

#include "reports/fields/draw_film.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Returns the HTML elements of an animation.
std::string film_element(const FieldFigure& figure, const DrawnFilm& drawn);

// Returns the figure's caption, and after it which of the moments are shown where not all are.
std::string film_caption(const FieldFigure& figure, const DrawnFilm& drawn);

// Returns the whole <script> element.
std::string film_script_element();

// Returns the part of a page's Content-Security-Policy that allows the script:
// "script-src 'sha256-...'" (CSP Level 3).
std::string film_script_policy();

}  // namespace slosh::reports
