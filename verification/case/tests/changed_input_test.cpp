#include "verification/case/changed_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"

namespace slosh::changed_input_test {
namespace {

CaseDefinition of_two_sines() {
  CaseDefinition definition{};
  definition.motion.surge = SumOfSines{{SineMotion{0.03, 2, 0, 0.5}, SineMotion{0.01, 5, 1}}};
  return definition;
}

TEST(ChangedInput, RaisesTheAmplitudeOfASumAndKeepsTheSharesOfItsSines) {
  const CaseDefinition raised = with_input(of_two_sines(), Input::amplitude, 0.004);
  const std::vector<SineMotion> sines = sines_of(*raised.motion.surge);
  EXPECT_DOUBLE_EQ(sines.at(0).amplitude, 0.033);
  EXPECT_DOUBLE_EQ(sines.at(1).amplitude, 0.011);
  EXPECT_EQ(sines.at(0).phase, 0.5);
}

TEST(ChangedInput, RaisesEveryValueOfATableByTheShareOfItsLargest) {
  CaseDefinition definition{};
  definition.motion.surge = TableMotion{"a.csv", {0, 1, 2, 3}, {0, 0.1, -0.2, 0}};
  const CaseDefinition raised = with_input(definition, Input::amplitude, 0.02);
  EXPECT_DOUBLE_EQ(std::get<TableMotion>(*raised.motion.surge).value[1], 0.11);
  EXPECT_DOUBLE_EQ(std::get<TableMotion>(*raised.motion.surge).value[2], -0.22);
}

TEST(ChangedInput, StartsEverySineElsewhereInItsPeriod) {
  const CaseDefinition later = with_input(of_two_sines(), Input::start_phase, 90);
  const std::vector<SineMotion> sines = sines_of(*later.motion.surge);
  EXPECT_DOUBLE_EQ(sines.at(0).phase, 0.5 + std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(sines.at(1).phase, std::numbers::pi / 2);
  CaseDefinition rolling{};
  rolling.motion.roll = RollDefinition{SineMotion{0.07, 3.8}, 0.45, 0};
  const RollMotion roll = *roll_motion(with_input(rolling, Input::start_phase, 90));
  EXPECT_NEAR(roll.angle(0), 0.07, 1e-15);
  EXPECT_NEAR(roll.rate(0), 0, 1e-15);
  rolling.motion.roll->angle = TableMotion{};
  EXPECT_THROW(with_input(rolling, Input::start_phase, 1), std::logic_error);
}

TEST(ChangedInput, StretchesEverySineThatSharesThePeriod) {
  CaseDefinition definition{};
  definition.motion.surge = SumOfSines{{SineMotion{0.03, 2}, SineMotion{0.01, 2, 0, 1.5}}};
  const CaseDefinition slower = with_input(definition, Input::period, 0.1);
  const double stretched = 2 / (1 + 0.1 / 3.14159265358979);
  for (const SineMotion& sine : sines_of(*slower.motion.surge))
    EXPECT_NEAR(sine.angular_frequency, stretched, 1e-12);
}

// The inputs that the members of an ensemble draw.

const std::vector<InputUncertainty> declared{{Input::fill_depth, 0.002, "a paper"},
                                             {Input::density, 3, "a paper"}};

TEST(DrawnInputs, LieWithinTheDeclaredIntervalInNineteenOfTwentyDraws) {
  constexpr int draws = 20000;
  double inside = 0, sum = 0, squares = 0, together = 0;
  for (int seed = 0; seed < draws; ++seed) {
    const std::vector<InputChange> drawn = drawn_inputs(declared, seed);
    ASSERT_EQ(drawn.size(), 2u);
    const double depth = drawn[0].change / 0.002, density = drawn[1].change / 3;
    inside += std::abs(depth) <= 1 ? 1.0 / draws : 0;
    sum += depth / draws;
    squares += depth * depth / draws;
    together += depth * density / draws;
  }
  EXPECT_NEAR(inside, 0.95, 3.29 * std::sqrt(0.95 * 0.05 / draws));
  EXPECT_NEAR(sum, 0, 3.29 * 0.51 / std::sqrt(draws));
  EXPECT_NEAR(std::sqrt(squares), 1 / 1.96, 0.01);
  EXPECT_NEAR(together, 0, 3.29 * 0.26 / std::sqrt(draws)) << "two inputs are drawn independently";
}

TEST(DrawnInputs, DependOnTheSeedAndOnTheInputAlone) {
  const std::vector<InputChange> both = drawn_inputs(declared, 7);
  EXPECT_EQ(drawn_inputs(declared, 7), both);
  EXPECT_EQ(drawn_inputs({declared[1]}, 7), std::vector{both[1]});
  EXPECT_NE(drawn_inputs(declared, 8), both);
  // Rounded, so that the last digits of a logarithm do not matter.
  EXPECT_EQ(both[1].change / 3, std::round(both[1].change / 3 * 1e6) / 1e6);
}

template <class Solver>
RunDefinition named(const char* name, const Solver& solver) {
  RunDefinition run{};
  run.name = name;
  run.solver = solver;
  return run;
}

CaseDefinition with_ensembles() {
  CaseDefinition definition{};
  definition.liquid = {0.3, 1000, 1e-6};
  definition.inputs = declared;
  RunDefinition run = named("mesh", InterFoamRun{80, 30});
  run.varies_inputs = true;
  definition.runs = ensemble_of(run, 3, 3);
  definition.runs.push_back(named("alone", SphRun{"recommended", 0.01, 0.01}));
  draw_inputs(definition);
  return definition;
}

TEST(DrawnInputs, MakeEachMemberSolveACaseOfItsOwn) {
  const CaseDefinition definition = with_ensembles();
  EXPECT_TRUE(definition.runs[3].drawn_inputs.empty());
  EXPECT_EQ(definition_solved_by(definition.runs[3], definition).liquid.fill_depth, 0.3);
  for (int k = 0; k < 3; ++k) {
    const RunDefinition& member = definition.runs.at(static_cast<std::size_t>(k));
    EXPECT_EQ(member.drawn_inputs, drawn_inputs(declared, k)) << "the first is drawn too";
    const CaseDefinition solved = definition_solved_by(member, definition);
    EXPECT_DOUBLE_EQ(solved.liquid.fill_depth, 0.3 + member.drawn_inputs[0].change);
    EXPECT_DOUBLE_EQ(solved.liquid.density, 1000 + member.drawn_inputs[1].change);
    EXPECT_NE(solved.liquid.fill_depth, 0.3);
  }
}

TEST(DrawnInputs, AreToldWithTheirUnits) {
  RunDefinition run = named("a", InterFoamRun{80, 30});
  EXPECT_EQ(drawn_inputs_text(run, {}), "");
  run.drawn_inputs = {{Input::fill_depth, 0.00031}, {Input::density, -2}};
  EXPECT_EQ(drawn_inputs_text(run, {}), "fill_depth +0.00031 m, density -2 kg/m3");
}

TEST(DrawnInputs, AreNotThoseOfARunAtTheEndOfAnInputsInterval) {
  const CaseDefinition definition = with_ensembles();
  for (const RunDefinition& end : runs_at_ends(declared[0], definition.runs[0])) {
    EXPECT_TRUE(end.drawn_inputs.empty() && !end.varies_inputs);
    EXPECT_DOUBLE_EQ(definition_solved_by(end, definition).liquid.density, 1000);
  }
}

}  // namespace
}  // namespace slosh::changed_input_test
