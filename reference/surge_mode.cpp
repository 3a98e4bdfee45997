#include "reference/surge_mode.hpp"

#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace slosh::reference {

std::vector<SurgeMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                   double initial_velocity, int count) {
  constexpr auto where = "LinearSurge";
  require(count >= 1, where, "number of modes", count, "1 or more (500 for a converged elevation)");
  require(std::isfinite(initial_velocity), where, "initial velocity", initial_velocity,
          "a finite velocity, m/s");
  require(tank.density > 0 && std::isfinite(tank.density), where, "liquid density", tank.density,
          "a density > 0 kg/m3");
  std::vector<SurgeMode> modes;
  modes.reserve(count);
  for (int n = 0; n < count; ++n) {
    const int m = 2 * n + 1;
    const double omega = gas ? natural_frequency(tank, *gas, m) : natural_frequency(tank, m);
    const double lambda = m * std::numbers::pi / tank.length;
    const double depth_factor = std::tanh(lambda * tank.fill_depth);
    const double sign = n % 2 == 0 ? 1 : -1;
    const double coupling = sign * 4 / (tank.length * lambda) * depth_factor;
    modes.push_back({.wave_number = lambda,
                     .depth_factor = depth_factor,
                     .coupling = coupling,
                     .natural_frequency = omega,
                     .initial_rate = -coupling * initial_velocity});
  }
  return modes;
}

}  // namespace slosh::reference
