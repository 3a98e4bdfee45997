#include "verification/case_file/quantities.hpp"

namespace slosh {

std::vector<std::string> compared_quantities(const CaseDefinition& definition) {
  std::vector<std::string> quantities;
  if (definition.liquid.column_width) quantities.push_back("front_position");
  for (const GaugeDefinition& gauge : definition.gauges)
    quantities.push_back("elevation@" + gauge.name);
  return quantities;
}

bool has_modes(const std::string& quantity) { return quantity.starts_with("elevation@"); }

}  // namespace slosh
