// The order of the pair sums on manufactured fields, with k the fields' wave number. Source:
// Quinlan, Basa & Lastiwka 2006, Int. J. Numer. Meth. Eng. 66:2064; Monaghan 2005, Rep. Prog. Phys.
// 68:1703.
//   lattice     The smoothing error is (k h)^2 times half the kernel's second moment. The error
//               of the quadrature depends on h / dp alone: it is constant where that ratio is
//               constant, and of second order in h where the ratio grows.
//   scattered   sum_b V_b grad W_ab is no longer zero. An operator with the sum p_a + p_b or with a
//               second derivative has an error of disorder / (k h), of order -1 at constant h / dp;
//               one with the difference v_a - v_b has a constant relative error, of order 0. At
//               constant h both vanish as (dp / h)^2, because independent displacements average
//               out.
// The fields fill a unit box whose mirror particles continue them: with k = pi / L, even and odd in
// the walls,
//   p = P cos kx cos kz                      -grad p / rho
//   v = (sin kx cos kz, cos kx sin kz)       -rho div v = -2 k rho cos kx cos kz
//   v = (sin kx cos kz, -cos kx sin kz)      nu lap v = -2 k^2 nu v
//   d = p / c0^2                             delta h c0 lap d = -2 k^2 delta h c0 d
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "sph/compiled_terms.hpp"
#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"

namespace slosh::manufactured_operators_test {
namespace {

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

// The pressure's part of the momentum equation a twentieth too large.
struct TooStrong : sph::VolumeWeighted {
  using VolumeWeighted::VolumeWeighted;
  template <class Number>
  Number strength(Number pressure, Number density) const {
    return 1.05 * VolumeWeighted::strength(pressure, density);
  }
};
struct WithWrongGradient : sph::Recommended {
  using Formulation = TooStrong;
};

}  // namespace
}  // namespace slosh::manufactured_operators_test

namespace slosh::sph {
// No start is projected with it.
template <>
std::shared_ptr<const SchemeTerms> compiled_operators(
    const PressureAlone<PairTermsOf<
        manufactured_operators_test::Measured<manufactured_operators_test::WithWrongGradient>>>&) {
  return nullptr;
}
}  // namespace slosh::sph

namespace slosh::manufactured_operators_test {
namespace {

using Errors = double OperatorErrors::*;
using ResolutionOf = std::function<Resolution(int cells)>;

// h / dp grows as the square root of the number of cells.
Resolution growing_ratio(int cells) { return {cells, 3 * std::sqrt(cells / 32.0), 0}; }
Resolution on_lattice(int cells) { return {cells, 1.5, 0}; }
Resolution scattered(int cells) { return {cells, 1.5, 0.1}; }
Resolution scattered_in_kept_smoothing(int cells) { return {cells, 1.5 * cells / 32.0, 0.1}; }

// The errors with 32, 64 and 128 cells, and the slope of their logarithm over that of 1 / cells.
struct Series {
  std::vector<double> errors;
  double order;
  double finest() const { return errors.back(); }
  double largest() const { return *std::max_element(errors.begin(), errors.end()); }
};

template <class Choice>
Series series_of(Errors which, const ResolutionOf& resolution) {
  Series series;
  for (const int cells : {32, 64, 128})
    series.errors.push_back(operator_errors<Choice>(resolution(cells)).*which);
  series.order = std::log2(series.errors.front() / series.errors.back()) / 2;
  return series;
}

// In h, which falls as the root of the spacing where h / dp grows.
double order_in_smoothing(const Series& series) { return 2 * series.order; }

TEST(ManufacturedOperators, AreOfSecondOrderInTheSmoothingLengthOnALattice) {
  for (const auto& [which, limit] : {std::pair{&OperatorErrors::gradient, 0.005},
                                     {&OperatorErrors::divergence, 0.005},
                                     {&OperatorErrors::diffusion, 0.0025}}) {
    const Series series = series_of<sph::Recommended>(which, growing_ratio);
    EXPECT_NEAR(order_in_smoothing(series), 2, 0.1);  // measured 1.99
    EXPECT_LE(series.finest(), limit);
  }
  const Series symmetric =
      series_of<sph::WithSymmetricPressure>(&OperatorErrors::gradient, growing_ratio);
  EXPECT_NEAR(order_in_smoothing(symmetric), 2, 0.1);
  EXPECT_LE(symmetric.finest(), 0.005);
}

// Smoothing and a quadrature error in (dp / h)^2, of opposite signs: the two cancel at the coarse
// end.
TEST(ManufacturedOperators, LoseOrderWhereTheViscousForcesErrorsCancel) {
  const Series series = series_of<sph::Recommended>(&OperatorErrors::viscosity, growing_ratio);
  EXPECT_GE(order_in_smoothing(series), 1);  // measured 1.57
  EXPECT_LE(series.finest(), 0.002);
}

// Beyond the smoothing the quadrature is left, a floor where h / dp is kept. The Kaiser-Bessel
// kernel's transform ends before the lattice's first wave number: next to none is left.
TEST(ManufacturedOperators, KeepAFloorOfTheLatticeThatTheKernelDecides) {
  const Errors beyond = &OperatorErrors::gradient_beyond_smoothing;
  EXPECT_LE(series_of<sph::Recommended>(beyond, growing_ratio).finest(), 5e-6);
  EXPECT_LE(series_of<sph::Recommended>(beyond, on_lattice).largest(), 1e-5);
  const Series quintic = series_of<sph::WithQuinticSpline>(beyond, on_lattice),
               wendland = series_of<sph::WithWendlandC2>(beyond, on_lattice);
  EXPECT_NEAR(quintic.order, 0, 0.1);
  EXPECT_NEAR(wendland.order, 0, 0.1);
  EXPECT_NEAR(quintic.largest(), 8.0e-4, 2e-4);
  EXPECT_NEAR(wendland.largest(), 2.6e-3, 4e-4);
}

TEST(ManufacturedOperators, DivergeOnScatteredParticlesButForTheDivergence) {
  for (const Errors which :
       {&OperatorErrors::gradient, &OperatorErrors::viscosity, &OperatorErrors::diffusion})
    EXPECT_NEAR(series_of<sph::Recommended>(which, scattered).order, -1, 0.1);
  const Series divergence = series_of<sph::Recommended>(&OperatorErrors::divergence, scattered);
  EXPECT_NEAR(divergence.order, 0, 0.1);
  EXPECT_LE(divergence.largest(), 0.045);
  EXPECT_GE(
      series_of<sph::Recommended>(&OperatorErrors::gradient, scattered_in_kept_smoothing).order,
      1.8);
}

TEST(ManufacturedOperators, FindAGradientThatIsATwentiethTooLarge) {
  const Series wrong = series_of<WithWrongGradient>(&OperatorErrors::gradient, growing_ratio),
               right = series_of<WithWrongGradient>(&OperatorErrors::divergence, growing_ratio);
  EXPECT_LT(order_in_smoothing(wrong), 1);
  EXPECT_GT(wrong.finest(), 0.04);
  EXPECT_NEAR(order_in_smoothing(right), 2, 0.1);
}

// Of the transform of a Gaussian no closed form is at hand; that of any kernel begins with 1 - (k
// h)^2 / 4 times its second moment.
TEST(KeptOfWave, FallsWithTheSquareOfTheWaveNumber) {
  EXPECT_NEAR(kept_of_wave<sph::QuinticSpline>(0), 1, 1e-6);
  const double loss = 1 - kept_of_wave<sph::QuinticSpline>(0.2);
  EXPECT_NEAR((1 - kept_of_wave<sph::QuinticSpline>(0.1)) / loss, 0.25, 2e-3);
}

}  // namespace
}  // namespace slosh::manufactured_operators_test
