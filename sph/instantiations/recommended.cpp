// `recommended` in every frame and with every integrator, and its variants with other walls.
#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(Recommended);
SLOSH_COMPILE(WithStickingWalls);
SLOSH_COMPILE(WithRepulsiveWalls);
SLOSH_COMPILE(WithGhostWalls);
SLOSH_COMPILE(WithStickingGhostWalls);
SLOSH_COMPILE(WithDynamicWalls);

}  // namespace slosh::sph
