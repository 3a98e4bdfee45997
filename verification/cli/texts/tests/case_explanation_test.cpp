#include "verification/cli/texts/case_explanation.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "verification/tests/sample_case.hpp"

namespace slosh::case_explanation_test {
namespace {

// Compares the texts regardless of their line breaks.
bool holds(const std::string& text, const std::string& part) {
  const std::regex spaces("\\s+");
  return std::regex_replace(text, spaces, " ").find(part) != std::string::npos;
}

CaseDefinition tank() {
  CaseDefinition definition = sample_case();
  definition.title = "A small surge";
  definition.source = "made for a test";
  definition.runs = {sample_run(
      SphRun{.scheme = "recommended", .particle_spacing = 0.01, .surface_particle_spacing = 0.01})};
  return definition;
}

GateRow row_of(Metric metric, const std::string& unit) {
  GateRow row{};
  row.candidate = "fine";
  row.reference = "theory";
  row.quantity = "elevation@right";
  row.mode = "whole";
  row.metric = metric;
  row.unit = unit;
  return row;
}

// The case with one run of which this is known.
std::string explained(const KnownRun& known, const CaseDefinition& definition = tank()) {
  return explanation(definition, {{"a_run", known}});
}

TEST(CaseExplanation, TellsWhatWasMeasuredApartFromWhatIsExpectedAndWhatARunIsFor) {
  KnownRun known;
  known.cost.processor_time = 1.4;
  EXPECT_TRUE(
      holds(explained(known), "spacing 10 mm: about 1.4 core-seconds, scaled from another run "));
  known.start = SphOutline{3500, {"a kernel", "a state"}};
  known.cost.measured = true;
  EXPECT_TRUE(holds(explained(known), "3500 particles: 1.4 core-seconds measured "));
  EXPECT_TRUE(holds(explained(known), " terms: a kernel; a state "));
  known.step = SphStep{.stable = 0.001, .between_samples = 0.0008};
  EXPECT_TRUE(holds(explained(known),
                    "steps: 0.8 ms each: landing on the samples every 20 ms shortens the stable 1 "
                    "ms by 20 %"));
  known.step = SphStep{.stable = 0.001, .between_samples = 0.001};
  EXPECT_FALSE(holds(explained(known), "steps:"));
  CaseDefinition definition = tank();
  known.start = SphOutline{3500, {"a kernel"}, 1.875};
  EXPECT_FALSE(holds(explained(known, definition), "coarse run"));
  std::get<SphRun>(definition.runs.front().solver).speed_from_coarse_run = true;
  const std::string text = explained(known, definition);
  EXPECT_TRUE(holds(text, "with expected_speed = coarse_run, spacing 10 mm")) << text;
  EXPECT_TRUE(holds(text,
                    "a coarse run of the same flow measures the expected largest speed first; cost "
                    "and steps are those of the estimate, 1.875 m/s"))
      << text;
  definition.runs.front().at_input = InputEnd{Input::fill_depth, -0.0005, "coarse"};
  EXPECT_TRUE(holds(explanation(definition, {}),
                    "repeats coarse with fill_depth less by 0.0005 m, for u_input"));
  EXPECT_TRUE(holds(explanation(definition, {}), "Gate rows none: the case is only shown"));
}

TEST(CaseExplanation, TellsTheShapeOfTheTankAndWhereItsSensorsSit) {
  CaseDefinition definition = tank();
  EXPECT_TRUE(holds(explanation(definition, {}), "tank 1 m long, 1 m high "));
  definition.pressure_gauges = {{"a", Wall::roof, 0.3}, {"b", Wall::left, 0.1}};
  EXPECT_TRUE(holds(explanation(definition, {}),
                    "wall_pressure@a on the roof 0.3 m from the left wall; wall_pressure@b on the "
                    "left wall 0.1 m above the bottom"));
  definition.tank.outline = {{0, 0}, {1, 0}, {0.5, 1}};
  definition.pressure_gauges = {
      {.name = "a", .wall = Wall::bottom, .position = 0, .at = Corner{0.75, 0.5}}};
  const std::string text = explanation(definition, {});
  EXPECT_TRUE(holds(text, "tank a polygon of 3 corners, 1 m long, 1 m high ")) << text;
  EXPECT_TRUE(holds(text, "on the outline 0.75 m from the left and 0.5 m above the bottom"))
      << text;
  EXPECT_TRUE(holds(text, "for the first modes of the section, linear theory")) << text;
  definition.tank.diameter = 1;
  EXPECT_TRUE(holds(explanation(definition, {}),
                    "tank a lying cylinder of 1 m diameter, as a polygon of 3 corners"));
}

TEST(CaseExplanation, TellsEveryKindOfBound) {
  GateRow row = row_of(Metric::mean_offset, "m");
  row.limit = 0.01;
  EXPECT_EQ(
      row_text(row),
      "fine: mean less the reference's of elevation@right against theory must not exceed 0.01 m "
      "either way.");
  row = row_of(Metric::impact_peak_error, "1");
  row.reference.clear();
  row.mode = "impact_2";
  row.between = {0.05, 0.95};
  EXPECT_EQ(row_text(row),
            "fine: error of the peak of an impact of elevation@right "
            "(impact_2) must lie between 5 % and 95 %.");
  row = row_of(Metric::normalised_rms, "1");
  row.improves_on = "coarse";
  EXPECT_EQ(row_text(row),
            "fine: normalised rms of the difference of elevation@right against theory must be "
            "nearer to zero than that of coarse.");
}

}  // namespace
}  // namespace slosh::case_explanation_test
