// With the liquid's own viscosity, and walls that hold it.
#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(WithLaminarViscosity);
SLOSH_COMPILE(WithStickingWallsAndLaminarViscosity);
SLOSH_COMPILE(InOutline<WithLaminarViscosity>);
SLOSH_COMPILE(InOutline<WithStickingWallsAndLaminarViscosity>);

}  // namespace slosh::sph
