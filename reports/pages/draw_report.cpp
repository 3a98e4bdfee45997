#include "reports/pages/draw_report.hpp"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

#include "reports/model/report_files.hpp"

namespace slosh::reports {

namespace fs = std::filesystem;

Report with_legible_figures(Report report) {
  for (Section& section : report.sections)
    for (Figure& figure : section.figures) {
      const std::size_t count = figure.curves.size();
      if (count <= most_curves) continue;
      figure.curves.resize(most_curves);
      figure.caption += fmt::format("{}The first {} of {} curves are drawn.",
                                    figure.caption.empty() ? "" : " ", most_curves, count);
    }
  return report;
}

Drawings draw_report(const Report& report, int threads, const Gnuplot& gnuplot,
                     const fs::path& scratch, const fs::path& directory) {
  std::vector<const Figure*> figures;
  std::vector<const FieldFigure*> fields;
  for (const Section& section : report.sections) {
    for (const Figure& figure : section.figures) figures.push_back(&figure);
    for (const FieldFigure& figure : section.fields) fields.push_back(&figure);
  }
  Drawings drawings;
  drawings.fields.resize(fields.size());
  drawings.figures.resize(figures.size());
  const auto draw_one_field = [&](std::size_t i) {
    drawings.fields[i] = draw_field(*fields[i], scratch, gnuplot);
    write_text(directory / picture_file(*fields[i]), drawings.fields[i].picture);
  };
  const auto draw_one = [&](const Figure& figure) {
    DrawnFigure drawn = draw_figure(figure, scratch, gnuplot);
    write_text(directory / (figure.id + ".svg"), svg_element(figure, drawn, SvgPlace::own_file));
    return drawn;
  };
  const auto draw_one_figure = [&](std::size_t i) { drawings.figures[i] = draw_one(*figures[i]); };
  // A field takes seconds, a figure a tenth of a second: the long ones are drawn first.
  std::vector<std::function<void()>> drawn;
  for (std::size_t i = 0; i < fields.size(); ++i) drawn.emplace_back([&, i] { draw_one_field(i); });
  for (std::size_t i = 0; i < figures.size(); ++i)
    drawn.emplace_back([&, i] { draw_one_figure(i); });
  side_by_side(drawn.size(), threads, [&](std::size_t i) { drawn[i](); });
  drawings.glances.resize(report.pages.size());
  side_by_side(report.pages.size(), threads, [&](std::size_t i) {
    if (const std::optional<Figure>& glance = report.pages[i].glance)
      drawings.glances[i] = draw_one(*glance);
  });
  return drawings;
}

}  // namespace slosh::reports
