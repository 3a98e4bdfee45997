#include "sph/run_scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

template RunOutput run_scheme<Zhao2021Moving>(const Scene&, const Progress&);
template RunOutput run_scheme<Zhao2021Fixed>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<Li2010>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<Recommended>>(const Scene&, const Progress&);
template RunOutput run_scheme<InTank<DeltaSph>>(const Scene&, const Progress&);

}  // namespace slosh::sph
