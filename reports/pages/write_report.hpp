// Writes a report: <directory>/index.html and a file for each other page (self-contained, figures
// inline as SVG and PNG), report.md, results.json with its schema, figures/*.svg and figures/*.png,
// and, where asked for, report.pdf of all pages. All of it goes to a temporary directory beside the
// target first and is swapped in when complete, so that there is always one whole report under the
// name: the old one until the new one is done.
#pragma once

#include <filesystem>

#include "reports/drawing/run_gnuplot.hpp"
#include "reports/model/report_error.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct WriteOptions {
  bool pdf = false;
  int threads = 1;  // that draw, each by a gnuplot of its own
  Gnuplot gnuplot = run_gnuplot;
};

// Replaces an earlier report under the same name. A directory that holds anything else is never
// replaced: ReportError. After any error what was under the name is as it was, but for one of the
// PDF alone: then the new report stands there without it.
void write_report(const Report& report, const std::filesystem::path& directory,
                  const WriteOptions& options = {});

}  // namespace slosh::reports
