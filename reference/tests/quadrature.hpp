// Simpson's rule.
#pragma once

namespace slosh::reference {

// Integrates f over [from, to] with an even number of intervals.
template <class Function>
double integral(double from, double to, int intervals, Function f) {
  const double step = (to - from) / intervals;
  double sum = f(from) + f(to);
  for (int i = 1; i < intervals; ++i) {
    sum += (i % 2 == 1 ? 4 : 2) * f(from + i * step);
  }
  return sum * step / 3;
}

}  // namespace slosh::reference
