// The closed form of one mode under X(t) = b sin(omega t), with F = coupling b omega^2,
// delta = omega_n - omega, sigma = omega_n + omega and sinc(x) = sin(x)/x, sinc(0) = 1:
//   eta_n   = eta_n'(0)/omega_n sin(omega_n t)
//             + F/(omega_n sigma) [sin(omega t) - omega t cos(sigma t/2) sinc(delta t/2)]
//   eta_n'  = eta_n'(0) cos(omega_n t) + F omega t/sigma sin(sigma t/2) sinc(delta t/2)
//   eta_n'' = F sin(omega t) - omega_n^2 eta_n
// It is the usual P sin(omega t) + (eta_n'(0) - P omega)/omega_n sin(omega_n t) with
// P = F/(omega_n^2 - omega^2), the small divisor taken out by the difference of two sines: nothing
// cancels near resonance, and omega = omega_n gives the growing wave
//   F/(2 omega^2) [sin(omega t) - omega t cos(omega t)].
#pragma once

#include "reference/tank_mode.hpp"

namespace slosh::reference {

// The mode at the time t [s] >= 0.
ModeState forced_mode(const TankMode& mode, const SineSurge& motion, double t);

}  // namespace slosh::reference
