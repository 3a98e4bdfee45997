#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(WithoutViscosity);
SLOSH_COMPILE(WithLinearViscosity);
SLOSH_COMPILE(WithMonaghanViscosity);
SLOSH_COMPILE(WithoutDiffusion);
SLOSH_COMPILE(WithMolteniColagrossi);
SLOSH_COMPILE(WithAntuono);

}  // namespace slosh::sph
