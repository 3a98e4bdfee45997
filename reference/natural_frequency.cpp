#include "reference/natural_frequency.hpp"

#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_natural_frequency = "natural_frequency";

double wave_number(const Tank& tank, int m) {
  require(tank.length > 0 && std::isfinite(tank.length), in_natural_frequency, "tank length",
          tank.length, "a length > 0 m");
  require(tank.fill_depth > 0 && std::isfinite(tank.fill_depth), in_natural_frequency, "fill depth",
          tank.fill_depth, "a depth > 0 m");
  require(tank.gravity > 0 && std::isfinite(tank.gravity), in_natural_frequency, "gravity",
          tank.gravity, "an acceleration > 0 m/s2");
  require(m >= 1, in_natural_frequency, "mode", m, "1, 2, ...");
  return m * std::numbers::pi / tank.length;
}

}  // namespace

double natural_frequency(const Tank& tank, int m) {
  const double k = wave_number(tank, m);
  return std::sqrt(tank.gravity * k * std::tanh(k * tank.fill_depth));
}

double natural_frequency(const Tank& tank, const Gas& gas, int m) {
  const double k = wave_number(tank, m);
  require(tank.density > 0 && std::isfinite(tank.density), in_natural_frequency, "liquid density",
          tank.density, "a density > 0 kg/m3");
  require(gas.density >= 0 && gas.density < tank.density, in_natural_frequency, "gas density",
          gas.density, "a density from 0 to below the liquid's, kg/m3");
  require(gas.height > 0, in_natural_frequency, "gas height", gas.height, "a height > 0 m");
  const double inertia =
      tank.density / std::tanh(k * tank.fill_depth) + gas.density / std::tanh(k * gas.height);
  return std::sqrt(tank.gravity * k * (tank.density - gas.density) / inertia);
}

}  // namespace slosh::reference
