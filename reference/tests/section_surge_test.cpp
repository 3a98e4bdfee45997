// The surging tank of any section against the rectangle's series, and against an oscillator: in
// walls at 45 degrees a surge moves the first mode alone, whose surface stays plane.
#include "reference/section/section_surge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/linear_surge.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/sections.hpp"

namespace slosh::reference::section_surge_test {
namespace {

constexpr double a = li_tank.length / 2, h = li_tank.fill_depth;

const SectionModes& of_rectangle() {
  static const SectionModes modes(rectangle(li_tank), 40);
  return modes;
}

TEST(SectionSurge, OfARectangleIsTheSeries) {
  SineSurge late = li_surge;
  late.phase = 0.7;
  for (const SineSurge& motion : {li_surge, late}) {
    const SectionSurge section(of_rectangle(), Start::tank, motion);
    const LinearSurge series(li_tank, Start::tank, motion, 2000),
        same(li_tank, Start::tank, motion, 20);
    for (const double t : {0.0, 0.4, 2.9, 11.0}) {
      for (const double z : {-h, -0.2, -0.1}) {
        for (const double x : {-a, -0.2, 0.13, a}) {
          const auto [u, w] = section.velocity(x + a, z + h, t);
          const auto wanted = same.velocity(x, z, t);
          EXPECT_NEAR(section.pressure(x + a, z + h, t), series.pressure(x, z, t), 2e-4);
          EXPECT_NEAR(u, wanted.x, 1e-8);
          EXPECT_NEAR(w, wanted.z, 1e-8);
        }
      }
      EXPECT_NEAR(section.horizontal_force(t), series.horizontal_force(t), 2e-3);
    }
  }
}

double worst_elevation(Start start, int modes) {
  const SectionSurge section(of_rectangle(), start, li_surge);
  const LinearSurge series(li_tank, start, li_surge, modes);
  double worst = 0;
  for (int i = 0; i <= 120; ++i) {
    for (const double x : {-a, 0.1, li_gauge}) {
      worst = std::max(worst,
                       std::abs(section.elevation(x + a, 0.1 * i) - series.elevation(x, 0.1 * i)));
    }
  }
  return worst;
}

TEST(SectionSurge, ConvergesToTheSeriesElevation) {
  EXPECT_LT(worst_elevation(Start::tank, 2000), 1e-6);
  EXPECT_LT(worst_elevation(Start::earth, 2000), 0.4e-3);  // of 9 mm, as the same series of 20
}

TEST(SectionSurge, OfWallsAt45DegreesIsAnOscillator) {
  const double depth = 0.4, tip = 0.8, g = 9.81, rho = 1000;
  const SectionModes modes(vee(depth), 8);
  const SineSurge motion{.amplitude = 0.01, .angular_frequency = 3.1, .phase = 0.4};
  const double omega = motion.angular_frequency, omega_1 = std::sqrt(g / depth);
  for (const Start start : {Start::earth, Start::tank}) {
    const SectionSurge surge(modes, start, motion);
    // eta = s (x - tip), s'' + g/depth s = -X''/depth.
    const double X = motion.amplitude,
                 P = X * omega * omega / depth / (omega_1 * omega_1 - omega * omega);
    const double s0_rate = start == Start::earth ? -X * omega * std::cos(motion.phase) / depth : 0;
    for (const double t : {0.0, 0.2, 1.3, 6.0}) {
      const double phase = omega * t + motion.phase;
      const double by_rate = (s0_rate - P * omega * std::cos(motion.phase)) / omega_1;
      const double s = P * std::sin(phase) - P * std::sin(motion.phase) * std::cos(omega_1 * t) +
                       by_rate * std::sin(omega_1 * t);
      const double s_rate = P * omega * std::cos(phase) +
                            P * std::sin(motion.phase) * omega_1 * std::sin(omega_1 * t) +
                            by_rate * omega_1 * std::cos(omega_1 * t);
      const double tank = -X * omega * omega * std::sin(phase);
      const double s_acceleration = -omega_1 * omega_1 * s - tank / depth;
      EXPECT_NEAR(surge.elevation(tip + 0.3, t), s * 0.3, 1e-10);
      EXPECT_NEAR(surge.elevation(tip - 0.4, t), -s * 0.4, 1e-10);
      // phi = s' (x - tip) z.
      for (const auto& [x, z] : {std::pair{tip, 0.0}, {tip + 0.1, 0.1}, {tip - 0.15, 0.3}}) {
        const auto [u, w] = surge.velocity(x, z, t);
        EXPECT_NEAR(u, s_rate * z, 1e-7);
        EXPECT_NEAR(w, s_rate * (x - tip), 1e-7);
        const double p = -rho * (g * (z - depth) + (x - tip) * (tank + s_acceleration * z));
        EXPECT_NEAR(surge.pressure(x, z, t), p, 1e-5);
      }
      // The momentum of the relative flow is the integral of s' z over the section.
      const double force =
          -rho * (tank * depth * depth + s_acceleration * 2 * depth * depth * depth / 3);
      EXPECT_NEAR(surge.horizontal_force(t), force, 1e-5);
    }
  }
}

TEST(SectionSurge, TakesASampledMotionAsTheClosedForm) {
  const SectionModes modes(skewed(), 20);
  for (const Start start : {Start::earth, Start::tank}) {
    const SectionSurge closed(modes, start, li_surge),
        any(modes, start, sampled(li_surge, 5, 2e-3));
    for (const double t : {0.0, 0.777, 5.0}) {
      EXPECT_NEAR(any.elevation(0.3, t), closed.elevation(0.3, t), 1e-7);
      EXPECT_NEAR(any.pressure(0.5, 0.2, t), closed.pressure(0.5, 0.2, t), 1e-3);
      EXPECT_NEAR(any.horizontal_force(t), closed.horizontal_force(t), 1e-3);
    }
  }
}

// The walls' pressure, integrated along the outline, is the force.
TEST(SectionSurge, PressesOnTheWallsAsItsForceSays) {
  const Section section = skewed();
  const SectionModes modes(section, 40);
  const SectionSurge surge(modes, Start::tank, li_surge);
  const std::vector<Corner> wetted{{0.05, 0.6}, {0.1, 0.3}, {0.3, 0},
                                   {0.9, 0.1},  {1.2, 0.4}, {1.15, 0.6}};
  const double t = 1.7;
  double force = 0;
  for (std::size_t i = 0; i + 1 < wetted.size(); ++i) {
    const auto &from = wetted[i], &to = wetted[i + 1];
    const int points = 400;
    for (int k = 0; k < points; ++k) {
      const double share = (k + 0.5) / points;
      force +=
          surge.pressure(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z), t) *
          (to.z - from.z) / points;
    }
  }
  EXPECT_NEAR(force, surge.horizontal_force(t), 0.02);
}

}  // namespace
}  // namespace slosh::reference::section_surge_test
