#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(WithSymmetricPressure);
SLOSH_COMPILE(WithLinearState);
SLOSH_COMPILE(WithCubicState);
SLOSH_COMPILE(WithQuinticState);

}  // namespace slosh::sph
