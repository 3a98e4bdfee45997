#include <gtest/gtest.h>

#include "verification/cli/texts/result_text.hpp"
#include "verification/tests/impact_results.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::comparison_text_test {
namespace {

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
}

TEST(ImpactText, SaysWhyASeriesHasNone) {
  const std::string lines =
      impact_lines(published_case(), pressure_of({.until = 2}), pressure_of({}));
  EXPECT_TRUE(begins(lines, "impacts of the candidate: wall_pressure@B"));
  EXPECT_FALSE(holds(lines, "impact_1 of the candidate"));
  EXPECT_TRUE(holds(lines, "impact_1 of the reference"));
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

TEST(ImpactText, IsOfThePressureAtTheCasesImpacts) {
  EXPECT_TRUE(has_impacts(published_case(), impact_pressure));
  EXPECT_FALSE(has_impacts(published_case(), "elevation@left"));
  CaseDefinition without = published_case();
  without.impacts.reset();
  EXPECT_FALSE(has_impacts(without, impact_pressure));
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
}  // namespace slosh::comparison_text_test
