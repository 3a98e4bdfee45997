#include "verification/problems/stability/lattice_stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace slosh {
namespace {

struct Symbols {
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d viscosity = Eigen::Matrix2d::Zero();
  double diffusion = 0;
};

Symbols symbols(const LatticeScheme& scheme, const Eigen::Vector2d& wave_number) {
  const double dp = 1 / scheme.ratio;
  const int reach = static_cast<int>(sph::kernel_support * scheme.ratio) + 1;
  Symbols sum;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Eigen::Vector2d r(i * dp, j * dp);
      const double distance = r.norm();
      if (distance == 0 || distance >= sph::kernel_support) continue;
      const double weight = dp * dp * scheme.gradient_shape(distance), phase = wave_number.dot(r);
      sum.gradient += weight * std::sin(phase) * r;
      sum.diffusion -= 2 * scheme.diffusion * weight * (1 - std::cos(phase));
      sum.viscosity -= 8 * scheme.viscosity * weight * (1 - std::cos(phase)) /
                       (distance * distance + 0.01) * r * r.transpose();
    }
  return sum;
}

double growth(const Symbols& of, double step) {
  Eigen::Matrix3d matrix;
  const Eigen::Matrix2d kept = Eigen::Matrix2d::Identity() - step * of.viscosity;
  const Eigen::Vector2d pushed = step * of.gradient;
  matrix.topLeftCorner<2, 2>() = kept;
  matrix.topRightCorner<2, 1>() = pushed;
  matrix.bottomLeftCorner<1, 2>() = -pushed.transpose() * kept;
  matrix(2, 2) = 1 - step * of.diffusion - pushed.squaredNorm();
  return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

// Returns the largest value for which `holds` is true, to a relative 1e-4; it is true at small
// values.
double largest(const std::function<bool(double)>& holds) {
  double low = 0, high = 1e-3;
  while (holds(high) && high < 1e3) {
    low = high;
    high *= 2;
  }
  while (high - low > 1e-4 * high) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double largest_growth(const LatticeScheme& scheme, double courant_number) {
  constexpr int waves = 32;  // along an axis of a quarter of the first Brillouin zone
  const double shortest = std::numbers::pi * scheme.ratio;
  double worst = 0;
  for (int i = 0; i <= waves; ++i)
    for (int j = 0; j <= i; ++j)
      worst = std::max(worst, growth(symbols(scheme, {shortest * i / waves, shortest * j / waves}),
                                     courant_number));
  return worst;
}

namespace {
bool stable(const LatticeScheme& scheme, double courant_number) {
  return largest_growth(scheme, courant_number) <= 1 + 1e-9;
}
}  // namespace

double stable_courant_number(const LatticeScheme& scheme) {
  return largest([&](double courant_number) { return stable(scheme, courant_number); });
}

double stable_viscosity(LatticeScheme scheme, double courant_number) {
  return largest([&](double viscosity) {
    scheme.viscosity = viscosity;
    return stable(scheme, courant_number);
  });
}

double stable_diffusion(LatticeScheme scheme, double courant_number) {
  return largest([&](double diffusion) {
    scheme.diffusion = diffusion;
    return stable(scheme, courant_number);
  });
}

}  // namespace slosh
