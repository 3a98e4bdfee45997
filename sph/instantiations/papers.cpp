// The schemes of papers.
#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

SLOSH_COMPILE(Li2010);
SLOSH_COMPILE(Li2010TwoSpacings);
SLOSH_COMPILE(DeltaSph);
SLOSH_COMPILE(Zhao2021Moving);

}  // namespace slosh::sph
