#include <utility>

#include "verification/peers/dualsphysics/definition.hpp"

namespace slosh {

// GaugesSWL reads still water too high and GaugesMaxZ too low, by parts of a spacing: the first
// reading is the datum, but for a dam, at whose gauges the surface need not be level at first.
std::vector<SeriesSource> dualsphysics_series(const CaseDefinition& definition) {
  std::vector<SeriesSource> series;
  const auto add_series = [&](const std::string& quantity, const std::string& file,
                              const char* column, const char* unit) -> SeriesSource& {
    series.push_back({.quantity = quantity,
                      .file = file + ".csv",
                      .format = "dualsphysics_gauge",
                      .column = column,
                      .unit = unit});
    return series.back();
  };
  const auto above_still_level = [&](SeriesSource& source) {
    if (definition.liquid.column_width)
      source.offset = -definition.liquid.fill_depth;
    else
      source.first_is_zero = true;
  };
  for (const auto& [name, x] : definition.gauges) {
    above_still_level(add_series("elevation@" + name, "GaugesSWL_surface_" + name, "swlz", ""));
    above_still_level(
        add_series("highest_surface@" + name, "GaugesMaxZ_highest_" + name, "zmax", ""));
  }
  for (const ProbeDefinition& probe : definition.probes)
    for (const auto& [component, column] :
         {std::pair{"velocity_x@", "velx"}, {"velocity_z@", "velz"}})
      add_series(component + probe.name, "GaugesVel_probe_" + probe.name, column, "");
  if (definition.wall_forces.empty())
    for (const auto& [force, column] : {std::pair{"force_x", "forcex"}, {"force_z", "forcez"}})
      add_series(force, "GaugesForce_on_tank", column, "N/m").whole_tank = true;
  for (const Wall wall : definition.wall_forces)
    for (const auto& [force, column] : {std::pair{"force_x@", "forcex"}, {"force_z@", "forcez"}})
      add_series(force + name_of(wall, wall_names), "GaugesForce_on_" + name_of(wall, wall_names),
                 column, "N/m");
  return series;
}

}  // namespace slosh
