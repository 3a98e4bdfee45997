#include "verification/case/quantities.hpp"

#include <algorithm>
#include <stdexcept>

namespace slosh {
namespace {

struct Kind {
  std::string name;  // up to the gauge's, where it ends in '@'
  const char* unit;
  bool has_modes, is_gauged;
};

const std::vector<Kind> kinds{
    {"front_position", "m", false, false}, {"elevation@", "m", true, true},
    {"wall_pressure@", "Pa", true, true},  {"force_x", "N/m", true, false},
    {"force_z", "N/m", false, false},      {"moment", "N", true, false},
    {"momentum_x", "kg/s", true, false},   {"momentum_z", "kg/s", false, false},
    {"highest_surface@", "m", true, false}};

const Kind* kind_of(const std::string& quantity) {
  const std::string name = quantity.substr(0, quantity.find('@') + 1);
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) {
    return kind.name == (name.empty() ? quantity : name);
  });
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> compared_quantities(const CaseDefinition& definition) {
  std::vector<std::string> quantities;
  if (definition.liquid.column_width) quantities.push_back("front_position");
  for (const GaugeDefinition& gauge : definition.gauges)
    quantities.push_back("elevation@" + gauge.name);
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    quantities.push_back("wall_pressure@" + gauge.name);
    if (gauge.filter_cutoff) quantities.push_back("wall_pressure@" + gauge.name + "/filtered");
  }
  quantities.insert(quantities.end(), {"force_x", "force_z"});
  if (definition.motion.roll) quantities.push_back("moment");
  quantities.insert(quantities.end(), {"momentum_x", "momentum_z"});
  for (const GaugeDefinition& gauge : definition.gauges)
    quantities.push_back("highest_surface@" + gauge.name);
  return quantities;
}

std::string unit_of(const std::string& quantity) {
  if (const Kind* kind = kind_of(quantity)) return kind->unit;
  throw std::invalid_argument("no compared quantity: " + quantity);
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds)
    names.push_back(kind.name + (kind.name.ends_with('@') ? "GAUGE" : ""));
  return names;
}

bool has_modes(const std::string& quantity) {
  const Kind* kind = kind_of(quantity);
  return kind && kind->has_modes;
}

bool is_gauged(const std::string& quantity) {
  const Kind* kind = kind_of(quantity);
  return kind && kind->is_gauged;
}

}  // namespace slosh
