#include "sph/free_surface_gauge.hpp"

#include <algorithm>
#include <cmath>

namespace slosh::sph {
namespace {

// Cubic B-spline on knots -2, -1, 0, 1, 2; integral 1.
double window(double s) {
  const double a = std::abs(s), outer = std::max(0.0, 2 - a), inner = std::max(0.0, 1 - a);
  return (outer * outer * outer - 4 * inner * inner * inner) / 6;
}

}  // namespace

double surface_elevation(const Particles& p, double wall_left, double tank_length,
                         double fill_depth, double x) {
  double depth = 0;
#pragma omp simd reduction(+ : depth)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double from_left = p.x[i] - wall_left;
    const double scale = 1.0 / p.spacing[i];
    depth += p.mass[i] / p.density[i] * scale *
             (window((x - from_left) * scale) + window((x + from_left) * scale) +
              window((x - 2 * tank_length + from_left) * scale));
  }
  return depth - fill_depth;
}

}  // namespace slosh::sph
