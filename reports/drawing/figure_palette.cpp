#include "reports/drawing/figure_palette.hpp"

#include <fmt/format.h>

#include <vector>

namespace slosh::reports {

std::string dark_rules() {
  std::vector<PaletteColour> colours{paper, ink, faint_ink, grid};
  colours.insert(colours.end(), curve_colours.begin(), curve_colours.end());
  colours.insert(colours.end(), band_colours.begin(), band_colours.end());
  std::string rules;
  for (const auto& [light, dark] : colours) {
    for (const char* property : {"fill", "stroke", "color"}) {
      rules += fmt::format(".plot [{0}=\"{1}\"]{{{0}:{2}}}\n", property, light, dark);
    }
  }
  return rules;
}

}  // namespace slosh::reports
