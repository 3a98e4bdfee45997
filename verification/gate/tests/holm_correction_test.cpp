// Families of p-values: the correction by its definition.
#include "verification/gate/distributions/holm_correction.hpp"

#include <gtest/gtest.h>

namespace slosh::holm_correction_test {
namespace {

TEST(HolmCorrection, IsWhatItIsDefinedAs) {
  // Holm's step-down by hand: 4 x 0.01, 3 x 0.02, then 2 x 0.03 which is no smaller, then 0.2.
  const std::vector<Estimate> family{{0.2, 0.02}, {0.01, 0.001}, {0.03, 0.003}, {0.02, 0.002}};
  const double expected[] = {0.2, 0.04, 0.06, 0.06};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(holm_corrected(family, i).value, expected[i], 1e-15) << i;
  EXPECT_NEAR(holm_corrected(family, 1).half_width, 0.004, 1e-15);
  EXPECT_EQ(holm_corrected({{0.9, 0}, {0.8, 0}}, 0).value, 1);
  EXPECT_EQ(holm_corrected({{0.03, 0.004}}, 0).value, 0.03);
}

TEST(HolmCorrection, CountsAnImpactThatDoesNotOccurAsRejected) {
  EXPECT_EQ(holm_corrected({{not_a_number, 0}, {0.03, 0}}, 0).value, 0);
  EXPECT_NEAR(holm_corrected({{not_a_number, 0}, {0.03, 0}}, 1).value, 0.03, 1e-15);
}

GateRow row_of(const char* candidate, Metric metric, const char* mode, const char* quantity) {
  GateRow row{};
  row.candidate = candidate;
  row.metric = metric;
  row.mode = mode;
  row.quantity = quantity;
  return row;
}

TEST(HolmCorrection, HasTheRowsOfOneCandidateAndPressureAsAFamily) {
  const GateRow own = row_of("a", Metric::peak_ks_p_value, "impact_1", "p");
  const std::vector<GateRow> rows{own,
                                  row_of("a", Metric::peak_ad_p_value, "impact_1", "p"),
                                  row_of("a", Metric::peak_ks_p_value, "impact_2", "p"),
                                  row_of("a", Metric::peak_median_error, "impact_2", "p"),
                                  row_of("a", Metric::peak_ks_p_value, "impact_2", "p/filtered"),
                                  row_of("b", Metric::peak_ks_p_value, "impact_1", "p")};
  const std::vector<GateRow> rest = rest_of_family(own, rows);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].metric, Metric::peak_ad_p_value);
  EXPECT_EQ(rest[1].mode, "impact_2");
  EXPECT_TRUE(rest_of_family(own, {}).empty());
}

}  // namespace
}  // namespace slosh::holm_correction_test
