// Draws the figures of a report.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/fields/draw_field.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// The drawings of a report: one for each figure, for each field and for each page, in the report's
// order. The glance of a page that has none is empty.
struct Drawings {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnField> fields;
  std::vector<DrawnFigure> glances = {};
};

// A figure of more curves cannot be read.
inline constexpr std::size_t most_curves = 24;

// Returns the report with the first most_curves of each figure; its caption says how many it lacks.
Report with_legible_figures(Report report);

// Draws each figure once, on so many threads, and writes it to `figures` as <id>.svg, or as
// <id>.png for a field and <id>.gif for an animation. Throws ReportError as draw_figure() does.
Drawings draw_report(const Report& report, int threads, const Gnuplot& gnuplot,
                     const std::filesystem::path& scratch, const std::filesystem::path& figures);

}  // namespace slosh::reports
