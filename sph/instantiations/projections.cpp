// The operators of the projected start (start/projection.hpp), which schemes with the same kernel,
// formulation and walls share.
#include "sph/instantiations/instantiation.hpp"

namespace slosh::sph {

template <class Terms>
std::shared_ptr<const SchemeTerms> compiled_operators(const Terms& terms) {
  return std::make_shared<CompiledTerms<Terms>>(terms);
}

#define SLOSH_COMPILE_OPERATORS(CHOICE)                           \
  template std::shared_ptr<const SchemeTerms> compiled_operators( \
      const PressureAlone<PairTermsOf<CHOICE>>& terms)

SLOSH_COMPILE_OPERATORS(Recommended);
SLOSH_COMPILE_OPERATORS(WithStickingWalls);
SLOSH_COMPILE_OPERATORS(WithStickingWallsAndLaminarViscosity);
SLOSH_COMPILE_OPERATORS(WithRepulsiveWalls);
SLOSH_COMPILE_OPERATORS(WithGhostWalls);
SLOSH_COMPILE_OPERATORS(WithStickingGhostWalls);
SLOSH_COMPILE_OPERATORS(WithCubicSpline);
SLOSH_COMPILE_OPERATORS(WithWendlandC2);
SLOSH_COMPILE_OPERATORS(WithWendlandC4);
SLOSH_COMPILE_OPERATORS(WithWendlandC6);
SLOSH_COMPILE_OPERATORS(WithQuinticSpline);
SLOSH_COMPILE_OPERATORS(WithSymmetricPressure);
SLOSH_COMPILE_OPERATORS(Li2010);
SLOSH_COMPILE_OPERATORS(DeltaSph);

}  // namespace slosh::sph
