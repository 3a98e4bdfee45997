// The tank's motion as interFoam's tabulatedAccelerationSource takes it, which transforms the
// equations of motion to the tank's frame by
//
//     g_eff = g - a,   and per unit mass   -2 Omega x u - Omega x (Omega x r) - dOmega/dt x r,
//
// where r starts at the mesh's origin, which is the roll's axis. In the tank's frame gravity keeps
// its direction (0, 0, -g), so that `a` must also account for its tilt. With the surge X along the
// earth's horizontal and the angle theta, counter-clockwise positive with x to the right and z up,
//
//     a = (X'' cos theta + g sin theta, 0, -X'' sin theta + g cos theta - g),
//     Omega = (0, -theta', 0), as with x to the right and z up y points away from the viewer.
#pragma once

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

struct FrameMotion {
  double acceleration_x, acceleration_z;  // a [m/s2]
  double omega_y, omega_y_derivative;     // [rad/s], [rad/s2]
};

// Throws std::invalid_argument where the motion is not finite at that time [s].
FrameMotion frame_motion(const SloshingTank& tank, double time);

// The velocity of liquid and gas relative to the tank at the start, along the tank's axes [m/s].
struct Velocity {
  double x, z;
};

Velocity initial_velocity(const SloshingTank& tank, const TankMesh& mesh, Cell cell);

}  // namespace slosh::openfoam
