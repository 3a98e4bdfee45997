// Writes a report: <directory>/index.html (self-contained, figures inline as SVG), report.md, results.json and
// figures/*.svg. All of it goes to a temporary directory first and is renamed when complete.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "reports/report_model.hpp"

namespace slosh::reports {

// gnuplot is missing or refused a figure, or the directory cannot be written.
struct ReportError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void write_report(const Report& report, const std::filesystem::path& directory);

}  // namespace slosh::reports
