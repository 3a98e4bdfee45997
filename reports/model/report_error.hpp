// The one exception of everything that writes or draws a report.
#pragma once

#include <stdexcept>

namespace slosh::reports {

// The report contradicts its model, gnuplot is missing or refused a figure, or the directory cannot
// be written.
struct ReportError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace slosh::reports
