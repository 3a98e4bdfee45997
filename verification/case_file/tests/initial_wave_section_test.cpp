// [initial_wave] of a case file: what it may say, and every mistake.
#include <gtest/gtest.h>

#include "verification/case/quantities.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::initial_wave_section_test {
namespace {

const std::string third_mode = "[initial_wave]\nmode = 3\namplitude_m = -0.02\n";

std::string with_wave(const std::string& section, std::string text = valid_text) {
  return text.insert(text.find("[time]"), section);
}

// In a still tank, where linear theory has no modes to sum.
std::string still_with_wave(const std::string& section) {
  const std::string text = with_wave(section, edited({sine_surge, "[motion]\nstill = true\n"}));
  return with_keys(text.substr(0, text.find("[[gate]]")),
                   "run(theory).modes is missing & comparison.natural_modes = 1");
}

TEST(InitialWaveSection, ReadsTheModeAndTheHeightAtTheLeftWall) {
  const CaseDefinition definition = read_text(still_with_wave(third_mode));
  ASSERT_TRUE(definition.initial_wave);
  EXPECT_EQ(definition.initial_wave->mode, 3);
  EXPECT_EQ(definition.initial_wave->amplitude, -0.02);
  EXPECT_FALSE(read_text(valid_text).initial_wave);
}

TEST(InitialWaveSection, GoesWithATankThatMovesToo) {
  const CaseDefinition definition = read_text(with_wave(third_mode));
  EXPECT_TRUE(definition.initial_wave);
  EXPECT_FALSE(definition.motion.still());
}

TEST(InitialWaveSection, IsTheOneNaturalModeOfATankThatStands) {
  EXPECT_EQ(natural_modes(read_text(still_with_wave(third_mode)), 1), std::vector<int>{3});
  EXPECT_EQ(natural_modes(read_text(still_with_wave(third_mode)), 0), std::vector<int>{});
}

TEST(InitialWaveSection, JoinsTheModesThatTheTanksMotionExcites) {
  const std::string even = "[initial_wave]\nmode = 2\namplitude_m = 0.02\n";
  EXPECT_EQ(natural_modes(read_text(valid_text), 3), (std::vector{1, 3, 5}));
  EXPECT_EQ(natural_modes(read_text(with_wave(third_mode)), 3), (std::vector{1, 3, 5}));
  EXPECT_EQ(natural_modes(read_text(with_wave(even)), 3), (std::vector{1, 2, 3}));
}

TEST(InitialWaveSection, RefusesAWaveThatTheTankCannotHold) {
  expect_refusals(with_wave(third_mode), R"(
initial_wave.amplitude_m = 0.49: accepted
initial_wave.amplitude_m = 0.5: expected a number other than 0 of a magnitude below 0.5, in m:
  shallower than the liquid (0.5) and below the roof (0.5 above it)
initial_wave.amplitude_m = -0.5: expected a number other than 0 of a magnitude below 0.5
initial_wave.amplitude_m = 0.7: expected a number other than 0 of a magnitude below 0.5
initial_wave.amplitude_m = 0: expected
initial_wave.amplitude_m = nan: expected
initial_wave.amplitude_m = inf: expected
initial_wave.amplitude_m = "high": expected
initial_wave.mode = 0: expected an integer >= 1
initial_wave.mode = -1: expected an integer >= 1
initial_wave.mode = 1.5: expected an integer >= 1
initial_wave.mode is missing: expected
initial_wave.phase = 1: expected
liquid.column_width_m = 1 -> initial_wave = a wave on a dam about to break: expected liquid without
  column_width_m, which stands from wall to wall
)");
  const std::string obstacle =
      "[[obstacle]]\nname = \"baffle\"\nleft_m = 1.0\nright_m = 1.2\nbottom_m = 0.0\ntop_m = 0.2\n";
  expect_refusals(with_wave(obstacle + third_mode), R"(
-> initial_wave = a wave over an [[obstacle]]: expected a tank without one, whose modes are cosines
  from wall to wall
)");
  expect_refusals(still_with_wave(third_mode), R"(
comparison.natural_modes = 2: expected 0 or 1: a still tank has only the mode of its initial wave
run(theory).modes = 500: expected no such key for a still tank: its initial wave is a single mode
)");
}

TEST(InitialWaveSection, MayBeComparedWithAViscousWave) {
  const std::string text =
      with_keys(still_with_wave(third_mode), "run(theory).solver = \"viscous_wave\"");
  const CaseDefinition definition = read_text(text);
  EXPECT_EQ(std::get<ViscousWaveRun>(definition.runs.at(0).solver).valid_elevation_over_depth, 0.1);
  expect_refusals(text, "run(theory).two_layer = true: expected");
}

}  // namespace
}  // namespace slosh::initial_wave_section_test
