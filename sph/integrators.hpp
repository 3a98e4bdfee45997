// Time integration. An integrator advances a Liquid (liquid.hpp) by dt through its two right-hand
// sides: liquid.accelerate(t) and liquid.compress(t) evaluate dv/dt and drho/dt with the walls of
// time t. The neighbour search is renewed, and the particles thereby reordered, only at the start
// of a step.
#pragma once

#include "sph/particles.hpp"

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
  double previous_dt = 0;

  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    Particles& p = liquid.particles;
    const Rates& rates = liquid.rates;
    liquid.renew_neighbours(dt);
    liquid.accelerate(liquid.time);
    const double kick = 0.5 * (previous_dt + dt);
    add_scaled(p.velocity_x, kick, rates.acceleration_x);
    add_scaled(p.velocity_z, kick, rates.acceleration_z);
    add_scaled(p.x, 0.5 * dt, p.velocity_x);
    add_scaled(p.z, 0.5 * dt, p.velocity_z);
    liquid.compress(liquid.time + 0.5 * dt);
    add_scaled(p.density, dt, rates.density_rate);
    add_scaled(p.x, 0.5 * dt, p.velocity_x);
    add_scaled(p.z, 0.5 * dt, p.velocity_z);
    previous_dt = dt;
  }
};

// Predictor-corrector by the midpoint (Monaghan 1989; Li et al. 2010): the rates at the middle of
// the step, reached by an Euler half step, carry the whole step.
struct PredictorCorrector {
  static constexpr const char* name = "predictor-corrector";

  template <class Liquid>
  void advance(Liquid& liquid, double dt) {
    Particles& p = liquid.particles;
    const Rates& rates = liquid.rates;
    liquid.renew_neighbours(dt);
    start_ = p;
    liquid.accelerate(liquid.time);
    liquid.compress(liquid.time);
    add_scaled(p.x, 0.5 * dt, start_.velocity_x);
    add_scaled(p.z, 0.5 * dt, start_.velocity_z);
    add_scaled(p.velocity_x, 0.5 * dt, rates.acceleration_x);
    add_scaled(p.velocity_z, 0.5 * dt, rates.acceleration_z);
    add_scaled(p.density, 0.5 * dt, rates.density_rate);
    liquid.accelerate(liquid.time + 0.5 * dt);
    liquid.compress(liquid.time + 0.5 * dt);
    p = start_;
    // x + dt (v + v_new) / 2 = x + dt v + dt^2 / 2 a
    add_scaled(p.x, dt, start_.velocity_x);
    add_scaled(p.z, dt, start_.velocity_z);
    add_scaled(p.x, 0.5 * dt * dt, rates.acceleration_x);
    add_scaled(p.z, 0.5 * dt * dt, rates.acceleration_z);
    add_scaled(p.velocity_x, dt, rates.acceleration_x);
    add_scaled(p.velocity_z, dt, rates.acceleration_z);
    add_scaled(p.density, dt, rates.density_rate);
  }

 private:
  Particles start_;
};

}  // namespace slosh::sph
