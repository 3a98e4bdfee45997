// The series of Li et al. 2010 (eqs 16-20, after Faltinsen 1978) as printed, where A is not
// defined. For X = b sin(omega t) it equals ours with A = -b omega, and minus ours with A = +b
// omega:
//   K_n = omega A/C_n 2/a (-1)^n/lambda_n^2,    C_n = cosh(lambda_n h),
//   B_n = omega K_n/(omega_n^2 - omega^2),      A_n = -B_n - K_n/omega,
//   eta = -1/g {A omega x sin(omega t) + sum sin(lambda_n x) C_n
//               [A_n omega_n sin(omega_n t) + B_n omega sin(omega t)]}.
// C_n is cancelled against the one in K_n, as it overflows from the 323rd mode on.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/linear_surge.hpp"
#include "reference/tests/li_tank.hpp"

namespace slosh::reference::li_2010_series_test {
namespace {

double printed_elevation(double A, double x, double t, int modes) {
  const double g = li_tank.gravity, h = li_tank.fill_depth, a = li_tank.length / 2;
  const double w = li_surge.angular_frequency;
  double sum = A * w * x * std::sin(w * t);
  for (int n = 0; n < modes; ++n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / (2 * a);
    const double wn = std::sqrt(g * lambda * std::tanh(lambda * h));
    const double K = w * A * 2 / a * std::pow(-1, n) / (lambda * lambda);
    const double B = w * K / (wn * wn - w * w);
    const double An = -B - K / w;
    sum += std::sin(lambda * x) * (An * wn * std::sin(wn * t) + B * w * std::sin(w * t));
  }
  return -sum / g;
}

// The printed series contains x itself, while ours expands it; the truncated part is below 1e-8 m.
TEST(Li2010Series, IsOursWithMinusTheVelocityAmplitudeAndItsOppositeWithPlus) {
  const double A = li_surge.amplitude * li_surge.angular_frequency;
  const LinearSurge surge(li_tank, Start::earth, li_surge, 800);
  for (const double t : {0.4, 1.0, 2.794, 5.0, 9.731, 12.0}) {
    const double eta = surge.elevation(li_gauge, t);
    EXPECT_NEAR(printed_elevation(-A, li_gauge, t, 800), eta, 1e-8) << t;
    EXPECT_NEAR(printed_elevation(A, li_gauge, t, 800), -eta, 1e-8) << t;
    EXPECT_GT(std::abs(printed_elevation(A, li_gauge, t, 800) - eta), 1e-4) << t;
  }
}

}  // namespace
}  // namespace slosh::reference::li_2010_series_test
