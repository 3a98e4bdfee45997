// A scheme's pair sums on fields whose derivatives are known, in a unit box whose mirror particles
// continue them: with k = pi / L, even and odd in the walls,
//   p = P cos kx cos kz                      -grad p / rho
//   v = (sin kx cos kz, cos kx sin kz)       -rho div v = -2 k rho cos kx cos kz
//   v = (sin kx cos kz, -cos kx sin kz)      nu lap v = -2 k^2 nu v
//   d = p / c0^2                             delta h c0 lap d = -2 k^2 delta h c0 d
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sph/compiled_terms.hpp"
#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"

namespace slosh {

// The choice with the terms that are measured: linear viscosity and a linear equation of state.
template <class Choice>
struct Measured : Choice {
  using EquationOfState = sph::LinearState;
  using Viscosity = sph::LaminarViscosity;
  using DensityDiffusion = sph::DynamicDensityDiffusion;
  static constexpr sph::SchemeNumbers numbers{.smoothing_length_ratio = 1.5,
                                              .sound_speed_ratio = 10,
                                              .courant_number = 0.4,
                                              .artificial_viscosity = {},
                                              .density_diffusion = 0.1};
};

struct Resolution {
  int cells;        // along each side of the box
  double ratio;     // h / dp
  double disorder;  // [spacings], the largest displacement of a particle from the lattice

  double spacing() const { return 1.0 / cells; }
  double smoothing_length() const { return ratio / cells; }
};

// The rms of the errors over the rms of the exact values.
struct OperatorErrors {
  double gradient, divergence, viscosity, diffusion;
  double gradient_beyond_smoothing;
};

// Returns the factor by which a kernel's sum reduces a wave of wave number k, the kernel's
// transform,
//   2 pi int W(r) J0(k r) r dr,  k in 1/h.
template <class Kernel>
double kept_of_wave(double k) {
  const int steps = 4000;
  const double dq = sph::kernel_support / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double q = (i + 0.5) * dq;
    sum += q * Kernel::shape(q) * std::cyl_bessel_j(0, k * q) * dq;
  }
  return 2 * std::numbers::pi * Kernel::normalisation * sum;
}

// The share of the liquid's viscosity that its pair term acts with, whose denominator is r^2 + 0.01
// h^2:  int F q^5 / (q^2 + 0.01) dq / int F q^3 dq,  F = (dW/dr) / r.
template <class Kernel>
double share_of_viscosity() {
  const int steps = 4000;
  const double dq = sph::kernel_support / steps;
  double kept = 0, whole = 0;
  for (int i = 0; i < steps; ++i) {
    const double q = (i + 0.5) * dq, f = q * q * q * Kernel::gradient_shape(q);
    kept += f * q * q / (q * q + 0.01);
    whole += f;
  }
  return kept / whole;
}

template <class Choice>
class OperatorTrial {
 public:
  explicit OperatorTrial(const Resolution& resolution)
      : box_{.length = 1,
             .height = 1,
             .spacing = resolution.spacing(),
             .speed_of_sound = 10,
             .viscosity = 1,
             .smoothing_length_ratio = resolution.ratio},
        flow_(box_, disordered(box_, resolution.disorder)) {}

  OperatorErrors errors() {
    using Kernel = typename Choice::Kernel;
    const double h = flow_.liquid.setting().smoothing_length();
    const double kept = kept_of_wave<Kernel>(std::numbers::sqrt2 * k * h);
    OperatorErrors errors;
    errors.gradient = gradient_error(1);
    errors.gradient_beyond_smoothing = gradient_error(kept);
    set([](Wave) { return 0.0; }, [](Wave w) { return sph::Vector2{w.sx * w.cz, w.cx * w.sz}; });
    errors.divergence = error(rates_.density_rate,
                              [&](Wave w) { return -2 * k * box_.rest_density * w.cx * w.cz; });
    const auto eddy = [](Wave w) { return sph::Vector2{w.sx * w.cz, -w.cx * w.sz}; };
    set([](Wave) { return 0.0; }, eddy);
    const double strength = -2 * k * k * share_of_viscosity<Kernel>() * box_.viscosity;
    errors.viscosity =
        std::hypot(error(rates_.acceleration_x, [&](Wave w) { return strength * eddy(w).x; }),
                   error(rates_.acceleration_z, [&](Wave w) { return strength * eddy(w).z; })) /
        std::numbers::sqrt2;
    set([](Wave w) { return w.cx * w.cz; }, [](Wave) { return sph::Vector2{0, 0}; });
    const sph::Setting& s = flow_.liquid.setting();
    errors.diffusion = error(rates_.density_rate, [&](Wave w) {
      return -2 * k * k * s.density_diffusion * h / s.speed_of_sound * pressure_scale * w.cx * w.cz;
    });
    return errors;
  }

 private:
  static constexpr double k = std::numbers::pi;
  static constexpr double pressure_scale = 100;  // [Pa], of rho c0^2 = 1e5
  struct Wave {
    double sx, cx, sz, cz;
  };

  static sph::Particles disordered(const Box& box, double share) {
    sph::Particles p = full_lattice(box);
    sph::perturb_randomly(p, share, 1);
    return p;
  }

  Wave wave(std::size_t i) const {
    const sph::Particles& p = flow_.liquid.particles;
    return {std::sin(k * p.x[i]), std::cos(k * p.x[i]), std::sin(k * p.z[i]), std::cos(k * p.z[i])};
  }

  template <class PressureOf, class VelocityOf>
  void set(const PressureOf& pressure_of, const VelocityOf& velocity_of) {
    sph::Particles& p = flow_.liquid.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Wave w = wave(i);
      set_pressure(scheme_, p, i, pressure_scale * pressure_of(w));
      const sph::Vector2 velocity = velocity_of(w);
      p.velocity_x[i] = velocity.x;
      p.velocity_z[i] = velocity.z;
    }
    flow_.liquid.evaluate(rates_);
  }

  double gradient_error(double kept) {
    set([](Wave w) { return w.cx * w.cz; }, [](Wave) { return sph::Vector2{0, 0}; });
    const sph::Array<double>& density = flow_.liquid.particles.density;
    sph::Array<double> force_x = rates_.acceleration_x, force_z = rates_.acceleration_z;
    for (std::size_t i = 0; i < density.size(); ++i) {
      force_x[i] *= density[i];
      force_z[i] *= density[i];
    }
    const double scale = k * pressure_scale * kept;
    return std::hypot(error(force_x, [&](Wave w) { return scale * w.sx * w.cz; }),
                      error(force_z, [&](Wave w) { return scale * w.cx * w.sz; })) /
           std::numbers::sqrt2;
  }

  template <class Exact>
  double error(const sph::Array<double>& found, const Exact& exact) const {
    double error2 = 0, exact2 = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double value = exact(wave(i));
      error2 += (found[i] - value) * (found[i] - value);
      exact2 += value * value;
    }
    return std::sqrt(error2 / exact2);
  }

  Box box_;
  sph::Scheme<Measured<Choice>> scheme_ = scheme_of<Measured<Choice>>(box_);
  Flow<Measured<Choice>> flow_;
  sph::Rates rates_;
};

template <class Choice>
OperatorErrors operator_errors(const Resolution& resolution) {
  return OperatorTrial<Choice>(resolution).errors();
}

}  // namespace slosh
