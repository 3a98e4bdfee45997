// The named schemes: each a closed choice of one policy per physical term, with the constants that
// go with it. A term that a scheme leaves out is its "No..." policy and costs nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sph/density_diffusion.hpp"
#include "sph/equation_of_state.hpp"
#include "sph/formulation.hpp"
#include "sph/initial_lattice.hpp"
#include "sph/integrators.hpp"
#include "sph/kernels.hpp"
#include "sph/mirror_particles.hpp"
#include "sph/simulation.hpp"
#include "sph/smoothing.hpp"
#include "sph/viscosity.hpp"
#include "sph/wall_contact.hpp"

namespace slosh::sph {

// The largest speed that the liquid is expected to reach: that of a long wave, sqrt(g h), over the
// tank's own.
inline double expected_speed(const Scene& scene) {
  double tank_speed = 0;
  for (double t = 0; t <= scene.duration; t += scene.sample_interval)
    tank_speed = std::max(tank_speed, std::abs(scene.velocity(t)));
  return std::sqrt(scene.gravity * scene.fill_depth) + tank_speed;
}

// Li et al. 2010, as printed, but for its errata: gravity and the artificial viscosity stand in the
// momentum equation, and a mirror particle of a moving wall has the velocity 2 v_wall - v.
template <class SmoothingPolicy>
struct Li2010 {
  using Kernel = CubicSpline;
  using Smoothing = SmoothingPolicy;
  using Formulation = MassWeighted;
  using Viscosity = MonaghanViscosity;
  using DensityDiffusion = NoDensityDiffusion;
  using Mirror = NoSlipMirror;
  using WallContact = RepulsiveWall;
  using Integrator = PredictorCorrector;
  static constexpr double smoothing_ratio = 1.5;  // h = 1.5 dp, section 4.1

  double gravity, fill_depth;
  Tait state;
  Smoothing smoothing;
  Formulation formulation{};
  Viscosity viscosity;
  DensityDiffusion density_diffusion{};
  WallContact wall_contact;

  explicit Li2010(const Scene& scene)
      : gravity(scene.gravity),
        fill_depth(scene.fill_depth),
        state{scene.rest_density, 10 * expected_speed(scene)},  // c0 = 10 V_max
        smoothing(smoothing_ratio, scene.particle_spacing),
        viscosity{1.0, 1.0, state.speed_of_sound},          // alpha = beta = 1
        wall_contact{5 * scene.gravity * scene.fill_depth,  // D = 5 g h, Monaghan 1994
                     0.5 * flattest_cell(initial_lattice(scene, state))} {}

  // The paper's 0.5 ms, whatever the spacing.
  static double time_step(const Scene&, double) { return 5e-4; }
  static constexpr bool fixed_step = true;
  // Courant number dt c0 / h. Measured with alpha = 1 on a surge: the same motion up to 1.1, noise
  // from 1.2, divergence at 1.4. The limit keeps a margin to that.
  static constexpr double stable_courant_number = 0.65;
};

// What a practitioner would use today on a smooth free surface: delta-SPH's consistent operators,
// density diffusion, slip walls, next to no viscosity, and a step near the limit of stability.
template <class KernelPolicy>
struct LowDissipation {
  using Kernel = KernelPolicy;
  using Smoothing = UniformSmoothing;
  using Formulation = VolumeWeighted;
  using Viscosity = LinearViscosity;
  using DensityDiffusion = DynamicDensityDiffusion;
  using Mirror = FreeSlipMirror;
  using WallContact = ReflectingWall;
  using Integrator = StaggeredLeapfrog;
  static constexpr double smoothing_ratio = 1.5;

  double gravity, fill_depth;
  Tait state;
  Smoothing smoothing;
  Formulation formulation;
  Viscosity viscosity;
  DensityDiffusion density_diffusion;
  WallContact wall_contact{};

  explicit LowDissipation(const Scene& scene)
      : gravity(scene.gravity),
        fill_depth(scene.fill_depth),
        state{scene.rest_density, 10 * expected_speed(scene)},
        smoothing(smoothing_ratio, scene.particle_spacing),
        formulation{scene.rest_density},
        viscosity{0.003, state.speed_of_sound},
        density_diffusion{0.1, state, scene.gravity, scene.fill_depth} {}

  // dt = min(0.8 h / c0, 0.25 sqrt(h / |a|)): Courant and force criterion (Monaghan 1992,
  // section 10.3).
  double time_step(const Scene&, double largest_acceleration) const {
    const double h = 1.0 / smoothing.inverse_length;
    return std::min(0.8 * h / state.speed_of_sound, 0.25 * std::sqrt(h / largest_acceleration));
  }
  static constexpr bool fixed_step = false;
};

template <class Scheme>
std::vector<std::string> active_terms() {
  std::vector<std::string> terms;
  for (const char* name :
       {Scheme::Kernel::name, Scheme::Smoothing::name, Scheme::Formulation::name,
        Scheme::Viscosity::name, Scheme::DensityDiffusion::name, Tait::name, Scheme::Mirror::name,
        Scheme::WallContact::name, Scheme::Integrator::name})
    if (*name) terms.push_back(name);
  return terms;
}

}  // namespace slosh::sph
