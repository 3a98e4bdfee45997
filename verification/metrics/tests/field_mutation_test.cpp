#include "verification/metrics/field_mutation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/tests/field_results.hpp"

namespace slosh::field_mutation_test {
namespace {

const FieldMutationFrame frame{.datum = 1000, .length = 2};

std::vector<FieldSnapshot> fields() {
  std::vector<FieldSnapshot> moments;
  for (const double time : {1.0, 2.0, 3.0, 4.0})
    moments.push_back(
        tiled_field(time, {0.05, 0.05}, [time](double x, double z) { return 100 * time + x - z; }));
  return moments;
}

std::vector<FieldSnapshot> with(MutationKind kind, double strength) {
  return mutated(fields(), {kind, strength}, frame);
}

TEST(FieldMutation, ChangesThePressureByAFactorOrAnOffset) {
  const double own = fields()[1].pressure[7];
  EXPECT_DOUBLE_EQ(with(MutationKind::louder, 0.1)[1].pressure[7], 1.1 * own);
  EXPECT_DOUBLE_EQ(with(MutationKind::quieter, 0.1)[1].pressure[7], 0.9 * own);
  EXPECT_DOUBLE_EQ(with(MutationKind::thousandfold, 1)[1].pressure[7], 1000 * own);
  EXPECT_DOUBLE_EQ(with(MutationKind::sign_flipped, 1)[1].pressure[7], -own);
  EXPECT_DOUBLE_EQ(with(MutationKind::raised, 0.02)[1].pressure[7], own + 20);
  EXPECT_DOUBLE_EQ(with(MutationKind::lowered, 0.02)[1].pressure[7], own - 20);
}

TEST(FieldMutation, MovesALateFieldAlongTheTank) {
  const double own = fields()[2].x[7];
  EXPECT_DOUBLE_EQ(with(MutationKind::late, 0.05)[2].x[7], own + 0.1);
  EXPECT_DOUBLE_EQ(with(MutationKind::early, 0.05)[2].x[7], own - 0.1);
  EXPECT_EQ(with(MutationKind::late, 0.05)[2].pressure, fields()[2].pressure);
}

TEST(FieldMutation, AddsNoiseOfTheShareOfEachMomentsDeviation) {
  const auto noisy = with(MutationKind::noisy, 0.5);
  for (std::size_t n = 0; n < noisy.size(); ++n) {
    const double deviation = rms(without_mean(fields()[n].pressure));
    EXPECT_NEAR(rms(minus(noisy[n].pressure, fields()[n].pressure)) / deviation, 0.5, 0.1);
  }
  EXPECT_EQ(noisy[0].pressure, with(MutationKind::noisy, 0.5)[0].pressure);
}

TEST(FieldMutation, LosesTheLastMomentsWhereItIsCutShort) {
  EXPECT_EQ(with(MutationKind::truncated, 0.2).size(), 3u);
  EXPECT_EQ(with(MutationKind::truncated, 0.2).back().time, 3);
  EXPECT_EQ(moments_left(5, 0.2), 4u);
  EXPECT_EQ(moments_left(6, 0.2), 4u);
  EXPECT_EQ(moments_left(1, 0.2), 0u);
  EXPECT_EQ(moments_left(0, 0.2), 0u);
}

TEST(FieldMutation, PoisonsOnePlaceOfEachMoment) {
  for (const FieldSnapshot& field : with(MutationKind::not_a_number, 1)) {
    int poisoned = 0;
    for (const double pressure : field.pressure) poisoned += std::isnan(pressure);
    EXPECT_EQ(poisoned, 1);
  }
}

TEST(FieldMutation, HasNoKindThatNeedsATime) {
  for (const MutationKind kind : field_mutations) EXPECT_NO_THROW(with(kind, 0.1));
  for (const MutationKind kind :
       {MutationKind::faster, MutationKind::drifting, MutationKind::chirped,
        MutationKind::mode_gained, MutationKind::slipped, MutationKind::other_unit})
    EXPECT_THROW(with(kind, 0.1), std::logic_error) << mutation_name(kind);
}

}  // namespace
}  // namespace slosh::field_mutation_test
