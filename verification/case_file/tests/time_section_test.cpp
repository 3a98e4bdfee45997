// What a case file may leave out, and the three ways to give a frequency.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "verification/case/field_times.hpp"
#include "verification/case/motion.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::time_section_test {
namespace {

const std::string liquid = "density_kg_m3 = 1000.0\nkinematic_viscosity_m2_s = 1e-6\n";
const std::string gas = "[gas]\ndensity_kg_m3 = 1.2\nkinematic_viscosity_m2_s = 1.5e-5\n";
const std::string frequency = "angular_frequency_rad_s = 1.5\n";

std::string without(std::string text, const std::string& part) {
  return text.replace(text.find(part), part.size(), "");
}

double surge_frequency(const std::string& given) {
  return std::get<SineMotion>(*read_text(edited({frequency, given})).motion.surge)
      .angular_frequency;
}

TEST(CaseFile, IsOfWaterUnderAirOnTheEarthUnlessItSaysOtherwise) {
  const std::string bare = without(without(with_keys(valid_text,
                                                     "gravity_m_s2 is missing & tags is missing & "
                                                     "comparison.window_end_s is missing"),
                                           liquid),
                                   gas);
  const CaseDefinition definition = read_text(bare), written = read_text(valid_text);
  EXPECT_EQ(definition.gravity, written.gravity);
  EXPECT_EQ(definition.liquid.density, written.liquid.density);
  EXPECT_EQ(definition.liquid.kinematic_viscosity, written.liquid.kinematic_viscosity);
  EXPECT_EQ(definition.gas.density, written.gas.density);
  EXPECT_EQ(definition.gas.kinematic_viscosity, written.gas.kinematic_viscosity);
  EXPECT_EQ(definition.window_end, 20);
  EXPECT_TRUE(definition.tags.empty());
}

TEST(CaseFile, NamesBothPropertiesOfALiquidThatIsNotWaterAndTheGasAboveALighterOne) {
  expect_refusals(without(valid_text, gas),
                  R"(liquid.density_kg_m3 = 1.1 -> gas is missing: expected)");
}

TEST(CaseFile, GivesAFrequencyInAnyOfThreeWays) {
  EXPECT_EQ(surge_frequency("angular_frequency_rad_s = 1.5\n"), 1.5);
  EXPECT_DOUBLE_EQ(surge_frequency("period_s = 4\n"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(surge_frequency("frequency_Hz = 0.25\n"), std::numbers::pi / 2);
}

// [animation] of a case file: its times, and what is refused.

std::string animated(const std::string& begin, const std::string& end,
                     const std::string& interval) {
  return valid_text + "[animation]\nbegin_s = " + begin + "\nend_s = " + end +
         "\ninterval_s = " + interval + "\n";
}

TEST(AnimationSection, IsEvenlySpacedMomentsWithBothEnds) {
  const CaseDefinition definition = read_text(animated("18.7", "20", "0.05"));
  ASSERT_EQ(definition.animation_times.size(), 27u);
  EXPECT_NEAR(definition.animation_times.front(), 18.7, 1e-12);
  EXPECT_NEAR(definition.animation_times[1], 18.75, 1e-12);
  EXPECT_NEAR(definition.animation_times.back(), 20, 1e-12);
  EXPECT_TRUE(read_text(valid_text).animation_times.empty());
}

TEST(AnimationSection, Is3To60MultiplesOfTheSampleIntervalInsideTheCase) {
  EXPECT_EQ(read_text(animated("1", "2.18", "0.02")).animation_times.size(), 60u);
  expect_refusals(animated("18", "20", "0.1"), R"(
animation.begin_s = 18.705: expected a number > 0 and <= the duration (20), a multiple of
  sample_interval_s (0.01), in s
animation.interval_s = 0.02: expected a number that gives 3 to 60 times
animation.begin_s = 19.5 & animation.interval_s = 0.3: expected a number that gives 3 to 60 times
animation.end_s = 17 -> animation.interval_s = 0.1: expected a number that gives 3 to 60 times
)");
}

TEST(FieldTimes, AreSnapshotsAndMomentsEachOnce) {
  CaseDefinition definition{};
  definition.sample_interval = 0.01;
  definition.snapshot_times = {0.5, 0.95, 2};
  definition.animation_times = {0.9, 0.95 + 1e-12, 1};
  EXPECT_EQ(field_times(definition), (std::vector<double>{0.5, 0.9, 0.95, 1, 2}));
}

// The forcing frequency of a motion table: named, or found from its spectrum.

const std::string table_surge = "[motion.surge]\ntype = \"table\"\nfile = \"surge.csv\"\n";
const std::string from_spectrum = "natural_modes = 2\nforcing = \"from_spectrum\"\n";

std::string table_of(const std::function<double(double)>& displacement) {
  std::ostringstream csv;
  csv.precision(12);
  csv << "time_s,displacement_m\n";
  for (int i = 0; i <= 1000; ++i) csv << 0.02 * i << ',' << displacement(0.02 * i) << '\n';
  return csv.str();
}

std::string with_comparison(const std::string& keys) {
  const std::string text = edited({"natural_modes = 2\n", keys});
  return std::string(text).replace(text.find(sine_surge), sine_surge.size(), table_surge);
}

CaseDefinition read_with(const std::string& csv, const std::string& keys) {
  return read_trial({with_comparison(keys), {{"surge.csv", csv}}});
}

std::string complaint_with(const std::string& csv, const std::string& keys) {
  const Workspace workspace;
  workspace.write("surge.csv", csv);
  return complaint(workspace.write("trial.toml", with_comparison(keys)));
}

double sine(double t) { return 0.02 * std::sin(2.9 * t + 1); }

TEST(ForcingSection, FindsTheFrequencyOfATableFromItsSpectrum) {
  const CaseDefinition definition = read_with(table_of(sine), from_spectrum);
  EXPECT_NEAR(forcing_frequency(definition), 2.9, 1e-6);
  ASSERT_TRUE(definition.found_forcing);
  EXPECT_LT(definition.found_forcing->half_width, 1e-4);
  EXPECT_LT(definition.found_forcing->rest, 1e-4);
  EXPECT_EQ(definition.gate.at(0).mode, "forced");
}

TEST(ForcingSection, NamesWhatToWriteForATableOfTwoSines) {
  const auto two = [](double t) { return sine(t) + 0.015 * std::sin(5 * t); };
  const std::string message = complaint_with(table_of(two), from_spectrum);
  EXPECT_TRUE(begins(message,
                     "trial.toml:34: comparison.forcing = \"from_spectrum\": expected "
                     "a motion table that is nearly one sine from 1 to 20 s, the "
                     "window of the comparison; surge.csv: the rest beside the sine "
                     "of 0.461"));
  EXPECT_TRUE(holds(message, "the next peak is at 0.79"));
  EXPECT_TRUE(holds(message, "Write forcing_frequency_Hz or forcing_period_s instead"));
  EXPECT_NEAR(forcing_frequency(read_with(table_of(two),
                                          "natural_modes = 2\nforcing_angular_frequency_rad_s = "
                                          "5\n")),
              5, 0);
}

TEST(ForcingSection, RefusesASpectrumThatIsNotATablesOrIsNamedBesideOrIsNeeded) {
  expect_refusals({with_comparison(from_spectrum), {{"surge.csv", table_of(sine)}}}, R"(
comparison.forcing_period_s = 2: expected no such key beside forcing
comparison.forcing = "spectrum": expected how the frequency of a motion table is known, which is
  from_spectrum
comparison.forcing is missing -> gate.mode = "forced": expected ... the table has a forced mode where
  [comparison] gives forcing_frequency_Hz, or forcing = "from_spectrum"
)");
}

// A period can be uncertain only where the motion has one.
TEST(ForcingSection, HasAnUncertainPeriodOnlyOfATableWhosePeriodIsKnown) {
  const std::string input =
      "[[input]]\nname = \"period\"\nunit = \"s\"\nhalf_width = 0.01\nsource = \"none\"\n";
  std::string text = with_comparison(from_spectrum);
  text = text.substr(0, text.find("[[gate]]")) + input;
  expect_refusals({text, {{"surge.csv", table_of(sine)}}}, R"(
input.half_width = 0.01: accepted
comparison.forcing is missing -> input.name = "period": expected an input that this case has: its
  motion has no single period
)");
}

// The shipped roll of SPHERIC benchmark 10 declares 3.840445 rad/s, fitted to the whole record.
TEST(ForcingSection, FindsTheFrequencyOfTheShippedRoll) {
  std::ifstream stream(SLOSH_SOURCE_DIR "/verification/cases/zhao2021_violent_roll.toml");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string declared = "forcing_angular_frequency_rad_s = 3.840445";
  ASSERT_TRUE(holds(text, declared));
  text.replace(text.find(declared), declared.size(), "forcing = \"from_spectrum\"");
  const Workspace workspace;
  const std::filesystem::path cases = SLOSH_SOURCE_DIR "/verification/cases";
  for (const auto& entry : std::filesystem::directory_iterator(cases))
    if (entry.path().extension() == ".csv")
      std::filesystem::copy_file(entry.path(), workspace.path() / entry.path().filename());
  const CaseDefinition definition = read_case(workspace.write("trial.toml", text));
  EXPECT_NEAR(forcing_frequency(definition), 3.840445, 2e-3);
  EXPECT_LT(definition.found_forcing->rest, 0.05);
}

}  // namespace
}  // namespace slosh::time_section_test
