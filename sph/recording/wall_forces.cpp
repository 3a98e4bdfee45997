#include "sph/recording/wall_forces.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "sph/walls/mirror_particles.hpp"

namespace slosh::sph {
namespace {

// The bits of Reflection in the order of Wall.
constexpr std::array<int, 4> wall_bits{in_left, in_right, in_bottom, in_roof};

// Returns the walls that face from the outline to a place behind it: two of them behind an inclined
// side, as behind the corner of a rectangle.
int walls_before(const TankOutline& outline, Vector2 place) {
  const Vector2 inward = outline.nearest(place.x, place.z).inward;
  constexpr double none = 1e-6;
  return (inward.x > none    ? in_left
          : inward.x < -none ? in_right
                             : in_none) +
         (inward.z > none    ? in_bottom
          : inward.z < -none ? in_roof
                             : in_none);
}

class WallForcesOf {
 public:
  WallForcesOf(Liquid& liquid, const TankOutline* outline, double gravity)
      : liquid_(liquid), tank_(liquid.tank_at(liquid.time)), gravity_(gravity) {
    const NeighbourSources& neighbours = liquid.neighbours();
    for (std::size_t s = 0; s < neighbours.source_count(); ++s) {
      const Source& source = neighbours.sources()[s];
      walls_.push_back(
          static_cast<std::uint8_t>(outline && s >= neighbours.first_solid_source()
                                        ? walls_before(*outline, tank_.in_tank(source.x, source.z))
                                        : neighbours.walls_before(s)));
    }
  }

  WallForces all() {
    for (const int side : {in_none, in_left, in_right})
      for (const int level : {in_none, in_bottom, in_roof})
        if (side + level != in_none) add_from_behind(side, level);
    for (std::size_t wall = 0; wall < forces_.size(); ++wall) add_contact(wall);
    return forces_;
  }

 private:
  // Adds the forces of the sources behind exactly these walls.
  void add_from_behind(int side, int level) {
    push_from_behind(side + level);
    const bool at_corner = side && level;
    for (std::size_t wall = 0; wall < forces_.size(); ++wall) {
      if (wall_bits[wall] == side) add_reaction(wall, 1, at_corner ? 0 : 1);
      if (wall_bits[wall] == level) add_reaction(wall, at_corner ? 0 : 1, 1);
    }
  }

  // Evaluates the pair sum that moves the liquid over the sources behind the walls of these bits.
  void push_from_behind(int bits) {
    const Particles& p = liquid_.particles;
    const NeighbourSources& neighbours = liquid_.neighbours();
    forget_pushes();
    neighbours.clusters().for_each([&](const Cluster& cluster) {
      std::vector<std::uint32_t> behind;
      for (std::size_t k = 0; k < cluster.source_count; ++k)
        if (walls_[cluster.sources[k]] == bits) behind.push_back(cluster.sources[k]);
      if (behind.empty()) return;
      const std::size_t count = behind.size();
      behind.resize(count + prefetch_distance, 0);
      const Cluster part{cluster.first, cluster.size, behind.data(), count};
      for (std::size_t i = part.first; i < part.first + part.size; ++i)
        tank_.pull(gravity_, p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i],
                   pushes_.acceleration_x[i], pushes_.acceleration_z[i]);
      liquid_.terms().sum_momentum_of(part, liquid_.at(tank_), pushes_);
      for (std::size_t i = part.first; i < part.first + part.size; ++i) {
        const Vector2 push = push_on(p, i, pushes_, tank_, gravity_);
        pushes_.acceleration_x[i] = push.x;
        pushes_.acceleration_z[i] = push.z;
      }
    });
  }

  // Adds the force of a wall's repulsive particles, where the scheme has them.
  void add_contact(std::size_t wall) {
    forget_pushes();
    std::visit(
        [&](const auto& contact) {
          contact.push(liquid_.particles, tank_, pushes_, wall_bits[wall]);
        },
        liquid_.method().wall_contact);
    add_reaction(wall, 1, 1);
  }

  void forget_pushes() {
    for (auto* field : {&pushes_.acceleration_x, &pushes_.acceleration_z})
      field->assign(liquid_.particles.size(), 0.0);
  }

  // Adds the shares of both components of the reaction to the pushes.
  void add_reaction(std::size_t wall, double share_x, double share_z) {
    const Particles& p = liquid_.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector2 push = tank_.along_tank(pushes_.acceleration_x[i], pushes_.acceleration_z[i]);
      forces_[wall].x -= share_x * p.mass[i] * push.x;
      forces_[wall].z -= share_z * p.mass[i] * push.z;
    }
  }

  Liquid& liquid_;
  Tank tank_;
  double gravity_;
  std::vector<std::uint8_t> walls_;  // by source, the bits of Reflection
  Rates pushes_;
  WallForces forces_{};
};

}  // namespace

WallForces wall_forces(Liquid& liquid, const TankOutline* outline, double gravity) {
  return WallForcesOf(liquid, outline, gravity).all();
}

}  // namespace slosh::sph
