// The particles of obstacles that are thinner than the kernel's support, and the liquid's particles
// that run into such an obstacle. Every face has ghost particles of its own, on the lattice behind
// it and as deep as the support, and so beyond the opposite face as well, in the place of the
// liquid there. The line of sight (line_of_sight.hpp) tells which particles they act on.
#pragma once

#include <vector>

#include "sph/walls/line_of_sight.hpp"
#include "sph/walls/obstacle_contact.hpp"

namespace slosh::sph {

// Adds the places behind the faces of the thin obstacles, each with its mirror image in the face as
// its node. A node that another obstacle hides from the face is mirrored in that one too.
// `obstacles` are all, as obstacles_on_lattice returns them.
void add_places_behind_faces(const Scene& scene, const std::vector<Rectangle>& obstacles,
                             double depth, std::vector<SolidPlace>& places);

// Returns the face through which a particle has entered an obstacle of the line of sight, or passed
// all through it, or no_face. It came from `before`, a place in the liquid. Where that is not known
// (null), it came against its velocity relative to the tank.
int face_run_into(const LineOfSight& sight, const Vector2* before, Vector2 now, Vector2 velocity,
                  double tank_length, double tank_height);

// Brings particles that have run into an obstacle back to the side they came from, with their
// normal velocity in the tank's frame turned, as expel() does. before(i) returns the place in the
// tank at which particle i was in the liquid, or nothing. Returns how many it has moved.
template <class Before>
std::size_t turn_back(Particles& p, const Tank& tank, const LineOfSight& sight,
                      const Before& before) {
  std::size_t turned = 0;
#pragma omp parallel for schedule(static) reduction(+ : turned)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 now = tank.in_tank(p.x[i], p.z[i]);
    if (!std::isfinite(now.x + now.z)) continue;  // the stability guard reports it
    const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
    const Vector2 velocity = tank.along_tank(p.velocity_x[i] - wall.x, p.velocity_z[i] - wall.z);
    const auto place = before(i);
    const int face = face_run_into(sight, place ? &*place : nullptr, now, velocity, tank.length(),
                                   tank.tank_height());
    if (face == no_face) continue;
    ++turned;
    const int side = face % 4;
    const bool along_x = side == left_side || side == right_side;
    move_with_tank(p, i, tank,
                   mirrored(now, sight.rectangles()[static_cast<std::size_t>(face / 4)], side),
                   along_x, !along_x);
  }
  return turned;
}

}  // namespace slosh::sph
