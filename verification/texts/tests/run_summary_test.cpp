#include "verification/texts/run_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/tests/messages.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::run_summary_test {
namespace {

RunResult swaying(double duration) {
  RunResult result;
  result.solver = "sph";
  result.cost = {.wall_time = 2,
                 .user_time = 1.25,
                 .system_time = 0.25,
                 .peak_memory = 50.0 * 1024 * 1024,
                 .steps = 1000,
                 .elements = 140};
  TimeSeries series{"elevation@right", "m", {}, {}};
  for (int i = 0; i * 0.02 < duration; ++i) {
    series.time.push_back(i * 0.02);
    series.value.push_back(0.03 * (1 - 1e-3 * series.time.back()) *
                           std::sin(2 * std::numbers::pi * series.time.back() / 1.6));
  }
  result.series = {series};
  return result;
}

const RunDefinition particles = sample_run(
    SphRun{.scheme = "recommended", .particle_spacing = 0.05, .surface_particle_spacing = 0.05});

TEST(RunSummary, TellsThePeaksAndThePeriodOfEachGauge) {
  const std::string text = run_summary(swaying(16), sample_case(), particles);
  EXPECT_TRUE(holds(text,
                    "elevation@right: highest 0.03 m at 0.4 s, lowest -0.03 m at 1.2 s, "
                    "period 1.6 s (spectral peak)\n"))
      << text;
}

TEST(RunSummary, TellsNoPeriodOfASeriesThatIsTooShort) {
  const std::string text = run_summary(swaying(0.05), sample_case(), particles);
  EXPECT_TRUE(holds(text, "lowest 0 m at 0 s\n")) << text;
}

TEST(RunSummary, TellsWhatTheRunTook) {
  const std::string text = run_summary(swaying(16), sample_case(), particles);
  EXPECT_TRUE(holds(text, "cost: 1.5 core-seconds in 2 s of wall time, 50 MiB; 140 particles\n"))
      << text;
}

TEST(RunSummary, TellsHowMuchTheSamplesShortenTheStep) {
  RunResult result = swaying(16);
  CaseDefinition definition = sample_case();
  const SphStep step = sph_step(definition, particles).value();
  result.cost.steps = definition.duration / step.between_samples;
  EXPECT_TRUE(holds(run_summary(result, definition, particles),
                    "each: landing on the samples every 20 ms shortens the stable "));
  EXPECT_FALSE(holds(run_summary(result, definition, particles), "accelerations"));
  result.cost.steps *= 1.25;
  EXPECT_TRUE(holds(run_summary(result, definition, particles),
                    "; the flow's accelerations to a mean of "));
  EXPECT_EQ(step_text({0.001, 0.0008}, 0.004),
            "0.8 ms each: landing on the samples every 4 ms shortens the stable 1 ms by 20 %");
  EXPECT_EQ(step_text({0.0005, 0.0005}, 0.01),
            "0.5 ms each: landing on the samples every 10 ms costs nothing");
}

TEST(RunSummary, TellsTheSpeedThatACoarseRunMeasuredAndTheStepThatFollowsFromIt) {
  RunResult result = swaying(16);
  result.cost.steps = 1000;
  EXPECT_FALSE(holds(run_summary(result, sample_case(), particles), "coarse run"));
  result.diagnostics = {
      {"speed_of_sound_m_s", 40}, {"expected_speed_m_s", 4}, {"coarse_run_spacing_m", 0.03}};
  EXPECT_TRUE(holds(run_summary(result, sample_case(), particles),
                    "speed of sound: 40 m/s, 10 times the 4 m/s that a coarse run at 30 mm "
                    "measured\n"));
  const SphStep step = sph_step(sample_case(), particles, 4).value();
  EXPECT_NEAR(step.stable / sph_step(sample_case(), particles, 8)->stable, 2, 0.2);
  EXPECT_TRUE(holds(run_summary(result, sample_case(), particles),
                    step_text(step, sample_case().sample_interval)));
}

TEST(RunSummary, TellsNoStepsOfAnotherSolver) {
  RunResult result = swaying(16);
  result.solver = "linear";
  result.cost.elements = 0;
  const std::string text = run_summary(result, sample_case(), sample_run(LinearRun{}));
  EXPECT_FALSE(holds(text, "steps"));
  EXPECT_FALSE(holds(text, "particles"));
}

}  // namespace
}  // namespace slosh::run_summary_test
