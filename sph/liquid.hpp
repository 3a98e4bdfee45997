// The liquid of a run: its particles, their neighbours, and the two right-hand sides that the
// integrators call.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sph/held_arrays.hpp"
#include "sph/integrators.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/recording/wall_power.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"
#include "sph/scheme_terms.hpp"
#include "sph/terms/gap_friction.hpp"

namespace slosh::sph {

class Liquid {
 public:
  Particles particles;
  Rates rates;
  double time = 0;
  // How long before the time the velocities are taken, by a staggered integrator [s].
  double velocities_behind = 0;

  // The scene must outlive the liquid.
  Liquid(const Scene& scene, Method method, Particles initial);

  Tank tank_at(double t) const { return method_.frame.tank(scene_, t); }

  // Makes the neighbour lists valid for a step of dt from now. Returns whether they were rebuilt.
  bool renew_neighbours(double dt);

  void accelerate(double t);
  // Evaluates the accelerations of the present state and time, which a sample records and which
  // limit the next step. That step begins with them unless it first changes the state or the order
  // of the particles.
  void accelerate_for_sample();
  void compress(double t) { compress(t, Dissipation::included, rates); }

  // Computes the rates of the present state, without any effect on the liquid's later steps.
  void evaluate(Rates& result, Dissipation dissipation = Dissipation::included);

  // Returns each particle's kernel sum over liquid, images and solids (neighbours/kernel_sum.hpp).
  // Overwrites the densities' rates, which every step computes before it reads them.
  Array<double>& kernel_sums();
  // Returns their median, and overwrites the same rates.
  double median_kernel_sum();

  void kick(double dt);
  void drift(double dt);
  void update_density(double dt);
  // Each of these does two updates, in the order of its name, in one pass over the memory. They
  // serve a half of a step, with velocities of its middle.
  void kick_and_drift(double kick_dt, double drift_dt);
  void update_density_and_drift(double density_dt, double drift_dt);

  // These serve integrators that return to the start of a step.
  void save();
  void restore();

  // Both call visit(name, value) for the state that the next step reads besides the time.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("exchanged_at_walls", exchanged_at_walls_);
    visit("velocities_behind", velocities_behind);
  }
  template <class Visit>
  void for_each_saved_field(const Visit& visit) {
    particles.for_each_named_field(visit);
    visit("acceleration_x", rates.acceleration_x);
    visit("acceleration_z", rates.acceleration_z);
    if (Array<double>* density = solids_->density()) visit("solid_density", *density);
  }
  void report_memory(HeldArrays& held);
  // The next step sorts the particles and builds the neighbour lists anew.
  void forget_neighbours() { neighbours_.forget(); }

  // Sets the instruction set of the pair loops; the default is the processor's widest.
  void use(InstructionSet set) { instructions_ = set; }

  const Method& method() const { return method_; }
  const SchemeTerms& terms() const { return *method_.terms; }
  const Setting& setting() const { return method_.terms->setting; }
  const NeighbourSources& neighbours() const { return neighbours_; }
  SchemeSolids& solids() const { return *solids_; }

  // What the terms read of the liquid in this tank.
  LiquidAt at(const Tank& tank) { return {particles, neighbours_, tank, instructions_}; }
  // Returns the walls' power on the liquid, given its accelerations `of` at the time t.
  PowerAt power_of_walls(const Rates& of, double t) const;
  // From the next evaluation of the accelerations on, wall_power() is the walls' power on the
  // liquid at the latest evaluation.
  void keep_wall_power() { keeps_wall_power_ = true; }
  const PowerAt& wall_power() const { return wall_power_; }
  // How often a particle that had crossed a wall was put back.
  std::size_t exchanged_at_walls() const { return exchanged_at_walls_; }

 private:
  void accelerate(double t, Dissipation dissipation, Rates& result);
  void compress(double t, Dissipation dissipation, Rates& result);
  void advance_gap(double dt, double t);
  void keep_thick_obstacles();
  double largest_support() const;

  Method method_;
  const Scene& scene_;
  NeighbourSources neighbours_;
  std::unique_ptr<SchemeSolids> solids_;
  std::vector<Rectangle> obstacles_;
  std::optional<TankOutline> outline_;
  GapFriction gap_;
  DensityGradient gradient_;
  Particles saved_;
  Array<double> saved_solid_density_;
  std::size_t exchanged_at_walls_ = 0;
  bool of_sample_ = false;  // whether the accelerations are those of the present state
  bool keeps_wall_power_ = false;
  PowerAt wall_power_ = {};
  InstructionSet instructions_ = widest_instruction_set();
};

}  // namespace slosh::sph
