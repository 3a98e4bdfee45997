// A tank that moves as a rigid body in its plane: its axis (X0, z0) surges by X(t), and the tank
// rolls about it by theta(t), positive counter-clockwise with x to the right and z up. Both may be
// of any size. In the tank's frame x is measured from the tank's CENTRE and z up from the still
// surface. The points of the tank have the velocity in the earth's frame, along the tank's axes,
//   u_tank = V_x - theta' (z - z0),  V_x =  X' cos(theta),
//   w_tank = V_z + theta' (x - X0),  V_z = -X' sin(theta),
// and the height Z = z0 + (x - X0) sin(theta) + (z - z0) cos(theta) in the earth's frame.
#pragma once

#include <functional>

namespace slosh::reference {

// Functions of the time [s]. For a tank that does not surge, or does not roll, all functions of
// that motion are empty.
struct TankMotion {
  std::function<double(double)> surge_velocity = {},
                                surge_acceleration = {};  // X' [m/s], X'' [m/s2]
  std::function<double(double)> angle = {}, rate = {},
                                roll_acceleration = {};  // theta [rad], theta', theta''
  double axis_x = 0, axis_z = 0;  // [m]: X0 from the tank's centre, z0 above the still surface
};

// The velocity of the tank's points along the tank's axes [m/s], or its rate of change at points
// that are fixed in the tank [m/s2].
struct RigidField {
  double x, z;            // of the axis itself
  double spin;            // [rad/s] or [rad/s2]
  double axis_x, axis_z;  // [m]

  double along_x(double at_z) const { return x - spin * (at_z - axis_z); }
  double along_z(double at_x) const { return z + spin * (at_x - axis_x); }
};

// The tank's angle [rad], velocity and acceleration at one time.
struct TankPlace {
  double angle;
  RigidField velocity, acceleration;

  double height(double x, double z) const;  // Z [m]
};

// The load of the liquid on the walls and the bottom, along the tank's axes, per metre of width.
struct WallLoad {
  double force_x, force_z;  // [N/m]
  double left, right;       // the parts of force_x on the side walls [N/m]; force_z is the bottom's
  double moment;            // about the axis, counter-clockwise [N]
};

// Returns where the tank is at t [s]. Throws std::invalid_argument for a surge or a roll of which
// some functions are empty and others are not, and for an axis or a value that is not finite.
TankPlace place(const TankMotion& motion, double t);

}  // namespace slosh::reference
