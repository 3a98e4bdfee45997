// The frame in which a scheme follows the particles: the tank's motion in it, and the initial state
// of the liquid.
//   EarthFrame         the walls surge
//   RollingEarthFrame  the walls surge and roll; only walls made of particles can
//   TankFrame          the walls are fixed, and the tank's motion acts as inertial forces
#pragma once

#include <cmath>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

struct EarthFrame {
  static constexpr const char* name = "walls move in the frame of the earth";
  static constexpr bool takes_roll = false, walls_roll = false, is_tanks = false;

  static Tank tank(const Scene& scene, double t) {
    const double x = scene.displacement(t);
    return TankWalls{
        x, x + scene.tank_length, 0, scene.tank_height, scene.velocity(t), scene.acceleration(t)};
  }
};

struct RollingEarthFrame {
  static constexpr const char* name = "walls move and roll in the frame of the earth";
  static constexpr bool takes_roll = true, walls_roll = true, is_tanks = false;

  static Tank tank(const Scene& scene, double t) {
    const Roll& roll = roll_of(scene);
    const double angle = roll.angle(t);
    return RollingTank{.tank_length = scene.tank_length,
                       .roof = scene.tank_height,
                       .axis_x = roll.axis_x,
                       .axis_z = roll.axis_z,
                       .displacement = scene.displacement(t),
                       .velocity = scene.velocity(t),
                       .cosine = std::cos(angle),
                       .sine = std::sin(angle),
                       .rate = roll.rate(t)};
  }
};

struct TankFrame {
  static constexpr const char* name =
      "walls fixed, the tank's motion as forces (turning gravity, angular, centripetal, Coriolis)";
  static constexpr bool takes_roll = true, walls_roll = false, is_tanks = true;

  static Tank tank(const Scene& scene, double t) {
    const Roll& roll = roll_of(scene);
    const double angle = roll.angle(t);
    return {TankWalls{0, scene.tank_length, 0, scene.tank_height, 0, 0},
            InertialForces{.axis_x = roll.axis_x,
                           .axis_z = roll.axis_z,
                           .cosine = std::cos(angle),
                           .sine = std::sin(angle),
                           .rate = roll.rate(t),
                           .rate_of_change = roll.acceleration(t),
                           .surge_acceleration = scene.acceleration(t)}};
  }
};

// A frame as a run knows it.
struct Frame {
  const char* name;
  bool takes_roll;
  bool is_tanks;  // whether velocities in it are relative to the tank
  Tank (*tank)(const Scene&, double t);
};
template <class Chosen>
constexpr Frame frame_of() {
  return {Chosen::name, Chosen::takes_roll, Chosen::is_tanks, &Chosen::tank};
}

// The tank's motion relative to the earth at one time, along the tank's axes. It relates positions
// and velocities in the tank to those in the frame of the earth. A tank that does not roll has the
// earth's axes.
class TankMotion {
 public:
  TankMotion(const Scene& scene, double t)
      : seen_from_earth_(scene.roll ? RollingEarthFrame::tank(scene, t)
                                    : EarthFrame::tank(scene, t)),
        seen_from_tank_(scene.roll ? TankFrame::tank(scene, t) : seen_from_earth_) {}

  // Returns the velocity of the tank's point at (x, z) in the tank [m/s], along the tank's axes.
  Vector2 velocity(double x, double z) const {
    if (!seen_from_earth_.rolling) return {seen_from_earth_.walls.velocity, 0};
    const RollingTank& tank = *seen_from_earth_.rolling;
    const Vector2 surge = tank.along_tank(tank.velocity, 0);
    return {surge.x - tank.rate * (z - tank.axis_z), surge.z + tank.rate * (x - tank.axis_x)};
  }
  const Tank& in_earth() const { return seen_from_earth_; }
  const Tank& in_tank() const { return seen_from_tank_; }

 private:
  Tank seen_from_earth_, seen_from_tank_;
};

// Converts particles from positions in the tank to the frame's positions, and sets their velocities
// to those at the start: moving with the tank, or at rest in the frame of the earth.
void enter(const Frame& frame, const Scene& scene, Particles& p);

}  // namespace slosh::sph
