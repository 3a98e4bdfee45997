#include "reports/fields/draw_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/fields/field_layout.hpp"
#include "reports/fields/field_range.hpp"
#include "reports/fields/field_script.hpp"
#include "reports/model/base64.hpp"
#include "reports/model/png_file.hpp"
#include "reports/model/report_error.hpp"

namespace slosh::reports {

DrawnField draw_field(const FieldFigure& figure, const std::filesystem::path& scratch_directory,
                      const Gnuplot& gnuplot) {
  const FieldLayout layout = field_layout(figure);
  std::string png = gnuplot(field_script(figure, layout), figure.id, scratch_directory);
  if (!is_whole_png(png))
    throw ReportError(broken_output(figure.id, "PNG file", scratch_directory));
  return {std::move(png), layout.width, layout.height};
}

std::string description(const FieldFigure& figure) {
  std::vector<std::string> labels;
  for (const FieldPanel& panel : figure.panels) labels.push_back(panel.label);
  const ColourRange range = colour_range(figure);
  const bool arrows = std::any_of(figure.panels.begin(), figure.panels.end(),
                                  [](const FieldPanel& panel) { return !panel.arrow_x.empty(); });
  return fmt::format("{}. Panels: {}. Colour: {} from {} to {}.{}", figure.title,
                     fmt::join(labels, "; "), figure.value_label, range.ticks.front().label,
                     range.ticks.back().label, arrows ? " Arrows: velocity." : "");
}

std::string data_address(const DrawnField& drawn) {
  return "data:image/png;base64," + base64(drawn.png);
}

}  // namespace slosh::reports
