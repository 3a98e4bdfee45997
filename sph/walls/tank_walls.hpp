// The rectangular tank at one time, in the frame of the particles' positions and velocities
// (frames.hpp). Its functions:
//   in_tank, in_frame         convert a position in the frame to one in the tank, from its bottom
//                             left corner, and back [m]
//   along_tank, along_frame   convert a vector to components along the tank's axes, and back
//   wall_velocity             returns the velocity of the tank's point at a position in the frame
//                             [m/s]
//   height                    returns the height of a position above a fixed level [m]
//   apparent_gravity          returns gravity less the wall's acceleration [m/s2]
//   pull                      returns gravity and the frame's inertial forces, per mass [m/s2]
#pragma once

#include <cassert>
#include <cmath>
#include <optional>

namespace slosh::sph {

// Whether the liquid slides along a wall or sticks to it.
enum class Slip { free, none };

// A position or a vector in components along x and z.
struct Vector2 {
  double x, z;
};

// Four planes parallel to the frame's axes, with the bottom at z = 0, that move along x.
struct TankWalls {
  double left, right;   // [m], at this time
  double bottom, roof;  // [m]
  double velocity;      // X' [m/s]
  double acceleration;  // X'' [m/s2]

  double length() const { return right - left; }
  double tank_height() const { return roof - bottom; }

  Vector2 in_tank(double x, double z) const { return {x - left, z}; }
  Vector2 in_frame(double x, double z) const { return {left + x, z}; }
  Vector2 along_tank(double x, double z) const { return {x, z}; }
  Vector2 along_frame(double x, double z) const { return {x, z}; }
  Vector2 wall_velocity(double, double) const { return {velocity, 0}; }
};

// The walls of a tank that moves and rolls, in the frame of the earth: a point of the tank at r
// from the axis is at axis + R r.
struct RollingTank {
  double tank_length, roof;   // [m]
  double axis_x, axis_z;      // of the roll, in the tank [m]
  double displacement;        // X of the axis, whose place in the earth is (X + axis_x, axis_z) [m]
  double velocity;            // X' [m/s]
  double cosine, sine, rate;  // of theta; theta' [rad/s]

  double length() const { return tank_length; }
  double tank_height() const { return roof; }

  Vector2 in_tank(double x, double z) const {
    const Vector2 from_axis = along_tank(x - displacement - axis_x, z - axis_z);
    return {axis_x + from_axis.x, axis_z + from_axis.z};
  }
  Vector2 in_frame(double x, double z) const {
    const Vector2 from_axis = along_frame(x - axis_x, z - axis_z);
    return {displacement + axis_x + from_axis.x, axis_z + from_axis.z};
  }
  Vector2 along_tank(double x, double z) const {
    return {cosine * x + sine * z, cosine * z - sine * x};
  }
  Vector2 along_frame(double x, double z) const {
    return {cosine * x - sine * z, cosine * z + sine * x};
  }
  Vector2 wall_velocity(double x, double z) const {
    return {velocity - rate * (z - axis_z), rate * (x - displacement - axis_x)};
  }
};

// The inertial forces in the frame of a tank that moves and rolls. A particle at r from the roll's
// axis with the velocity v relative to the tank has, besides the forces between particles, the
// acceleration
//   R^T (g - X'') - theta'' x r - theta' x (theta' x r) - 2 theta' x v - attraction r
// where R is the rotation by theta about the axis, positive from x towards z. The terms are rotated
// gravity and the angular, centripetal and Coriolis term (Zhao et al. 2021, section 2.4), and for
// problems with a known solution a central force.
struct InertialForces {
  double axis_x = 0, axis_z = 0;        // of the roll [m]
  double cosine = 1, sine = 0;          // of theta
  double rate = 0, rate_of_change = 0;  // theta' [rad/s], theta'' [rad/s2]
  double surge_acceleration = 0;        // X'' of the axis, along the earth's horizontal [m/s2]
  double attraction = 0;                // to the axis [1/s2]

  template <class Number>
  Number height(Number x, Number z) const {
    return sine * x + cosine * z;
  }
  template <class Number>
  void pull(double gravity, Number x, Number z, Number u, Number w, Number& acceleration_x,
            Number& acceleration_z) const {
    const Number from_axis_x = x - axis_x, from_axis_z = z - axis_z;
    acceleration_x = rate_of_change * from_axis_z + rate * (rate * from_axis_x + 2.0 * w) -
                     (gravity * sine + surge_acceleration * cosine) - attraction * from_axis_x;
    acceleration_z = rate * (rate * from_axis_z - 2.0 * u) - rate_of_change * from_axis_x -
                     (gravity * cosine - surge_acceleration * sine) - attraction * from_axis_z;
  }
};

// The tank in any frame. Where it rolls in the frame of the earth, `rolling` takes the place of the
// walls; where the frame is its own, the walls are at rest and `forces` act on the liquid.
struct Tank {
  TankWalls walls;
  std::optional<RollingTank> rolling;
  std::optional<InertialForces> forces;

  Tank(const TankWalls& of_tank) : walls(of_tank) {}
  Tank(const RollingTank& tank) : walls{}, rolling(tank) {}
  Tank(const TankWalls& of_tank, const InertialForces& in_frame)
      : walls(of_tank), forces(in_frame) {}

  double length() const { return rolling ? rolling->length() : walls.length(); }
  double tank_height() const { return rolling ? rolling->tank_height() : walls.tank_height(); }
  Vector2 in_tank(double x, double z) const {
    return rolling ? rolling->in_tank(x, z) : walls.in_tank(x, z);
  }
  Vector2 in_frame(double x, double z) const {
    return rolling ? rolling->in_frame(x, z) : walls.in_frame(x, z);
  }
  Vector2 along_tank(double x, double z) const {
    return rolling ? rolling->along_tank(x, z) : walls.along_tank(x, z);
  }
  Vector2 along_frame(double x, double z) const {
    return rolling ? rolling->along_frame(x, z) : walls.along_frame(x, z);
  }
  Vector2 wall_velocity(double x, double z) const {
    return rolling ? rolling->wall_velocity(x, z) : walls.wall_velocity(x, z);
  }
  // Calls loop(axes), where the axes have the functions above: a loop over all particles is
  // compiled for each kind of them.
  template <class Loop>
  auto with_axes(const Loop& loop) const {
    return rolling ? loop(*rolling) : loop(walls);
  }

  template <class Number>
  Number height(Number x, Number z) const {
    return forces ? forces->height(x, z) : z;
  }
  // Not of a tank that rolls in the frame of the earth, whose walls are dynamic boundary particles.
  Vector2 apparent_gravity(double gravity, double x, double z, double u, double w) const {
    assert(!rolling);
    return forces ? pull(gravity, x, z, u, w) : Vector2{-walls.acceleration, -gravity};
  }
  Vector2 pull(double gravity, double x, double z, double u, double w) const {
    Vector2 acceleration{0, 0};
    pull(gravity, x, z, u, w, acceleration.x, acceleration.z);
    return acceleration;
  }
  // Sets the acceleration to it, of one particle or of those in the lanes.
  template <class Number>
  void pull(double gravity, Number x, Number z, Number u, Number w, Number& acceleration_x,
            Number& acceleration_z) const {
    if (forces) return forces->pull(gravity, x, z, u, w, acceleration_x, acceleration_z);
    acceleration_x = Number{};
    acceleration_z = Number{} - gravity;
  }
};

}  // namespace slosh::sph
