// A scheme combines a choice of one policy per physical term (schemes.hpp) with the numbers of a
// scene. A term that the choice leaves out is its "No..." policy and costs nothing.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sph/scene.hpp"
#include "sph/setting.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// Returns the speed of the tank's fastest point below the still level at time t [m/s].
double tank_speed(const Scene& scene, double t);

// Returns the largest tank_speed at the sample times [m/s].
double largest_tank_speed(const Scene& scene);

// Returns the estimate of the largest speed that the liquid is expected to reach [m/s]: the speed
// sqrt(g h) of a long wave, or twice that where a dam breaks (Ritter 1892), plus the largest
// tank_speed.
double expected_speed(const Scene& scene);

// Returns the numbers of a scheme whose own numbers are `own`, with the scene's changes. Throws
// std::invalid_argument where the scene changes a number that the scheme does not have.
Setting setting_of(const Scene& scene, const SchemeNumbers& own);

template <class Choice>
struct Scheme : Choice {
  // These combinations of policies are not implemented.
  static_assert(!Choice::Solids::has_density || Choice::Integrator::advances_solids);
  static_assert(!Choice::Solids::has_density || !Choice::DensityDiffusion::reads_gradient);
  static_assert(!Choice::Smoothing::reads_spacing || !Choice::DensityDiffusion::active);
  // All walls except dynamic boundary particles have to be parallel to the frame's axes.
  static constexpr bool rolls_in_frame =
      !std::is_base_of_v<TankWalls, typename Choice::Frame::Tank>;
  static_assert(!rolls_in_frame || (!Choice::Mirror::exists && Choice::Solids::has_density &&
                                    !Choice::DensityDiffusion::of_whole_density));

  Setting setting;
  typename Choice::EquationOfState state;
  typename Choice::Smoothing smoothing;
  typename Choice::Formulation formulation;
  typename Choice::Viscosity viscosity;
  typename Choice::DensityDiffusion density_diffusion;
  typename Choice::WallContact wall_contact;
  typename Choice::TimeStep time_step;

  explicit Scheme(const Scene& scene) : Scheme(setting_of(scene, Choice::numbers)) {}
  explicit Scheme(const Setting& numbers)
      : setting(numbers),
        state(setting),
        smoothing(setting),
        formulation(setting),
        viscosity(setting),
        density_diffusion(setting),
        wall_contact(setting),
        time_step(setting) {}

  static std::vector<std::string> active_terms() {
    std::vector<std::string> terms;
    for (const char* name :
         {Choice::Kernel::name, Choice::Smoothing::name, Choice::Formulation::name,
          Choice::Viscosity::name, Choice::DensityDiffusion::name, Choice::EquationOfState::name,
          Choice::Mirror::name, Choice::Solids::name, Choice::WallContact::name,
          Choice::Integrator::name, Choice::Frame::name})
      if (*name) terms.push_back(name);
    return terms;
  }
};

}  // namespace slosh::sph
