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

#include "verification/input/tables/time_table.hpp"
#include "verification/tests/published_records.hpp"

namespace slosh::spheric10_roll_test {
namespace {

constexpr double join = 0.75;  // [s]

// cases/spheric10_roll.md: the mean, the harmonics (cosine and sine of n w (t - phase_time)), and
// the coefficients of the start.
struct Formula {
  const char *table, *record;
  double w, phase_time, mean;
  std::vector<std::pair<double, double>> harmonics;
  std::array<double, 8> start;
};

const Formula water{"spheric10_roll.csv",
                    "spheric_test10/roll_lateral_water_10ms.csv",
                    3.840445,
                    2.21764,
                    -0.04428,
                    {{3.96666, 0}, {-0.03998, 0.00671}},
                    {3.1167048, 16.0032658, 25.6032532, 23.6799964, -4.6100369, 480.0983056,
                     -1242.8435954, 803.7589826}};
const Formula oil{"spheric10_oil_roll.csv",
                  "spheric_test10/roll_lateral_oil.csv",
                  4.07820,
                  2,
                  -0.04848,
                  {{3.66016, 1.56183}, {-0.02452, -0.01973}, {-0.00106, -0.00120}},
                  {2.7799404, 16.7210289, 28.4844817, 25.9727667, -84.5771642, 788.8666181,
                   -1684.3888439, 1040.4926493}};

// The angle [deg].
double harmonics(const Formula& formula, double t) {
  double sum = formula.mean;
  for (std::size_t n = 0; n < formula.harmonics.size(); ++n) {
    const double p = static_cast<double>(n + 1) * formula.w * (t - formula.phase_time);
    const auto [c, s] = formula.harmonics[n];
    sum += c * std::cos(p) + s * std::sin(p);
  }
  return sum;
}

// x^3 G(1 - x), x = t / join.
double start(const Formula& formula, double t) {
  const double x = t / join;
  double g = 0;
  for (std::size_t i = formula.start.size(); i-- > 0;) g = g * (1 - x) + formula.start[i];
  return x * x * x * g;
}

double roll(const Formula& formula, double t) {
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
  EXPECT_NEAR(start(formula, join), harmonics(formula, join), 2e-6);
  const TimeTable roll_table = table(formula);
  ASSERT_EQ(roll_table.time.size(), 375U + 1126U);
  for (std::size_t i = 0; i < roll_table.time.size(); ++i) {
    const double n = static_cast<double>(i);
    const double t = i < 375 ? 0.002 * n : join + 0.01 * (n - 375);
    ASSERT_NEAR(roll_table.time[i], t, 1e-12);
    ASSERT_NEAR(roll_table.value[i], roll(formula, t), 6e-10) << t;  // nine decimals
  }
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
    const double error = record.angle[i] - roll(formula, record.time[i]);
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
