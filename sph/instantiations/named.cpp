#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<Li2010>(const Scene&, const Progress&);
template RunOutput run_scheme<Li2010TwoSpacings>(const Scene&, const Progress&);
template RunOutput run_scheme<Recommended>(const Scene&, const Progress&);
template RunOutput run_scheme<DeltaSph>(const Scene&, const Progress&);

}  // namespace slosh::sph
