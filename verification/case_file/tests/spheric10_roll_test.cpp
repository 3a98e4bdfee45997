// The rolls of SPHERIC benchmark 10: compares each table with its formula, and the formula with the
// record.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/case/cubic_spline.hpp"
#include "verification/input/tables/time_table.hpp"
#include "verification/tests/published_records.hpp"

namespace slosh::spheric10_roll_test {
namespace {

constexpr double join = 0.75;  // [s]

// The angle [deg], rate [deg/s] and acceleration [deg/s2].
using Motion = std::array<double, 3>;

// cases/spheric10_roll.md: the mean, the harmonics (cosine and sine of n w (t - phase_time)), and
// the coefficients of the start.
struct Formula {
  const char *table, *record;
  double w, phase_time, mean;
  std::vector<std::pair<double, double>> harmonics;
  std::array<double, 8> start;
  Motion spline_error;  // the largest of the cubic spline through the table; the acceleration's is
                        // at 0
};

const Formula water{"spheric10_roll.csv",
                    "spheric_test10/roll_lateral_water_10ms.csv",
                    3.840445,
                    2.21764,
                    -0.04428,
                    {{3.96666, 0}, {-0.03998, 0.00671}},
                    {3.1167048, 16.0032658, 25.6032532, 23.6799964, -4.6100369, 480.0983056,
                     -1242.8435954, 803.7589826},
                    {2.1e-7, 1.3e-4, 0.15}};
const Formula oil{"spheric10_oil_roll.csv",
                  "spheric_test10/roll_lateral_oil.csv",
                  4.07820,
                  2,
                  -0.04848,
                  {{3.66016, 1.56183}, {-0.02452, -0.01973}, {-0.00106, -0.00120}},
                  {2.7799404, 16.7210289, 28.4844817, 25.9727667, -84.5771642, 788.8666181,
                   -1684.3888439, 1040.4926493},
                  {3e-7, 1.9e-4, 0.2}};

Motion harmonics(const Formula& formula, double t) {
  Motion sum{formula.mean, 0, 0};
  for (std::size_t n = 0; n < formula.harmonics.size(); ++n) {
    const double w = static_cast<double>(n + 1) * formula.w, p = w * (t - formula.phase_time);
    const auto [c, s] = formula.harmonics[n];
    sum[0] += c * std::cos(p) + s * std::sin(p);
    sum[1] += w * (s * std::cos(p) - c * std::sin(p));
    sum[2] -= w * w * (c * std::cos(p) + s * std::sin(p));
  }
  return sum;
}

// x^3 G(y), y = 1 - x, x = t / join; derivatives of G with respect to x.
Motion start(const Formula& formula, double t) {
  const std::array<double, 8>& c = formula.start;
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

Motion roll(const Formula& formula, double t) {
  return t < join ? start(formula, t) : harmonics(formula, t);
}

TimeTable table(const Formula& formula) {
  return read_time_table(std::string(SLOSH_SOURCE_DIR "/verification/cases/") + formula.table,
                         {"angle_deg"});
}

class Spheric10Roll : public testing::TestWithParam<const Formula*> {};
INSTANTIATE_TEST_SUITE_P(Of, Spheric10Roll, testing::Values(&water, &oil),
                         [](const auto& named) { return named.index == 0 ? "Water" : "Oil"; });

TEST_P(Spheric10Roll, IsItsFormulaFromZeroToTwelveSeconds) {
  const Formula& formula = *GetParam();
  const TimeTable roll_table = table(formula);
  ASSERT_EQ(roll_table.time.size(), 375U + 1126U);
  for (std::size_t i = 0; i < roll_table.time.size(); ++i) {
    const double n = static_cast<double>(i);
    const double t = i < 375 ? 0.002 * n : join + 0.01 * (n - 375);
    ASSERT_NEAR(roll_table.time[i], t, 1e-12);
    ASSERT_NEAR(roll_table.value[i], roll(formula, t)[0], 6e-10) << t;  // nine decimals
  }
}

TEST_P(Spheric10Roll, StartsFromRestAndJoinsTheHarmonicsSmoothly) {
  const Formula& formula = *GetParam();
  EXPECT_EQ(start(formula, 0), (Motion{0, 0, 0}));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(start(formula, join)[i], harmonics(formula, join)[i], 2e-6) << i;
  constexpr double step = 1e-4;  // third derivatives
  EXPECT_NEAR((start(formula, join)[2] - start(formula, join - step)[2]) / step,
              (harmonics(formula, join + step)[2] - harmonics(formula, join)[2]) / step, 0.5);
}

TEST_P(Spheric10Roll, IsSampledFinelyEnoughForACubicSpline) {
  const Formula& formula = *GetParam();
  TimeTable points = table(formula);
  const CubicSpline spline(points.time, points.value);
  Motion largest{};
  for (int i = 0; i <= 12000 * 4; ++i) {
    const double t = i / 4000.0;
    const Motion exact = roll(formula, t);
    const Motion found{spline.value(t), spline.first_derivative(t), spline.second_derivative(t)};
    for (std::size_t k = 0; k < 3; ++k)
      largest[k] = std::max(largest[k], std::abs(found[k] - exact[k]));
  }
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(largest[k], formula.spline_error[k]) << k;
}

TEST(Spheric10RollOfWater, LagsBehindThePapersSineByASixthOfASecondAndMore) {
  const std::vector<std::pair<int, double>> zeros{// number of the zero, its time [s]
                                                  {1, 0.9903},
                                                  {2, 1.8089},
                                                  {4, 3.4450},
                                                  {8, 6.7171},
                                                  {12, 9.9892}};
  const std::vector<double> lags{0.1743, 0.1769, 0.1810, 0.1891, 0.1972};
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const auto [number, time] = zeros[i];
    EXPECT_LT(roll(water, time - 6e-5)[0] * roll(water, time + 6e-5)[0], 0) << time;
    EXPECT_NEAR(time - number * std::numbers::pi / 3.85, lags[i], 1e-4);
  }
  EXPECT_NEAR(roll(water, 0.57)[0], 3.918, 5e-4);  // the first crest
  EXPECT_NEAR(roll(water, 0.57)[1], 0, 1e-2);
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

Difference difference(const Formula& formula, double after, double until) {
  const Record record = read_record(published_record(formula.record).value());
  Difference found{};
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (record.time[i] <= after || record.time[i] > until) continue;
    const double error = record.angle[i] - roll(formula, record.time[i])[0];
    found.largest = std::max(found.largest, std::abs(error));
    found.rms += error * error;
    ++found.samples;
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(found.samples));
  return found;
}

void expect_difference(const Formula& formula, double after, double until,
                       const Difference& expected) {
  const Difference found = difference(formula, after, until);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_NEAR(found.largest, expected.largest, 6e-5);
  EXPECT_NEAR(found.rms, expected.rms, 6e-5);
}

TEST_P(Spheric10Roll, IsNearerToTheRecordThanTheRecordsOwnUncertainty) {
  const Formula& formula = *GetParam();
  if (!published_record(formula.record)) GTEST_SKIP() << formula.record << record_missing;
  const bool of_water = &formula == &water;
  expect_difference(formula, -1, join + 1e-9,
                    of_water ? Difference{76, 0.0079, 0.0043} : Difference{376, 0.0139, 0.0068});
  expect_difference(formula, join + 1e-9, 9,
                    of_water ? Difference{760, 0.0070, 0.0011} : Difference{812, 0.0145, 0.0037});
}

}  // namespace
}  // namespace slosh::spheric10_roll_test
