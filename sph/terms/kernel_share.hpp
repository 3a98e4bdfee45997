// The share of a kernel's integral on the liquid's side of a flat surface. It is what the kernel
// sum sum_b V_b W_ab is where the volumes of the particles fill the liquid.
#pragma once

#include <cmath>

#include "sph/terms/kernels.hpp"

namespace slosh::sph {

// `depth` is that of the kernel's centre below the surface, in smoothing lengths; it is negative
// above the surface. The share beyond a surface at the distance d >= 0 is
//   int_d^2 2 acos(d / q) W(q) q dq,
// by the midpoint rule in t with q = d + (2 - d) t^2, where the integrand is smooth.
inline double kernel_share_below(const KernelFunction& kernel, double depth) {
  constexpr int intervals = 100;
  const double d = std::abs(depth), width = kernel_support - d;
  if (width <= 0) return depth > 0 ? 1 : 0;
  double beyond = 0;
  for (int i = 0; i < intervals; ++i) {
    const double t = (i + 0.5) / intervals, q = d + width * t * t;
    beyond += 2 * std::acos(d / q) * kernel.shape(q) * q * 2 * width * t / intervals;
  }
  beyond *= kernel.normalisation;
  return depth > 0 ? 1 - beyond : beyond;
}

}  // namespace slosh::sph
