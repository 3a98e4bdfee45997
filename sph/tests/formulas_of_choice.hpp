// Which of the oracle's formulas each policy of a scheme stands for.
#pragma once

#include <type_traits>

#include "sph/schemes.hpp"
#include "sph/tests/all_pairs_oracle.hpp"

namespace slosh::sph {

template <class Policy, class Named>
inline constexpr bool is = std::is_same_v<Policy, Named>;

template <class Policy>
inline constexpr bool no_formula = false;

template <class Kernel>
KernelFormula kernel_formula() {
  if constexpr (is<Kernel, CubicSpline>)
    return cubic_formula;
  else if constexpr (is<Kernel, WendlandC2>)
    return wendland_c2_formula;
  else if constexpr (is<Kernel, WendlandC4>)
    return wendland_c4_formula;
  else if constexpr (is<Kernel, WendlandC6>)
    return wendland_c6_formula;
  else if constexpr (is<Kernel, QuinticSpline>)
    return quintic_formula;
  else if constexpr (is<Kernel, KaiserBessel>)
    return kaiser_bessel_formula;
  else
    static_assert(no_formula<Kernel>);
}

template <class Viscosity>
auto viscous_formula() {
  if constexpr (is<Viscosity, NoViscosity>)
    return inviscid;
  else if constexpr (is<Viscosity, MonaghanViscosity>)
    return monaghan_viscous;
  else if constexpr (is<Viscosity, LinearViscosity>)
    return linear_viscous;
  else if constexpr (is<Viscosity, ImpactViscosity>)
    return impact_viscous;
  else if constexpr (is<Viscosity, LaminarViscosity>)
    return laminar_viscous;
  else
    static_assert(no_formula<Viscosity>);
}

template <class Diffusion>
constexpr Diffuses diffuses() {
  if constexpr (is<Diffusion, NoDensityDiffusion>)
    return Diffuses::nothing;
  else if constexpr (is<Diffusion, MolteniColagrossiDiffusion>)
    return Diffuses::density;
  else if constexpr (is<Diffusion, DynamicDensityDiffusion>)
    return Diffuses::dynamic_density;
  else if constexpr (is<Diffusion, AntuonoDiffusion>)
    return Diffuses::beyond_gradient;
  else
    static_assert(no_formula<Diffusion>);
}

template <class Mirror>
constexpr Images images() {
  if constexpr (is<Mirror, FreeSlipMirror>)
    return Images::free_slip;
  else if constexpr (is<Mirror, StickingMirror>)
    return Images::sticking;
  else if constexpr (is<Mirror, NoSlipMirror>)
    return Images::of_li;
  else if constexpr (is<Mirror, NoMirror>)
    return Images::none;
  else
    static_assert(no_formula<Mirror>);
}

template <class Solids>
constexpr SolidFormula solid_formula() {
  if constexpr (is<Solids, NoSolids>)
    return SolidFormula::none;
  else if constexpr (is<Solids, GhostSolids<Slip::free>>)
    return SolidFormula::ghost_free_slip;
  else if constexpr (is<Solids, GhostSolids<Slip::none>>)
    return SolidFormula::ghost_no_slip;
  else if constexpr (is<Solids, DynamicSolids>)
    return SolidFormula::dynamic;
  else
    static_assert(no_formula<Solids>);
}

template <class Choice>
Formulas formulas_of() {
  static_assert(is<typename Choice::Formulation, VolumeWeighted> ||
                is<typename Choice::Formulation, MassWeighted>);
  static_assert(is<typename Choice::EquationOfState, Tait> ||
                is<typename Choice::EquationOfState, LinearState>);
  return {.kernel = kernel_formula<typename Choice::Kernel>(),
          .volumes = is<typename Choice::Formulation, VolumeWeighted>,
          .pressure = is<typename Choice::EquationOfState, Tait> ? tait_pressure : linear_pressure,
          .viscous = viscous_formula<typename Choice::Viscosity>(),
          .diffuses = diffuses<typename Choice::DensityDiffusion>(),
          .images = images<typename Choice::Mirror>(),
          .solids = solid_formula<typename Choice::Solids>()};
}

}  // namespace slosh::sph
