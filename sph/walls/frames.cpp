#include "sph/walls/frames.hpp"

namespace slosh::sph {

void enter(const Frame& frame, const Scene& scene, Particles& p) {
  const Tank tank = frame.tank(scene, 0);
  const TankMotion motion(scene, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 velocity = motion.velocity(p.x[i], p.z[i]);
    const double share = (scene.start == Start::tank ? 1 : 0) - (frame.is_tanks ? 1 : 0);
    const Vector2 seen = tank.along_frame(share * velocity.x, share * velocity.z);
    const Vector2 place = tank.in_frame(p.x[i], p.z[i]);
    p.x[i] = place.x;
    p.z[i] = place.z;
    p.velocity_x[i] = seen.x;
    p.velocity_z[i] = seen.z;
  }
}

}  // namespace slosh::sph
