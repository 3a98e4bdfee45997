#include "verification/fits/dominant_sine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "verification/tests/messages.hpp"

namespace slosh::dominant_sine_test {
namespace {

constexpr double omega = 3.84;                     // [rad/s]
constexpr TimeWindow window{1, 13};                // 7.3 periods
constexpr double bin = 2 * std::numbers::pi / 12;  // [rad/s], the resolution of this window

// A sample every 10 ms from 0 to 14 s, with an interval that varies.
TimeSeries sampled(const std::function<double(double)>& motion) {
  TimeSeries series{"roll.csv", "rad", {}, {}};
  for (double t = 0; t <= 14; t += 0.01 + 0.004 * std::sin(9 * t)) {
    series.time.push_back(t);
    series.value.push_back(motion(t));
  }
  return series;
}

double sine(double t) { return 0.07 * std::sin(omega * t + 0.4); }

std::string complaint(const TimeSeries& series, TimeWindow in = window) {
  return message_of<ComparisonError>([&] { dominant_sine(series, in); });
}

TEST(DominantSine, OfASineIsThatSine) {
  const DominantSine found = dominant_sine(sampled(sine), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 1e-6);
  EXPECT_LT(found.angular_frequency.half_width, 1e-4);
  EXPECT_LT(found.rest, 1e-5);
}

TEST(DominantSine, IsFoundWhateverTheMeanAndTheDrift) {
  const DominantSine found =
      dominant_sine(sampled([](double t) { return 5 + 0.1 * t + sine(t); }), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 1e-6);
}

TEST(DominantSine, OfANoisyTableIsWithinItsInterval) {
  int inside = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0, 0.01);
    const DominantSine found =
        dominant_sine(sampled([&](double t) { return sine(t) + noise(generator); }), window);
    EXPECT_NEAR(found.angular_frequency.value, omega, 5e-3);
    EXPECT_NEAR(found.rest, 0.01 / (0.07 / std::numbers::sqrt2), 0.02);
    inside += std::abs(found.angular_frequency.value - omega) <= found.angular_frequency.half_width;
  }
  // Of 40 intervals of 95 %, 33 or fewer hold the truth once in 400 times.
  EXPECT_GE(inside, 34);
}

TEST(DominantSine, TellsTheRestOfAHarmonic) {
  const DominantSine found = dominant_sine(
      sampled([](double t) { return sine(t) + 0.014 * std::sin(3 * omega * t); }), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 5e-3);
  EXPECT_NEAR(found.rest, 0.2, 0.005);
}

TEST(DominantSine, IsNoneOfTwoSines) {
  const std::string message =
      complaint(sampled([](double t) { return sine(t) + 0.05 * std::sin(7.1 * t); }));
  EXPECT_TRUE(holds(message, "roll.csv: the rest beside the sine of 0.611"));
  EXPECT_TRUE(holds(message, "is 0.71"));
  EXPECT_TRUE(holds(message, "has at most 0.32; the next peak is at 1.1"));
}

// Half a bin apart, two sines beat as one sine whose amplitude changes. A weak one beside it is
// part of the rest. With r the ratio of their amplitudes and d the difference of their
// frequencies, the frequency of the sum differs from the strong one's by r d / (1 - r) at most.
TEST(DominantSine, IsNoneOfTwoLikeSinesThatTheWindowCannotTellApart) {
  const auto beside = [](double amplitude) {
    return sampled(
        [amplitude](double t) { return sine(t) + amplitude * std::sin((omega + 0.6 * bin) * t); });
  };
  EXPECT_NE(complaint(beside(0.05)), "");
  const DominantSine found = dominant_sine(beside(0.02), window);
  const double ratio = 0.02 / 0.07;
  EXPECT_NEAR(found.angular_frequency.value, omega, 0.6 * bin * ratio / (1 - ratio));
  EXPECT_GT(found.rest, 0.1);
}

TEST(DominantSine, IsNoneOfNoiseOrOfASweep) {
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0, 1);
  EXPECT_NE(complaint(sampled([&](double) { return noise(generator); })), "");
  EXPECT_NE(complaint(sampled([](double t) { return std::sin((2 + 0.3 * t) * t); })), "");
}

TEST(DominantSine, IsNoneOfAMotionThatDoesNotSwing) {
  EXPECT_NE(complaint(sampled([](double) { return 0.1; })), "");
  EXPECT_NE(complaint(sampled([](double t) { return std::exp(-t); })), "");
}

TEST(DominantSine, NeedsThreePeriods) {
  const std::string message = complaint(sampled(sine), {1, 1 + 2.5 * 2 * std::numbers::pi / omega});
  EXPECT_TRUE(holds(message, "periods in the window, and three or more tell a frequency"));
}

TEST(DominantSine, PassesUpToTheTolerancesRest) {
  const auto beside = [](double share) {
    return sampled([share](double t) { return sine(t) + share * 0.07 * std::sin(7.1 * t); });
  };
  EXPECT_EQ(complaint(beside(0.30)), "");
  EXPECT_NE(complaint(beside(0.34)), "");
  EXPECT_NEAR(largest_rest, std::sqrt(1.05 * 1.05 - 1), 5e-5);
}

}  // namespace
}  // namespace slosh::dominant_sine_test
