// The sums over neighbours: the momentum and the continuity equation. For particle a over its
// sources b,
//   dv_a/dt   = -A_a sum_b w_b (s_a + s_b + viscous_ab) grad_a W_ab          (plus gravity)
//   drho_a/dt =  C_a sum_b w_b (v_a - v_b) . grad_a W_ab + sum_b V_b diffusion_ab (dW/dr)/r
// with the factors of formulation.hpp. Each particle sums its own neighbours in a fixed order: no
// write is shared, and the result does not depend on the number of threads.
#pragma once

#include <cmath>

#include "sph/neighbour_sources.hpp"
#include "sph/particles.hpp"

namespace slosh::sph {

// (dW/dr)/r of a pair [1/m4]; `inverse_h` [1/m].
template <class Kernel>
inline double gradient_over_distance(double distance2, double inverse_h) {
  const double inverse_h2 = inverse_h * inverse_h;
  return Kernel::normalisation * inverse_h2 * inverse_h2 *
         Kernel::gradient_shape(std::sqrt(distance2) * inverse_h);
}

inline double total(const double (&lanes)[vector_length]) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

template <class Scheme>
void sum_momentum(const Scheme& scheme, const NeighbourSources& neighbours,
                  const Particles& particles, Rates& rates) {
  using Viscosity = typename Scheme::Viscosity;
  const Sources& source = neighbours.sources();
  const double *x = source.x.data(), *z = source.z.data(), *u = source.velocity_x.data(),
               *w = source.velocity_z.data(), *strength = source.strength.data(),
               *weight = source.weight.data(), *density = source.density.data(),
               *spacing = source.spacing.data();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::size_t a = neighbours.slot(i);
    const double x_a = x[a], z_a = z[a], u_a = u[a], w_a = w[a], s_a = strength[a];
    const double rho_a = particles.density[i], spacing_a = particles.spacing[i];
    double sum_x[vector_length] = {}, sum_z[vector_length] = {};
    for (const IndexRange run : neighbours.neighbourhood(i)) {
      for (std::size_t first = run.begin; first < run.end; first += vector_length)
#pragma omp simd
        for (std::size_t lane = 0; lane < vector_length; ++lane) {
          const std::size_t b = first + lane;
          const double weight_b = b < run.end ? weight[b] : 0.0;
          const double dx = x_a - x[b], dz = z_a - z[b];
          const double distance2 = dx * dx + dz * dz;
          const double inverse_h = scheme.smoothing.inverse(
              spacing_a, Scheme::Smoothing::reads_spacing ? spacing[b] : 0.0);
          double s = s_a + strength[b];
          if constexpr (Viscosity::active) {
            const double approach = (u_a - u[b]) * dx + (w_a - w[b]) * dz;
            s += scheme.viscosity.pair(approach, distance2, 1.0 / inverse_h) *
                 scheme.formulation.viscous_scale(
                     rho_a, Scheme::Formulation::reads_density ? density[b] : 0.0);
          }
          const double f =
              weight_b * s * gradient_over_distance<typename Scheme::Kernel>(distance2, inverse_h);
          sum_x[lane] += f * dx;
          sum_z[lane] += f * dz;
        }
    }
    const double factor = scheme.formulation.acceleration_factor(rho_a);
    rates.acceleration_x[i] = -factor * total(sum_x);
    rates.acceleration_z[i] = -factor * total(sum_z) - scheme.gravity;
  }
}

template <class Scheme>
void sum_continuity(const Scheme& scheme, const NeighbourSources& neighbours,
                    const Particles& particles, Rates& rates) {
  using Diffusion = typename Scheme::DensityDiffusion;
  const Sources& source = neighbours.sources();
  const double *x = source.x.data(), *z = source.z.data(), *u = source.velocity_x.data(),
               *w = source.velocity_z.data(), *weight = source.weight.data(),
               *dynamic_density = source.dynamic_density.data(), *spacing = source.spacing.data();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::size_t a = neighbours.slot(i);
    const double x_a = x[a], z_a = z[a], u_a = u[a], w_a = w[a], spacing_a = particles.spacing[i];
    const double factor = scheme.formulation.continuity_factor(particles.density[i]);
    const double dynamic_a = Diffusion::active ? dynamic_density[a] : 0.0;
    double divergence[vector_length] = {}, diffusion[vector_length] = {};
    for (const IndexRange run : neighbours.neighbourhood(i)) {
      for (std::size_t first = run.begin; first < run.end; first += vector_length)
#pragma omp simd
        for (std::size_t lane = 0; lane < vector_length; ++lane) {
          const std::size_t b = first + lane;
          const double weight_b = b < run.end ? weight[b] : 0.0;
          const double dx = x_a - x[b], dz = z_a - z[b];
          const double inverse_h = scheme.smoothing.inverse(
              spacing_a, Scheme::Smoothing::reads_spacing ? spacing[b] : 0.0);
          const double f = weight_b * gradient_over_distance<typename Scheme::Kernel>(
                                          dx * dx + dz * dz, inverse_h);
          divergence[lane] += f * ((u_a - u[b]) * dx + (w_a - w[b]) * dz);
          if constexpr (Diffusion::active)
            diffusion[lane] +=
                f * scheme.density_diffusion.pair(dynamic_a - dynamic_density[b], 1.0 / inverse_h);
        }
    }
    rates.density_rate[i] = factor * total(divergence) + total(diffusion);
  }
}

}  // namespace slosh::sph
