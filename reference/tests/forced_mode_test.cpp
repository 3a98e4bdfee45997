#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "reference/mode_response.hpp"
#include "reference/tests/li_tank.hpp"
#include "reference/tests/mode_by_odeint.hpp"

namespace slosh::reference::forced_mode_test {
namespace {

const std::vector<double> times{0.01, 0.3, 1, 2.7, 5, 8, 12};

double initial_velocity(const SineSurge& sine) {
  return sine.amplitude * sine.angular_frequency * std::cos(sine.phase);
}

void expect_solves_the_modes(const SineSurge& sine, double start_velocity) {
  const auto modes = surge_modes(li_tank, std::nullopt, start_velocity, 6);
  const auto acceleration = sampled(sine, 12, 1).acceleration;
  for (const TankMode& mode : modes) {
    const auto expected = mode_by_odeint(mode, acceleration, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const ModeState state = forced_mode(mode, sine, times[i]);
      EXPECT_NEAR(state.elevation, expected[i][0], 1e-10) << "at " << times[i] << " s";
      EXPECT_NEAR(state.rate, expected[i][1], 1e-9) << "at " << times[i] << " s";
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
  for (const double t : times)
    EXPECT_NEAR(forced_mode(mode, opposite, t).elevation, -forced_mode(mode, li_surge, t).elevation,
                1e-16);
}

TEST(ForcedMode, GrowsLinearlyAtExactResonance) {
  const double omega = natural_frequency(li_tank, 1);
  const TankMode mode = surge_modes(li_tank, std::nullopt, 0, 1).front();
  const double force = mode.coupling * 0.02 * omega * omega;
  for (const double t : times) {
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
  for (const double t : times) {
    const auto at = [&](double time) { return forced_mode(mode, shifted, time); };
    EXPECT_NEAR(at(t).rate, (at(t + step).elevation - at(t - step).elevation) / (2 * step), 1e-8);
    EXPECT_NEAR(at(t).acceleration, (at(t + step).rate - at(t - step).rate) / (2 * step), 1e-6);
  }
}

}  // namespace
}  // namespace slosh::reference::forced_mode_test
