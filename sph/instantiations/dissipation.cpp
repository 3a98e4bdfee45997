#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<WithoutViscosity>(const Scene&, const Progress&);
template RunOutput run_scheme<WithLinearViscosity>(const Scene&, const Progress&);
template RunOutput run_scheme<WithMonaghanViscosity>(const Scene&, const Progress&);
template RunOutput run_scheme<WithLaminarViscosity>(const Scene&, const Progress&);
template RunOutput run_scheme<WithoutDiffusion>(const Scene&, const Progress&);
template RunOutput run_scheme<WithMolteniColagrossi>(const Scene&, const Progress&);
template RunOutput run_scheme<WithAntuono>(const Scene&, const Progress&);

}  // namespace slosh::sph
