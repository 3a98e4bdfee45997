#include "reference/tank_mode.hpp"

#include <cmath>
#include <numbers>

#include "reference/natural_frequency.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

// Returns the modes of a tank at rest, with neither a coupling nor an initial rate.
std::vector<TankMode> still_modes(const Tank& tank, const std::optional<Gas>& gas, int count,
                                  std::string_view where) {
  require(count >= 1, where, "number of modes", count, "1 or more (500 for a converged elevation)");
  require(tank.density > 0 && std::isfinite(tank.density), where, "liquid density", tank.density,
          "a density > 0 kg/m3");
  std::vector<TankMode> modes;
  modes.reserve(count);
  for (int n = 0; n < count; ++n) {
    const int m = 2 * n + 1;
    const double omega = gas ? natural_frequency(tank, *gas, m) : natural_frequency(tank, m);
    const double lambda = m * std::numbers::pi / tank.length;
    const double sign = n % 2 == 0 ? 1 : -1;
    modes.push_back({.wave_number = lambda,
                     .depth_factor = std::tanh(lambda * tank.fill_depth),
                     .line = sign * 4 / (tank.length * lambda * lambda),
                     .coupling = 0,
                     .natural_frequency = omega,
                     .initial_rate = 0});
  }
  return modes;
}

}  // namespace

std::vector<TankMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                  double initial_velocity, int count) {
  constexpr auto where = "LinearSurge";
  require(std::isfinite(initial_velocity), where, "initial velocity", initial_velocity,
          "a finite velocity, m/s");
  auto modes = still_modes(tank, gas, count, where);
  for (TankMode& mode : modes) {
    mode.coupling = mode.line * mode.natural_frequency * mode.natural_frequency / tank.gravity;
    mode.initial_rate = -mode.coupling * initial_velocity;
  }
  return modes;
}

std::vector<TankMode> roll_modes(const Tank& tank, const std::optional<Gas>& gas,
                                 const RollStart& roll, int count) {
  constexpr auto where = "LinearRoll";
  require(std::isfinite(roll.axis_z), where, "axis_z", roll.axis_z, "a finite height, m");
  require(std::isfinite(roll.rate), where, "initial rate", roll.rate, "a finite rate, rad/s");
  auto modes = still_modes(tank, gas, count, where);
  const double gas_density = gas ? gas->density : 0, gas_height = gas ? gas->height : 0;
  const double weight = tank.gravity * (tank.density - gas_density);
  for (TankMode& mode : modes) {
    const auto below_lid = [&](double height) {  // of the surface
      return 2 * std::tanh(mode.wave_number * height / 2) / mode.wave_number;
    };
    const double rigid = tank.density * (roll.axis_z + below_lid(tank.fill_depth)) -
                         gas_density * (roll.axis_z - below_lid(gas_height));
    const double mobility = mode.natural_frequency * mode.natural_frequency / weight;  // 1/D_n
    mode.coupling = mode.line * (rigid * mobility - 1);
    mode.initial_rate = (roll.start == Start::earth ? -mode.coupling : mode.line) * roll.rate;
  }
  return modes;
}

std::vector<double> surface_shapes(const std::vector<TankMode>& modes, double x) {
  std::vector<double> shapes;
  shapes.reserve(modes.size());
  for (const TankMode& mode : modes) shapes.push_back(std::sin(mode.wave_number * x));
  return shapes;
}

DepthProfile depth_profile(double lambda, double z, double depth) {
  const double surface_wave = std::exp(lambda * z) / (1 + std::exp(-2 * lambda * depth));
  const double bottom_image = std::exp(-2 * lambda * (z + depth));
  return {surface_wave * (1 + bottom_image), surface_wave * (1 - bottom_image)};
}

}  // namespace slosh::reference
