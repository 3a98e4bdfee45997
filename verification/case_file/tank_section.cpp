#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {

TankDefinition read_tank(const TomlTable& tank) {
  tank.allow_only(keys_of("tank"));
  return {.length = tank.get("length_m", positive("m")),
          .height = tank.get("height_m", positive("m"))};
}

LiquidDefinition read_liquid(const TomlTable& liquid, const TankDefinition& tank) {
  liquid.allow_only(keys_of("liquid"));
  const Rule<double> inside_tank{
      fmt::format("a number > 0 and below the tank's height ({}), in m", tank.height),
      [height = tank.height](double depth) { return depth > 0 && depth < height; },
      tank.height / 2};
  const Rule<double> within_length{
      fmt::format("a number > 0 and below the tank's length ({}), in m", tank.length),
      [length = tank.length](double width) { return width > 0 && width < length; },
      tank.length / 2};
  return {.fill_depth = liquid.get("fill_depth_m", inside_tank),
          .density = liquid.get("density_kg_m3", positive("kg/m3")),
          .kinematic_viscosity = liquid.get("kinematic_viscosity_m2_s", not_negative("m2/s")),
          .column_width = liquid.find("column_width_m", within_length)};
}

GasDefinition read_gas(const TomlTable& gas, const LiquidDefinition& liquid) {
  gas.allow_only(keys_of("gas"));
  const Rule<double> lighter{
      fmt::format("a number > 0 and below the liquid's density ({}), in kg/m3", liquid.density),
      [most = liquid.density](double density) { return density > 0 && density < most; },
      liquid.density / 2};
  return {.density = gas.get("density_kg_m3", lighter),
          .kinematic_viscosity = gas.get("kinematic_viscosity_m2_s", not_negative("m2/s"))};
}

}  // namespace slosh
