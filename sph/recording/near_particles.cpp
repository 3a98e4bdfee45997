#include "sph/recording/near_particles.hpp"

#include "sph/walls/solid_particles.hpp"

namespace slosh::sph {

LineOfSight sight_of_instruments(const Scene& scene) {
  if (scene.obstacles.empty()) return {};
  const double radius = WeightsAbout(scene.particle_spacing).radius();
  return LineOfSight(thin_obstacles(obstacles_on_lattice(scene, radius), radius, scene.tank_length,
                                    scene.tank_height));
}

}  // namespace slosh::sph
