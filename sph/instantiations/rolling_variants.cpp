#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<InTank<WithWendlandC2>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithWendlandC4>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithWendlandC6>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithQuinticSpline>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithRepulsiveWalls>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithStickingWalls>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithLaminarViscosity>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithStickingWallsAndLaminarViscosity>>(const Scene&,
                                                                            const Progress&);
template RunOutput run_scheme<InTank<WithGhostWalls>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<WithStickingGhostWalls>>(const Scene&, const Progress&);

}  // namespace slosh::sph
