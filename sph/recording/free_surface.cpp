#include "sph/recording/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slosh::sph {
double window(double s) {
  const double a = std::abs(s), outer = std::max(0.0, 2 - a), inner = std::max(0.0, 1 - a);
  return 0.5 * outer * outer * (1 - a) - inner * inner * (1 - 2 * a);
}

double window_integral(double s) {
  const double a = std::min(2.0, std::abs(s));
  // The integral of M from 0: that of 1 - 5/2 s^2 + 3/2 s^3 up to 1, and that of
  // (2 - s)^2 (1 - s) / 2 from there to 2.
  const double inner = std::min(1.0, a), b = 2 - std::max(1.0, a);
  const double from_middle = inner - 5.0 / 6 * std::pow(inner, 3) + 3.0 / 8 * std::pow(inner, 4) -
                             (1.0 / 24 + std::pow(b, 4) / 8 - std::pow(b, 3) / 6);
  return 0.5 + std::copysign(from_middle, s);
}

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

double surface_elevation(const Particles& p, double tank_length, double fill_depth, double x,
                         const LineOfSight& sight) {
  double depth = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double scale = 1.0 / (window_width * p.spacing_of(i));
    // The faces to the left and to the right at this height.
    double left = 0, right = tank_length;
    for (const Rectangle& r : sight.rectangles()) {
      if (!(p.z[i] > r.bottom && p.z[i] < r.top)) continue;
      if (r.right <= x) left = std::max(left, r.right);
      if (r.left >= x) right = std::min(right, r.left);
    }
    if (p.x[i] < left || p.x[i] > right) continue;
    depth += p.mass[i] / p.density[i] * scale *
             (window((x - p.x[i]) * scale) + window((x - 2 * left + p.x[i]) * scale) +
              window((x - 2 * right + p.x[i]) * scale));
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

double front_position(const Particles& p, double particle_spacing) {
  std::vector<double> lowest;  // x from the left wall
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.z[i] < 2 * particle_spacing) lowest.push_back(p.x[i]);
  std::sort(lowest.begin(), lowest.end());
  // The wall counts as a particle's edge, half a spacing from where the particle would be.
  double last = -0.5 * particle_spacing;
  for (const double x : lowest) {
    if (x - last > 2 * particle_spacing) break;
    last = x;
  }
  return last + 0.5 * particle_spacing;
}

}  // namespace slosh::sph
