// The wall's action on particles that come too near, in addition to the mirror particles' pressure:
// `push` adds that of the walls named by its bits to their accelerations; `confine` corrects their
// state at the start of a step and returns how many it has corrected.
#pragma once

#include <cmath>

#include "sph/neighbours/particles.hpp"
#include "sph/setting.hpp"
#include "sph/walls/mirror_particles.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// A particle that has crossed a wall is exchanged with its mirror image: its position is reflected
// and its normal velocity becomes 2 v_wall - v, which keeps its energy in the wall's frame. This
// happens to single particles in splashes, which their own image does not repel.
struct ReflectingWall {
  static constexpr const char* name =
      "particles that cross a wall exchanged with their mirror image";

  explicit ReflectingWall(const Setting&) {}

  template <int walls = all_walls, class Tank>
  void push(const Particles&, const Tank&, Rates&) const {}

  template <class Tank>
  std::size_t confine(Particles& p, const Tank& tank) const {
    if (all_inside(p, tank)) return 0;
    std::size_t exchanged = 0;
#pragma omp parallel for schedule(static) reduction(+ : exchanged)
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector2 place = tank.in_tank(p.x[i], p.z[i]);
      const bool out_x = !inside(place.x, tank.length()),
                 out_z = !inside(place.z, tank.tank_height());
      if (!out_x && !out_z) continue;
      ++exchanged;
      move_with_tank(p, i, tank,
                     {out_x ? reflected(place.x, tank.length()) : place.x,
                      out_z ? reflected(place.z, tank.tank_height()) : place.z},
                     out_x, out_z);
    }
    return exchanged;
  }

 private:
  // The usual case, found in a loop without branches, which takes plain pointers and a copy of the
  // tank because its loads would not be vectorised otherwise.
  template <class Tank>
  static bool all_inside(const Particles& p, const Tank& tank) {
    const double *x = p.x.data(), *z = p.z.data();
    const std::size_t n = p.size();
    const Tank at = tank;
    const double length = at.length(), height = at.tank_height();
    double outside = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : outside)
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2 place = at.in_tank(x[i], z[i]);
      const double out =
          place.x > 0 && place.x < length && place.z > 0 && place.z < height ? 0.0 : 1.0;
      outside += out;
    }
    return outside == 0;
  }
  static bool inside(double position, double length) { return position > 0 && position < length; }
  static double reflected(double position, double length) {
    return 2 * (position <= 0 ? 0 : length) - position;
  }
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

  std::size_t confine(Particles&, const TankWalls&) const { return 0; }

  template <int of = all_walls>
  void push(const Particles& p, const TankWalls& walls, Rates& rates) const {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double r0 = range * p.spacing_of(i);
      const double from_left = p.x[i] - walls.left, from_right = p.x[i] - walls.right;
      const double from_bottom = p.z[i] - walls.bottom, from_roof = p.z[i] - walls.roof;
      double& ax = rates.acceleration_x[i];
      double& az = rates.acceleration_z[i];
      if ((of & in_left) && from_left < r0) push_one(from_left, from_bottom, r0, ax, az);
      if ((of & in_right) && -from_right < r0) push_one(from_right, from_bottom, r0, ax, az);
      if ((of & in_bottom) && from_bottom < r0) push_one(from_bottom, from_left, r0, az, ax);
      if ((of & in_roof) && -from_roof < r0) push_one(from_roof, from_left, r0, az, ax);
    }
  }

 private:
  // `normal` is the signed distance from the wall, `along` the position along it from a wall
  // particle.
  void push_one(double normal, double along, double r0, double& normal_rate,
                double& tangential_rate) const {
    const double pitch = r0;
    const double nearest = std::round(along / pitch);
    for (int k = -1; k <= 1; ++k) {
      const double tangential = along - (nearest + k) * pitch;
      const double r2 = normal * normal + tangential * tangential;
      if (r2 >= r0 * r0) continue;
      const double ratio4 = (r0 * r0 / r2) * (r0 * r0 / r2);
      const double f = strength * (ratio4 * ratio4 * ratio4 - ratio4) / r2;
      normal_rate += f * normal;
      tangential_rate += f * tangential;
    }
  }
};

}  // namespace slosh::sph
