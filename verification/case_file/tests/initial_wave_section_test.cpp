// [initial_wave] of a case file: what it may say, and every mistake.
#include <gtest/gtest.h>

#include "verification/case/quantities.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::initial_wave_section_test {
namespace {

const std::string third_mode = "[initial_wave]\nmode = 3\namplitude_m = -0.02\n";

// The section stands on lines 21 to 23, after the motion.
std::string with_wave(const std::string& section, std::string text = valid_text) {
  return text.insert(text.find("[time]"), section);
}

// In a still tank, where linear theory has no modes to sum.
std::string still_with_wave(const std::string& section) {
  std::string text = with_wave(section, edited({sine_surge, "[motion]\nstill = true\n"}));
  text = text.substr(0, text.find("[[gate]]"));
  text.replace(text.find("modes = 500\n"), std::string("modes = 500\n").size(), "");
  const std::string fitted = "natural_modes = 2";
  return text.replace(text.find(fitted), fitted.size(), "natural_modes = 1");
}

std::string first_error_line(const std::string& text) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text));
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
  const auto of_amplitude = [](const std::string& amplitude) {
    return first_error_line(
        with_wave("[initial_wave]\nmode = 1\namplitude_m = " + amplitude + "\n"));
  };
  for (const std::string amplitude : {"0.5", "-0.5", "0.7"})
    EXPECT_EQ(of_amplitude(amplitude),
              "trial.toml:23: initial_wave.amplitude_m = " + amplitude +
                  ": expected a number other than 0 of a magnitude below 0.5, in m: shallower than "
                  "the liquid (0.5) and below the roof (0.5 above it)");
  for (const std::string amplitude : {"0", "nan", "inf", "\"high\""})
    EXPECT_TRUE(of_amplitude(amplitude).starts_with("trial.toml:23: initial_wave.amplitude_m = "))
        << amplitude;
  EXPECT_EQ(of_amplitude("0.49"), "");
}

TEST(InitialWaveSection, RefusesAModeThatIsNoWholeNumberOfHalfWaves) {
  for (const std::string mode : {"0", "-1", "1.5"})
    EXPECT_EQ(
        first_error_line(with_wave("[initial_wave]\nmode = " + mode + "\namplitude_m = 0.02\n")),
        "trial.toml:22: initial_wave.mode = " + mode + ": expected an integer >= 1");
  EXPECT_TRUE(first_error_line(with_wave("[initial_wave]\namplitude_m = 0.02\n"))
                  .starts_with("trial.toml:21: initial_wave.mode is missing"));
}

TEST(InitialWaveSection, RefusesUnknownKeys) {
  EXPECT_TRUE(first_error_line(with_wave(third_mode + "phase = 1\n"))
                  .starts_with("trial.toml:24: initial_wave.phase = 1: expected "));
}

TEST(InitialWaveSection, RefusesADamAndObstaclesBesideIt) {
  const std::string obstacle =
      "[[obstacle]]\nname = \"baffle\"\nleft_m = 1.0\nright_m = 1.2\nbottom_m = 0.0\ntop_m = 0.2\n";
  EXPECT_EQ(first_error_line(with_wave(obstacle + third_mode)),
            "trial.toml:27: initial_wave = a wave over an [[obstacle]]: expected a tank without "
            "one, whose modes are cosines from wall to wall");
  const std::string dam = edited({"fill_depth_m = 0.5", "fill_depth_m = 0.5\ncolumn_width_m = 1"});
  EXPECT_EQ(first_error_line(with_wave(third_mode, dam)),
            "trial.toml:22: initial_wave = a wave on a dam about to break: expected liquid without "
            "column_width_m, which stands from wall to wall");
}

TEST(InitialWaveSection, RefusesModesThatAStillTankDoesNotHave) {
  std::string text = still_with_wave(third_mode);
  const std::string fitted = "natural_modes = 1", solver = "solver = \"linear\"\n";
  EXPECT_TRUE(first_error_line(
                  std::string(text).replace(text.find(fitted), fitted.size(), "natural_modes = 2"))
                  .ends_with(": comparison.natural_modes = 2: expected 0 or 1: a still tank has "
                             "only the mode of its initial wave"));
  EXPECT_TRUE(first_error_line(std::string(text).replace(text.find(solver), solver.size(),
                                                         solver + "modes = 500\n"))
                  .ends_with(": run.modes = 500: expected no such key for a still tank: its "
                             "initial wave is a single mode"));
}

TEST(InitialWaveSection, MayBeComparedWithAViscousWave) {
  std::string text = still_with_wave(third_mode);
  const std::string linear = "solver = \"linear\"";
  text.replace(text.find(linear), linear.size(), "solver = \"viscous_wave\"");
  const CaseDefinition definition = read_text(text);
  EXPECT_EQ(std::get<ViscousWaveRun>(definition.runs.at(0).solver).valid_elevation_over_depth, 0.1);
  text.insert(text.find("valid_elevation_over_depth"), "two_layer = true\n");
  EXPECT_NE(first_error_line(text).find("run.two_layer"), std::string::npos);
}

}  // namespace
}  // namespace slosh::initial_wave_section_test
