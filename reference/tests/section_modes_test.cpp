#include "reference/section/section_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "reference/linear_roll.hpp"
#include "reference/natural_frequency.hpp"
#include "reference/section/section_flow.hpp"
#include "reference/section/section_roll.hpp"
#include "reference/section/section_wave.hpp"
#include "reference/standing_wave.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/sections.hpp"

namespace slosh::reference::section_modes_test {
namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

double kappa(const Section& section, int n, int modes = 10) {
  const double omega = SectionModes(section, modes).angular_frequency(n);
  return omega * omega / section.gravity;
}

TEST(SectionModes, OfARectangleAreTheClosedForm) {
  const SectionModes modes(rectangle(li_tank), 40);
  for (int n = 1; n <= 40; ++n) {
    EXPECT_NEAR(modes.angular_frequency(n) / natural_frequency(li_tank, n), 1, 1e-10) << n;
    for (const double x : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      EXPECT_NEAR(modes.shape(n, x), std::cos(n * pi * x), 2e-5) << n << " " << x;
    }
  }
}

// Kirchhoff's modes (Lamb, Hydrodynamics, section 258), with z from the tip: x z, and with
// alpha = k depth
//   cosh kx cos kz + cos kx cosh kz,  tanh alpha = -tan alpha,  kappa = k tanh alpha,
//   sinh kx sin kz + sin kx sinh kz,  tanh alpha = tan alpha,   kappa = k / tanh alpha.
TEST(SectionModes, OfWallsAt45DegreesAreKirchhoffs) {
  const double depth = 0.4;
  // alpha = m pi -+ atan(tanh alpha), by iteration.
  const auto alpha = [](int m, double sign) {
    double value = m * pi;
    for (int i = 0; i < 60; ++i) value = m * pi + sign * std::atan(std::tanh(value));
    return value;
  };
  const SectionModes modes(vee(depth), 10);
  EXPECT_NEAR(modes.angular_frequency(1), std::sqrt(g / depth), 1e-10);
  for (int m = 1; m <= 4; ++m) {
    const double even = alpha(m, -1), odd = alpha(m, 1);
    EXPECT_NEAR(modes.angular_frequency(2 * m), std::sqrt(g * even * std::tanh(even) / depth),
                1e-9);
    EXPECT_NEAR(modes.angular_frequency(2 * m + 1), std::sqrt(g * odd / std::tanh(odd) / depth),
                1e-9);
  }
  // The surface stays plane in the first mode. The tip is at x = 0.8.
  for (const double x : {0.4, 0.5, 0.8, 1.1}) {
    EXPECT_NEAR(modes.shape(1, x), (0.8 - x) / 0.4, 1e-9);
  }
}

// The eigenvalues of a half-filled circle of radius 1 by another method. A flux f through the
// diameter gives there, but for a constant, the potential
//   phi(x) = -1/pi integral f(s) [ln|x - s| + ln(1 - x s)] ds,
// by the images in the diameter and in the circle. With x = tanh u and s = tanh v the bracket is
// ln|sinh 2(u-v)| plus functions of u or of v alone, which a flux whose total is zero, and a
// potential that is known but for a constant, leave out. The kernel is split into
// ln|2 sin(pi (u-v)/(2T))|, which is integrated by its Fourier series, and a smooth rest (Kress,
// Linear Integral Equations, section 12.3). At |u| = T = 12 the weight ds/dv has fallen to 1e-10.
Eigen::VectorXd circle_kappas() {
  const int half = 200, count = 2 * half;
  const double T = 12, step = 2 * T / count;
  const auto kernel = [&](int apart) {
    const double t = apart * step, angle = pi * t / T;
    double series = -std::cos(half * angle) / (2.0 * half);
    for (int m = 1; m < half; ++m) series -= std::cos(m * angle) / m;
    if (apart == 0) return series + std::log(2 * T / pi);
    return series + std::log(std::abs(std::sinh(2 * t) / (2 * std::sin(angle / 2))));
  };
  std::vector<double> kernels;
  for (int apart = 0; apart < count; ++apart) kernels.push_back(kernel(apart));
  Eigen::MatrixXd operation(count, count);
  Eigen::VectorXd root(count);  // of ds/dv
  for (int i = 0; i < count; ++i) root[i] = 1 / std::cosh(-T + (i + 0.5) * step);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      operation(i, j) = -step / pi * root[i] * root[j] * kernels[std::abs(i - j)];
    }
  }
  const Eigen::VectorXd constant = root.normalized();
  const Eigen::MatrixXd project =
      Eigen::MatrixXd::Identity(count, count) - constant * constant.transpose();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(project * operation * project).eigenvalues();
  return values.reverse().head(6).cwiseInverse();
}

TEST(SectionModes, OfAHalfFilledCylinderAreThoseOfAnIntegralEquation) {
  const Eigen::VectorXd exact = circle_kappas();
  EXPECT_NEAR(exact[0], 1.3557, 5e-5);  // the literature's
  EXPECT_NEAR(exact[1], 3.0331, 5e-5);
  const SectionModes coarse(cylinder(64, 1), 6), fine(cylinder(128, 1), 6);
  for (int n = 1; n <= 6; ++n) {
    const double with_64 = coarse.angular_frequency(n) * coarse.angular_frequency(n) / g;
    const double with_128 = fine.angular_frequency(n) * fine.angular_frequency(n) / g;
    // The polygon lacks a share of the circle that falls as the square of the edges.
    EXPECT_NEAR(with_128 / exact[n - 1], 1, 4e-4) << n;
    EXPECT_NEAR((exact[n - 1] - with_64) / (exact[n - 1] - with_128), 4, 0.1) << n;
    EXPECT_NEAR((4 * with_128 - with_64) / 3 / exact[n - 1], 1, 1e-5) << n;
  }
}

// A chamfer of length c cuts a stagnation flow, phi = phi_0 (1 - k^2 Re(w^2)/2) with w from the
// corner, |k w| << 1. In the corner so cut the potential is Re(w^2 + d/w^2), with d = 8 A^4/3 by
// the Schwarz-Christoffel map dw/ds = A (s^2-1)^(-1/4), of which the chamfer is -1 < s < 1:
// sqrt(2) c = A B(1/2, 3/4). Green's theorem for the two flows then gives
//   kappa - kappa_0 = -2 pi/3 A^4 k^4 phi_0^2 / <phi, phi>,
// which is 1.52 times what the Rayleigh quotient of the uncut flow loses with the triangle,
// k^4 phi_0^2 c^4/6: the flow also gives way. That loss alone is a bound.
TEST(SectionModes, FallWithAChamferAsTheFlowInTheCornerSays) {
  const Tank tank{.length = 1, .fill_depth = 0.35, .gravity = g, .density = 1000};
  for (const double c : {0.12, 0.06, 0.03}) {
    for (const int n : {1, 2}) {
      const double k = n * pi, bottom = 1 / std::cosh(k * tank.fill_depth);
      const double A = std::sqrt(2.0) * c / std::beta(0.5, 0.75);
      const double predicted = -2 * pi / 3 * std::pow(A * k, 4) * bottom * bottom / 0.5;
      const double bound = -std::pow(c * k, 4) / 6 * bottom * bottom / 0.5;
      const double uncut = k * std::tanh(k * tank.fill_depth);
      const double one = kappa(chamfered(c, 0, tank.fill_depth), n) - uncut;
      const double both = kappa(chamfered(c, c, tank.fill_depth), n) - uncut;
      EXPECT_LT(one, bound);
      // The next term is smaller by (c k)^4.
      EXPECT_NEAR(one / predicted, 1, 0.2 * std::pow(c * k, 4) + 1e-5) << c << " " << n;
      EXPECT_NEAR(both / predicted, 2, 0.4 * std::pow(c * k, 4) + 1e-5) << c << " " << n;
    }
  }
}

TEST(SectionModes, KnowLeftFromRight) {
  const SectionModes left(chamfered(0.3, 0, 0.35), 4), right(chamfered(0, 0.3, 0.35), 4);
  for (int n = 1; n <= 4; ++n) {
    EXPECT_NEAR(left.angular_frequency(n), right.angular_frequency(n), 1e-9);
    const double ratio = left.shape(n, 1);
    if (n == 1) {
      EXPECT_GT(std::abs(std::abs(ratio) - 1), 0.01);
    }
    for (const double x : {0.0, 0.2, 0.6}) {
      EXPECT_NEAR(left.shape(n, x), ratio * right.shape(n, 1 - x), 1e-8);
    }
  }
  // Over the shallower left half the first mode is steeper and higher.
  EXPECT_GT(std::abs(left.shape(1, 0)), std::abs(left.shape(1, 1)));
}

TEST(SectionModes, DoNotDependOnTheOriginOrOnWhatIsDry) {
  Section moved = skewed();
  for (Corner& corner : moved.outline) corner.x -= 7, corner.z += 3;
  const SectionModes here(skewed(), 5), there(moved, 5);
  for (int n = 1; n <= 5; ++n) {
    EXPECT_NEAR(here.angular_frequency(n), there.angular_frequency(n), 1e-9);
    EXPECT_NEAR(here.shape(n, 0.4), there.shape(n, -6.6), 1e-8);
  }
  Section chamfered_above = with_outline({{0, 0}, {1, 0}, {1, 0.6}, {0.8, 0.7}, {0, 0.7}}, 0.35);
  EXPECT_NEAR(kappa(chamfered_above, 1), pi * std::tanh(pi * 0.35), 1e-9);
}

TEST(SectionModes, ConvergeWithTheDegree) {
  const auto first = [](int height_degree, int more) {
    SectionGrid grid = SectionGrid::usual(10);
    grid.height_degree = height_degree;
    for (int& degree : grid.layer_degrees) degree += more;
    grid.middle_degree += more;
    return SectionFlow(skewed(), 10, grid, "Test").wave_numbers;
  };
  const auto best = first(12, 4);
  const auto error = [&](const Eigen::VectorXd& kappas) {
    return (kappas - best).cwiseQuotient(best).cwiseAbs().maxCoeff();
  };
  const double with_4 = error(first(4, 0)), with_6 = error(first(6, 0)),
               with_8 = error(first(8, 0));
  EXPECT_LT(with_6, with_4 / 20);
  EXPECT_LT(with_8, with_6 / 4);
  EXPECT_LT(with_8, 1e-9);
}

TEST(SectionWave, OfARectangleIsTheStandingWave) {
  const StandingWave exact(li_tank, std::nullopt, {.mode = 3, .amplitude = 0.02});
  const SectionWave wave(SectionModes(rectangle(li_tank), 6), 3, 0.02);
  EXPECT_NEAR(wave.angular_frequency(), exact.angular_frequency(), 1e-9);
  for (const double t : {0.0, 0.3, 1.7}) {
    EXPECT_NEAR(wave.horizontal_force(t), exact.horizontal_force(t), 1e-6);
    for (const double x : {0.0, 0.1, 0.8}) {
      EXPECT_NEAR(wave.elevation(x, t), exact.elevation(x - 0.5, t), 1e-9);
      for (const double z : {0.0, 0.2, 0.35}) {
        const auto [u, w] = wave.velocity(x, z, t);
        const auto wanted = exact.velocity(x - 0.5, z - 0.35, t);
        EXPECT_NEAR(wave.pressure(x, z, t), exact.pressure(x - 0.5, z - 0.35, t), 1e-5);
        EXPECT_NEAR(u, wanted.x, 1e-7);
        EXPECT_NEAR(w, wanted.z, 1e-7);
      }
    }
  }
}

// The rolling tank of any section against the rectangle's series, about an axis off the centre, and
// its force and moment against its pressure.

constexpr double a = zhao_tank.length / 2, h = zhao_tank.fill_depth;
constexpr RollAxis axis{0.11, zhao_axis_z};

SectionRollMotion about(const Corner& place, const RollMotion& motion) {
  return {motion.angle, motion.rate, motion.acceleration, place, motion.duration, motion.step};
}

TEST(SectionRoll, OfARectangleIsTheSeries) {
  const SectionModes modes(rectangle(zhao_tank), 40);
  const RollMotion motion = ramped_roll(axis, 3, 5, 5e-3);
  const SectionRoll section(modes, Start::tank, about({axis.x + a, axis.z + h}, motion));
  const LinearRoll series(zhao_tank, Start::tank, motion, 1000);
  for (const double t : {0.0, 0.9, 3.3, 5.0}) {
    for (const double x : {-a, -0.2, 0.13, a}) {
      EXPECT_NEAR(section.elevation(x + a, t), series.elevation(x, t), 3e-6);
      for (const double z : {-h, -0.3, -0.1}) {
        const auto [u, w] = section.velocity(x + a, z + h, t);
        const auto wanted = series.velocity(x, z, t);
        // In the corners Psi's gradient is r log r and its series falls as n^-2.
        const bool corner = std::abs(x) == a && z == -h;
        EXPECT_NEAR(section.pressure(x + a, z + h, t), series.pressure(x, z, t), 3e-4);
        EXPECT_NEAR(u, wanted.x, corner ? 1e-3 : 2e-6);
        EXPECT_NEAR(w, wanted.z, corner ? 1e-3 : z == -h ? 3e-5 : 2e-6);
      }
    }
    EXPECT_NEAR(section.force(t).x, series.force(t).x, 3e-3);
    EXPECT_NEAR(section.force(t).z, series.force(t).z, 1e-6);
    EXPECT_NEAR(section.moment(t), series.moment(t), 3e-3);
  }
}

TEST(SectionRoll, StartsAtRestInTheFrameThatIsNamed) {
  const SectionModes modes(vee(0.4), 20);
  const RollMotion motion = sine_roll(axis, 1, 1e-3);
  const SectionRollMotion roll = about({0.6, 0.1}, motion);
  const SectionRoll tank(modes, Start::tank, roll), earth(modes, Start::earth, roll);
  // A surface at rest in the tank has no normal velocity, under which an ideal liquid cannot but
  // turn against the walls.
  for (const double x : {0.5, 0.7, 0.9, 1.1}) EXPECT_NEAR(tank.velocity(x, 0.4, 0).z, 0, 1e-4);
  EXPECT_GT(std::abs(tank.velocity(0.8, 0.2, 0).x), 1e-3);
  // In the earth's frame the walls push the liquid; the surface, on which no impulse acts, keeps
  // its tangential velocity: relative to the tank it moves by -theta' times that of the tank.
  const double turning = motion.rate(0);
  EXPECT_NEAR(earth.velocity(0.8, 0.4, 0).x, turning * (0.4 - 0.1), 0.05 * turning * 0.3);
  // The flow follows the wall: along it alone.
  const auto [u, w] = earth.velocity(1.0, 0.2, 0);
  EXPECT_NEAR(u, w, 2e-4);
  EXPECT_NEAR(earth.elevation(0.6, 0), 0, 1e-12);
}

// The pressure along the wetted walls gives the force and the moment.
TEST(SectionRoll, PressesOnTheWallsAsItsForceAndMomentSay) {
  const SectionModes modes(skewed(), 40);
  const Corner place{0.4, 0.25};
  const SectionRoll roll(modes, Start::tank, about(place, ramped_roll(axis, 2, 4, 5e-3)));
  const std::vector<Corner> wetted{{0.05, 0.6}, {0.1, 0.3}, {0.3, 0},
                                   {0.9, 0.1},  {1.2, 0.4}, {1.15, 0.6}};
  for (const double t : {0.7, 2.9}) {
    double x = 0, z = 0, moment = 0;
    for (std::size_t i = 0; i + 1 < wetted.size(); ++i) {
      const auto &from = wetted[i], &to = wetted[i + 1];
      const int points = 400;
      for (int k = 0; k < points; ++k) {
        const double share = (k + 0.5) / points, at_x = from.x + share * (to.x - from.x),
                     at_z = from.z + share * (to.z - from.z);
        const double p = roll.pressure(at_x, at_z, t) / points;
        x += p * (to.z - from.z);
        z -= p * (to.x - from.x);
        moment -= p * ((at_x - place.x) * (to.x - from.x) + (at_z - place.z) * (to.z - from.z));
      }
    }
    EXPECT_NEAR(x, roll.force(t).x, 0.05);
    EXPECT_NEAR(z, roll.force(t).z, 0.05);
    EXPECT_NEAR(moment, roll.moment(t), 0.05);
  }
}

}  // namespace
}  // namespace slosh::reference::section_modes_test
