#include "verification/problems/stability/lattice_buckling.hpp"

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

struct Bond {
  int i, j;  // place on the lattice
  Eigen::Vector2d r;
  Eigen::Vector2d gradient;  // V grad W
  Eigen::Matrix2d hessian;   // V grad grad W
  double weight;             // V (dW/dr) / r
};

struct LatticeVectors {
  Eigen::Vector2d first, second;
};

LatticeVectors vectors_of(Lattice lattice) {
  if (lattice == Lattice::square) return {{1, 0}, {0, 1}};
  const double side = std::sqrt(2 / std::sqrt(3.0));  // gives a particle the area dp^2
  return {{side, 0}, {0.5 * side, 0.5 * std::sqrt(3.0) * side}};
}

// Returns one bond of each pair r, -r.
std::vector<Bond> bonds_of(const LatticeScheme& scheme, Lattice lattice) {
  constexpr double difference = 1e-4;
  const double h = scheme.ratio, support = sph::kernel_support * h;
  const auto shape = [&](double r) { return scheme.gradient_shape(r / h) / (h * h * h * h); };
  const LatticeVectors vectors = vectors_of(lattice);
  const int reach = static_cast<int>(1.2 * support) + 1;
  std::vector<Bond> bonds;
  for (int i = 0; i <= reach; ++i)
    for (int j = i == 0 ? 1 : -reach; j <= reach; ++j) {
      const Eigen::Vector2d r = i * vectors.first + j * vectors.second;
      const double distance = r.norm();
      if (distance >= support) continue;
      const double weight = shape(distance),
                   slope = (shape(distance + difference) - shape(distance - difference)) /
                           (2 * difference);
      bonds.push_back({i, j, r, weight * r,
                       weight * Eigen::Matrix2d::Identity() + slope / distance * r * r.transpose(),
                       weight});
    }
  return bonds;
}

struct PressedSymbols {
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();   // g
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();    // H
  Eigen::Matrix2d viscosity = Eigen::Matrix2d::Zero();  // of nu = 1
  double diffusion = 0;                                 // of delta h c0 = 1
};

// The symbols of the waves whose phase at the lattice vector i a1 + j a2 is
// 2 pi (m i + n j) / period, so that a table holds all sines and cosines.
class Waves {
 public:
  Waves(const LatticeScheme& scheme, Lattice lattice, int period)
      : bonds_(bonds_of(scheme, lattice)), h_(scheme.ratio), period_(period) {
    for (int n = 0; n < period; ++n) {
      const double phase = 2 * std::numbers::pi * n / period;
      sine_.push_back(std::sin(phase));
      rest_.push_back(1 - std::cos(phase));
    }
  }

  PressedSymbols at(int m, int n) const {
    PressedSymbols sum;
    for (const Bond& bond : bonds_) {
      const int steps = (m * bond.i + n * bond.j) % period_;
      const auto phase = static_cast<std::size_t>(steps < 0 ? steps + period_ : steps);
      sum.gradient -= 2 * sine_[phase] * bond.gradient;
      sum.hessian += 2 * rest_[phase] * bond.hessian;
      sum.viscosity -= 16 * bond.weight * rest_[phase] / (bond.r.squaredNorm() + 0.01 * h_ * h_) *
                       bond.r * bond.r.transpose();
      sum.diffusion -= 4 * bond.weight * rest_[phase];
    }
    return sum;
  }

 private:
  std::vector<Bond> bonds_;
  double h_;
  int period_;
  std::vector<double> sine_, rest_;
};

// Calls visit(symbols) for the waves of half a cell of the reciprocal lattice; the other half are
// their negatives.
template <class Visit>
void for_each_wave(const LatticeScheme& scheme, Lattice lattice, const Visit& visit) {
  constexpr int period = 60;
  const Waves waves(scheme, lattice, period);
  for (int m = 0; m <= period / 2; ++m)
    for (int n = 0; n < period; ++n) visit(waves.at(m, n));
}

double smallest_eigenvalue(const Eigen::Matrix2d& symmetric) {
  const double mean = 0.5 * symmetric.trace(), half = 0.5 * (symmetric(0, 0) - symmetric(1, 1)),
               off = symmetric(0, 1);
  return mean - std::hypot(half, off);
}

// Returns the largest real part of the rates of the linear motion of displacement, velocity and
// density.
double largest_rate(const PressedSymbols& of, double stiffness, double viscosity,
                    double diffusion) {
  Eigen::Matrix<double, 5, 5> motion = Eigen::Matrix<double, 5, 5>::Zero();
  motion.block<2, 2>(0, 2).setIdentity();
  motion.block<2, 2>(2, 0) = -2 * of.hessian;
  motion.block<2, 2>(2, 2) = -viscosity * of.viscosity;
  motion.block<2, 1>(2, 4) = -(stiffness - 2) * of.gradient;
  motion.block<1, 2>(4, 2) = of.gradient.transpose();
  motion(4, 4) = -diffusion * of.diffusion;
  return motion.eigenvalues().real().maxCoeff();
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

namespace {
// Returns the growth of the faster growing of a wave and `fastest`.
double faster(double fastest, const PressedSymbols& of, const LatticeScheme& scheme,
              double stiffness) {
  const double unit = scheme.ratio * std::sqrt(stiffness);  // h c0 in dp sqrt(p0 / rho)
  if (smallest_eigenvalue(of.hessian) >= 0) return fastest;
  return std::max(fastest,
                  largest_rate(of, stiffness, scheme.viscosity * unit, scheme.diffusion * unit));
}
}  // namespace

double buckling_growth(const LatticeScheme& scheme, Lattice lattice, double stiffness) {
  double fastest = 0;
  for_each_wave(scheme, lattice, [&](const PressedSymbols& of) {
    fastest = faster(fastest, of, scheme, stiffness);
  });
  return fastest;
}

double buckling_growth_in_box(const LatticeScheme& scheme, int cells, double stiffness) {
  const Waves waves(scheme, Lattice::square, 2 * cells);
  // A displacement along x goes as sin(k_x x) cos(k_z z), one along z as cos(k_x x) sin(k_z z).
  double fastest = 0;
  for (int m = 0; m <= cells; ++m)
    for (int n = 0; n <= cells; ++n) {
      PressedSymbols of = waves.at(m, n);
      const auto hold = [&](int component) {
        of.gradient(component) = 0;
        of.hessian.row(component).setZero();
        of.hessian.col(component).setZero();
        of.viscosity.row(component).setZero();
        of.viscosity.col(component).setZero();
      };
      if (m == 0 || n == cells) hold(0);
      if (n == 0 || m == cells) hold(1);
      fastest = faster(fastest, of, scheme, stiffness);
    }
  return fastest;
}

bool holds(const LatticeScheme& scheme, Lattice lattice) {
  constexpr double round_off = 1e-7;
  bool held = true;
  for_each_wave(scheme, lattice, [&](const PressedSymbols& of) {
    held = held && smallest_eigenvalue(of.hessian) >= -round_off;
  });
  return held;
}

std::vector<Window> windows_that_hold(LatticeScheme scheme, Lattice lattice) {
  const auto held = [&](double ratio) {
    scheme.ratio = ratio;
    return holds(scheme, lattice);
  };
  const auto edge = [&](double low, double high) {
    const bool at_low = held(low);
    while (high - low > 1e-3) {
      const double middle = 0.5 * (low + high);
      (held(middle) == at_low ? low : high) = middle;
    }
    return 0.5 * (low + high);
  };
  constexpr double step = 0.01;
  const auto steps = std::lround((searched_ratios.high - searched_ratios.low) / step);
  std::vector<Window> windows;
  bool before = false;
  for (long n = 0; n <= steps; ++n) {
    const double ratio = searched_ratios.low + step * static_cast<double>(n);
    const bool now = held(ratio);
    if (now && !before) windows.push_back({n == 0 ? ratio : edge(ratio - step, ratio), ratio});
    if (before && !now) windows.back().high = edge(ratio - step, ratio);
    if (now && n == steps) windows.back().high = ratio;
    before = now;
  }
  return windows;
}

std::vector<Window> common_windows(const std::vector<Window>& a, const std::vector<Window>& b) {
  constexpr double narrowest = 0.01;
  std::vector<Window> both;
  for (const Window& one : a)
    for (const Window& other : b) {
      const Window shared{std::max(one.low, other.low), std::min(one.high, other.high)};
      if (shared.low + narrowest < shared.high) both.push_back(shared);
    }
  return both;
}

const std::vector<NamedKernel>& kernels_of_schemes() {
  static const std::vector<NamedKernel> kernels{
      {"cubic B-spline", &gradient_shape_of<sph::CubicSpline>},
      {"Wendland C2", &gradient_shape_of<sph::WendlandC2>},
      {"Wendland C4", &gradient_shape_of<sph::WendlandC4>},
      {"Wendland C6", &gradient_shape_of<sph::WendlandC6>},
      {"quintic B-spline", &gradient_shape_of<sph::QuinticSpline>},
      {"Kaiser-Bessel", &gradient_shape_of<sph::KaiserBessel>}};
  return kernels;
}

// On a square lattice E has three numbers: s = -sum V x dW/dx, by which the hydrostatic pressure is
// divided too, and the sums A1 and A2 of V ((dW/dr)/r)' / r x^4 and x^2 z^2, which in an integral
// are 3 and 1. For phi = cos(k x) cosh(k z),
//   E_ijkl phi_ik phi_jl = 2 (A1 - A2 - s) phi_xx^2 + 2 (2 A2 - s) phi_xz^2.
double frequency_shift_of_lattice(const LatticeScheme& scheme, double k_times_depth) {
  double s = 0, along = 0, across = 0;
  for (const Bond& bond : bonds_of(scheme, Lattice::square)) {
    const double x2 = bond.r.x() * bond.r.x(), z2 = bond.r.y() * bond.r.y();
    s -= bond.weight * (x2 + z2);
    // The Hessian's off-diagonal element is ((dW/dr)/r)' / r x z; the diagonal gives it for x z =
    // 0.
    const double curvature = (bond.hessian.trace() - 2 * bond.weight) / (x2 + z2);
    along += curvature * (x2 * x2 + z2 * z2);
    across += 2 * curvature * x2 * z2;
  }
  // The pressure is proportional to depth - z. Its means with cosh^2(k z) and sinh^2(k z) over the
  // depth, of which 1/4 and -1/4 come from their constant halves:
  const double q = k_times_depth, common = (std::cosh(2 * q) - 1) / (8 * q * q),
               of_xx = common + 0.25, of_xz = common - 0.25;
  const double quotient =
      ((along - across - s) * of_xx + (2 * across - s) * of_xz) / (s * (of_xx + of_xz));
  return 0.5 * (quotient - 1);
}

double frequency_shift_of_sound(double sound_speed_ratio, double k_times_depth) {
  const double mach = 1 / sound_speed_ratio, cosh = std::cosh(k_times_depth);
  return -mach * mach / (4 * cosh * cosh);
}

}  // namespace slosh
