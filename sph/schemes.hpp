// The closed list of schemes. Each is a choice of one policy per term and of the numbers that go
// with it; scheme.hpp combines it with a scene. A variant of `recommended` changes one thing.
#pragma once

#include "sph/integrators.hpp"
#include "sph/scene.hpp"
#include "sph/terms/density_diffusion.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/terms/formulation.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/terms/smoothing.hpp"
#include "sph/terms/time_step.hpp"
#include "sph/terms/viscosity.hpp"
#include "sph/walls/frames.hpp"
#include "sph/walls/mirror_particles.hpp"
#include "sph/walls/solids.hpp"
#include "sph/walls/wall_contact.hpp"

namespace slosh::sph {

// Li et al. 2010 as printed, except for its errata: the momentum equation includes gravity and the
// artificial viscosity, and a mirror particle of a moving wall has the velocity 2 v_wall - v.
struct Li2010 {
  using Frame = EarthFrame;
  using Kernel = CubicSpline;
  using Smoothing = UniformSmoothing;
  using Formulation = MassWeighted;
  using EquationOfState = Tait;
  using Viscosity = MonaghanViscosity;
  using DensityDiffusion = NoDensityDiffusion;
  using Mirror = NoSlipMirror;
  using Solids = NoSolids;
  using WallContact = RepulsiveWall;
  using Integrator = PredictorCorrector;
  using TimeStep = FixedStep;
  static constexpr InitialState initial_state = InitialState::lattice;
  static constexpr SchemeNumbers numbers{.smoothing_length_ratio = 1.5,  // section 4.1
                                         .sound_speed_ratio = 10,        // c0 = 10 V_max
                                         .courant_number = {},
                                         .artificial_viscosity = 1,  // alpha = beta = 1
                                         .density_diffusion = {}};
};

// Li et al. 2010 with two particle spacings.
struct Li2010TwoSpacings : Li2010 {
  using Smoothing = PairSmoothing;
};

// Each term was chosen by measurement on sloshing tanks (docs/schemes.md; ./slosh campaign
// schemes): delta-SPH's consistent operators, a kernel and h/dp with which lattices hardly
// buckle and hardly resist a small shear (terms/kernels.hpp), very little viscosity, a diffusion
// that does not act on still liquid, free-slip mirror walls, and a step near the stability limit.
struct Recommended {
  using Frame = EarthFrame;
  using Kernel = KaiserBessel;
  using Smoothing = UniformSmoothing;
  using Formulation = VolumeWeighted;
  using EquationOfState = Tait;
  using Viscosity = ImpactViscosity;
  using DensityDiffusion = DynamicDensityDiffusion;
  using Mirror = FreeSlipMirror;
  using Solids = GhostSolids<Slip::free>;
  using WallContact = ReflectingWall;
  using Integrator = StaggeredLeapfrog;
  using TimeStep = AdaptiveStep;
  static constexpr InitialState initial_state = InitialState::projected;
  static constexpr SchemeNumbers numbers{.smoothing_length_ratio = 1.5,
                                         .sound_speed_ratio = 10,
                                         .courant_number = 0.8,
                                         .artificial_viscosity = 0.0005,
                                         .density_diffusion = 0.05};
};

// delta-SPH as published (Antuono et al. 2010; Marrone et al. 2011): Wendland C2 at h = 2 dp, the
// linear equation of state, alpha = 0.02, delta = 0.1 with renormalised gradients, and fixed ghost
// particles with free slip. Two things are added at the walls: the ghost particles stand twice as
// densely along them, and count only as far as there is liquid at their nodes (docs/walls.md).
// The staggered leapfrog takes the place of a Runge-Kutta step, with the same result at less cost.
struct DeltaSph : Recommended {
  using Kernel = WendlandC2;
  using Viscosity = LinearViscosity;
  using EquationOfState = LinearState;
  using DensityDiffusion = AntuonoDiffusion;
  using Mirror = NoMirror;
  static constexpr SchemeNumbers numbers{.smoothing_length_ratio = 2,
                                         .sound_speed_ratio = 10,
                                         .courant_number = 0.8,
                                         .artificial_viscosity = 0.02,
                                         .density_diffusion = 0.1};
};

// A scheme with mirror walls, solved in the frame of a tank that rolls.
template <class Choice>
struct InTank : Choice {
  using Frame = TankFrame;
};

// Zhao et al. 2021 with dynamic boundary particles that move with the walls: Wendland C2,
// artificial viscosity, predictor-corrector and CFL = 0.2. Symmetric pressure and Tait's equation
// are as in Li2010. h = 1.5 dp and alpha = 0.1 are choices of this project and not of the paper
// (docs/schemes.md); docs/accuracy.md gives the errors of the wall pressure in the mildly rolling
// tank.
struct Zhao2021Moving {
  using Frame = RollingEarthFrame;
  using Kernel = WendlandC2;
  using Smoothing = UniformSmoothing;
  using Formulation = MassWeighted;
  using EquationOfState = Tait;
  using Viscosity = MonaghanViscosity;
  using DensityDiffusion = NoDensityDiffusion;
  using Mirror = NoMirror;
  using Solids = DynamicSolids;
  using WallContact = ReflectingWall;
  using Integrator = PredictorCorrector;
  using TimeStep = AdaptiveStep;
  static constexpr InitialState initial_state = InitialState::lattice;
  static constexpr SchemeNumbers numbers{.smoothing_length_ratio = 1.5,
                                         .sound_speed_ratio = 10,
                                         .courant_number = 0.2,
                                         .artificial_viscosity = 0.1,
                                         .density_diffusion = {}};
};

// Zhao et al. 2021 with fixed boundary particles; the liquid is solved in the tank's frame.
struct Zhao2021Fixed : Zhao2021Moving {
  using Frame = TankFrame;
};

// Returns the recommended numbers with another Courant number, for integrators with a lower
// stability limit.
constexpr SchemeNumbers recommended_at(double courant_number) {
  SchemeNumbers numbers = Recommended::numbers;
  numbers.courant_number = courant_number;
  return numbers;
}
constexpr SchemeNumbers recommended_without_viscosity() {
  SchemeNumbers numbers = Recommended::numbers;
  numbers.artificial_viscosity = std::optional<double>();
  return numbers;
}
constexpr SchemeNumbers recommended_without_diffusion() {
  SchemeNumbers numbers = Recommended::numbers;
  numbers.density_diffusion = std::optional<double>();
  return numbers;
}

struct WithCubicSpline : Recommended {
  static constexpr const char* variant = "cubic_spline";
  using Kernel = CubicSpline;
};
struct WithWendlandC2 : Recommended {
  static constexpr const char* variant = "wendland_c2";
  using Kernel = WendlandC2;
};
struct WithWendlandC4 : Recommended {
  static constexpr const char* variant = "wendland_c4";
  using Kernel = WendlandC4;
};
struct WithWendlandC6 : Recommended {
  static constexpr const char* variant = "wendland_c6";
  using Kernel = WendlandC6;
};
struct WithQuinticSpline : Recommended {
  static constexpr const char* variant = "quintic_spline";
  using Kernel = QuinticSpline;
};
struct WithSymmetricPressure : Recommended {
  static constexpr const char* variant = "symmetric_pressure";
  using Formulation = MassWeighted;
};
struct WithLinearState : Recommended {
  static constexpr const char* variant = "linear_state";
  using EquationOfState = LinearState;
};
struct WithCubicState : Recommended {
  static constexpr const char* variant = "gamma_3";
  using EquationOfState = CubicState;
};
struct WithQuinticState : Recommended {
  static constexpr const char* variant = "gamma_5";
  using EquationOfState = QuinticState;
};
struct WithoutViscosity : Recommended {
  static constexpr const char* variant = "no_viscosity";
  using Viscosity = NoViscosity;
  static constexpr SchemeNumbers numbers = recommended_without_viscosity();
};
struct WithLinearViscosity : Recommended {
  static constexpr const char* variant = "linear_viscosity";
  using Viscosity = LinearViscosity;
};
struct WithMonaghanViscosity : Recommended {
  static constexpr const char* variant = "monaghan_viscosity";
  using Viscosity = MonaghanViscosity;
};
struct WithLaminarViscosity : Recommended {
  static constexpr const char* variant = "laminar_viscosity";
  using Viscosity = LaminarViscosity;
  static constexpr SchemeNumbers numbers = recommended_without_viscosity();
};
struct WithoutDiffusion : Recommended {
  static constexpr const char* variant = "no_diffusion";
  using DensityDiffusion = NoDensityDiffusion;
  static constexpr SchemeNumbers numbers = recommended_without_diffusion();
};
struct WithMolteniColagrossi : Recommended {
  static constexpr const char* variant = "molteni_colagrossi";
  using DensityDiffusion = MolteniColagrossiDiffusion;
};
struct WithAntuono : Recommended {
  static constexpr const char* variant = "antuono";
  using DensityDiffusion = AntuonoDiffusion;
};
struct WithStickingWalls : Recommended {
  static constexpr const char* variant = "no_slip_mirror";
  using Mirror = StickingMirror;
};
// Obstacles do not let slip either.
struct WithStickingWallsAndLaminarViscosity : WithLaminarViscosity {
  static constexpr const char* variant = "no_slip_laminar";
  using Mirror = StickingMirror;
  using Solids = GhostSolids<Slip::none>;
};
struct WithRepulsiveWalls : Recommended {
  static constexpr const char* variant = "repulsive_mirror";
  using Mirror = NoSlipMirror;
  using WallContact = RepulsiveWall;
};
struct WithGhostWalls : Recommended {
  static constexpr const char* variant = "ghost_walls";
  using Mirror = NoMirror;
};
struct WithStickingGhostWalls : WithGhostWalls {
  static constexpr const char* variant = "no_slip_ghost_walls";
  using Solids = GhostSolids<Slip::none>;
};
struct WithDynamicWalls : WithGhostWalls {
  using Frame = RollingEarthFrame;
  static constexpr const char* variant = "dynamic_walls";
  using Solids = DynamicSolids;
  static constexpr InitialState initial_state = InitialState::lattice;
};
struct WithFixedDynamicWalls : WithDynamicWalls {
  using Frame = TankFrame;
  static constexpr const char* variant = "fixed_dynamic_walls";
};
struct WithPredictorCorrector : Recommended {
  static constexpr const char* variant = "predictor_corrector";
  using Integrator = PredictorCorrector;
  static constexpr SchemeNumbers numbers = recommended_at(0.4);
};
struct WithSymplectic : Recommended {
  static constexpr const char* variant = "symplectic";
  using Integrator = Symplectic;
  static constexpr SchemeNumbers numbers = recommended_at(0.4);
};
struct WithVerlet : Recommended {
  static constexpr const char* variant = "verlet";
  using Integrator = Verlet;
  static constexpr SchemeNumbers numbers = recommended_at(0.15);
};

template <class... Choices>
struct ChoiceList {};
using Variants =
    ChoiceList<WithCubicSpline, WithWendlandC2, WithWendlandC4, WithWendlandC6, WithQuinticSpline,
               WithSymmetricPressure, WithLinearState, WithCubicState, WithQuinticState,
               WithoutViscosity, WithLinearViscosity, WithMonaghanViscosity, WithLaminarViscosity,
               WithoutDiffusion, WithMolteniColagrossi, WithAntuono, WithStickingWalls,
               WithStickingWallsAndLaminarViscosity, WithRepulsiveWalls, WithGhostWalls,
               WithStickingGhostWalls, WithDynamicWalls, WithFixedDynamicWalls,
               WithPredictorCorrector, WithSymplectic, WithVerlet>;

// The variants that are also solved in the frame of a tank that rolls. The variants whose walls are
// dynamic boundary particles roll as they are.
using RollingVariants =
    ChoiceList<WithWendlandC2, WithWendlandC4, WithWendlandC6, WithQuinticSpline,
               WithRepulsiveWalls, WithStickingWalls, WithLaminarViscosity,
               WithStickingWallsAndLaminarViscosity, WithGhostWalls, WithStickingGhostWalls>;

// A choice whose mirror particles are replaced by ghost particles, for a tank that is no rectangle.
template <class Choice>
struct InOutline : Choice {
  using Mirror = NoMirror;
};

// The variants that are also solved in a tank with an outline. `ghost_walls` is what `recommended`
// itself becomes there.
using OutlineVariants =
    ChoiceList<WithGhostWalls, WithStickingGhostWalls, InOutline<WithLaminarViscosity>,
               InOutline<WithStickingWallsAndLaminarViscosity>>;

}  // namespace slosh::sph
