#include "verification/problems/drop_motion.hpp"

#include <cmath>

namespace slosh {
namespace {

SemiAxes rate(const SemiAxes& s) {
  const double a2 = s.a * s.a, b2 = s.b * s.b;
  return {s.sigma * s.a, -s.sigma * s.b, (s.sigma * s.sigma + 1) * (b2 - a2) / (a2 + b2)};
}

SemiAxes moved(const SemiAxes& from, double dt, const SemiAxes& rate) {
  return {from.a + dt * rate.a, from.b + dt * rate.b, from.sigma + dt * rate.sigma};
}

SemiAxes step(const SemiAxes& s, double dt) {
  const SemiAxes k1 = rate(s), k2 = rate(moved(s, dt / 2, k1)), k3 = rate(moved(s, dt / 2, k2)),
                 k4 = rate(moved(s, dt, k3));
  return moved(s, dt / 6,
               {k1.a + 2 * k2.a + 2 * k3.a + k4.a, k1.b + 2 * k2.b + 2 * k3.b + k4.b,
                k1.sigma + 2 * k2.sigma + 2 * k3.sigma + k4.sigma});
}

constexpr double longest_step = 0.002;

}  // namespace

SemiAxes advanced(SemiAxes from, double time) {
  const double steps = std::ceil(time / longest_step);
  for (int i = 0; i < steps; ++i) from = step(from, time / steps);
  return from;
}

double drop_period(double amplitude) {
  SemiAxes now{1, 1, amplitude};
  double time = 0;
  // The axis a passes its initial value twice in a period: first decreasing, then increasing.
  for (;;) {
    const SemiAxes next = step(now, longest_step);
    if (now.a < 1 && next.a >= 1) return time + longest_step * (1 - now.a) / (next.a - now.a);
    now = next;
    time += longest_step;
  }
}

}  // namespace slosh
