// Time integration. An integrator advances a Liquid (liquid.hpp) by dt with its two right-hand
// sides: liquid.accelerate(t) and liquid.compress(t) evaluate dv/dt and drho/dt with the walls at
// time t. liquid.kick, drift and update_density add dt times the rates to velocities, positions and
// densities; kick_and_drift and update_density_and_drift do two of these in one pass over the
// memory. The neighbour search is renewed, and the particles thereby reordered, only at the start
// of a step.
//   evaluations            how often a step evaluates the momentum and the continuity sum
//   advances_solids        whether the density of dynamic boundary particles is integrated too
//   carries_earlier_state  whether the previous step's velocities and densities are kept
//   for_each_number        visits the numbers that are kept from step to step
#pragma once

#include <cstddef>
#include <variant>

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

inline void add_scaled(Array<double>& y, double dt, const Array<double>& rate) {
#pragma omp parallel for simd schedule(static)
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += dt * rate[i];
}

// Staggered leapfrog: velocities are stored at half steps, positions and densities at whole steps.
// A step takes one momentum and one continuity sum; the divergence is evaluated in the middle of
// the step with the velocity at that time. The method is of second order for constant steps and
// stable up to dt c0 / h of about 1.3 on a calm lattice; the main loop (run.cpp) shortens the step
// where the liquid is compressed.
struct StaggeredLeapfrog {
  static constexpr const char* name = "staggered leapfrog";
  static constexpr int evaluations = 1;
  static constexpr bool advances_solids = true, carries_earlier_state = false;

  template <class Visit>
  void for_each_number(const Visit&) {}
  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    liquid.renew_neighbours(dt);
    liquid.accelerate(liquid.time);
    liquid.kick_and_drift(liquid.velocities_behind + 0.5 * dt, 0.5 * dt);
    liquid.compress(liquid.time + 0.5 * dt);
    liquid.update_density_and_drift(dt, 0.5 * dt);
    liquid.velocities_behind = 0.5 * dt;
  }
};

// Saves the start of the step, goes to its middle by an Euler half step, and evaluates there the
// rates of the whole step.
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

// Returns to the saved start and takes the whole step from there: velocities by the midpoint's
// acceleration, positions by the mean of the old and the new velocity.
template <class Liquid>
void move_from_start(Liquid& liquid, double dt) {
  liquid.restore();
  liquid.drift(0.5 * dt);
  liquid.kick(dt);
  liquid.drift(0.5 * dt);
}

// Predictor-corrector with the midpoint rule (Monaghan 1989; Li et al. 2010).
struct PredictorCorrector {
  static constexpr const char* name = "predictor-corrector";
  static constexpr int evaluations = 2;
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

// Symplectic position Verlet with a midpoint predictor (Leimkuhler & Matthews 2015; Dominguez et
// al. 2022, eqs 24 to 27). It differs from the predictor-corrector in the density,
//   rho_new = rho (2 + e) / (2 - e),   e = dt drho/dt / rho at the middle,
// which cannot become negative for |e| < 2.
struct Symplectic {
  static constexpr const char* name = "symplectic, two evaluations";
  static constexpr int evaluations = 2;
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
// advance from their values before the last step. An Euler step every 40 steps keeps the solutions
// of odd and even steps together.
struct Verlet {
  static constexpr const char* name = "Verlet, one evaluation";
  static constexpr int evaluations = 1;
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

using Integrator = std::variant<StaggeredLeapfrog, PredictorCorrector, Symplectic, Verlet>;

template <class Liquid>
void advance(Integrator& integrator, Liquid& liquid, double dt) {
  std::visit([&](auto& own) { own.advance(liquid, dt); }, integrator);
}

}  // namespace slosh::sph
