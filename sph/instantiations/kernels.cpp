#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(WithCubicSpline);
SLOSH_COMPILE(WithWendlandC2);
SLOSH_COMPILE(WithWendlandC4);
SLOSH_COMPILE(WithWendlandC6);
SLOSH_COMPILE(WithQuinticSpline);

}  // namespace slosh::sph
