#include "reports/draw_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <string_view>
#include <vector>

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
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  // Three bytes make four characters; what the last three lack is marked by '=' (RFC 4648, 4).
  const std::size_t lacking = (3 - drawn.png.size() % 3) % 3;
  const std::string bytes = drawn.png + std::string(lacking, '\0');
  std::string address = "data:image/png;base64,";
  address.append(Base64(bytes.begin()), Base64(bytes.end()));
  return address.replace(address.size() - lacking, lacking, lacking, '=');
}

}  // namespace slosh::reports
