// The friction of a narrow tank's gap walls, which interFoam in two dimensions does not
// see.
// Between two parallel walls the gap b apart, the mean velocity v over the gap of a laminar flow
// that oscillates as exp(i omega t) follows from the force f per mass that drives it (Landau &
// Lifshitz 1987, section 24, problem 6):
//   f = i omega v / (1 - tanh(kappa) / kappa),   kappa = (b / 2) sqrt(i omega / nu)
// The part in phase with the velocity is a friction f = ... + r v with the rate
//   r = Re(i omega / (1 - tanh(kappa) / kappa))
// Its limits, with the thickness delta = sqrt(2 nu / omega) of a Stokes layer, are
//   r -> 12 nu / b^2                              for delta >> b, Poiseuille flow in a thin gap
//   r -> (2 / b) sqrt(nu omega / 2) + 4 nu / b^2  for delta << b, two Stokes layers
// so that no model needs to be chosen. The first term of the second limit alone is 15 % too low at
// delta = b / 12.
//
// The part out of phase is an added mass,
//   a = Im(i omega / (1 - tanh(kappa) / kappa)) / omega - 1
// It is r / omega for thin layers and 1/5 in a thin gap, and lowers a natural frequency by half of
// that. interFoam leaves it out, as it would need it in the inertia of the liquid; SPH has both
// parts (sph/terms/gap_layers.hpp).
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

struct WallLayers {
  double friction;    // the rate r [1/s]
  double added_mass;  // a, as a share of the liquid's inertia
};

// Returns what the two walls add to the mean motion over the gap [m] of a liquid of this viscosity
// [m2/s] at this frequency [rad/s]; for the frequency 0 the limit of Poiseuille flow, and nothing
// for a liquid without viscosity.
WallLayers layers_between_walls(double gap, double kinematic_viscosity, double angular_frequency);

// Returns the rate r of the case's tank [1/s], or 0 where the case gives no breadth. The frequency
// is that of the forcing. Where the forcing has no single one, it is the natural frequency of the
// initial wave's mode, and without a wave that of the first mode; these are known of a rectangle
// alone, and std::invalid_argument is thrown for another tank.
double gap_friction(const CaseDefinition& definition);

}  // namespace slosh
