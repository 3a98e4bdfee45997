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

class SurgeMotion;
class TankMotion;

struct EarthFrame {
  static constexpr const char* name = "walls move in the frame of the earth";
  using Tank = TankWalls;
  using Motion = SurgeMotion;
  static constexpr bool takes_roll = false;

  static Tank tank(const Scene& scene, double t) {
    const double x = scene.displacement(t);
    return {
        x, x + scene.tank_length, 0, scene.tank_height, scene.velocity(t), scene.acceleration(t)};
  }
};

struct RollingEarthFrame {
  static constexpr const char* name = "walls move and roll in the frame of the earth";
  using Tank = RollingTank;
  using Motion = TankMotion;
  static constexpr bool takes_roll = true;

  static Tank tank(const Scene& scene, double t) {
    const Roll& roll = roll_of(scene);
    const double angle = roll.angle(t);
    return {.tank_length = scene.tank_length,
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
  using Tank = TankInItsFrame;
  using Motion = TankMotion;
  static constexpr bool takes_roll = true;

  static Tank tank(const Scene& scene, double t) {
    const Roll& roll = roll_of(scene);
    const double angle = roll.angle(t);
    return {{0, scene.tank_length, 0, scene.tank_height, 0, 0},
            roll.axis_x,
            roll.axis_z,
            std::cos(angle),
            std::sin(angle),
            roll.rate(t),
            roll.acceleration(t),
            scene.acceleration(t)};
  }
};

// The tank's motion relative to the earth at one time, along the tank's axes. It relates positions
// and velocities in the tank to those in the frame of the earth.
class TankMotion {
 public:
  TankMotion(const Scene& scene, double t)
      : seen_from_earth_(RollingEarthFrame::tank(scene, t)),
        seen_from_tank_(TankFrame::tank(scene, t)) {}

  // Returns the velocity of the tank's point at (x, z) in the tank [m/s], along the tank's axes.
  Vector2 velocity(double x, double z) const {
    const RollingTank& tank = seen_from_earth_;
    const Vector2 surge = tank.along_tank(tank.velocity, 0);
    return {surge.x - tank.rate * (z - tank.axis_z), surge.z + tank.rate * (x - tank.axis_x)};
  }
  const RollingTank& in_earth() const { return seen_from_earth_; }
  const TankInItsFrame& in_tank() const { return seen_from_tank_; }

 private:
  RollingTank seen_from_earth_;
  TankInItsFrame seen_from_tank_;
};

// The motion of a tank that does not roll, whose axes are the earth's.
class SurgeMotion {
 public:
  SurgeMotion(const Scene& scene, double t) : walls_(EarthFrame::tank(scene, t)) {}

  Vector2 velocity(double x, double z) const { return walls_.wall_velocity(x, z); }
  const TankWalls& in_earth() const { return walls_; }
  const TankWalls& in_tank() const { return walls_; }

 private:
  TankWalls walls_;
};

template <class Scheme>
using Motion = typename Scheme::Frame::Motion;

// Converts particles from positions in the tank to the frame's positions, and sets their velocities
// to those at the start: moving with the tank, or at rest in the frame of the earth.
template <class Frame>
void enter(const Scene& scene, Particles& p) {
  const typename Frame::Tank tank = Frame::tank(scene, 0);
  const typename Frame::Motion motion(scene, 0);
  constexpr bool against_tank = std::is_same_v<Frame, TankFrame>;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 velocity = motion.velocity(p.x[i], p.z[i]);
    const double share = (scene.start == Start::tank ? 1 : 0) - (against_tank ? 1 : 0);
    const Vector2 seen = tank.along_frame(share * velocity.x, share * velocity.z);
    const Vector2 place = tank.in_frame(p.x[i], p.z[i]);
    p.x[i] = place.x;
    p.z[i] = place.z;
    p.velocity_x[i] = seen.x;
    p.velocity_z[i] = seen.z;
  }
}

}  // namespace slosh::sph
