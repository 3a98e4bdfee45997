#include "verification/case/gap_friction.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"

namespace slosh {
namespace {

// Returns the frequency with which the liquid oscillates [rad/s].
double frequency_of(const CaseDefinition& definition) {
  if (const double forced = forcing_frequency(definition); forced > 0) return forced;
  if (!is_rectangle(definition.tank))
    throw std::invalid_argument(
        "the friction between the walls of a tank that is no rectangle: "
        "expected a motion with a single frequency");
  const int mode = definition.initial_wave ? definition.initial_wave->mode : 1;
  const double k = mode * std::numbers::pi / definition.tank.length;
  return std::sqrt(definition.gravity * k * std::tanh(k * definition.liquid.fill_depth));
}

}  // namespace

WallLayers layers_between_walls(double gap, double kinematic_viscosity, double angular_frequency) {
  if (kinematic_viscosity == 0) return {0, 0};
  using Complex = std::complex<double>;
  const Complex i_omega{0, angular_frequency};
  const Complex kappa = 0.5 * gap * std::sqrt(i_omega / kinematic_viscosity);
  // In a thin gap the denominator loses its digits: 1 / (1 - tanh(kappa) / kappa) is there the
  // series 3 / kappa^2 + 6/5 - kappa^2 / 175, which is exact to 1e-7.
  if (std::abs(kappa) < 0.1)
    return {12 * kinematic_viscosity / (gap * gap) + angular_frequency * std::norm(kappa) / 175,
            0.2};
  const Complex force = i_omega / (1.0 - std::tanh(kappa) / kappa);
  return {force.real(), force.imag() / angular_frequency - 1};
}

double gap_friction(const CaseDefinition& definition) {
  const std::optional<double> gap = definition.tank.breadth;
  if (!gap) return 0;
  return layers_between_walls(*gap, definition.liquid.kinematic_viscosity, frequency_of(definition))
      .friction;
}

}  // namespace slosh
