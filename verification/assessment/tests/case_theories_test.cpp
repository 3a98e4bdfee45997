#include "verification/assessment/references/case_theories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/validity_envelope.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::case_theories_test {
namespace {

CaseDefinition theory_case() {
  CaseDefinition definition = sample_case();
  definition.runs = {sample_run(LinearRun{.modes = 10, .valid_elevation_over_depth = 0.1}),
                     sample_run(PotentialRun{}), sample_run(SphRun{"recommended", 0.01, 0.01})};
  definition.runs[0].name = "linear";
  definition.runs[1].name = "potential";
  definition.runs[2].name = "particles";
  return definition;
}

CaseRuns theory_runs(double over_depth = 0.03) {
  CaseRuns runs;
  for (const char* run : {"linear", "potential", "particles"})
    runs.results[run].series = {{"elevation@right", "m", {0, 1, 2}, {0, 0.01, 0.02}}};
  runs.results["linear"].diagnostics["highest_elevation_over_depth"] = over_depth;
  runs.results["potential"].diagnostics["valid_until_s"] = 2;
  runs.results["potential"].series.push_back(
      {"elevation@right/coarser", "m", {0, 1, 2}, {0, 0.013, 0.02}});
  return runs;
}

TEST(CaseTheories, AreJoinedByTheirNamesWithTheHalfWidthsOfPotentialFlowFromItsCoarserRun) {
  const CaseTheories theories = case_theories(theory_case(), theory_runs());
  std::vector<std::string> names;
  for (const TimeSeries& series : theories.result.series) names.push_back(series.name);
  EXPECT_EQ(names, (std::vector<std::string>{"elevation@right/linear", "elevation@right/potential",
                                             "elevation@right/potential/half_width"}));
  EXPECT_EQ(theories.result.at("elevation@right/linear").value,
            (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_EQ(theories.result.at("elevation@right/linear").unit, "m");
  const TimeSeries& widths = theories.result.at("elevation@right/potential/half_width");
  EXPECT_EQ(widths.unit, "m");
  EXPECT_NEAR(widths.value[1], 0.003, 1e-12);
}

TEST(CaseTheories, TellTheirRangesWithTheNumbersOfTheCase) {
  const CaseTheories theories = case_theories(theory_case(), theory_runs());
  ASSERT_EQ(theories.remarks.size(), 2u);
  EXPECT_EQ(theories.remarks[0].range,
            "an elevation of at most 0.1 fill depths and below the roof, of which it predicts "
            "0.03; a steepness k A of at most 0.2, of which it predicts 0.033; a detuning |(omega "
            "/ omega_n)^2 - 1| of at least 0.074 from each natural mode n that the motion excites"
            "; a loss of the wave to viscosity of at most 0.5 %, here 0.0039 %; a first "
            "natural frequency that the gas lowers by at most 0.5 %, here 0.11 %");
  EXPECT_EQ(theories.remarks[1].range,
            "valid to 2 s; a loss of the wave to viscosity of at most 0.5 %, here 0.0039 %; "
            "a first natural frequency that the gas lowers by at most 0.5 %, here 0.11 %");
  for (const TheoryRemarks& remarks : theories.remarks) EXPECT_FALSE(remarks.outside);
  const auto& texts = theories.result.provenance;
  EXPECT_EQ(texts.at("linear_range"), theories.remarks[0].range);
  EXPECT_NE(texts.at("linear_uncertainty").find("k A / 2 = 0.016"), std::string::npos);
  EXPECT_FALSE(texts.contains("linear_outside_its_range"));
}

TEST(CaseTheories, TellWhyOneIsOutsideItsRangeAsIsAPredictionThatIsNoNumber) {
  CaseRuns runs = theory_runs(0.11);
  runs.results["potential"].diagnostics["valid_until_s"] = 1;
  runs.results["potential"].provenance["left_range_because"] = "its surface is too steep";
  const CaseTheories theories = case_theories(theory_case(), runs);
  EXPECT_EQ(theories.remarks[0].outside, "predicts an elevation of 0.11 fill depths, valid to 0.1");
  EXPECT_EQ(theories.remarks[1].range.find("valid to 1 s: its surface is too steep;"), 0u);
  EXPECT_TRUE(theories.remarks[1].outside);
  EXPECT_EQ(theories.result.provenance.at("linear_outside_its_range"), theories.remarks[0].outside);
  // A missing elevation is no elevation inside the range.
  EXPECT_TRUE(case_theories(theory_case(), theory_runs(std::numeric_limits<double>::quiet_NaN()))
                  .remarks[0]
                  .outside);
}

// Where linear theory judges a copy of itself, which it would pass with nothing to tell.
TEST(CaseTheories, AreOutsideTheirRangeUnderALowRoofInAThickLiquidUnderADenseGasAndForcedTooFast) {
  const CaseDefinition inside = theory_case();
  const auto reason = [](const CaseDefinition& definition, const char* run) {
    const CaseRuns runs = theory_runs();
    return outside_validity(definition, run_named(definition, run), runs.results.at(run))
        .value_or("");
  };
  EXPECT_EQ(reason(inside, "linear"), "");
  CaseDefinition low = inside;
  low.gas.density = 0.01;  // so low a layer of air would count
  low.tank.height = 1.02 * low.liquid.fill_depth;
  EXPECT_NE(reason(low, "linear").find(" m under a roof "), std::string::npos);
  low.tank.height = 1.04 * low.liquid.fill_depth;
  EXPECT_EQ(reason(low, "linear"), "") << "its crest is at 1.03 depths";
  CaseDefinition thick = inside;
  thick.liquid.kinematic_viscosity = 1e-3;
  thick.window_end = 2;  // exp(-2 nu k^2 t) = 0.961 in a tank of 1 m
  for (const char* run : {"linear", "potential"})
    EXPECT_NE(reason(thick, run)
                  .find("has no viscosity, by which the wave loses 3.9 % until "
                        "2 s"),
              std::string::npos)
        << reason(thick, run);
  CaseDefinition dense = inside;
  dense.gas.density = 0.02 * dense.liquid.density;
  for (const char* run : {"linear", "potential"})
    EXPECT_NE(reason(dense, run).find("has no gas, which lowers the first natural frequency by "),
              std::string::npos)
        << reason(dense, run);
  std::get<LinearRun>(dense.runs[0].solver).two_layer = true;
  EXPECT_EQ(reason(dense, "linear"), "");
  // At the first frequency of the two layers (Lamb, article 231), far below that of the liquid.
  dense.gas.density = 0.8 * dense.liquid.density;
  const double k = std::numbers::pi / dense.tank.length, depth = dense.liquid.fill_depth,
               heavy = dense.liquid.density / std::tanh(k * depth),
               light = dense.gas.density / std::tanh(k * (dense.tank.height - depth));
  const double resonance =
      std::sqrt(dense.gravity * k * (dense.liquid.density - dense.gas.density) / (heavy + light));
  dense.motion.surge = SineMotion{.amplitude = 0.01, .angular_frequency = resonance};
  EXPECT_NE(reason(dense, "linear").find("is forced at 1 times its natural mode 1"),
            std::string::npos)
      << reason(dense, "linear");
  CaseDefinition short_wave = inside;
  short_wave.motion.surge.reset();
  short_wave.initial_wave = InitialWaveDefinition{20, 0.03 * short_wave.liquid.fill_depth};
  EXPECT_NE(reason(short_wave, "linear").find("predicts a steepness k A of 0.6"), std::string::npos)
      << reason(short_wave, "linear") << ", 20 times 0.033";
  CaseDefinition fast = inside;
  fast.motion.surge = SineMotion{.amplitude = 1e-12, .angular_frequency = 6e6};
  EXPECT_NE(reason(fast, "linear").find("of its natural mode 256"), std::string::npos);
}

}  // namespace
}  // namespace slosh::case_theories_test
