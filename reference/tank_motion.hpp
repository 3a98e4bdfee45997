// A tank that moves as a rigid body in its plane: its axis (X0, z0) surges by X(t), and the tank
// rolls about it by theta(t), counter-clockwise with x to the right and z up, both of any size.
// x from the tank's CENTRE and z up from the still surface in the tank's frame. Along the
// tank's axes its points move, against the earth, with
//   u_tank = V_x - theta' (z - z0),  V_x =  X' cos(theta),
//   w_tank = V_z + theta' (x - X0),  V_z = -X' sin(theta),
// and stand at the height Z = z0 + (x - X0) sin(theta) + (z - z0) cos(theta) in the earth's frame.
#pragma once

#include <functional>

namespace slosh::reference {

// Functions of the time [s]. A tank that does not surge, or does not roll, leaves all the functions
// of that motion empty.
struct TankMotion {
  std::function<double(double)> surge_velocity = {},
                                surge_acceleration = {};  // X' [m/s], X'' [m/s2]
  std::function<double(double)> angle = {}, rate = {},
                                roll_acceleration = {};  // theta [rad], theta', theta''
  double axis_x = 0, axis_z = 0;  // [m]: X0 from the tank's centre, z0 above the still surface
};

// The velocity of the tank's points along the tank's axes [m/s], or its rate of change at points
// fixed in the tank [m/s2].
struct RigidField {
  double x, z;            // the axis's own
  double spin;            // [rad/s] or [rad/s2]
  double axis_x, axis_z;  // [m]

  double along_x(double at_z) const { return x - spin * (at_z - axis_z); }
  double along_z(double at_x) const { return z + spin * (at_x - axis_x); }
};

// How the tank stands and moves at one time.
struct TankPlace {
  double angle;
  RigidField velocity, acceleration;

  double height(double x, double z) const;  // Z [m]
};

// What the liquid does to the walls and the bottom, along the tank's axes, per metre of width.
struct WallLoad {
  double force_x, force_z;  // [N/m]
  double moment;            // about the axis, counter-clockwise [N]
};

// Throws std::invalid_argument for a motion of which one function is given and another is not, an
// axis that is not finite, and a value that is not finite.
TankPlace place(const TankMotion& motion, double t);

}  // namespace slosh::reference
