#include "verification/campaign/shown_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "verification/case_file/quantities.hpp"
#include "verification/metrics/low_pass_filter.hpp"

namespace slosh {
namespace {

constexpr std::string_view filtered = "/filtered";

template <class Gauge>
const Gauge& gauge_named(const std::vector<Gauge>& gauges, const std::string& name) {
  const auto found = std::find_if(gauges.begin(), gauges.end(),
                                  [&](const Gauge& gauge) { return gauge.name == name; });
  if (found == gauges.end()) throw std::invalid_argument("the case has no gauge " + name);
  return *found;
}

std::string wall_text(const PressureGaugeDefinition& gauge) {
  if (gauge.wall == Wall::bottom)
    return fmt::format("on the bottom {:.3g} m from the left wall", gauge.position);
  return fmt::format("on the {} wall {:.3g} m above the bottom",
                     gauge.wall == Wall::left ? "left" : "right", gauge.position);
}

ShownQuantity pressure(const CaseDefinition& definition, const std::string& name,
                       bool is_filtered) {
  const PressureGaugeDefinition& gauge = gauge_named(definition.pressure_gauges, name);
  const std::string state = is_filtered ? ", filtered" : gauge.filter_cutoff ? ", unfiltered" : "";
  const std::string sensor =
      gauge.width > 0 ? fmt::format("the mean over the sensor, {:.3g} mm wide", 1000 * gauge.width)
                      : "at a point";
  const std::string filter =
      is_filtered ? "low-pass filter, the same for all: " + low_pass_name(*gauge.filter_cutoff)
                  : "unfiltered";
  return {"Pressure " + wall_text(gauge) + state, "pressure", "Pa", 1,
          fmt::format("Above the gas's pressure, {}. SPH: the kernel mean over three spacings, "
                      "carried to the wall by its pressure gradient; interFoam: interpolated "
                      "between the wall's faces, less the gas's mean. Solvers and theory are "
                      "sampled every {:.3g} s, at that instant; {}.",
                      sensor, definition.sample_interval, filter)};
}

ShownQuantity force(const std::string& title, const char* word, const char* unit,
                    const std::string& what) {
  return {title, word, unit, 1,
          what +
              " SPH: the reaction to what the walls give the particles; interFoam: liquid and "
              "gas on the walls and obstacles; theory: its pressure on the walls and the bottom "
              "up to the still surface."};
}

ShownQuantity ungauged(const std::string& quantity) {
  const std::string along = "On the tank, per metre of width, along the tank's axes.";
  if (quantity == "front_position")
    return {"Front of the breaking dam, from the left wall", "front position", "mm", 1000, ""};
  if (quantity == "force_x") return force("Force along the tank's bottom", "force x", "N/m", along);
  if (quantity == "force_z")
    return force("Force normal to the tank's bottom", "force z", "N/m", along);
  if (quantity == "moment")
    return force("Moment about the roll's axis", "moment", "N",
                 "On the tank, per metre of width, counter-clockwise.");
  const bool horizontal = quantity == "momentum_x";
  if (!horizontal && quantity != "momentum_z")
    throw std::invalid_argument("no figure shows " + quantity);
  return {horizontal ? "Total momentum, horizontal" : "Total momentum, vertical",
          horizontal ? "momentum x" : "momentum z", "kg/s", 1,
          "Of the liquid against the earth, along the earth's axes, per metre of width."};
}

}  // namespace

ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity) {
  const std::size_t at = quantity.find('@');
  if (at == quantity.npos) return ungauged(quantity);
  const std::string kind = quantity.substr(0, at);
  std::string gauge = quantity.substr(at + 1);
  if (kind == "wall_pressure") {
    const bool is_filtered = gauge.ends_with(filtered);
    if (is_filtered) gauge.resize(gauge.size() - filtered.size());
    return pressure(definition, gauge, is_filtered);
  }
  const double x = gauge_named(definition.gauges, gauge).x;
  if (kind == "elevation")
    return {fmt::format("Surface elevation {:.3g} m from the left wall", x), "elevation", "mm",
            1000,
            "SPH and interFoam: the depth of liquid over the gauge, drops and overturning jets "
            "included, less the still depth."};
  return {fmt::format("Highest surface {:.3g} m from the left wall", x), "highest surface", "mm",
          1000,
          "The highest liquid over the gauge, spray included, above the still level. SPH: the "
          "upper edge of the highest particle within a spacing; interFoam: the highest place of "
          "the column where a cell is half full."};
}

std::string id_of(const std::string& quantity) {
  std::string id = quantity;
  if (id.ends_with(filtered)) id = "filtered_" + id.substr(0, id.size() - filtered.size());
  std::replace(id.begin(), id.end(), '@', '-');
  return id;
}

}  // namespace slosh
