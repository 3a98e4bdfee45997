// The recorder enters the requested quantities into the output at the sample times.
#pragma once

#include <optional>
#include <vector>

#include "sph/guards/energy_bound.hpp"
#include "sph/held_arrays.hpp"
#include "sph/liquid.hpp"
#include "sph/recording/column_in_outline.hpp"
#include "sph/recording/energy_budget.hpp"
#include "sph/recording/soundness.hpp"
#include "sph/recording/still_water.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

// The liquid as seen by instruments that are fixed to the tank, in any frame of the scheme.
struct SeenFromTank {
  // Positions in the tank, and velocities relative to the earth along the tank's axes.
  Particles particles;
  // The acceleration of each particle by the other particles and the walls, that is without gravity
  // and inertial forces, along the tank's axes [m/s2].
  Array<double> push_x, push_z;

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    particles.for_each_named_field(visit);
    visit("push_x", push_x);
    visit("push_z", push_z);
  }
};

class Recorder {
 public:
  Recorder(const Scene& scene, Liquid& liquid);

  // Records what is integrated over every step.
  void add_step(const Liquid& liquid) {
    if (energy_budget_) energy_budget_->add_step(liquid);
  }

  // Records the liquid, whose accelerations must be those of its present state and time. `is_last`:
  // this is the run's last sample.
  void record(Liquid& liquid, bool is_last);

  // Passes on a snapshot of the time that has just been recorded.
  void record_snapshot(const Liquid& liquid) const;

  // Calls visit(name, value) for every number besides the output that is kept from sample to
  // sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("initial_potential_energy", initial_potential_);
    energy_bound_.for_each_number(visit);
    soundness_.for_each_number(visit);
    if (still_water_) still_water_->for_each_number(visit);
    if (energy_budget_) energy_budget_->for_each_number(visit);
  }

  void report_memory(HeldArrays& held) {
    held.add_all("record", seen_);
    if (energy_budget_) held.add_all("energy budget", *energy_budget_);
  }

  RunOutput output;

 private:
  void record_gauges(const Liquid& liquid, const TankMotion& motion);
  void record_probes(const Liquid& liquid, const TankMotion& motion);
  void record_wall_forces(Liquid& liquid);
  void record_energies(double t, const TankMotion& motion);
  void record_forces(double t);
  double moment_about(double axis_x, double axis_z) const;
  void check_energy(double t, const TankMotion& motion);

  const Scene& scene_;
  LineOfSight sight_;
  std::vector<ColumnInOutline> columns_;  // of the gauges of a tank with an outline
  SeenFromTank seen_;
  EnergyBound energy_bound_;
  Soundness soundness_;
  double initial_potential_ = 0;
  std::optional<StillWater> still_water_;
  std::optional<EnergyBudget> energy_budget_;
};

}  // namespace slosh::sph
