// A scheme combines a choice of one policy per physical term (schemes.hpp) with the numbers of a
// scene. A term that the choice leaves out is its "No..." policy and costs nothing.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "sph/integrators.hpp"
#include "sph/scene.hpp"
#include "sph/setting.hpp"
#include "sph/terms/time_step.hpp"
#include "sph/walls/frames.hpp"
#include "sph/walls/wall_contact.hpp"

namespace slosh::sph {

// Returns the speed of the tank's fastest point below the still level at time t [m/s], in a frame
// that moves at a constant speed.
double tank_speed(const Scene& scene, double t, double frame = 0);

// Returns the largest tank_speed at the sample times [m/s], in the earth's frame or in that of the
// liquid at the start, where it is smaller: a tank and its liquid that move together are at rest.
double largest_tank_speed(const Scene& scene);

// Returns the estimate of the largest speed that the liquid is expected to reach [m/s]: the speed
// sqrt(g h) of a long wave, or twice that where a dam breaks (Ritter 1892), plus the largest
// tank_speed.
double expected_speed(const Scene& scene);

// Returns the numbers of a scheme whose own numbers are `own`, with the scene's changes. Throws
// std::invalid_argument where the scene changes a number that the scheme does not have.
Setting setting_of(const Scene& scene, const SchemeNumbers& own);

// The terms of the pair sums, with their numbers. Schemes with the same terms share their code.
template <class KernelPolicy, class SmoothingPolicy, class FormulationPolicy, class StatePolicy,
          class ViscosityPolicy, class DiffusionPolicy, class MirrorPolicy, class SolidsPolicy>
struct PairTerms {
  using Kernel = KernelPolicy;
  using Smoothing = SmoothingPolicy;
  using Formulation = FormulationPolicy;
  using EquationOfState = StatePolicy;
  using Viscosity = ViscosityPolicy;
  using DensityDiffusion = DiffusionPolicy;
  using Mirror = MirrorPolicy;
  using Solids = SolidsPolicy;
  // These combinations of policies are not implemented.
  static_assert(!Solids::has_density || !DensityDiffusion::reads_gradient);
  static_assert(!Smoothing::reads_spacing || !DensityDiffusion::active);

  Setting setting;
  EquationOfState state;
  Smoothing smoothing;
  Formulation formulation;
  Viscosity viscosity;
  DensityDiffusion density_diffusion;

  explicit PairTerms(const Setting& numbers)
      : setting(numbers),
        state(setting),
        smoothing(setting),
        formulation(setting),
        viscosity(setting),
        density_diffusion(setting) {}
};
template <class Choice>
using PairTermsOf =
    PairTerms<typename Choice::Kernel, typename Choice::Smoothing, typename Choice::Formulation,
              typename Choice::EquationOfState, typename Choice::Viscosity,
              typename Choice::DensityDiffusion, typename Choice::Mirror, typename Choice::Solids>;

template <class Choice>
struct Scheme : PairTermsOf<Choice> {
  static_assert(!Choice::Solids::has_density || Choice::Integrator::advances_solids);
  // All walls except dynamic boundary particles have to be parallel to the frame's axes.
  static_assert(!Choice::Frame::walls_roll ||
                (!Choice::Mirror::exists && Choice::Solids::has_density &&
                 !Choice::DensityDiffusion::of_whole_density));

  typename Choice::WallContact wall_contact;
  typename Choice::TimeStep time_step;

  explicit Scheme(const Scene& scene) : Scheme(setting_of(scene, Choice::numbers)) {}
  explicit Scheme(const Setting& numbers)
      : PairTermsOf<Choice>(numbers), wall_contact(numbers), time_step(numbers) {}
};

class SchemeTerms;

// A scheme as a run knows it: code that is compiled once, besides the terms of its pair sums
// (scheme_terms.hpp).
struct Method {
  std::shared_ptr<const SchemeTerms> terms;
  Frame frame;
  WallContact wall_contact;
  TimeStep time_step;
  Integrator integrator;
  InitialState initial_state;
  std::vector<std::string> (*active_terms)();

  // Returns the longest step that is stable with these [s] (terms/time_step.hpp).
  double stable_step(double largest_acceleration, double largest_speed_of_sound) const {
    return std::visit(
        [&](const auto& step) { return step(largest_acceleration, largest_speed_of_sound); },
        time_step);
  }
  double longest_step() const { return stable_step(0, 0); }
};

// Returns the compiled terms. compiled_terms.hpp defines it; it is instantiated in
// sph/instantiations/ for the terms of all schemes of the list (schemes.hpp).
template <class Terms>
std::shared_ptr<const SchemeTerms> compiled(const Terms& terms);

// Returns the names that are not empty.
std::vector<std::string> named_terms(std::initializer_list<const char*> names);

template <class Choice>
std::vector<std::string> active_terms() {
  return named_terms({Choice::Kernel::name, Choice::Smoothing::name, Choice::Formulation::name,
                      Choice::Viscosity::name, Choice::DensityDiffusion::name,
                      Choice::EquationOfState::name, Choice::Mirror::name, Choice::Solids::name,
                      Choice::WallContact::name, Choice::Integrator::name, Choice::Frame::name});
}

template <class Choice>
Method method_of(const Scheme<Choice>& scheme) {
  return {compiled(static_cast<const PairTermsOf<Choice>&>(scheme)),
          frame_of<typename Choice::Frame>(),
          scheme.wall_contact,
          scheme.time_step,
          typename Choice::Integrator{},
          Choice::initial_state,
          &active_terms<Choice>};
}

}  // namespace slosh::sph
