#include <fmt/format.h>

#include <algorithm>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

Wall read_wall(const TomlTable& gauge) {
  const std::string wall = gauge.choice("wall", "a wall", {"left", "right", "bottom"});
  if (wall == "left") return Wall::left;
  return wall == "right" ? Wall::right : Wall::bottom;
}

}  // namespace

GaugeDefinition read_gauge(const TomlTable& gauge, const CaseDefinition& definition) {
  gauge.allow_only(keys_of("gauge"));
  const Rule<double> inside_tank{
      fmt::format("a number from 0 to the tank's length ({}), in m from the left wall",
                  definition.tank.length),
      [length = definition.tank.length](double x) { return x >= 0 && x <= length; }, 0};
  return {.name = gauge.get("name", file_safe_name()), .x = gauge.get("x_m", inside_tank)};
}

PressureGaugeDefinition read_pressure_gauge(const TomlTable& gauge,
                                            const CaseDefinition& definition) {
  gauge.allow_only(keys_of("pressure_gauge"));
  PressureGaugeDefinition read{};
  read.name = gauge.get("name", file_safe_name());
  read.wall = read_wall(gauge);
  const bool along_bottom = read.wall == Wall::bottom;
  const double extent = along_bottom ? definition.tank.length : definition.tank.height;
  read.position = gauge.get<double>(
      "position_m", {fmt::format("a number from 0 to the tank's {} ({}), in m from the {}",
                                 along_bottom ? "length" : "height", extent,
                                 along_bottom ? "left wall" : "bottom"),
                     [extent](double at) { return at >= 0 && at <= extent; }});
  // A billionth for the rounding of a sensor that ends where the wall does.
  const double widest = 2 * std::min(read.position, extent - read.position) + 1e-9 * extent;
  read.width = gauge
                   .find<double>("width_m",
                                 {fmt::format("a number >= 0 and <= {:.6g}, in m: a sensor that "
                                              "lies on the wall as a whole",
                                              widest),
                                  [widest](double width) { return width >= 0 && width <= widest; }})
                   .value_or(0);
  const double highest = 0.5 / definition.sample_interval;
  read.filter_cutoff = gauge.find<double>(
      "filter_cutoff_Hz",
      {fmt::format("a number > 0 and below half the sampling rate ({:.6g}), in Hz", highest),
       [highest](double cutoff) { return cutoff > 0 && cutoff < highest; }});
  return read;
}

}  // namespace slosh
