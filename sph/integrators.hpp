// Time integration. An integrator advances a Liquid (liquid.hpp) by dt through its two right-hand
// sides: liquid.accelerate(t) and liquid.compress(t) evaluate dv/dt and drho/dt with the walls of
// time t. `advances_solids`: whether the density of dynamic
// boundary particles is carried too; `carries_earlier_state`: whether the particles of a step
// earlier are; for_each_number tells what else is kept from step to step. liquid.kick, drift and
// update_density add dt times the rates to velocities, positions and densities; kick_and_drift and
// update_density_and_drift do two of them in one pass over the memory. The neighbour search is
// renewed, and the particles thereby reordered, only at the start of a step.
#pragma once

#include <cstddef>

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

inline void add_scaled(Array<double>& y, double dt, const Array<double>& rate) {
#pragma omp parallel for simd schedule(static)
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += dt * rate[i];
}

// Staggered leapfrog: velocities live at half steps, positions and densities at whole ones. One
// momentum and one continuity sum per step; the divergence is taken at the middle of the step, with
// the velocity of that moment. Second order for constant steps; stable to dt c0 / h of about 1.4 on
// a calm lattice.
struct StaggeredLeapfrog {
  static constexpr const char* name = "staggered leapfrog";
  static constexpr bool advances_solids = true, carries_earlier_state = false;
  double previous_dt = 0;

  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("previous_time_step", previous_dt);
  }
  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    liquid.renew_neighbours(dt);
    liquid.accelerate(liquid.time);
    liquid.kick_and_drift(0.5 * (previous_dt + dt), 0.5 * dt);
    liquid.compress(liquid.time + 0.5 * dt);
    liquid.update_density_and_drift(dt, 0.5 * dt);
    previous_dt = dt;
  }
};

// Goes to the middle of the step by an Euler half step, and leaves there the rates that carry the
// whole step from the saved start.
template <class Liquid>
void evaluate_midpoint(Liquid& liquid, double dt) {
  liquid.renew_neighbours(dt);
  liquid.save();
  liquid.accelerate(liquid.time);
  liquid.compress(liquid.time);
  liquid.drift(0.5 * dt);
  liquid.kick(0.5 * dt);
  liquid.update_density(0.5 * dt);
  liquid.accelerate(liquid.time + 0.5 * dt);
  liquid.compress(liquid.time + 0.5 * dt);
}

// Back at the start, velocities by the midpoint's acceleration and positions by the mean of the old
// and the new velocity.
template <class Liquid>
void move_from_start(Liquid& liquid, double dt) {
  liquid.restore();
  liquid.drift(0.5 * dt);
  liquid.kick(dt);
  liquid.drift(0.5 * dt);
}

// Predictor-corrector by the midpoint (Monaghan 1989; Li et al. 2010).
struct PredictorCorrector {
  static constexpr const char* name = "predictor-corrector";
  static constexpr bool advances_solids = true, carries_earlier_state = false;

  template <class Visit>
  void for_each_number(const Visit&) {}
  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    evaluate_midpoint(liquid, dt);
    move_from_start(liquid, dt);
    liquid.update_density(dt);
  }
};

// Symplectic, position Verlet with a midpoint predictor (Leimkuhler & Matthews 2015; Dominguez et
// al. 2022, eqs 24 to 27): as the predictor-corrector, but with a density that, for |e| < 2, cannot
// turn negative, rho_new = rho (2 + e) / (2 - e), e = dt drho/dt / rho at the middle.
struct Symplectic {
  static constexpr const char* name = "symplectic, two evaluations";
  static constexpr bool advances_solids = false, carries_earlier_state = false;

  template <class Visit>
  void for_each_number(const Visit&) {}
  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    evaluate_midpoint(liquid, dt);
    Array<double>&density = liquid.particles.density, &rate = liquid.rates.density_rate;
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] /= density[i];
    move_from_start(liquid, dt);
    for (std::size_t i = 0; i < rate.size(); ++i)
      density[i] *= (2 + dt * rate[i]) / (2 - dt * rate[i]);
  }
};

// Verlet's two-step scheme (Verlet 1967; Dominguez et al. 2022, eqs 20 to 23): velocity and density
// from those before the last step, with an Euler step every 40 to keep the two families together.
struct Verlet {
  static constexpr const char* name = "Verlet, one evaluation";
  static constexpr bool advances_solids = false, carries_earlier_state = true;
  double previous_dt = 0;
  int since_euler = 0;

  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("previous_time_step", previous_dt);
    visit("steps_since_euler", since_euler);
  }
  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    liquid.renew_neighbours(dt);
    liquid.accelerate(liquid.time);
    liquid.compress(liquid.time);
    Particles& p = liquid.particles;
    const bool euler = since_euler == 0;
    if (euler) p.make_earlier_state();
    liquid.drift(dt);
    add_scaled(p.x, 0.5 * dt * dt, liquid.rates.acceleration_x);
    add_scaled(p.z, 0.5 * dt * dt, liquid.rates.acceleration_z);
    p.velocity_x.swap(p.earlier_velocity_x);
    p.velocity_z.swap(p.earlier_velocity_z);
    p.density.swap(p.earlier_density);
    const double whole = euler ? dt : previous_dt + dt;
    liquid.kick(whole);
    liquid.update_density(whole);
    since_euler = (since_euler + 1) % 40;
    previous_dt = dt;
  }
};

}  // namespace slosh::sph
