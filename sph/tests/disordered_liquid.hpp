// A small tank of disordered liquid: full, shallow with a splash, at rest and moving.
#pragma once

#include <random>

#include "sph/neighbours/particles.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

inline constexpr double small_spacing = 0.01;
inline constexpr TankWalls tank_at_rest{
    .left = 0, .right = 0.2, .bottom = 0, .roof = 0.16, .velocity = 0, .acceleration = 0};
inline constexpr TankWalls moving_tank{.left = 0.137,
                                       .right = 0.337,
                                       .bottom = 0,
                                       .roof = 0.16,
                                       .velocity = 0.3,
                                       .acceleration = -2.1};

// Returns the walls as the tank of a scheme's frame.
template <class Frame>
Tank tank_of(const TankWalls& walls) {
  if constexpr (Frame::walls_roll)
    return RollingTank{.tank_length = walls.length(),
                       .roof = walls.roof,
                       .axis_x = 0,
                       .axis_z = 0,
                       .displacement = walls.left,
                       .velocity = walls.velocity,
                       .cosine = 1,
                       .sine = 0,
                       .rate = 0};
  else
    return walls;
}

// Returns the scene of both tanks, with a viscosity large enough to matter.
inline Scene small_scene(double surface_spacing = small_spacing) {
  Scene scene = still_scene(small_spacing, 0.1);
  scene.tank_length = 0.2;
  scene.tank_height = 0.16;
  scene.fill_depth = 0.16;
  scene.kinematic_viscosity = 0.01;
  scene.surface_particle_spacing = surface_spacing;
  return scene;
}

class DisorderedLiquid {
 public:
  explicit DisorderedLiquid(const TankWalls& walls) : walls_(walls) {}

  void add(double from_left, double z, double lattice) {
    const double density = 1000 * (1 + 0.01 * disorder());
    particles.x.push_back(walls_.left + from_left);
    particles.z.push_back(z);
    particles.velocity_x.push_back(walls_.velocity + disorder());
    particles.velocity_z.push_back(disorder());
    particles.density.push_back(density);
    particles.mass.push_back(1000 * lattice * lattice * (1 + 0.02 * disorder()));
    particles.spacing.push_back(lattice);
  }

  // A lattice of cells, each particle up to 0.45 of a cell off its centre, in any order.
  void add_block(double bottom, double top, double lattice) {
    const double length = walls_.right - walls_.left;
    for (double z = bottom + 0.5 * lattice; z < top; z += lattice)
      for (double x = 0.5 * lattice; x < length; x += lattice)
        add(x + 0.45 * lattice * disorder(), z + 0.45 * lattice * disorder(), lattice);
  }

  double disorder() { return unit_(random_); }  // -1 to 1

  Particles particles;

 private:
  TankWalls walls_;
  std::mt19937 random_{20100};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

// Fills the whole tank, so that every wall and corner has particles close to it.
inline Particles full_tank(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(walls.bottom, walls.roof, small_spacing);
  return liquid.particles;
}

inline Particles full_tank_of_two_spacings(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(0, 0.1, small_spacing);
  liquid.add_block(0.1, 0.16, small_spacing / 2);
  return liquid.particles;
}

// A shallow pool, and a splash high up at the left wall: a single particle in most rows of cells.
inline Particles splashed_tank(const TankWalls& walls) {
  DisorderedLiquid liquid(walls);
  liquid.add_block(0, 0.03, small_spacing);
  for (double z : {0.075, 0.089, 0.101, 0.107, 0.118, 0.133, 0.148})
    liquid.add(0.006 + 0.004 * liquid.disorder(), z, small_spacing);
  liquid.add(0.195, 0.115, small_spacing);
  return liquid.particles;
}

}  // namespace slosh::sph
