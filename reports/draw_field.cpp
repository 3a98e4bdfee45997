#include "reports/draw_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <string_view>
#include <vector>

#include "reports/base64.hpp"
#include "reports/field_layout.hpp"
#include "reports/field_range.hpp"
#include "reports/field_script.hpp"
#include "reports/run_gnuplot.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {
namespace {

// The first bytes and the last chunk of every PNG file (its specification, 5.2 and 11.2.5).
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view png_end = "IEND\xae\x42\x60\x82";

}  // namespace

DrawnField draw_field(const FieldFigure& figure, const std::filesystem::path& scratch_directory) {
  const FieldLayout layout = field_layout(figure);
  std::string png = run_gnuplot(field_script(figure, layout), figure.id, scratch_directory);
  if (!boost::starts_with(png, png_signature) || !boost::ends_with(png, png_end)) {
    throw ReportError(broken_output(figure.id, "PNG file", scratch_directory));
  }
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
