#include "reports/draw_figure.hpp"

#include <fmt/format.h>

#include <boost/process.hpp>
#include <kainjow/mustache.hpp>
#include <system_error>

#include "reports/figure_palette.hpp"
#include "reports/gnuplot_script.hpp"
#include "reports/svg_markup.hpp"
#include "reports/templates.hpp"
#include "reports/text_file.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {
namespace {

namespace process = boost::process;

// The figure in words, for its <desc>: axes and what is drawn.
std::string description(const Figure& figure) {
  std::vector<std::string> names;
  for (const Curve& curve : figure.curves) names.push_back(curve.label);
  for (const Band& band : figure.bands) names.push_back(band.label + " (band)");
  for (const Marker& marker : figure.markers) names.push_back(marker.label + " (vertical line)");
  return fmt::format("Horizontal axis: {}. Vertical axis: {}. Shown: {}.", figure.x_label,
                     figure.y_label, fmt::join(names, "; "));
}

}  // namespace

DrawnFigure draw_figure(const Figure& figure, const std::filesystem::path& scratch_directory) {
  const auto gnuplot = process::search_path("gnuplot");
  if (gnuplot.empty()) {
    throw ReportError(
        "gnuplot, which draws the report's figures, is not on the PATH (Debian: apt-get install "
        "gnuplot-nox)");
  }
  const auto script = scratch_directory / (figure.id + ".gp");
  const auto output = scratch_directory / (figure.id + ".raw.svg");
  const auto messages = scratch_directory / (figure.id + ".log");
  write_text(script, gnuplot_script(figure));
  std::error_code failure;
  const int status =
      process::system(gnuplot, "--default-settings", script.string(),
                      process::std_in<process::null, process::std_out> output.string(),
                      process::std_err > messages.string(), failure);
  if (failure)
    throw ReportError(
        fmt::format("figure '{}': gnuplot did not start: {}", figure.id, failure.message()));
  if (status != 0) {
    throw ReportError(fmt::format("figure '{}': gnuplot ended with status {}: {}", figure.id,
                                  status, read_text(messages)));
  }
  return {shared_markup(read_text(output), figure.id), canvas_width, canvas_height(figure)};
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
