// The difference of two pressure fields, on fields whose difference is known.
#include "verification/metrics/field_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/series/time_series.hpp"
#include "verification/tests/field_results.hpp"

namespace slosh::field_difference_test {
namespace {

constexpr double small_tension = 100;  // [Pa]
constexpr double gradient = 9810;      // [Pa/m]

double at_rest(double, double z) { return gradient * (0.35 - z); }
double sloped(double x, double) { return gradient * x; }
PressureAt uniform(double pressure) {
  return [pressure](double, double) { return pressure; };
}

const Tiles cells{.width = 0.02, .height = 0.01};
const Tiles particles{.width = 0.005, .height = 0.005};

FieldSnapshot mesh(const PressureAt& pressure) { return tiled_field(2, cells, pressure); }

FieldDifference difference(const FieldSnapshot& candidate, const FieldSnapshot& reference) {
  return field_difference(candidate, reference, small_tension);
}

TEST(FieldDifference, IsZeroBetweenAFieldAndItselfAndParticlesOfItThatTileTheCells) {
  for (const Tiles& tiles : {cells, particles}) {
    const FieldDifference found = difference(tiled_field(2, tiles, at_rest), mesh(at_rest));
    EXPECT_EQ(found.time, 2);
    EXPECT_EQ(found.compared_cells, 50u * 35u);
    EXPECT_NEAR(found.pressure_rms, 0, 1e-9);
    EXPECT_NEAR(found.pressure_offset, 0, 1e-9);
    EXPECT_EQ(found.uncovered_share, 0);
    EXPECT_EQ(found.excess_share, 0);
    EXPECT_EQ(found.tension_share, 0);
  }
}

TEST(FieldDifference, IsExactForAUniformPressureHoweverDisorderedTheParticles) {
  for (const double disorder : {0.0, 0.2, 0.4}) {
    const Tiles disordered{.width = 0.006, .height = 0.006, .disorder = disorder};
    const FieldDifference found =
        difference(tiled_field(2, disordered, uniform(500)), mesh(uniform(350)));
    EXPECT_NEAR(found.pressure_rms, 150, 1e-9) << disorder;
    EXPECT_NEAR(found.pressure_offset, 150, 1e-9) << disorder;
    EXPECT_NEAR(found.candidate_rms, 500, 1e-9) << disorder;
  }
}

TEST(FieldDifference, ConvergesForALinearPressureWithTheSizeOfThePlaces) {
  double coarser = std::numeric_limits<double>::infinity();
  for (const double spacing : {0.007, 0.0035, 0.00175}) {
    const Tiles disordered{.width = spacing, .height = spacing, .disorder = 0.2};
    const double rms = difference(tiled_field(2, disordered, at_rest), mesh(at_rest)).pressure_rms;
    EXPECT_LT(rms, 0.1 * gradient * spacing) << spacing;
    EXPECT_LT(rms, 0.6 * coarser) << spacing;
    coarser = rms;
  }
}

TEST(FieldDifference, TakesTheMeanOfFinerCellsAndInterpolatesBetweenCoarserOnes) {
  const Tiles finer{.width = 0.005, .height = 0.0025};
  EXPECT_NEAR(difference(tiled_field(2, finer, at_rest), mesh(at_rest)).pressure_rms, 0, 1e-9);
  const Tiles coarser{.width = 0.04, .height = 0.02, .depth = 0.36};
  const FieldDifference found = difference(tiled_field(2, coarser, sloped), mesh(sloped));
  // At the two walls nothing lies beyond the last middles, 0.01 m from those of the cells.
  EXPECT_NEAR(found.pressure_rms, gradient * 0.01 * std::sqrt(2.0 / 50), 1e-6);
  EXPECT_EQ(found.uncovered_share, 0);
}

TEST(FieldDifference, GrowsAsThePressureIsScaledAndShifted) {
  const FieldSnapshot reference = mesh(at_rest);
  const double own = difference(reference, reference).candidate_rms;
  EXPECT_NEAR(own, gradient * 0.35 / std::sqrt(3), 0.001 * gradient * 0.35);
  for (const double factor : {0.0, 0.9, 1.1, -1.0}) {
    const auto scaled = [&](double x, double z) { return factor * at_rest(x, z); };
    EXPECT_NEAR(difference(mesh(scaled), reference).pressure_rms, std::abs(factor - 1) * own, 1e-6);
  }
  for (const double offset : {-200.0, 50.0}) {
    const auto raised = [&](double x, double z) { return at_rest(x, z) + offset; };
    const FieldDifference found = difference(mesh(raised), reference);
    EXPECT_NEAR(found.pressure_rms, std::abs(offset), 1e-6);
    EXPECT_NEAR(found.pressure_offset, offset, 1e-6);
  }
}

TEST(FieldDifference, SeesAFieldThatStandsElsewhere) {
  FieldSnapshot moved = mesh(sloped);
  for (double& x : moved.x) x += 0.1;
  const FieldDifference found = difference(moved, mesh(sloped));
  EXPECT_NEAR(found.pressure_rms, gradient * 0.1, 1e-6);
  EXPECT_NEAR(found.pressure_offset, -gradient * 0.1, 1e-6);
  EXPECT_NEAR(found.uncovered_share, 0.1, 1e-12);
  EXPECT_NEAR(found.excess_share, 0.1, 1e-12);
}

TEST(FieldDifference, CountsTheLiquidThatOnlyOneSideHas) {
  Tiles shallow = particles, deep = particles;
  shallow.depth = 0.28;
  deep.depth = 0.42;
  const FieldDifference less = difference(tiled_field(2, shallow, at_rest), mesh(at_rest)),
                        more = difference(tiled_field(2, deep, at_rest), mesh(at_rest));
  EXPECT_NEAR(less.uncovered_share, 0.2, 1e-12);
  EXPECT_EQ(less.excess_share, 0);
  EXPECT_EQ(more.uncovered_share, 0);
  EXPECT_NEAR(more.excess_share, 0.2, 1e-12);
  EXPECT_NEAR(less.pressure_rms, 0, 1e-9);  // what is not covered is not compared
}

TEST(FieldDifference, TellsTheShareUnderTensionAndTheLowestPressure) {
  const auto with_hole = [](double x, double z) {
    return x > 0.5 && x < 0.8 ? -400.0 : at_rest(x, z);
  };
  const FieldDifference found = difference(tiled_field(2, particles, with_hole), mesh(at_rest));
  EXPECT_NEAR(found.tension_share, 0.3, 1e-12);
  EXPECT_NEAR(found.lowest_pressure, -400, 1e-9);
  EXPECT_EQ(found.reference_tension_share, 0);
  EXPECT_NEAR(found.reference_lowest_pressure, gradient * 0.005, 1e-6);
  const auto slightly_below = [](double, double) { return -99.0; };
  EXPECT_EQ(difference(mesh(slightly_below), mesh(at_rest)).tension_share, 0);
}

TEST(FieldDifference, IsRefusedWhereANumberIsNotFinite) {
  for (const double broken : {not_a_number, std::numeric_limits<double>::infinity()})
    for (std::vector<double> FieldSnapshot::*values :
         {&FieldSnapshot::x, &FieldSnapshot::z, &FieldSnapshot::pressure}) {
      FieldSnapshot wrong = mesh(at_rest);
      (wrong.*values)[17] = broken;
      EXPECT_THROW(difference(wrong, mesh(at_rest)), ComparisonError);
      EXPECT_THROW(difference(mesh(at_rest), wrong), ComparisonError);
    }
}

TEST(FieldDifference, IsRefusedWhereAFieldIsEmptyCutShortOfAnotherUnitOrOfParticles) {
  const FieldSnapshot right = mesh(at_rest);
  FieldSnapshot empty = right, cut = right, in_millimetres = right, far = right, swapped = right;
  empty.x = empty.z = empty.pressure = {};
  cut.pressure.resize(cut.pressure.size() / 2);
  in_millimetres.width *= 1000;
  far.x[3] = 1e300;
  std::swap(swapped.x, swapped.z);
  for (const FieldSnapshot& wrong : {empty, cut, in_millimetres, far, swapped})
    EXPECT_THROW(difference(wrong, right), ComparisonError);
  const Tiles disordered{.width = 0.005, .height = 0.005, .disorder = 0.2};
  for (const FieldSnapshot& wrong : {empty, cut, tiled_field(2, disordered, at_rest)})
    EXPECT_THROW(difference(right, wrong), ComparisonError);
}

TEST(FieldDifference, IsRefusedWhereLessThanHalfOfTheReferenceIsCovered) {
  Tiles half = particles;
  half.length = 0.5;
  EXPECT_NEAR(difference(tiled_field(2, half, at_rest), mesh(at_rest)).uncovered_share, 0.5, 1e-12);
  half.length = 0.47;
  EXPECT_THROW(difference(tiled_field(2, half, at_rest), mesh(at_rest)), ComparisonError);
}

}  // namespace
}  // namespace slosh::field_difference_test
