#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

using Laminar = InOutline<WithLaminarViscosity>;
using StickingLaminar = InOutline<WithStickingWallsAndLaminarViscosity>;

template RunOutput run_scheme<Laminar>(const Scene&, const Progress&);
template RunOutput run_scheme<StickingLaminar>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<Laminar>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<StickingLaminar>>(const Scene&, const Progress&);

}  // namespace slosh::sph
