#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<WithStickingWalls>(const Scene&, const Progress&);
template RunOutput run_scheme<WithStickingWallsAndLaminarViscosity>(const Scene&, const Progress&);
template RunOutput run_scheme<WithRepulsiveWalls>(const Scene&, const Progress&);
template RunOutput run_scheme<WithGhostWalls>(const Scene&, const Progress&);
template RunOutput run_scheme<WithStickingGhostWalls>(const Scene&, const Progress&);
template RunOutput run_scheme<WithDynamicWalls>(const Scene&, const Progress&);
template RunOutput run_scheme<WithFixedDynamicWalls>(const Scene&, const Progress&);

}  // namespace slosh::sph
