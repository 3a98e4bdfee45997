#include "verification/sensitivity/gate_claims.hpp"

#include <gtest/gtest.h>

#include "verification/tests/synthetic_series.hpp"

namespace slosh::gate_claims_test {
namespace {

constexpr double period = 2;  // [s]
const MutationFrame frame{{0, 20}, period, 0.35};
const TimeSeries series =
    sampled([](double t) { return 0.02 * std::sin(two_pi / period * t); }, 0, 20);

GateRow row_of(Metric metric, double limit, const std::string& mode = "forced") {
  GateRow row{};
  row.metric = metric;
  row.mode = mode;
  row.limit = limit;
  return row;
}

bool claims(const GateRow& row, double measured, MutationKind kind, double strength = 1) {
  return claims_to_detect(row, {measured, series}, {kind, strength}, frame);
}

TEST(GateClaims, OfAnAmplitudeAreWhatTakesItBeyondTheLimit) {
  const GateRow row = row_of(Metric::amplitude_error, 0.05);
  EXPECT_TRUE(claims(row, 0, MutationKind::louder, 0.051));
  EXPECT_FALSE(claims(row, 0, MutationKind::louder, 0.05));
  EXPECT_TRUE(claims(row, 0.03, MutationKind::louder, 0.02));
  EXPECT_FALSE(claims(row, 0.03, MutationKind::quieter, 0.05));  // 1.03 times 0.95
  EXPECT_TRUE(claims(row, -0.03, MutationKind::quieter, 0.05));
  EXPECT_TRUE(claims(row, 0, MutationKind::thousandfold));
  EXPECT_FALSE(claims(row, 0, MutationKind::late, 0.1));
  EXPECT_FALSE(claims(row, 0, MutationKind::sign_flipped));
}

TEST(GateClaims, OfALagAreShiftsAndTheSign) {
  const GateRow row = row_of(Metric::phase_lag, 10);  // degrees
  EXPECT_TRUE(claims(row, 0, MutationKind::late, 0.05));
  EXPECT_TRUE(claims(row, 0, MutationKind::early, 0.05));
  EXPECT_FALSE(claims(row, 0, MutationKind::late, 0.02));
  EXPECT_TRUE(claims(row, 5, MutationKind::late, 0.02));
  EXPECT_FALSE(claims(row, 5, MutationKind::early, 0.02));
  EXPECT_TRUE(claims(row, 5, MutationKind::sign_flipped));
  EXPECT_FALSE(claims(row_of(Metric::phase_lag, 180), 5, MutationKind::sign_flipped));
  EXPECT_FALSE(claims(row, 0, MutationKind::slipped));
  EXPECT_FALSE(claims(row, 0, MutationKind::louder, 0.2));
}

TEST(GateClaims, OfAFrequencyAreOfARefinedModeAlone) {
  EXPECT_TRUE(
      claims(row_of(Metric::frequency_error, 0.01, "natural_1"), 0, MutationKind::faster, 0.02));
  EXPECT_TRUE(
      claims(row_of(Metric::frequency_error, 0.01, "natural_1"), 0, MutationKind::slower, 0.02));
  EXPECT_FALSE(
      claims(row_of(Metric::frequency_error, 0.01, "natural_1"), 0, MutationKind::faster, 0.01));
  EXPECT_FALSE(claims(row_of(Metric::frequency_error, 0.01), 0, MutationKind::faster, 0.05));
}

TEST(GateClaims, OfAResidualAreWhatTheTriangleInequalityLeaves) {
  const GateRow rms = row_of(Metric::normalised_rms, 0.1, "whole");
  EXPECT_TRUE(claims(rms, 0.04, MutationKind::louder, 0.2));    // 0.2 * 0.96 - 0.04
  EXPECT_FALSE(claims(rms, 0.06, MutationKind::louder, 0.15));  // 0.15 * 0.94 - 0.06
  EXPECT_TRUE(claims(rms, 0.06, MutationKind::sign_flipped));
  EXPECT_TRUE(claims(rms, 0.06, MutationKind::noisy, 0.5));
  EXPECT_FALSE(claims(rms, 0.06, MutationKind::noisy, 0.1));
  EXPECT_FALSE(claims(rms, 2, MutationKind::sign_flipped));  // nothing is left of it
}

TEST(GateClaims, OfAMeanOffsetAreTheDatumAndADrift) {
  const GateRow row = row_of(Metric::mean_offset, 0.003, "whole");  // metres
  EXPECT_TRUE(claims(row, 0, MutationKind::raised, 0.01));
  EXPECT_TRUE(claims(row, 0, MutationKind::lowered, 0.01));
  EXPECT_FALSE(claims(row, 0, MutationKind::raised, 0.005));
  EXPECT_FALSE(claims(row, -0.002, MutationKind::raised, 0.01));
  EXPECT_TRUE(claims(row, -0.002, MutationKind::lowered, 0.01));
  EXPECT_TRUE(claims(row, 0, MutationKind::drifting, 0.5));  // 0.9 / 2 of half of 14.1 mm
  EXPECT_FALSE(claims(row, 0, MutationKind::drifting, 0.2));
  EXPECT_FALSE(claims(row_of(Metric::amplitude_error, 0.003), 0, MutationKind::raised, 0.1));
}

TEST(GateClaims, OfASeriesThatIsAddedAreWhatTheTriangleInequalityLeaves) {
  const GateRow rms = row_of(Metric::normalised_rms, 0.2, "whole");
  EXPECT_TRUE(claims(rms, 0.04, MutationKind::raised, 0.02));  // 7 mm of 14.1 mm
  EXPECT_FALSE(claims(rms, 0.04, MutationKind::raised, 0.005));
  EXPECT_TRUE(claims(rms, 0.04, MutationKind::drifting, 1));
  EXPECT_FALSE(claims(rms, 0.04, MutationKind::drifting, 0.1));
  EXPECT_TRUE(claims(rms, 0.04, MutationKind::chirped, 0.2));
  EXPECT_FALSE(claims(rms, 0.04, MutationKind::chirped, 0.02));
}

TEST(GateClaims, OfASlowChangeOfFrequencyAreAThirdOfItsTurn) {
  const GateRow row = row_of(Metric::phase_lag, 10);
  EXPECT_TRUE(claims(row, 0, MutationKind::chirped, 0.1));  // 0.9 of 12 degrees
  EXPECT_FALSE(claims(row, 0, MutationKind::chirped, 0.05));
  EXPECT_FALSE(claims(row, 5, MutationKind::chirped, 0.1));
}

TEST(GateClaims, OfAGainedModeAreOfItsOwnAmplitude) {
  const auto gained = [](const std::string& mode, double strength) {
    return claims_to_detect(row_of(Metric::amplitude_error, 0.08, "natural_1"), {0, series},
                            {MutationKind::mode_gained, strength, mode}, frame);
  };
  EXPECT_TRUE(gained("natural_1", 0.1));
  EXPECT_FALSE(gained("natural_1", 0.05));
  EXPECT_FALSE(gained("natural_2", 0.5));
}

TEST(GateClaims, HoldForBoundsOnBothSidesAndNotForComparedErrors) {
  GateRow row = row_of(Metric::largest_magnitude, 0, "whole");
  row.limit.reset();
  EXPECT_FALSE(claims(row, 0.5, MutationKind::thousandfold));
  row.between = {0.45, 0.6};
  EXPECT_TRUE(claims(row, 0.5, MutationKind::quieter, 0.2));
  EXPECT_TRUE(claims(row, 0.5, MutationKind::louder, 0.25));
  EXPECT_FALSE(claims(row, 0.5, MutationKind::louder, 0.1));
  EXPECT_FALSE(claims(row, 0.5, MutationKind::sign_flipped));
}

TEST(GateClaims, HoldEveryRowButThoseOfImpactsToASoundSeries) {
  for (const MutationKind kind : {MutationKind::not_a_number, MutationKind::truncated,
                                  MutationKind::swapped_columns, MutationKind::other_unit}) {
    for (const Metric metric :
         {Metric::amplitude_error, Metric::phase_lag, Metric::decay_rate, Metric::aligned_rms,
          Metric::largest_magnitude, Metric::initial_value})
      EXPECT_TRUE(claims(row_of(metric, 1e9), 0, kind));
    EXPECT_FALSE(claims(row_of(Metric::impact_arrival, 1e9), 0, kind));
    EXPECT_EQ(claims(row_of(Metric::noise_share, 1e9), 0, kind), kind != MutationKind::other_unit);
  }
}

TEST(GateClaims, OfTheStartFollowTheDatum) {
  const GateRow row = row_of(Metric::initial_value, 0.0035, "whole");
  EXPECT_TRUE(claims(row, 1e-5, MutationKind::raised, 0.02));
  EXPECT_TRUE(claims(row, 1e-5, MutationKind::lowered, 0.02));
  EXPECT_FALSE(claims(row, 1e-5, MutationKind::raised, 0.001));
  EXPECT_FALSE(claims(row, 1e-5, MutationKind::louder, 0.5));
  EXPECT_FALSE(claims(row, 1e-5, MutationKind::noisy, 0.5));
}

TEST(GateClaims, OfWaveStatisticsFollowTheScaleAndTheNoise) {
  const GateRow row = row_of(Metric::rms_error, 0.05, "whole");
  EXPECT_TRUE(claims(row, 0, MutationKind::louder, 0.06));
  EXPECT_FALSE(claims(row, 0.01, MutationKind::louder, 0.03));
  const GateRow noise = row_of(Metric::noise_share, 0.05, "whole");
  EXPECT_TRUE(claims(noise, 0.001, MutationKind::noisy, 0.1));
  EXPECT_FALSE(claims(noise, 0.001, MutationKind::noisy, 0.05));
  EXPECT_FALSE(claims(noise, 0.001, MutationKind::louder, 0.5));
  EXPECT_TRUE(
      claims(row_of(Metric::spectral_peak_error, 0.01, "whole"), 0, MutationKind::faster, 0.02));
}

}  // namespace
}  // namespace slosh::gate_claims_test
