// The rectangular tank as the particles meet it: four planes that move together along x. Positions
// in the earth's frame, bottom at z = 0.
#pragma once

namespace slosh::sph {

// Whether the liquid slides along a wall or sticks to it.
enum class Slip { free, none };

struct TankWalls {
  double left, right;   // [m], at this moment
  double bottom, roof;  // [m]
  double velocity;      // X' [m/s]
  double acceleration;  // X'' [m/s2]
};

}  // namespace slosh::sph
