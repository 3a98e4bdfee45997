// The numbers of the papers' errata, which the report shows, against what theory and the shipped
// cases give.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/linear_surge.hpp"
#include "verification/case/motion.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/papers/paper.hpp"

namespace slosh::errata_test {
namespace {

using std::numbers::pi;

std::string computed(const char* paper, std::size_t row) {
  return paper_named(paper).errata.at(row).computed;
}

// The largest |f(t)| over the 12 s that the paper shows.
template <class Function>
double largest(const Function& f) {
  double value = 0;
  for (int i = 0; i <= 1200; ++i) value = std::max(value, std::abs(f(0.01 * i)));
  return value;
}

TEST(ErrataOfLi2010, CarryWhatLinearTheoryGives) {
  constexpr double printed = 4.94488;  // omega_0 [rad/s], section 4.1
  const reference::Tank tank{1.0, 0.35, 9.81, 1000};
  const reference::SineSurge motion{0.02, 0.3 * printed};
  const reference::LinearSurge ours(tank, reference::Start::earth, motion, 1000);
  const reference::LinearSurge opposite(tank, reference::Start::earth,
                                        {-motion.amplitude, motion.angular_frequency}, 1000);
  constexpr double gauge = 0.45;  // [m] from the centre
  EXPECT_EQ(
      computed("li2010", 0),
      fmt::format("largest |eta| {:.3f} mm; largest |eta(+b omega) + eta(-b omega)| {:.1g} mm",
                  1000 * largest([&](double t) { return ours.elevation(gauge, t); }),
                  1000 * largest([&](double t) {
                    return ours.elevation(gauge, t) + opposite.elevation(gauge, t);
                  })));
  const double omega = reference::natural_frequency(tank, 1);
  EXPECT_EQ(computed("li2010", 1),
            fmt::format("{:.5f} rad/s, {:+.2f} % off", omega, 100 * (printed / omega - 1)));
  EXPECT_EQ(computed("li2010", 2), fmt::format("omega_0 / 2 pi = {:.3f} Hz; 1 / 1.3 s = {:.3f} Hz",
                                               printed / (2 * pi), 1 / 1.3));
  // For L = 1 m, sin(lambda_n 0.95) = sin(lambda_n 0.05): x = 0.95 in eq. 16 is a gauge 0.05 m from
  // the centre.
  EXPECT_EQ(computed("li2010", 3),
            fmt::format("x = 0.95 m taken literally errs by up to {:.2f} mm within 12 s",
                        1000 * largest([&](double t) {
                          return ours.elevation(gauge, t) - ours.elevation(0.05, t);
                        })));
  EXPECT_EQ(computed("li2010", 5), fmt::format("the wall moves at up to {:.4f} m/s",
                                               motion.amplitude * motion.angular_frequency));
}

// The violently rolling tank: SPHERIC benchmark 10, water.
TEST(ErrataOfZhao2021, CarryWhatLinearTheoryGives) {
  const reference::Tank tank{0.9, 0.093, 9.81, 998};
  const double omega = reference::natural_frequency(tank, 1), forcing = 2 * pi / 1.631;
  EXPECT_EQ(computed("zhao2021", 0),
            fmt::format("omega_1 = {:.3f} rad/s, period {:.3f} s ({:+.2f} % off 1.919)", omega,
                        2 * pi / omega, 100 * (2 * pi / omega / 1.919 - 1)));
  EXPECT_EQ(computed("zhao2021", 1),
            fmt::format("omega = {:.3f} rad/s; periods {:.3f}, frequencies {:.3f}", forcing,
                        1.631 / 1.919, forcing / omega));
  EXPECT_EQ(computed("zhao2021", 2),
            fmt::format("still water presses with {:.0f} Pa at 0.0093 m and 0 Pa at 0.093 m, where "
                        "the record begins",
                        998 * 9.81 * (0.093 - 0.0093)));
  // The integral of (1 - q/2)^4 (1 + 2q) over the plane, q = r / h <= 2, is 4 pi / 7.
  EXPECT_EQ(computed("zhao2021", 4),
            fmt::format("the kernel over its constant integrates to {:.6f} h^2, and 7/(4 pi) times "
                        "that is 1.000000; 7/4 pi times it is {:.3f}",
                        4 * pi / 7, pi * pi));
}

TEST(ErrataOfZhao2021, SetTheMeasuredRollBesideTheSine) {
  const auto roll_of = [](const std::string& name) {
    return *roll_motion(read_case(SLOSH_SOURCE_DIR "/verification/cases/" + name + ".toml"));
  };
  const auto roll = roll_of("zhao2021_violent_roll"), sine = roll_of("zhao2021_violent_sine");
  const double duration = std::min(
      read_case(SLOSH_SOURCE_DIR "/verification/cases/zhao2021_violent_roll.toml").duration,
      read_case(SLOSH_SOURCE_DIR "/verification/cases/zhao2021_violent_sine.toml").duration);
  double most = 0, at = 0, sum = 0;
  int count = 0;
  for (; 0.01 * count <= duration; ++count) {
    const double t = 0.01 * count, apart = 180 / pi * (roll.angle(t) - sine.angle(t));
    if (std::abs(apart) > std::abs(most)) most = apart, at = t;
    sum += apart * apart;
  }
  EXPECT_EQ(computed("zhao2021", 3),
            fmt::format("it starts at {:.1f} deg/s, the sine at {:.1f}; apart by up to {:.2f} deg "
                        "(at {:.2f} s), rms {:.2f} deg",
                        180 / pi * roll.rate(0), 180 / pi * sine.rate(0), std::abs(most), at,
                        std::sqrt(sum / count)));
}

}  // namespace
}  // namespace slosh::errata_test
