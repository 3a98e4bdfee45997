// The free standing wave of one natural mode in a tank of any polygonal section, released from rest
// with eta(x,0) = A shape(x), where A is the elevation at the surface's LEFT end and shape is that
// of SectionModes, continued into the liquid as the harmonic S(x,z). Positions are in the outline's
// coordinates; h is the still surface's height and kappa = omega^2/g:
//   eta      = A S(x,h) cos(omega t)
//   velocity   grad phi,  phi = -A omega/kappa S sin(omega t)
//   pressure p = -rho g (z - h - A S cos(omega t))
//   force    F = rho A omega^2 cos(omega t) integral over the surface of x S
// Valid for small waves, as standing_wave.hpp says, of which this is the case of a rectangle.
#pragma once

#include "reference/section/section_modes.hpp"

namespace slosh::reference {

// Every function throws std::invalid_argument for NaN, a position outside the liquid at rest and a
// time before 0; the constructor throws it for a mode that `modes` does not have.
class SectionWave {
 public:
  SectionWave(const SectionModes& modes, int mode, double amplitude);  // 1, 2, ... and [m]

  double angular_frequency() const { return angular_frequency_; }  // [rad/s]
  double elevation(double x, double t) const;                      // [m]
  struct Velocity {
    double x, z;  // [m/s]
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  // Of the wave on the tank, per metre of width [N/m].
  double horizontal_force(double t) const;

 private:
  SectionModes modes_;
  int column_;
  double angular_frequency_, amplitude_;  // the amplitude is that of the normalised mode
};

}  // namespace slosh::reference
