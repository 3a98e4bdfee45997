#include "reference/forced_mode.hpp"

#include <cmath>

namespace slosh::reference {
namespace {

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

}  // namespace

ModeState forced_mode(const TankMode& mode, const SineSurge& motion, double t) {
  const double omega = motion.angular_frequency;
  const double omega_n = mode.natural_frequency;
  const double force = mode.coupling * motion.amplitude * omega * omega;
  const double sigma = omega_n + omega;
  const double forcing = std::sin(omega * t);
  const double beat = omega * t * sinc((omega_n - omega) * t / 2);

  const double elevation = mode.initial_rate / omega_n * std::sin(omega_n * t) +
                           force / (omega_n * sigma) * (forcing - beat * std::cos(sigma * t / 2));
  const double rate =
      mode.initial_rate * std::cos(omega_n * t) + force / sigma * beat * std::sin(sigma * t / 2);
  return {elevation, rate, force * forcing - omega_n * omega_n * elevation};
}

}  // namespace slosh::reference
