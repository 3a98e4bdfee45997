#include "openfoam_cases/compressible_fluids.hpp"

#include <fmt/format.h>

namespace slosh::openfoam {
namespace {

constexpr double temperature = 293.15;          // [K], 20 degrees Celsius
constexpr double molar_gas_constant = 8314.47;  // [J/(kmol K)], of OpenFOAM's etc/controlDict
// [m/s], of water at 20 degrees Celsius (Del Grosso and Mader 1972, J. Acoust. Soc. Am. 52:1442).
constexpr double speed_of_sound = 1482.3;

}  // namespace

void set_compressible_fluids(const SloshingTank& tank, kainjow::mustache::data& values) {
  const auto set = [&values](const char* name, double value) {
    values.set(name, fmt::format("{}", value));
  };
  constexpr double inverse_compressibility = speed_of_sound * speed_of_sound;
  set("temperature", temperature);
  set("liquid_gas_constant", inverse_compressibility / temperature);
  set("liquid_density_at_zero_pressure",
      tank.liquid.density - atmosphere / inverse_compressibility);
  set("gas_molar_mass", tank.gas.density * molar_gas_constant * temperature / atmosphere);
  set("liquid_dynamic_viscosity", tank.liquid.density * tank.liquid.kinematic_viscosity);
  set("gas_dynamic_viscosity", tank.gas.density * tank.gas.kinematic_viscosity);
}

}  // namespace slosh::openfoam
