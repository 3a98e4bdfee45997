// A report with every kind of content, made of closed forms, for the tests.
#pragma once

#include "reports/model/report_model.hpp"

namespace slosh::reports {

Report sample_report();

// The same report on three pages, "waves" and "cost" after the first, with links between them.
Report paged_report();

// A figure as heavy as a campaign's heaviest: six curves of 2001 samples.
Figure heavy_figure(const std::string& id);

// Three panels per moment with 0.072 m^2 of water each. The first has particles of this spacing
// [m].
FieldFigure sloshing_field(const std::string& id, int moments, double spacing);

// An animation of that water by so many runs; the second run did not record the second moment.
FieldFigure sloshing_animation(const std::string& id, int moments, int runs, double spacing);

}  // namespace slosh::reports
