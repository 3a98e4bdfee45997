// A scheme: one policy per physical term, as a choice (schemes.hpp) names them, made for a scene. A
// term that the choice leaves out is its "No..." policy and costs nothing.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sph/initial_lattice.hpp"
#include "sph/setting.hpp"
#include "sph/simulation.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// Of the tank's fastest point where it holds the still liquid [m/s].
double tank_speed(const Scene& scene, double t);

// The largest speed that the liquid is expected to reach: that of a long wave, sqrt(g h), twice
// that where a dam breaks (Ritter 1892), over the tank's own where it holds the still liquid.
double expected_speed(const Scene& scene);

// The scheme's own numbers, changed as the scene says. Throws std::invalid_argument for a number
// that the scheme does not have.
Setting setting_of(const Scene& scene, const SchemeNumbers& own);

template <class Choice>
struct Scheme : Choice {
  // What these policies do not do for one another.
  static_assert(!Choice::Solids::has_density || Choice::Integrator::advances_solids);
  static_assert(!Choice::Solids::has_density || !Choice::DensityDiffusion::reads_gradient);
  static_assert(!Choice::Shifting::active || Choice::Formulation::weighs_volumes);
  // What the walls are made of but dynamic boundary particles stands along the frame's axes.
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
          Choice::Shifting::name, Choice::Mirror::name, Choice::Solids::name,
          Choice::WallContact::name, Choice::Integrator::name, Choice::Frame::name})
      if (*name) terms.push_back(name);
    return terms;
  }
};

}  // namespace slosh::sph
