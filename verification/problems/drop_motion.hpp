// The exact motion of an ellipse of liquid under a central force -Omega^2 r. It starts as a circle
// of radius R with the velocity A0 (x, -z), and its semi-axes a (along x) and b follow
//   a' = sigma a,  b' = -sigma b,  sigma' = (sigma^2 + Omega^2) (b^2 - a^2) / (a^2 + b^2)
// (Monaghan & Rafiee 2013, Int. J. Numer. Meth. Fluids 71:537; the incompressible Euler
// equations with a pressure that is quadratic in x and z and vanishes on the ellipse).
#pragma once

namespace slosh {

struct SemiAxes {
  double a, b;   // over R
  double sigma;  // of the velocity sigma (x, -z), over Omega
};

// Returns the state after `time` [1 / Omega], integrated by the Runge-Kutta method of fourth order
// with steps of at most 0.002.
SemiAxes advanced(SemiAxes from, double time);

// Returns the period [1 / Omega] of the motion that starts with sigma = amplitude.
double drop_period(double amplitude);

}  // namespace slosh
