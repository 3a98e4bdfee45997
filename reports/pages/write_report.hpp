// Writes a report: <directory>/index.html and a file for each other page (self-contained, figures
// inline as SVG, PNG and GIF), results.json with its schema, and the figures as files of figures/.
// They are written to a temporary directory beside the target, and replace those of the target when
// all are there, the first page and the data last.
#pragma once

#include <cstddef>
#include <filesystem>

#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// A figure of more curves cannot be read.
inline constexpr std::size_t most_curves = 24;

// Returns the report with the first most_curves of each figure; its caption says how many it lacks.
Report with_legible_figures(Report report);

struct WriteOptions {
  int threads = 1;  // for drawing, each with a gnuplot process of its own
  Gnuplot gnuplot = run_gnuplot;
};

// Replaces an earlier report under the same name. What no report has made stays where it is; in the
// place of a page it is set aside (files/own_files.hpp). Throws ReportError where that cannot be.
// Until the new report is whole the earlier one is unchanged.
void write_report(const Report& report, const std::filesystem::path& directory,
                  const WriteOptions& options = {});

// Throws ReportError, which names the page, section, table or figure, for an id that is invalid or
// used twice, a section on a page that does not exist, a page without a section, a broken link,
// columns or samples of unequal number, a range that no axis or colour bar can show, a field
// without panels, with more in a row than fit, or with sizes that are not positive, and
// results_json that is not JSON.
void check_report(const Report& report);

}  // namespace slosh::reports
