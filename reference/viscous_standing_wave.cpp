#include "reference/viscous_standing_wave.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr auto in_viscous_standing_wave = "ViscousStandingWave";
constexpr double smallest_share = 1e-16;  // of the height, as small as a double's rounding

struct Wave {
  double k, h, nu;
  double sigma2;  // g k tanh kh [1/s2]

  double drag() const { return 4 * nu * nu * k * k * k * std::tanh(k * h); }
};

struct ValueAndSlope {
  Complex value, slope;
};

// Returns D(s) + sigma^2 and its derivative.
ValueAndSlope dispersion(const Wave& wave, Complex s) {
  const auto& [k, h, nu, sigma2] = wave;
  const Complex mu = std::sqrt(k * k + s / nu), coth = 1.0 / std::tanh(mu * h);
  const Complex shifted = s + 2 * nu * k * k;
  // d(mu coth mu h)/ds, with 1/sinh^2 = coth^2 - 1.
  const Complex slope = (coth - mu * h * (coth * coth - 1.0)) / (2 * nu * mu);
  return {shifted * shifted + sigma2 - wave.drag() * mu * coth,
          2.0 * shifted - wave.drag() * slope};
}

// Finds the complex root by Newton's method from Lamb's damping and the inviscid frequency.
Complex rate_of_pair(const Wave& wave) {
  Complex s{-2 * wave.nu * wave.k * wave.k, std::sqrt(wave.sigma2)};
  for (int i = 0; i < 50; ++i) {
    const auto [value, slope] = dispersion(wave, s);
    const Complex step = value / slope;
    s -= step;
    if (std::abs(step) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(s)) break;
  }
  const double residual = std::abs(dispersion(wave, s).value) / wave.sigma2;
  require(residual <= 1e-12 && s.imag() > 0 && s.real() < 0, in_viscous_standing_wave,
          "residual of the dispersion relation", residual, "at most 1e-12, of a damped wave");
  return s;
}

// On a real root mu = i q, so that tan(qh) = 4 k^3 T q / ((k^2 - q^2)^2 + sigma^2/nu^2), which is
// small and hardly depends on q. Returns the inverse of that.
double layer_cotangent(const Wave& wave, double q) {
  const double k = wave.k, difference = k * k - q * q;
  return (difference * difference + wave.sigma2 / (wave.nu * wave.nu)) /
         (wave.drag() / (wave.nu * wave.nu) * q);
}

double layer_wave_number(const Wave& wave, int n) {
  double q = n * pi / wave.h;
  for (int i = 0; i < 40; ++i) q = (n * pi + std::atan(1 / layer_cotangent(wave, q))) / wave.h;
  return q;
}

}  // namespace

ViscousStandingWave::ViscousStandingWave(const Tank& tank, double kinematic_viscosity,
                                         const InitialWave& wave)
    : tank_(tank), wave_(wave) {
  const double sigma = natural_frequency(tank, wave.mode), nu = kinematic_viscosity;
  const Wave of{wave.mode * pi / tank.length, tank.fill_depth, nu, sigma * sigma};
  require(std::isfinite(wave.amplitude), in_viscous_standing_wave, "amplitude", wave.amplitude,
          "a finite length, m");
  require(nu > 0 && 4 * nu * of.k * of.k <= sigma, in_viscous_standing_wave, "kinematic viscosity",
          nu,
          fmt::format("a viscosity > 0 and <= {:.3g} m2/s, a quarter of omega / k^2",
                      sigma / (4 * of.k * of.k)));
  const Complex rate = rate_of_pair(of);
  pair_ = {rate, -of.sigma2 / (rate * dispersion(of, rate).slope)};
  for (int n = 1;; ++n) {
    const double q = layer_wave_number(of, n), cot = layer_cotangent(of, q);
    const double s = -nu * (of.k * of.k + q * q);
    const double slope = 2 * (s + 2 * nu * of.k * of.k) +
                         of.drag() * (cot - q * of.h * (1 + cot * cot)) / (2 * nu * q);
    const double share = -of.sigma2 / (s * slope);
    layer_.push_back({s, share});
    // The shares grow up to q = k and, after a plateau, fall as q^-8.
    if (q > of.k && std::abs(share) < smallest_share) break;
  }
}

double ViscousStandingWave::relative_height(double t) const {
  const double time = time_within(in_viscous_standing_wave, t, std::numeric_limits<double>::max());
  double height = 2 * (pair_.share * std::exp(pair_.rate * time)).real();
  for (const auto& [rate, share] : layer_) height += share * std::exp(rate * time);
  return height;
}

double ViscousStandingWave::elevation(double x, double t) const {
  return wave_.amplitude * mode_shape(tank_, wave_.mode, x) * relative_height(t);
}

std::vector<double> ViscousStandingWave::elevation(double x, std::span<const double> times) const {
  std::vector<double> series;
  series.reserve(times.size());
  for (const double t : times) series.push_back(elevation(x, t));
  return series;
}

}  // namespace slosh::reference
