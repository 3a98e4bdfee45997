// Mirror particles: the liquid within the kernel's support of a wall, reflected in it. Each
// reflection, in one wall or in the two walls of a corner, is an affine map of the owner's state
// that is the same for all particles. An image therefore costs a gather and a few multiplications.
#pragma once

#include <array>
#include <cstdint>

#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// The walls in which a source is reflected, as a sum of these bits; 0 is the particle itself.
enum Reflection : std::uint8_t {
  in_none = 0,
  in_left = 1,
  in_right = 2,
  in_bottom = 4,
  in_roof = 8
};
inline constexpr int all_walls = in_left + in_right + in_bottom + in_roof;
// The largest sum of one side wall's bit and the bottom's or the roof's, plus one.
inline constexpr int reflection_count = in_right + in_roof + 1;

struct MirrorMap {
  double scale_x = 1, offset_x = 0, scale_z = 1, offset_z = 0;  // position
  double velocity_scale_x = 1, velocity_offset_x = 0, velocity_scale_z = 1;
};

// Free slip: an image has the normal velocity 2 v_wall - v and its owner's tangential velocity. Its
// pressure is higher than the owner's by rho (g - a_wall) . (r_image - r_owner), as in a liquid
// that moves with the wall.
struct FreeSlipMirror {
  static constexpr const char* name =
      "mirror particles, free slip, pressure gradient of the accelerated wall";
  static constexpr bool exists = true, no_slip = false;
  static constexpr bool hydrostatic = true;
  using InContinuity = FreeSlipMirror;
};

// Li et al. 2010, section 2.4, for a moving wall: an image has the velocity 2 v_wall - v in both
// components, and its owner's density and pressure.
struct NoSlipMirror {
  static constexpr const char* name = "mirror particles, velocity 2 v_wall - v, owner's pressure";
  static constexpr bool exists = true, no_slip = true;
  static constexpr bool hydrostatic = false;
  using InContinuity = NoSlipMirror;
};

// No slip: as free slip, except that the tangential velocity is reversed too in the momentum
// equation, whose viscous stress then holds the liquid at the wall. In the continuity equation the
// reversal would compress liquid that slides along a wall (de Leffe et al. 2011).
struct StickingMirror {
  static constexpr const char* name =
      "mirror particles, no slip, pressure gradient of the accelerated wall";
  static constexpr bool exists = true, no_slip = true;
  static constexpr bool hydrostatic = true;
  using InContinuity = FreeSlipMirror;
};

// There are no images; the tank's walls are made of solid particles.
struct NoMirror {
  static constexpr const char* name = "";
  static constexpr bool exists = false, no_slip = false;
  static constexpr bool hydrostatic = false;
  using InContinuity = NoMirror;
};

// Returns the maps by the bits of the walls; `no_slip` turns both components of the velocity.
inline std::array<MirrorMap, reflection_count> mirror_maps(const TankWalls& walls, bool no_slip) {
  std::array<MirrorMap, reflection_count> maps;
  for (int bits = 1; bits < reflection_count; ++bits) {
    MirrorMap& map = maps[bits];
    if (bits & (in_left | in_right)) {
      map.scale_x = -1;
      map.offset_x = 2 * ((bits & in_left) ? walls.left : walls.right);
    }
    if (bits & (in_bottom | in_roof)) {
      map.scale_z = -1;
      map.offset_z = 2 * ((bits & in_bottom) ? walls.bottom : walls.roof);
    }
    // A double reflection in a no-slip corner reverses the velocity twice.
    const bool turns_x = no_slip ? map.scale_x * map.scale_z < 0 : map.scale_x < 0;
    const bool turns_z = no_slip ? map.scale_x * map.scale_z < 0 : map.scale_z < 0;
    map.velocity_scale_x = turns_x ? -1 : 1;
    map.velocity_offset_x = turns_x ? 2 * walls.velocity : 0;
    map.velocity_scale_z = turns_z ? -1 : 1;
  }
  return maps;
}

}  // namespace slosh::sph
