// A report with every kind of content, made of closed forms: what the tests write and look at.
#pragma once

#include "reports/model/report_model.hpp"

namespace slosh::reports {

Report sample_report();

// The same on three pages, "waves" and "cost" beside the first, with links between them.
Report paged_report();

// A figure as heavy as a campaign's heaviest: six curves of 2001 samples.
Figure heavy_figure(const std::string& id);

// Three panels a moment, of which one has particles of this spacing [m] (0.072 m^2 of water in
// each).
FieldFigure sloshing_field(const std::string& id, int moments, double spacing);

}  // namespace slosh::reports
