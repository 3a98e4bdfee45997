// A report with every kind of content, made of closed forms: what the tests write and look at.
#pragma once

#include "reports/report_model.hpp"

namespace slosh::reports {

Report sample_report();

// A figure as heavy as a campaign's heaviest: six curves of 2001 samples.
Figure heavy_figure(const std::string& id);

}  // namespace slosh::reports
