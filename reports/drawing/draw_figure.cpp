#include "reports/drawing/draw_figure.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/drawing/svg_markup.hpp"
#include "reports/model/png_file.hpp"
#include "reports/model/report_error.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

// The figure in words, for its <desc>: axes and what is drawn.
std::string description(const Figure& figure) {
  std::vector<std::string> names;
  for (const Curve& curve : figure.curves) names.push_back(curve.label);
  for (const Band& band : figure.bands) names.push_back(band.label + " (band)");
  for (const Marker& marker : figure.markers) names.push_back(marker.label + " (vertical line)");
  for (const Span& span : figure.spans)
    names.push_back(
        fmt::format("{} from {:.4g} to {:.4g} (shaded)", span.label, span.begin, span.end));
  return fmt::format("Horizontal axis: {}. Vertical axis: {}. Shown: {}.", figure.x_label,
                     figure.y_label, fmt::join(names, "; "));
}

}  // namespace

DrawnFigure draw_figure(const Figure& figure, const std::filesystem::path& scratch_directory,
                        const Gnuplot& gnuplot) {
  const std::string output = gnuplot(gnuplot_script(figure), figure.id, scratch_directory);
  if (output.find("</svg>") == output.npos)
    throw ReportError(broken_output(figure.id, "SVG document", scratch_directory));
  return {shared_markup(output, figure.id), canvas_width, canvas_height(figure)};
}

std::string draw_png(const Figure& figure, const std::filesystem::path& scratch_directory) {
  std::string png =
      run_gnuplot(gnuplot_script(figure, Terminal::png), figure.id, scratch_directory);
  if (!is_whole_png(png))
    throw ReportError(broken_output(figure.id, "PNG file", scratch_directory));
  return png;
}

std::string svg_element(const Figure& figure, const DrawnFigure& drawn, SvgPlace place) {
  kainjow::mustache::mustache frame(figure_template);
  kainjow::mustache::data data;
  data.set("own_file", place == SvgPlace::own_file);
  data.set("id", figure.id);
  data.set("title", figure.title);
  data.set("description", description(figure));
  data.set("width", std::to_string(drawn.width));
  data.set("height", std::to_string(drawn.height));
  data.set("paper", paper.light);
  data.set("dark_rules", dark_rules());
  data.set("markup", drawn.markup);
  return frame.render(data);
}

}  // namespace slosh::reports
