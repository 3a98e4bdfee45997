// The runs of the closed list of schemes, each compiled in one of scheme_runs_*.cpp.
#pragma once

#include "sph/schemes.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

template <class Choice>
RunOutput run_scheme(const Scene& scene, const Progress& progress);

// The variants of `recommended`.
template <class... Choices>
struct ChoiceList {};
using Variants = ChoiceList<
    WithCubicSpline, WithWendlandC2, WithWendlandC4, WithSymmetricPressure, WithLinearState,
    WithCubicState, WithQuinticState, WithoutViscosity, WithLinearViscosity, WithMonaghanViscosity,
    WithLaminarViscosity, WithoutDiffusion, WithMolteniColagrossi, WithAntuono, WithShifting,
    WithStickingWalls, WithRepulsiveWalls, WithGhostWalls, WithStickingGhostWalls, WithDynamicWalls,
    WithFixedDynamicWalls, WithTwoSpacings, WithPredictorCorrector, WithSymplectic, WithVerlet>;

}  // namespace slosh::sph
