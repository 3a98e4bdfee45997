#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<WithPredictorCorrector>(const Scene&, const Progress&);
template RunOutput run_scheme<WithSymplectic>(const Scene&, const Progress&);
template RunOutput run_scheme<WithVerlet>(const Scene&, const Progress&);

}  // namespace slosh::sph
