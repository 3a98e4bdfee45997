#include "reports/fields/film_markup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <kainjow/mustache.hpp>
#include <vector>

#include "reports/fields/field_layout.hpp"
#include "reports/model/file_formats.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {

std::string film_element(const FieldFigure& figure, const DrawnField& drawn) {
  const FieldLayout layout = field_layout(figure);
  // A row's place counts as `background-position-y` does: as a percentage of what the picture is
  // taller than the frame, which holds at any width of the page.
  const int frame_height = layout.row_height() - row_gap;
  std::vector<std::string> positions;
  for (int row = 0; row < layout.rows; ++row)
    positions.push_back(
        fmt::format("{:.4f}", 100.0 * layout.row_top(row) / (layout.height - frame_height)));
  kainjow::mustache::mustache frame(film_template);
  kainjow::mustache::data data;
  data.set("id", figure.id);
  data.set("address", data_address(drawn));
  data.set("description", description(figure));
  data.set("width", std::to_string(drawn.width));
  data.set("key_height", std::to_string(key_height));
  data.set("frame_height", std::to_string(frame_height));
  data.set("positions", fmt::format("{}", fmt::join(positions, " ")));
  data.set("first", positions.front());
  data.set("labels", fmt::format("{}", fmt::join(figure.frames, "|")));
  data.set("first_label", figure.frames.front());
  data.set("last", std::to_string(figure.frames.size() - 1));
  return frame.render(data);
}

std::string film_script_element() { return fmt::format("<script>{}</script>", film_script); }

std::string film_script_policy() {
  const std::string hexadecimal = film_script_sha256;
  std::string bytes;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16));
  return fmt::format("script-src 'sha256-{}'", base64(bytes));
}

}  // namespace slosh::reports
