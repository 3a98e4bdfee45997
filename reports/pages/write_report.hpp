// Writes a report: <directory>/index.html and a file for each other page (self-contained, figures
// inline as SVG, PNG and GIF), results.json with its schema, and the figures as files of figures/.
// The files are written to a temporary directory beside the target, which replaces the target when
// it is complete. So there is always one whole report under the name.
#pragma once

#include <filesystem>

#include "reports/drawing/run_gnuplot.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct WriteOptions {
  int threads = 1;  // for drawing, each with a gnuplot process of its own
  Gnuplot gnuplot = run_gnuplot;
};

// Replaces an earlier report under the same name. Throws ReportError where something lies there
// that no report has made (files/own_files.hpp). After an error the earlier report is unchanged.
void write_report(const Report& report, const std::filesystem::path& directory,
                  const WriteOptions& options = {});

}  // namespace slosh::reports
