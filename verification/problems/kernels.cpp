// Problem: the properties that every smoothing kernel W(q), q = r / h, must have in two dimensions:
//   int W dA = 1             it reproduces a constant
//   int x dW/dx dA = -1      its gradient reproduces that of a linear field
//   W' q = gradient_shape    the gradient in the pair sums is that of W
//   W = W' = 0 for q >= 2    no source beyond the support
// Source: Monaghan 2005, Rep. Prog. Phys. 68:1703.
// The integrals are found by the midpoint rule in q and the slope by central differences, both with
// errors of second order.
#include "sph/terms/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

using sph::kernel_support;

template <class Kernel>
double sum_over_support(double step, double (*of)(double)) {
  double sum = 0;
  for (double q = 0.5 * step; q < kernel_support; q += step) sum += of(q) * step;
  return sum * Kernel::normalisation;
}

template <class Kernel>
double normalisation_error(double step) {
  return sum_over_support<Kernel>(
             step, [](double q) { return 2 * std::numbers::pi * q * Kernel::shape(q); }) -
         1;
}

template <class Kernel>
double moment_error(double step) {
  return sum_over_support<Kernel>(
             step,
             [](double q) { return std::numbers::pi * q * q * q * Kernel::gradient_shape(q); }) +
         1;
}

// The largest over the support, of the largest slope.
template <class Kernel>
double slope_error(double step) {
  double error = 0, largest = 0;
  const int places = 1999;  // prime: few of them on the knots
  for (int i = 1; i <= places; ++i) {
    const double q = kernel_support * i / places, slope = q * Kernel::gradient_shape(q);
    const double found = (Kernel::shape(q + step) - Kernel::shape(std::abs(q - step))) / (2 * step);
    error = std::max(error, std::abs(found - slope));
    largest = std::max(largest, std::abs(slope));
  }
  return error / largest;
}

// What is left of W and W' from the support to `step` beyond it.
template <class Kernel>
double largest_beyond_support(double step) {
  double largest = 0;
  for (int i = 0; i <= 100; ++i) {
    const double q = kernel_support + 0.01 * i * step;
    largest = std::max({largest, std::abs(Kernel::shape(q)), std::abs(Kernel::gradient_shape(q))});
  }
  return largest;
}

struct KernelTrial {
  const char* name;
  double (*normalisation)(double);
  double (*moment)(double);
  double (*slope)(double);
  double (*beyond)(double);
  double (*value)(double);
};

template <class Kernel>
constexpr KernelTrial trial_of(const char* name) {
  return {name,
          &normalisation_error<Kernel>,
          &moment_error<Kernel>,
          &slope_error<Kernel>,
          &largest_beyond_support<Kernel>,
          [](double q) { return Kernel::normalisation * Kernel::shape(q); }};
}

constexpr KernelTrial trials[] = {
    trial_of<sph::CubicSpline>("cubic_spline"),     trial_of<sph::WendlandC2>("wendland_c2"),
    trial_of<sph::WendlandC4>("wendland_c4"),       trial_of<sph::WendlandC6>("wendland_c6"),
    trial_of<sph::QuinticSpline>("quintic_spline"), trial_of<sph::KaiserBessel>("kaiser_bessel")};

std::vector<MeasureKind> kinds() {
  std::vector<MeasureKind> all;
  for (const KernelTrial& one : trials) {
    const std::string name = one.name;
    all.push_back({"normalisation_" + name, "1", "step / h", "int W dA - 1"});
    all.push_back({"first_moment_" + name, "1", "step / h", "int x dW/dx dA + 1"});
    all.push_back({"slope_" + name, "1", "step / h",
                   "largest difference of dW/dr in the pair sums and the slope of W, of the "
                   "largest slope"});
    all.push_back({"beyond_support_" + name, "1", "step / h",
                   "largest of W and (dW/dr)/r, in units of h, from 2 h to a step beyond"});
  }
  return all;
}

ProblemOutcome run(bool) {
  ProblemOutcome outcome;
  reports::Figure shapes;
  shapes.id = "kernels-shapes";
  shapes.title = "Kernels";
  shapes.x_label = "r / h";
  shapes.y_label = "W h^2";

  for (const KernelTrial& one : trials) {
    const std::string name = one.name;
    const auto add = [&](const std::string& what, double (*error)(double)) {
      MeasuredErrors measured{what + "_" + name, {}};
      for (const double step : {0.125, 0.0625, 0.03125, 0.015625})
        measured.errors.push_back({step, error(step)});
      outcome.measures.push_back(std::move(measured));
    };
    add("normalisation", one.normalisation);
    add("first_moment", one.moment);
    add("slope", one.slope);
    add("beyond_support", one.beyond);
    reports::Curve curve{name, {}, {}, {}};
    for (double q = 0; q <= 2.2; q += 0.02) {
      curve.x.push_back(q);
      curve.y.push_back(one.value(q));
    }
    shapes.curves.push_back(std::move(curve));
  }
  outcome.figures.push_back(std::move(shapes));
  return outcome;
}

}  // namespace

Problem kernels_problem() {
  return {"kernels",
          "Kernels: normalisation, first moment, slope, support",
          "Every kernel's integral over the plane, the first moment of its gradient, its slope "
          "against that of the pair sums, and what is left beyond its support.",
          "Monaghan 2005, Rep. Prog. Phys. 68:1703",
          "int W dA = 1, int x dW/dx dA = -1, nothing from 2 h on. The midpoint rule and the "
          "central differences by which they are found are of second order.",
          kinds(),
          &run,
          1};
}

}  // namespace slosh
