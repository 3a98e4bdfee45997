// Runs that have recorded of themselves that they are not sound, on the small surge of
// surge_results.hpp.
#include "verification/evidence/soundness.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::soundness_test {
namespace {

class Soundness : public ::testing::Test {
 protected:
  Soundness() { definition.gate.resize(1); }

  std::string doubt_of(const std::string& run) const {
    return soundness_doubt(definition, runs, run);
  }
  GateOutcome judged() const { return assess(definition, runs).gate.at(0); }
  std::map<std::string, double>& facts_of(const std::string& run) {
    return runs.results.at(run).diagnostics;
  }

  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
};

TEST_F(Soundness, IsDoubtedBeyondEachLimitAndOfNaN) {
  const std::pair<const char*, double> limits[] = {{"largest_mach_number", 0.2},
                                                   {"largest_density_error", 0.05},
                                                   {"largest_packing_drift", 0.01},
                                                   {"largest_tension_share", 0.5}};
  for (const auto& [fact, limit] : limits) {
    facts_of("particles") = {{fact, limit}};
    EXPECT_EQ(doubt_of("particles"), "") << fact;
    for (const double beyond : {1.01 * limit, not_a_number}) {
      facts_of("particles") = {{fact, beyond}};
      EXPECT_NE(doubt_of("particles"), "") << fact;
    }
  }
  facts_of("particles") = {{"largest_mach_number", 0.42}, {"largest_density_error", 0.21}};
  EXPECT_EQ(doubt_of("particles"),
            "particles is not sound: its largest Mach number is 0.42, limit 0.2, its largest "
            "density error is 21 %, limit 5 %");
  facts_of("fine_mesh") = {{"max_courant_number", 1.2}};
  EXPECT_NE(doubt_of("fine_mesh").find("largest Courant number is 1.2, limit 1"),
            std::string::npos);
  EXPECT_EQ(doubt_of("theory"), "");
}

TEST_F(Soundness, OfALiquidWithoutWeightHasNoLimitOfTension) {
  facts_of("particles") = {{"largest_tension_share", 0.9}};
  definition.gravity = 0;
  EXPECT_EQ(doubt_of("particles"), "");
}

// 0.35 m of water press with 3434 Pa.
TEST_F(Soundness, IsDoubtedWhereAWallPullsMoreThanTheColumnPresses) {
  definition.pressure_gauges.push_back({});
  definition.pressure_gauges[0].name = "P";
  RunResult& result = runs.results.at("particles");
  result.series.push_back({"wall_pressure@P", "Pa", {0, 1, 2}, {3000, -3400, 3000}});
  EXPECT_EQ(doubt_of("particles"), "");
  result.series.back().value[1] = -76000;
  EXPECT_NE(doubt_of("particles").find("wall_pressure@P falls to -7.6e+04 Pa, limit -3.43e+03 Pa"),
            std::string::npos)
      << doubt_of("particles");
}

TEST_F(Soundness, KeepsAValidationRowFromPassingAndIsToldBesideEveryRow) {
  EXPECT_EQ(judged().verdict, Verdict::pass);
  facts_of("particles") = {{"largest_mach_number", 0.42}};
  const GateOutcome outcome = judged();
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_NE(outcome.message.find("; doubtful: particles is not sound: its largest Mach number"),
            std::string::npos)
      << outcome.message;
  definition.gate[0].kind = RowKind::regression;
  EXPECT_EQ(judged().verdict, Verdict::pass);
  EXPECT_NE(judged().message.find("doubtful"), std::string::npos);
}

TEST_F(Soundness, IsNoMatterOfTheStart) {
  definition.gate = {surge_row("whole", Metric::initial_value, "m", 0.0035)};
  definition.gate[0].reference.clear();
  facts_of("particles") = {{"largest_mach_number", 0.42}};
  EXPECT_EQ(judged().verdict, Verdict::pass) << judged().message;
}

TEST_F(Soundness, OfTheReferenceCountsToo) {
  definition.gate[0].reference = "fine_mesh";
  definition.gate[0].kind = RowKind::regression;
  facts_of("fine_mesh") = {{"max_courant_number", 3}};
  EXPECT_NE(judged().message.find("doubtful: fine_mesh"), std::string::npos) << judged().message;
}

TEST_F(Soundness, OfACaseNamesTheFirstRunAndCountsTheOthers) {
  EXPECT_EQ(doubtful_runs(definition, runs), "");
  facts_of("coarse_mesh") = {{"max_courant_number", 3}};
  facts_of("particles") = {{"largest_mach_number", 0.42}};
  EXPECT_EQ(doubtful_runs(definition, runs),
            "doubtful: small_surge: particles is not sound: its largest Mach number is 0.42, limit "
            "0.2; so is 1 of its other runs");
}

}  // namespace
}  // namespace slosh::soundness_test
