// The terms of one scheme behind a table of functions: what is evaluated for every pair, or for
// every particle in a loop of its own, and so is compiled for each scheme (compiled_terms.hpp). All
// else of a run is compiled once and calls these functions a few times a step.
#pragma once

#include <memory>
#include <vector>

#include "sph/neighbours/density_gradient.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/setting.hpp"
#include "sph/terms/kernels.hpp"

namespace slosh::sph {

class HeldArrays;

// The liquid at one time, over which the sums are evaluated.
struct LiquidAt {
  const Particles& particles;
  NeighbourSources& neighbours;
  const Tank& tank;
  InstructionSet instructions;
};

// The solids of one run (walls/solids.hpp).
class SchemeSolids {
 public:
  virtual ~SchemeSolids() = default;

  virtual std::vector<SolidPlace>& places() = 0;
  // The places must have their final order.
  virtual void initialise() = 0;
  // Fill in the state that the sums read, after that of the liquid.
  virtual void refresh_for_momentum(const LiquidAt& liquid) = 0;
  virtual void refresh_for_continuity(const LiquidAt& liquid) = 0;
  // The density of solids that have one of their own [kg/m3]; null for others.
  virtual Array<double>* density() = 0;
  virtual void advance_density(double dt) = 0;
  virtual void report_memory(HeldArrays& held) = 0;
};

// Whether viscosity and density diffusion count.
enum class Dissipation { included, left_out };

class SchemeTerms {
 public:
  const Setting setting;
  const KernelFunction kernel;
  const bool has_images;     // the tank's walls are mirror particles
  const bool reads_spacing;  // the smoothing length is that of each pair
  const bool solids_have_density;

  virtual ~SchemeTerms() = default;

  // The equation of state (terms/equation_of_state.hpp).
  virtual double pressure(double density) const = 0;
  virtual double density(double pressure) const = 0;
  virtual double speed_of_sound_at(double density) const = 0;
  virtual double energy(double density) const = 0;

  // Returns 1/h of a pair of this spacing [1/m].
  virtual double inverse_smoothing_length(double spacing) const = 0;

  // Fill in the state of the liquid and its images that the sums read.
  virtual void refresh_for_momentum(const LiquidAt& liquid) const = 0;
  virtual void refresh_for_continuity(const LiquidAt& liquid) const = 0;
  // Set the accelerations, and the densities' rates (neighbours/pair_sums.hpp).
  virtual void sum_momentum(const LiquidAt& liquid, Dissipation dissipation,
                            Rates& rates) const = 0;
  virtual void sum_continuity(const LiquidAt& liquid, Dissipation dissipation,
                              DensityGradient& gradient, Rates& rates) const = 0;
  // Sets the particles' kernel sums, from what the momentum sum reads (neighbours/kernel_sum.hpp).
  virtual void sum_kernel(const LiquidAt& liquid, Array<double>& sums) const = 0;
  // Adds to the accelerations of one cluster those by the sources of its list.
  virtual void sum_momentum_of(const Cluster& cluster, const LiquidAt& liquid,
                               Rates& rates) const = 0;

  // Returns the solids of a scene; `support` is the largest kernel radius [m]. Throws
  // std::invalid_argument for solids that the scheme does not take.
  virtual std::unique_ptr<SchemeSolids> solids(const Scene& scene, double support) const = 0;

  // Returns the operators for pressure and divergence alone, with this gravity [m/s2] and the
  // linear equation of state: without viscosity, diffusion and the friction of a narrow tank. Null
  // for schemes without walls, whose solids have a density, or with several spacings.
  virtual std::shared_ptr<const SchemeTerms> pressure_alone(double gravity) const = 0;

 protected:
  SchemeTerms(const Setting& numbers, const KernelFunction& of_kernel, bool images, bool spacings,
              bool solid_density)
      : setting(numbers),
        kernel(of_kernel),
        has_images(images),
        reads_spacing(spacings),
        solids_have_density(solid_density) {}
};

}  // namespace slosh::sph
