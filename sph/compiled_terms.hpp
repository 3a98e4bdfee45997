// The functions of a scheme's terms (scheme_terms.hpp), compiled for its policies. Instantiations
// include it, and programs with schemes of their own; others include scheme.hpp.
#pragma once

#include <memory>
#include <utility>

#include "sph/held_arrays.hpp"
#include "sph/neighbours/kernel_sum.hpp"
#include "sph/neighbours/pair_sums.hpp"
#include "sph/scheme.hpp"
#include "sph/scheme_terms.hpp"
#include "sph/terms/density_diffusion.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/terms/viscosity.hpp"

namespace slosh::sph {

template <class Terms>
class CompiledSolids final : public SchemeSolids {
 public:
  CompiledSolids(const Terms& terms, const Scene& scene, double support)
      : terms_(terms), solids_(scene, !Terms::Mirror::exists, support) {}

  std::vector<SolidPlace>& places() override { return solids_.places(); }
  void initialise() override { solids_.initialise(terms_); }
  void refresh_for_momentum(const LiquidAt& l) override {
    const Terms terms = terms_;  // a copy, which the loop over the solids cannot change
    solids_.refresh_for_momentum(terms, l.neighbours, l.tank, l.instructions);
  }
  void refresh_for_continuity(const LiquidAt& l) override {
    const Terms terms = terms_;
    solids_.refresh_for_continuity(terms, l.neighbours, l.tank, l.instructions);
  }
  Array<double>* density() override {
    if constexpr (Terms::Solids::has_density) return &solids_.density();
    return nullptr;
  }
  void advance_density([[maybe_unused]] double dt) override {
    if constexpr (Terms::Solids::has_density) solids_.advance_density(terms_, dt);
  }
  void report_memory(HeldArrays& held) override { held.add_all("solids", solids_); }

 private:
  const Terms terms_;
  typename Terms::Solids solids_;
};

// The operators for pressure and divergence alone. Schemes that differ in other terms share them.
template <class Terms>
using PressureAlone = PairTerms<typename Terms::Kernel, typename Terms::Smoothing,
                                typename Terms::Formulation, LinearState, NoViscosity,
                                NoDensityDiffusion, typename Terms::Mirror, typename Terms::Solids>;

// Returns them compiled: sph/instantiations/projections.cpp lists those of all schemes.
template <class Terms>
std::shared_ptr<const SchemeTerms> compiled_operators(const Terms& terms);

template <class Terms>
class CompiledTerms final : public SchemeTerms {
 public:
  explicit CompiledTerms(const Terms& terms)
      : SchemeTerms(terms.setting, function_of<typename Terms::Kernel>(), Terms::Mirror::exists,
                    Terms::Smoothing::reads_spacing, Terms::Solids::has_density),
        terms_(terms) {}

  double pressure(double density) const override { return terms_.state.pressure(density); }
  double density(double pressure) const override { return terms_.state.density(pressure); }
  double speed_of_sound_at(double density) const override {
    return terms_.state.speed_of_sound_at(density);
  }
  double energy(double density) const override { return terms_.state.energy(density); }
  double inverse_smoothing_length(double spacing) const override {
    return terms_.smoothing.inverse(spacing, spacing);
  }

  void refresh_for_momentum(const LiquidAt& l) const override {
    l.neighbours.refresh_for_momentum(terms_, l.particles, l.tank);
  }
  void refresh_for_continuity(const LiquidAt& l) const override {
    l.neighbours.refresh_for_continuity(terms_, l.particles, l.tank);
  }
  void sum_momentum(const LiquidAt& l, Dissipation dissipation, Rates& rates) const override {
    slosh::sph::sum_momentum(with(dissipation), l.tank, l.neighbours.clusters(),
                             l.neighbours.sources(), l.particles, rates, l.instructions);
  }
  void sum_continuity(const LiquidAt& l, Dissipation dissipation,
                      [[maybe_unused]] DensityGradient& gradient, Rates& rates) const override {
    if constexpr (Terms::DensityDiffusion::reads_gradient)
      sum_density_gradient(terms_, l.neighbours, l.particles, l.tank, gradient, l.instructions);
    slosh::sph::sum_continuity(with(dissipation), l.tank, l.neighbours.clusters(),
                               l.neighbours.sources(), gradient, l.particles, rates,
                               l.instructions);
  }
  void sum_kernel(const LiquidAt& l, Array<double>& sums) const override {
    slosh::sph::sum_kernel(terms_, l.neighbours.clusters(), l.neighbours.sources(), l.particles,
                           sums, l.instructions);
  }
  void sum_momentum_of(const Cluster& cluster, const LiquidAt& l, Rates& rates) const override {
    const MomentumOf<Terms> momentum = momentum_of(terms_);
    MomentumOf<Terms>::template run<TwoLanes>(&momentum, &cluster, l.neighbours.sources(),
                                              &l.particles, &rates);
  }

  std::unique_ptr<SchemeSolids> solids(const Scene& scene, double support) const override {
    return std::make_unique<CompiledSolids<Terms>>(terms_, scene, support);
  }

  std::shared_ptr<const SchemeTerms> pressure_alone(
      [[maybe_unused]] double gravity) const override {
    constexpr bool has_walls = Terms::Mirror::exists || *Terms::Solids::name;
    if constexpr (Terms::Solids::has_density || Terms::Smoothing::reads_spacing || !has_walls) {
      return nullptr;
    } else {
      Setting numbers = this->setting;
      numbers.gravity = gravity;
      numbers.breadth = 0;
      return compiled_operators(PressureAlone<Terms>(numbers));
    }
  }

 private:
  Terms with(Dissipation dissipation) const {
    Terms terms = terms_;
    if (dissipation == Dissipation::included) return terms;
    terms.formulation.viscous_share = 0;
    if constexpr (Terms::DensityDiffusion::active) terms.density_diffusion.switch_off();
    return terms;
  }

  const Terms terms_;
};

template <class Terms>
std::shared_ptr<const SchemeTerms> compiled(const Terms& terms) {
  return std::make_shared<CompiledTerms<Terms>>(terms);
}

}  // namespace slosh::sph
