// The scales of a case's flow by which an effect is judged. All follow from the case file alone.
#pragma once

#include <optional>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the frequency with which the liquid moves [rad/s]: that of the motion, or where it has no
// single one the first natural frequency; none where that is unknown.
std::optional<double> flow_frequency(const CaseDefinition& definition);

// Returns the thickness sqrt(2 nu / omega) of a Stokes layer [m].
double stokes_layer(const CaseDefinition& definition, double angular_frequency);

// Returns the height of the waves above the still level [m]: the amplitude of the initial wave or
// that of the forced one, whichever is higher; 0 without gravity. The forced one is
//   (theta + X'' / g) L / 2 / |1 - (omega / omega_1)^2|
// of the largest tilt of a surface that follows the motion without delay, over the length L, by the
// response of an oscillator of the first natural frequency omega_1. It is at most the run-up
// V^2 / (2 g) of the expected speed V, at which a wave breaks, and is that where a dam breaks or
// the motion has no single frequency.
double wave_height(const CaseDefinition& definition);

// Whether liquid may strike a sensor: the case declares impacts, or a pressure gauge is not wholly
// under the still level and the forced wave breaks or reaches the roof.
bool may_strike_a_gauge(const CaseDefinition& definition);

}  // namespace slosh
