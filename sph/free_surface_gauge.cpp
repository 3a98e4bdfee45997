#include "sph/free_surface_gauge.hpp"

#include <algorithm>
#include <cmath>

namespace slosh::sph {
namespace {

constexpr double window_width = 3;  // in lattice spacings

// M4': support 2, integral 1, second moment 0.
double window(double s) {
  const double a = std::abs(s), outer = std::max(0.0, 2 - a), inner = std::max(0.0, 1 - a);
  return 0.5 * outer * outer * (1 - a) - inner * inner * (1 - 2 * a);
}

}  // namespace

double surface_elevation(const Particles& p, double tank_length, double fill_depth, double x) {
  double depth = 0;
#pragma omp simd reduction(+ : depth)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double from_left = p.x[i];
    const double scale = 1.0 / (window_width * p.spacing_of(i));
    depth += p.mass[i] / p.density[i] * scale *
             (window((x - from_left) * scale) + window((x + from_left) * scale) +
              window((x - 2 * tank_length + from_left) * scale));
  }
  return depth - fill_depth;
}

double highest_surface(const Particles& p, double fill_depth, double x) {
  double highest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::abs(p.x[i] - x) <= p.spacing_of(i))
      highest = std::max(highest, p.z[i] + 0.5 * p.spacing_of(i));
  return highest - fill_depth;
}

}  // namespace slosh::sph
