#include "verification/cli/texts/result_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/tests/impact_results.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::result_text_test {
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

TEST(RunSummary, TellsThePeaksAndThePeriodOfEachGaugeAndWhatTheRunTook) {
  const std::string text = run_summary(swaying(16), sample_case(), particles);
  for (const char* line :
       {"elevation@right: highest 0.03 m at 0.4 s, lowest -0.03 m at 1.2 s, period 1.6 s (spectral "
        "peak)\n",
        "cost: 1.5 core-seconds in 2 s of wall time, 50 MiB; 140 particles\n"})
    EXPECT_TRUE(holds(text, line)) << text;
  EXPECT_TRUE(holds(run_summary(swaying(0.05), sample_case(), particles), "lowest 0 m at 0 s\n"))
      << "too short a series has no period";
  RunResult linear = swaying(16);
  linear.solver = "linear";
  linear.cost.elements = 0;
  const std::string theory = run_summary(linear, sample_case(), sample_run(LinearRun{}));
  EXPECT_FALSE(holds(theory, "steps"));
  EXPECT_FALSE(holds(theory, "particles"));
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

RunResult with_series(const std::vector<TimeSeries>& series) {
  RunResult result{};
  result.series = series;
  return result;
}

TEST(SeriesCsv, HasAColumnOfEachSeriesWithItsUnitAndAnEmptyCellWhereItHasNoValue) {
  EXPECT_EQ(series_csv(with_series({{"elevation@right", "m", {0, 0.1}, {0, 1.0 / 3}},
                                    {"force_x", "N/m", {0, 0.1}, {-1e-7, 2}}})),
            "time [s],elevation@right [m],force_x [N/m]\n"
            "0,0,-1e-07\n"
            "0.1,0.3333333333333333,2\n");
  EXPECT_EQ(
      series_csv(with_series({{"a", "m", {0, 2}, {1, 2}}, {"b", "Pa", {1, 2, 3}, {3, 4, 5}}})),
      "time [s],a [m],b [Pa]\n0,1,\n1,,3\n2,2,4\n3,,5\n");
  EXPECT_THROW(series_csv(with_series({{"a", "m", {0, 2, 2}, {1, 2, 3}}})), ResultError)
      << "times that do not increase";
}

TEST(TheoryCsv, TellsTheRangeAndTheUncertaintyInCommentsAboveTheTableAndWhyItIsOutside) {
  CaseDefinition definition{};
  definition.name = "surge";
  definition.title = "A surge";
  definition.source = "made for a test,\nin two lines";
  CaseTheories theories{};
  theories.result.series = {{"elevation@right/linear", "m", {0, 1}, {0, 0.01}}};
  theories.remarks = {{"linear", "linear flow", "small waves", "none"}};
  EXPECT_EQ(theory_csv(definition, theories),
            "# Case surge: A surge\n"
            "# Source: made for a test,\n"
            "# in two lines\n"
            "# linear: linear flow\n"
            "# linear, range: small waves\n"
            "# linear, uncertainty: none\n"
            "time [s],elevation@right/linear [m]\n"
            "0,0\n"
            "1,0.01\n");
  theories.remarks[0].outside = "predicts too high a wave";
  EXPECT_TRUE(holds(theory_csv(definition, theories),
                    "# linear is outside its range: it predicts too high a wave\n"));
}

CaseDefinition published_case() {
  CaseDefinition definition = impact_case();
  definition.impacts->arrivals = ArrivalsDefinition{0.5, definition.impacts->times};
  definition.impacts->impulses = ImpulsesDefinition{0.05, {50, 51, 52, 53}};
  definition.impacts->rise_times = RiseTimesDefinition{{0.003, 0.004, 0.005, 0.006}};
  return definition;
}

TEST(ImpactText, HasALineOfEachFileAndOneOfWhatIsPublished) {
  const std::string lines =
      impact_lines(published_case(), pressure_of({.late = 0.012}), pressure_of({.impacts = 1}));
  EXPECT_TRUE(holds(lines, "impact_1 of the candidate: peak 3710 Pa at 2.3870 s, rise time 0.00"));
  EXPECT_TRUE(holds(lines, "impact_1 of the reference: peak 3710 Pa at 2.3750 s, rise time"));
  EXPECT_TRUE(holds(lines, "impact_2 of the reference: no impact\n"));
  EXPECT_TRUE(holds(lines,
                    "impact_4 as published: peak 4643 Pa at 7.3030 s, rise time 0.006 s, "
                    "arrival 7.3030 s, impulse 53 Pa s\n"));
  const std::string cut =
      impact_lines(published_case(), pressure_of({.until = 2}), pressure_of({}));
  EXPECT_TRUE(begins(cut, "impacts of the candidate: wall_pressure@B")) << "why it has none";
  EXPECT_FALSE(holds(cut, "impact_1 of the candidate"));
  EXPECT_TRUE(holds(cut, "impact_1 of the reference"));
  CaseDefinition without = published_case();
  EXPECT_TRUE(has_impacts(without, impact_pressure));
  EXPECT_FALSE(has_impacts(without, "elevation@left"));
  without.impacts.reset();
  EXPECT_FALSE(has_impacts(without, impact_pressure));
}

TEST(ImpactText, ListsThePlateauWhereOneIsPublished) {
  CaseDefinition definition = published_case();
  definition.impacts->plateau_begin = 2.45;
  definition.impacts->plateau_end = 2.65;
  definition.impacts->plateau = 670;
  TimeSeries flat = pressure_of({});
  for (double& value : flat.value) value = 737;
  const std::string lines = impact_lines(definition, flat, pressure_of({.until = 2.5}));
  EXPECT_TRUE(holds(lines, "plateau of the candidate: 737 Pa, +10 %\n"));
  EXPECT_TRUE(holds(lines, "plateau of the reference: wall_pressure@B"));
  EXPECT_TRUE(holds(lines, "plateau as published: 670 Pa\n"));
  definition.impacts->plateau = 0;
  EXPECT_FALSE(holds(impact_lines(definition, flat, flat), "plateau"));
}

TEST(ConvergenceText, TellsBesideItsFiguresThatARunIsNotSound) {
  CaseRuns runs = surge_runs();
  const auto told = [&](const std::string& words) {
    const ConvergenceStudy study{
        assess(surge_case(), runs), {"particles", "theory", surge_quantity}, {}};
    EXPECT_EQ(text_of(study).find("doubtful: ") != std::string::npos, !words.empty());
    return text_of(study).find(words) != std::string::npos &&
           json_of(study).find("\"doubtful\": \"" + words) != std::string::npos;
  };
  EXPECT_TRUE(told(""));
  runs.results.at("particles").series.push_back({"mach_number", "1", {0, 10, 20}, {0.5, 0.5, 0.5}});
  EXPECT_TRUE(told("particles is not sound: its Mach number but for 5 % of the time is 0.5"));
}

}  // namespace
}  // namespace slosh::result_text_test
