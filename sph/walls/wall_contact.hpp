// The wall's action on particles that come too near, in addition to the mirror particles' pressure:
// `push` adds that of the walls named by its bits to their accelerations; `confine` corrects their
// state at the start of a step and returns how many it has corrected.
#pragma once

#include <variant>

#include "sph/neighbours/particles.hpp"
#include "sph/setting.hpp"
#include "sph/walls/mirror_particles.hpp"
#include "sph/walls/tank_outline.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// A particle that has crossed a wall is exchanged with its mirror image: its position is reflected
// and its normal velocity becomes 2 v_wall - v, which keeps its energy in the wall's frame. This
// happens to single particles in splashes, which their own image does not repel.
struct ReflectingWall {
  static constexpr const char* name =
      "particles that cross a wall exchanged with their mirror image";

  explicit ReflectingWall(const Setting&) {}

  void push(const Particles&, const Tank&, Rates&, int = all_walls) const {}
  std::size_t confine(Particles& p, const Tank& tank) const;
};

// Repulsive particles along the walls, r0 apart (Monaghan 1994; Li et al. 2010, section 2.4). Each
// pushes a particle at a distance r < r0 with the acceleration
//   D ((r0/r)^12 - (r0/r)^4) r_vector / r^2
// r0 is half the spacing, or half the height of the lattice's cells where those are flatter. This
// is a lattice particle's distance from the wall, so that there is just no force on the still
// lattice.
struct RepulsiveWall {
  static constexpr const char* name = "repulsive wall particles, 12-4";
  double strength;  // D [m2/s2]
  double range;     // r0 over the particle's spacing

  explicit RepulsiveWall(const Setting& s)
      : strength(5 * s.gravity * s.fill_depth),  // Monaghan 1994
        range(0.5 * s.flattest_cell) {}

  std::size_t confine(Particles&, const Tank&) const { return 0; }
  void push(const Particles& p, const Tank& tank, Rates& rates, int of = all_walls) const;

 private:
  void push_one(double normal, double along, double r0, double& normal_rate,
                double& tangential_rate) const;
};
using WallContact = std::variant<ReflectingWall, RepulsiveWall>;

// Puts particles that have crossed a tank's outline back, as ReflectingWall does in a rectangle:
// every particle that has crossed it is exchanged with its mirror image in the outline's nearest
// point, so that its position is reflected, and the component of its velocity along the way back
// becomes 2 v_wall - v. Where the image is outside too, beyond a sharp corner, the particle is put
// just inside that point. Returns how many it has moved.
std::size_t confine_to(const TankOutline& outline, Particles& p, const Tank& tank);

}  // namespace slosh::sph
