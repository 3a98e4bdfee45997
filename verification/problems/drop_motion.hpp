// The exact motion of an ellipse of liquid under a central force -Omega^2 r, that starts as the
// circle of radius R with the velocity A0 (x, -z): its semi-axes a (along x) and b follow
//   a' = sigma a,  b' = -sigma b,  sigma' = (sigma^2 + Omega^2) (b^2 - a^2) / (a^2 + b^2)
// (Monaghan & Rafiee 2013, Int. J. Numer. Meth. Fluids 71:537; the incompressible Euler
// equations with a pressure that is quadratic in the place and vanishes on the ellipse).
#pragma once

namespace slosh {

struct SemiAxes {
  double a, b;   // over R
  double sigma;  // of the velocity sigma (x, -z), over Omega
};

// From one state to that a time later, in units of 1 / Omega; Runge and Kutta's fourth order with
// steps of at most 0.002.
SemiAxes advanced(SemiAxes from, double time);

// Of the whole motion, which starts with sigma = amplitude, in units of 1 / Omega.
double drop_period(double amplitude);

}  // namespace slosh
