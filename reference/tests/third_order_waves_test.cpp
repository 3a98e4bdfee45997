// The third-order estimate against fully nonlinear potential flow and against Tadjbakhsh and
// Keller's law of the frequency.
#include "reference/third_order_waves.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/linear_surge.hpp"
#include "reference/tests/modal_third_order.hpp"
#include "reference/tests/nonlinear_cases.hpp"

namespace slosh::reference::third_order_waves_test {
namespace {

double rms_of(const std::vector<double>& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

std::vector<double> less(std::vector<double> values, const std::vector<double>& others) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= others[i];
  return values;
}

// k A = 0.16, where the sum of the forcing's and the first frequency is near the second mode's:
// linear theory is 43 % rms off there. And a wave near resonance. The resolved potential flow takes
// eleven seconds.
TEST(ThirdOrderWaves, AreWhatPotentialFlowAddsToLinearTheory) {
  const Tank tank{.length = 1, .fill_depth = 0.35, .gravity = 9.81, .density = 1000};
  const auto times = instants_up_to(20, 0.05);
  struct Surge {
    double amplitude, frequency, error;  // error: of linear theory, rms over its own
  };
  for (const auto& [amplitude, frequency, error] : {Surge{0.052, 3.0, 0.43}, {0.0045, 4.6, 0.1}}) {
    TankMotion motion;
    motion.surge_velocity = [=](double t) {
      return amplitude * frequency * std::cos(frequency * t);
    };
    motion.surge_acceleration = [=](double t) {
      return -amplitude * frequency * frequency * std::sin(frequency * t);
    };
    const auto flow = run_nonlinear_potential_flow(
        {.tank = tank, .motion = motion, .start = Start::tank, .nodes_x = 40, .nodes_z = 16},
        {.times = times, .gauges = {0.45}});
    ASSERT_EQ(flow.times.size(), times.size());
    const auto linear = LinearSurge(tank, Start::tank, SineSurge{amplitude, frequency}, 1000)
                            .elevation(0.45, times);
    const auto found =
        third_order_waves({.tank = tank, .acceleration = motion.surge_acceleration}, times);
    const auto left_out = less(flow.elevation[0], linear);
    EXPECT_NEAR(rms_of(left_out) / rms_of(linear), error, 0.02);
    // Measured: 0.3 % of the linear wave.
    EXPECT_LT(rms_of(less(found.elevation(0.45), left_out)) / rms_of(linear), 0.006) << frequency;
    EXPECT_LT(rms_of(less(found.linear_elevation(0.45), linear)) / rms_of(linear), 0.01)
        << frequency;
  }
}

TEST(ThirdOrderWaves, HaveTheFrequencyOfTadjbakhshAndKeller) {
  for (const double depth : {0.22, 0.45, 0.9}) {
    const Tank tank{.length = 1, .fill_depth = depth, .gravity = 9.81, .density = 1000};
    const double amplitude = 0.01, omega = natural_frequency(tank, 1);
    const auto times = instants_up_to(200 * std::numbers::pi / omega, 0.05 / omega);
    const auto found = third_order_waves({.tank = tank, .initial_wave = {1, amplitude}}, times);
    const auto left = found.elevation(-0.5), right = found.elevation(0.5);
    // The odd modes, whose first drifts in phase against the linear one: its quadrature over the
    // last of 100 periods is the drift in radians.
    double quadrature = 0, square = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < 198 * std::numbers::pi / omega) continue;
      const double odd = (left[i] - right[i]) / 2;
      quadrature -= odd * std::sin(omega * times[i]) * amplitude;
      square += std::pow(std::sin(omega * times[i]) * amplitude, 2);
    }
    const double shift = quadrature / square / (199 * std::numbers::pi);
    const double law =
        frequency_shift_of_lasting_wave(tank) * std::pow(std::numbers::pi * amplitude, 2);
    EXPECT_NEAR(shift, law, 0.05 * std::abs(law) + 2e-6) << depth;
  }
}

// Where a wave of mode m has its crests and troughs, walls would change nothing: it is the first of
// a tank of length L / m.
TEST(ThirdOrderWaves, OfAHighModeAreThoseOfTheFirstInAShorterTank) {
  const auto times = instants_up_to(3, 0.01);
  for (const int mode : {5, 14, 20}) {
    const Tank whole{.length = 1, .fill_depth = 0.35, .gravity = 9.81, .density = 1000};
    Tank part = whole;
    part.length /= mode;
    const double amplitude = 0.2 * part.length / std::numbers::pi;
    const auto of_whole =
        third_order_waves({.tank = whole, .initial_wave = {mode, amplitude}}, times);
    const auto of_part = third_order_waves({.tank = part, .initial_wave = {1, amplitude}}, times);
    const auto found = of_whole.elevation(-0.5), expected = of_part.elevation(-part.length / 2);
    double largest = 0, apart = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      largest = std::max(largest, std::abs(expected[i]));
      apart = std::max(apart, std::abs(found[i] - expected[i]));
    }
    EXPECT_GT(largest, 0.05 * amplitude) << "kA is 0.2";
    EXPECT_LT(apart, 0.02 * largest) << mode << ", whose fourth harmonic is left out";
  }
}

TEST(ThirdOrderWaves, AreNotFiniteWhereTheyOutgrowTheExpansionAndRefuseAnImpossibleTank) {
  const auto steep = third_order_waves({.tank = {1, 0.35, 9.81, 1000}, .initial_wave = {1, 0.3}},
                                       instants_up_to(20, 0.05));
  EXPECT_FALSE(std::isfinite(steep.elevation(0.5).back()));
  const auto short_wave = third_order_waves(
      {.tank = {1, 0.35, 9.81, 1000}, .initial_wave = {22, 1e-4}}, instants_up_to(1, 0.05));
  EXPECT_FALSE(std::isfinite(short_wave.elevation(0.5).back())) << "its third harmonic is 66";
  EXPECT_THROW(third_order_waves({.tank = {1, -0.35, 9.81, 1000}}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(third_order_waves({.tank = {1, 0.35, 9.81, 1000}}, {0, 1}).elevation(0.6),
               std::invalid_argument);
}

}  // namespace
}  // namespace slosh::reference::third_order_waves_test
