// The roll of SPHERIC benchmark 10: compares the table with its formula, and the formula with the
// record.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <utility>
#include <vector>

#include "verification/case/cubic_spline.hpp"
#include "verification/input/time_table.hpp"
#include "verification/tests/published_records.hpp"

namespace slosh::spheric10_roll_test {
namespace {

constexpr double join = 0.75;  // [s]

// The angle [deg], rate [deg/s] and acceleration [deg/s2].
using Motion = std::array<double, 3>;

// cases/spheric10_roll.md.
Motion harmonics(double t) {
  constexpr double w = 3.840445;
  const double p = w * (t - 2.21764), c1 = 3.96666, c2 = -0.03998, s2 = 0.00671;
  return {-0.04428 + c1 * std::cos(p) + c2 * std::cos(2 * p) + s2 * std::sin(2 * p),
          w * (-c1 * std::sin(p) - 2 * c2 * std::sin(2 * p) + 2 * s2 * std::cos(2 * p)),
          w * w * (-c1 * std::cos(p) - 4 * c2 * std::cos(2 * p) - 4 * s2 * std::sin(2 * p))};
}

// x^3 G(y), y = 1 - x, x = t / join; derivatives of G with respect to x.
Motion start(double t) {
  constexpr std::array<double, 8> c{3.1167048,  16.0032658,  25.6032532,    23.6799964,
                                    -4.6100369, 480.0983056, -1242.8435954, 803.7589826};
  const double x = t / join, y = 1 - x;
  double g = 0, g1 = 0, g2 = 0;
  for (std::size_t i = c.size(); i-- > 0;) {
    g2 = g2 * y + 2 * g1;
    g1 = g1 * y + g;
    g = g * y + c[i];
  }
  g1 = -g1;
  return {x * x * x * g, (3 * x * x * g + x * x * x * g1) / join,
          (6 * x * g + 6 * x * x * g1 + x * x * x * g2) / (join * join)};
}

Motion roll(double t) { return t < join ? start(t) : harmonics(t); }

TimeTable table() {
  return read_time_table(SLOSH_SOURCE_DIR "/verification/cases/spheric10_roll.csv", {"angle_deg"});
}

TEST(Spheric10Roll, IsItsFormulaFromZeroToTwelveSeconds) {
  const TimeTable roll_table = table();
  ASSERT_EQ(roll_table.time.size(), 375U + 1126U);
  for (std::size_t i = 0; i < roll_table.time.size(); ++i) {
    const double n = static_cast<double>(i);
    const double t = i < 375 ? 0.002 * n : join + 0.01 * (n - 375);
    ASSERT_NEAR(roll_table.time[i], t, 1e-12);
    ASSERT_NEAR(roll_table.value[i], roll(t)[0], 6e-10) << t;  // nine decimals
  }
}

TEST(Spheric10Roll, StartsFromRestAndJoinsTheHarmonicsSmoothly) {
  EXPECT_EQ(start(0), (Motion{0, 0, 0}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(start(join)[i], harmonics(join)[i], 2e-6) << i;
  constexpr double step = 1e-4;  // third derivatives
  EXPECT_NEAR((start(join)[2] - start(join - step)[2]) / step,
              (harmonics(join + step)[2] - harmonics(join)[2]) / step, 0.5);
}

TEST(Spheric10Roll, IsSampledFinelyEnoughForACubicSpline) {
  TimeTable points = table();
  const CubicSpline spline(points.time, points.value);
  Motion largest{};
  for (int i = 0; i <= 12000 * 4; ++i) {
    const double t = i / 4000.0;
    const Motion exact = roll(t);
    const Motion found{spline.value(t), spline.first_derivative(t), spline.second_derivative(t)};
    for (std::size_t k = 0; k < 3; ++k)
      largest[k] = std::max(largest[k], std::abs(found[k] - exact[k]));
  }
  EXPECT_LT(largest[0], 2.1e-7);
  EXPECT_LT(largest[1], 1.3e-4);
  EXPECT_LT(largest[2], 0.15);  // at t = 0; the acceleration itself reaches 68
}

TEST(Spheric10Roll, LagsBehindThePapersSineByASixthOfASecondAndMore) {
  const std::vector<std::pair<int, double>> zeros{// number of the zero, its time [s]
                                                  {1, 0.9903},
                                                  {2, 1.8089},
                                                  {4, 3.4450},
                                                  {8, 6.7171},
                                                  {12, 9.9892}};
  const std::vector<double> lags{0.1743, 0.1769, 0.1810, 0.1891, 0.1972};
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const auto [number, time] = zeros[i];
    EXPECT_LT(roll(time - 6e-5)[0] * roll(time + 6e-5)[0], 0) << time;
    EXPECT_NEAR(time - number * std::numbers::pi / 3.85, lags[i], 1e-4);
  }
  EXPECT_NEAR(roll(0.57)[0], 3.918, 5e-4);  // the first crest
  EXPECT_NEAR(roll(0.57)[1], 0, 1e-2);
}

struct Record {
  std::vector<double> time, angle;
};

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string header;
  std::getline(stream, header);
  Record record;
  char comma = 0;
  for (double t = 0, angle = 0; stream >> t >> comma >> angle;) {
    record.time.push_back(t);
    record.angle.push_back(angle);
  }
  return record;
}

// The largest and the root mean square difference [deg] between the formula and the record.
struct Difference {
  std::size_t samples;
  double largest, rms;
};

Difference difference(const Record& record, double after, double until) {
  Difference found{};
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (record.time[i] <= after || record.time[i] > until) continue;
    const double error = record.angle[i] - roll(record.time[i])[0];
    found.largest = std::max(found.largest, std::abs(error));
    found.rms += error * error;
    ++found.samples;
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(found.samples));
  return found;
}

TEST(Spheric10Roll, IsNearerToTheRecordThanTheRecordsOwnUncertainty) {
  const auto file = published_record("spheric_test10/roll_lateral_water_10ms.csv");
  if (!file) GTEST_SKIP() << "spheric_test10/roll_lateral_water_10ms.csv" << record_missing;
  const Record record = read_record(*file);
  const Difference before = difference(record, -1, join + 1e-9);
  EXPECT_EQ(before.samples, 76U);
  EXPECT_NEAR(before.largest, 0.0079, 5e-5);
  EXPECT_NEAR(before.rms, 0.0043, 5e-5);
  const Difference after = difference(record, join + 1e-9, 9);
  EXPECT_EQ(after.samples, 760U);
  EXPECT_NEAR(after.largest, 0.0070, 5e-5);
  EXPECT_NEAR(after.rms, 0.0011, 5e-5);
}

}  // namespace
}  // namespace slosh::spheric10_roll_test
