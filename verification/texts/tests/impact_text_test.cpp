// The impacts that `slosh compare` lists.
#include "verification/texts/impact_text.hpp"

#include <gtest/gtest.h>

#include "verification/tests/impact_results.hpp"

namespace slosh::impact_text_test {
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
  EXPECT_NE(lines.find("impact_1 of the candidate: peak 3710 Pa at 2.3870 s, rise time 0.00"),
            std::string::npos)
      << lines;
  EXPECT_NE(lines.find("impact_1 of the reference: peak 3710 Pa at 2.3750 s, rise time"),
            std::string::npos);
  EXPECT_NE(lines.find("impact_2 of the reference: no impact\n"), std::string::npos);
  EXPECT_NE(lines.find("impact_4 as published: peak 4643 Pa at 7.3030 s, rise time 0.006 s, "
                       "arrival 7.3030 s, impulse 53 Pa s\n"),
            std::string::npos);
}

TEST(ImpactText, SaysWhyASeriesHasNone) {
  const std::string lines =
      impact_lines(published_case(), pressure_of({.until = 2}), pressure_of({}));
  EXPECT_TRUE(lines.starts_with("impacts of the candidate: wall_pressure@B")) << lines;
  EXPECT_EQ(lines.find("impact_1 of the candidate"), std::string::npos);
  EXPECT_NE(lines.find("impact_1 of the reference"), std::string::npos);
}

TEST(ImpactText, ListsThePlateauWhereOneIsPublished) {
  CaseDefinition definition = published_case();
  definition.impacts->plateau_begin = 2.45;
  definition.impacts->plateau_end = 2.65;
  definition.impacts->plateau = 670;
  TimeSeries flat = pressure_of({});
  for (double& value : flat.value) value = 737;
  const std::string lines = impact_lines(definition, flat, pressure_of({.until = 2.5}));
  EXPECT_NE(lines.find("plateau of the candidate: 737 Pa, +10 %\n"), std::string::npos) << lines;
  EXPECT_NE(lines.find("plateau of the reference: wall_pressure@B"), std::string::npos) << lines;
  EXPECT_NE(lines.find("plateau as published: 670 Pa\n"), std::string::npos) << lines;
  definition.impacts->plateau = 0;
  EXPECT_EQ(impact_lines(definition, flat, flat).find("plateau"), std::string::npos);
}

TEST(ImpactText, IsOfThePressureAtTheCasesImpacts) {
  EXPECT_TRUE(has_impacts(published_case(), impact_pressure));
  EXPECT_FALSE(has_impacts(published_case(), "elevation@left"));
  CaseDefinition without = published_case();
  without.impacts.reset();
  EXPECT_FALSE(has_impacts(without, impact_pressure));
}

}  // namespace
}  // namespace slosh::impact_text_test
