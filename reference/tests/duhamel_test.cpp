#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "reference/mode_response.hpp"
#include "reference/tests/mode_by_odeint.hpp"
#include "reference/tests/paper_tanks.hpp"

namespace slosh::reference::duhamel_test {
namespace {

const std::vector<double> times{0.01, 0.305, 1, 2.7041, 5, 8, 12};

// The displacement b sin(omega t), multiplied over the first two periods by (1 - cos(pi t/rise))/2,
// and its exact second derivative.
struct RampedSine {
  double rise, omega, b;
  double operator()(double t) const {
    const double q = std::numbers::pi / rise;
    const double ramp = t < rise ? (1 - std::cos(q * t)) / 2 : 1;
    const double ramp_rate = t < rise ? q / 2 * std::sin(q * t) : 0;
    const double ramp_curvature = t < rise ? q * q / 2 * std::cos(q * t) : 0;
    return b * ((ramp_curvature - omega * omega * ramp) * std::sin(omega * t) +
                2 * ramp_rate * omega * std::cos(omega * t));
  }
};

SampledMotion sampled_li(double step) {
  return {"LinearSurge", sampled(li_surge, 12, step).acceleration, 12, step};
}

TEST(Duhamel, SolvesTheModesEquationForARamp) {
  const double omega = li_surge.angular_frequency;
  const RampedSine ramp{4 * std::numbers::pi / omega, omega, 0.02};
  const auto modes = surge_modes(li_tank, std::nullopt, 0, 6);
  // The interpolation error is (omega step)^2/12 of the forcing, 2e-7 of some 3 mm.
  const DuhamelModes duhamel(modes, {"LinearSurge", ramp, 12, 1e-3});
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const auto expected = mode_by_odeint(modes[n], ramp, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_NEAR(duhamel.state(n, times[i]).elevation, expected[i][0], 2e-9);
      EXPECT_NEAR(duhamel.state(n, times[i]).rate, expected[i][1], 1e-8);
    }
  }
}

TEST(Duhamel, EqualsTheClosedFormOnASine) {
  const auto modes = surge_modes(li_tank, std::nullopt, 0.02 * li_surge.angular_frequency, 300);
  const DuhamelModes duhamel(modes, sampled_li(1e-3));
  for (std::size_t n = 0; n < modes.size(); ++n) {
    for (const double t : times) {
      const ModeState state = duhamel.state(n, t), closed = forced_mode(modes[n], li_surge, t);
      EXPECT_NEAR(state.elevation, closed.elevation, 2e-9);
      EXPECT_NEAR(state.rate, closed.rate, 1e-8);
    }
  }
}

// Joined by straight lines, a sine has its amplitude times 1 - (omega step)^2 / 12: each part of a
// mode's motion is off by 1.8e-7 and 2.2e-6 of itself.
TEST(Duhamel, OfASumOfSinesEqualsTheSumOfTheirClosedForms) {
  const SineSurge one{0.02, li_surge.angular_frequency, 0.8}, two{0.004, 5.1, -2};
  const AnySurge first = sampled(one, 12, 1e-3), second = sampled(two, 12, 1e-3);
  const auto modes =
      surge_modes(li_tank, std::nullopt, first.initial_velocity + second.initial_velocity, 50);
  const auto of_one = surge_modes(li_tank, std::nullopt, first.initial_velocity, 50),
             of_two = surge_modes(li_tank, std::nullopt, second.initial_velocity, 50);
  const DuhamelModes duhamel(
      modes, {"LinearSurge",
              [&](double t) { return first.acceleration(t) + second.acceleration(t); }, 12, 1e-3});
  const double share = 1.1 * std::pow(two.angular_frequency * 1e-3, 2) / 12;
  for (std::size_t n = 0; n < modes.size(); ++n) {
    ModeState largest{};
    for (const double t : times) {
      const ModeState a = forced_mode(of_one[n], one, t), b = forced_mode(of_two[n], two, t);
      largest.elevation =
          std::max(largest.elevation, std::abs(a.elevation) + std::abs(b.elevation));
      largest.rate = std::max(largest.rate, std::abs(a.rate) + std::abs(b.rate));
    }
    for (const double t : times) {
      const ModeState state = duhamel.state(n, t), a = forced_mode(of_one[n], one, t),
                      b = forced_mode(of_two[n], two, t);
      EXPECT_NEAR(state.elevation, a.elevation + b.elevation, share * largest.elevation);
      EXPECT_NEAR(state.rate, a.rate + b.rate, share * largest.rate);
    }
  }
}

// The integral is exact for a piecewise-linear X'', so that coarse and fine samples agree to
// rounding. The last interval may be shorter than a step.
TEST(Duhamel, IsExactWhereTheAccelerationIsPiecewiseLinear) {
  const auto sawtooth = [](double t) {
    const double phase = t - std::floor(t);
    return phase < 0.5 ? phase : 1 - phase;
  };
  const auto modes = surge_modes(li_tank, std::nullopt, 0.1, 50);
  const DuhamelModes coarse(modes, {"LinearSurge", sawtooth, 5.25, 0.5});
  const DuhamelModes fine(modes, {"LinearSurge", sawtooth, 5.25, 0.5 / 64});
  EXPECT_EQ(coarse.duration(), 5.25);
  for (const double t : {0.1, 0.5, 1.7, 4.999, 5.2, 5.25}) {
    EXPECT_NEAR(coarse.acceleration(t), sawtooth(t), 1e-14);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      EXPECT_NEAR(coarse.state(n, t).elevation, fine.state(n, t).elevation, 1e-14);
      EXPECT_NEAR(coarse.state(n, t).acceleration, fine.state(n, t).acceleration, 1e-10);
    }
  }
}

// With its bends for knots, which lie between all steps, it needs no more samples than bends.
TEST(Duhamel, IsExactBetweenTheKnotsThatItIsGiven) {
  const std::vector<double> knots{0, 0.13, 0.131, 0.9, 2.02, 3}, values{0.4, -2, 3, -1, 0.5, 2};
  const auto bent = [&](double t) {
    std::size_t i = 0;
    while (i + 2 < knots.size() && knots[i + 1] < t) ++i;
    const double share = (t - knots[i]) / (knots[i + 1] - knots[i]);
    return values[i] + share * (values[i + 1] - values[i]);
  };
  const auto modes = surge_modes(li_tank, std::nullopt, 0.1, 6);
  const DuhamelModes exact(modes, {"LinearSurge", bent, 3, 1, knots});
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const std::vector<double> at{0.05, 0.1305, 0.5, 1.7, 2.9};
    const auto expected = mode_by_odeint(modes[n], bent, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(exact.acceleration(at[i]), bent(at[i]), 1e-13);
      EXPECT_NEAR(exact.state(n, at[i]).elevation, expected[i][0], 1e-7);
    }
  }
  for (const std::vector<double>& bad :
       {std::vector<double>{0, 1, 2}, {0.1, 3}, {0, 2, 2, 3}, {0, 2, 1, 3}, {0, NAN, 3}})
    EXPECT_THROW(DuhamelModes(modes, {"LinearSurge", bent, 3, 1, bad}), std::invalid_argument);
}

TEST(Duhamel, FallsToTheSecondOrderOfTheStep) {
  const auto modes = surge_modes(li_tank, std::nullopt, 0, 1);
  const auto error = [&](double step) {
    return DuhamelModes(modes, sampled_li(step)).state(0, 12).elevation -
           forced_mode(modes[0], li_surge, 12).elevation;
  };
  EXPECT_NEAR(error(0.05) / error(0.025), 4, 0.02);
}

TEST(Duhamel, RefusesWhatItCannotSample) {
  const auto modes = surge_modes(li_tank, std::nullopt, 0, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto still = [](double) { return 0.0; };
  EXPECT_THROW(DuhamelModes(modes, {"LinearSurge", still, 0, 0.1}), std::invalid_argument);
  EXPECT_THROW(DuhamelModes(modes, {"LinearSurge", still, 1, 0}), std::invalid_argument);
  EXPECT_THROW(DuhamelModes(modes, {"LinearSurge", still, 1, 2}), std::invalid_argument);
  EXPECT_THROW(
      DuhamelModes(modes, {"LinearSurge", [=](double t) { return t > 0.5 ? nan : 0; }, 1, 0.1}),
      std::invalid_argument);
}

const std::vector<double> instants{0.01, 0.3, 1, 2.7, 5, 8, 12};

double initial_velocity(const SineSurge& sine) {
  return sine.amplitude * sine.angular_frequency * std::cos(sine.phase);
}

void expect_solves_the_modes(const SineSurge& sine, double start_velocity) {
  const auto modes = surge_modes(li_tank, std::nullopt, start_velocity, 6);
  const auto acceleration = sampled(sine, 12, 1).acceleration;
  for (const TankMode& mode : modes) {
    const auto expected = mode_by_odeint(mode, acceleration, instants);
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const ModeState state = forced_mode(mode, sine, instants[i]);
      EXPECT_NEAR(state.elevation, expected[i][0], 1e-10) << "at " << instants[i] << " s";
      EXPECT_NEAR(state.rate, expected[i][1], 1e-9) << "at " << instants[i] << " s";
    }
  }
}

TEST(ForcedMode, SolvesTheModesEquationFromBothStarts) {
  expect_solves_the_modes(li_surge, initial_velocity(li_surge));
  expect_solves_the_modes(li_surge, 0);
}

TEST(ForcedMode, SolvesTheModesEquationAtExactResonance) {
  for (const int m : {1, 3}) {
    const SineSurge resonant{0.02, natural_frequency(li_tank, m)};
    expect_solves_the_modes(resonant, initial_velocity(resonant));
    expect_solves_the_modes(resonant, 0);
  }
}

TEST(ForcedMode, SolvesTheModesEquationOfASineWithAnyPhase) {
  for (const double phase : {-2.5, 0.4, std::numbers::pi / 2, 3.0})
    for (const double omega : {li_surge.angular_frequency, natural_frequency(li_tank, 1)}) {
      const SineSurge shifted{0.02, omega, phase};
      expect_solves_the_modes(shifted, initial_velocity(shifted));
      expect_solves_the_modes(shifted, 0);
    }
}

TEST(ForcedMode, OfASineHalfATurnLaterIsItsNegative) {
  const TankMode mode = surge_modes(li_tank, std::nullopt, 0, 2).back();
  SineSurge opposite = li_surge;
  opposite.phase = std::numbers::pi;
  for (const double t : instants)
    EXPECT_NEAR(forced_mode(mode, opposite, t).elevation, -forced_mode(mode, li_surge, t).elevation,
                1e-16);
}

TEST(ForcedMode, GrowsLinearlyAtExactResonance) {
  const double omega = natural_frequency(li_tank, 1);
  const TankMode mode = surge_modes(li_tank, std::nullopt, 0, 1).front();
  const double force = mode.coupling * 0.02 * omega * omega;
  for (const double t : instants) {
    EXPECT_NEAR(
        forced_mode(mode, {0.02, omega}, t).elevation,
        force / (2 * omega * omega) * (std::sin(omega * t) - omega * t * std::cos(omega * t)),
        1e-14);
  }
}

// Near resonance the textbook form, evaluated with a mantissa of 64 bits, still has the digits that
// are compared here. Even closer to resonance the elevation must vary linearly with the frequency
// through omega = omega_n.
TEST(ForcedMode, PassesThroughResonanceWithoutCancellation) {
  const double omega_n = natural_frequency(li_tank, 1), b = 0.02, t = 7;
  const TankMode mode = surge_modes(li_tank, std::nullopt, 0, 1).front();
  const auto elevation = [&](double omega) { return forced_mode(mode, {b, omega}, t).elevation; };
  const auto textbook = [&](long double omega) {
    const long double wn = omega_n;
    const long double p = b * omega * omega * mode.coupling / (wn * wn - omega * omega);
    return static_cast<double>(p * std::sin(omega * t) - p * omega / wn * std::sin(wn * t));
  };
  for (const double offset : {1e-2, -1e-4, 1e-5, -1e-6}) {
    const double omega = omega_n * (1 + offset);
    EXPECT_NEAR(elevation(omega), textbook(omega), 1e-13) << offset;
  }
  const double slope = (textbook(omega_n * (1 + 1e-5)) - textbook(omega_n * (1 - 1e-5))) / 2e-5;
  for (const double offset : {1e-8, -1e-10, 1e-12}) {
    EXPECT_NEAR(elevation(omega_n * (1 + offset)) - elevation(omega_n), slope * offset, 2e-14)
        << offset;
  }
}

TEST(ForcedMode, HasRatesThatAreItsDerivatives) {
  const SineSurge shifted{li_surge.amplitude, li_surge.angular_frequency, 0.7};
  const TankMode mode = surge_modes(li_tank, std::nullopt, initial_velocity(shifted), 3).back();
  const double step = 1e-4;
  for (const double t : instants) {
    const auto at = [&](double time) { return forced_mode(mode, shifted, time); };
    EXPECT_NEAR(at(t).rate, (at(t + step).elevation - at(t - step).elevation) / (2 * step), 1e-8);
    EXPECT_NEAR(at(t).acceleration, (at(t + step).rate - at(t - step).rate) / (2 * step), 1e-6);
  }
}

}  // namespace
}  // namespace slosh::reference::duhamel_test
