#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<WithCubicSpline>(const Scene&, const Progress&);
template RunOutput run_scheme<WithWendlandC2>(const Scene&, const Progress&);
template RunOutput run_scheme<WithWendlandC4>(const Scene&, const Progress&);
template RunOutput run_scheme<WithWendlandC6>(const Scene&, const Progress&);
template RunOutput run_scheme<WithQuinticSpline>(const Scene&, const Progress&);
template RunOutput run_scheme<WithSymmetricPressure>(const Scene&, const Progress&);
template RunOutput run_scheme<WithLinearState>(const Scene&, const Progress&);
template RunOutput run_scheme<WithCubicState>(const Scene&, const Progress&);
template RunOutput run_scheme<WithQuinticState>(const Scene&, const Progress&);

}  // namespace slosh::sph
