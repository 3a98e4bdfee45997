// What inputs that nobody knows well make of a row: many predictions each.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/evidence/tests/row_of_a_record.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh::row_inputs_test {
namespace {

// A bound that no tank can have, and one at which theory fails: the row names the input, does not
// pass, and keeps what the other inputs do.
TEST(RowUncertainty, OfAnInputThatCannotBePropagatedIsNamedAndKeepsTheOthers) {
  const InputUncertainty known{Input::amplitude, 0.0002, "a ruler"};
  for (const auto& [input, half_width, reason] :
       {std::tuple{Input::sensor_position, 0.06, "x of gauge right in m = 1.01: expected 0 to 1"},
        {Input::fill_depth, 1e6, "fill depth = "},
        {Input::fill_depth, 0.34, "fill depth = 0.69 m: expected above 0 and below"},
        {Input::gravity, 10.0, "gravity = -0.19: expected 0 or more"},
        {Input::density, 2000.0, "density = -1000 kg/m3: expected above that of the gas"},
        {Input::kinematic_viscosity, 1.0, "kinematic viscosity = "},
        {Input::period, 5.0, "the motion: expected amplitudes and periods above zero"},
        {Input::gravity, 9.81, "the sensitivity to gravity is unknown: "}}) {
    OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0.01);
    row.definition.tank.height = input == Input::fill_depth && half_width < 1 ? 0.6 : 1.0;
    row.definition.inputs = {{input, half_width, "a guess"}, known};
    const GateOutcome outcome = row.judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << reason;
    EXPECT_NEAR(outcome.judgement->contributions.input.known(), 0.0002 / 0.02, 1e-6);
    EXPECT_NE(outcome.message.find("the sensitivity to " + input_name(input) + " is unknown"),
              std::string::npos);
    EXPECT_NE(outcome.message.find(reason), std::string::npos) << outcome.message;
    row.definition.inputs = {known};
    EXPECT_EQ(row.judged().verdict, Verdict::pass) << reason;
    row.definition.inputs = {{input, half_width, "a guess"}};
    EXPECT_EQ(row.judged().verdict, Verdict::inconclusive) << reason << ", alone";
  }
}

// At both bounds the liquid moves as at the value itself, or as high as there.
TEST(RowUncertainty, OfAnInputSeesWhatTurnsBetweenItsBounds) {
  for (const double turns : {360.0, 4680.0}) {
    OfARecord row(Metric::phase_lag, "forced", "deg", 5, 0);
    row.definition.start = Start::tank;
    std::get<LinearRun>(row.definition.runs.at(0).solver).modes = 10;
    row.definition.inputs = {{Input::start_phase, turns, "nobody"}};
    EXPECT_GT(row.contributions().input.known(), 140) << turns;
  }
  OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0);
  std::get<LinearRun>(row.definition.runs.at(0).solver).modes = 10;
  row.definition.gauges.at(0).x = 0.5 * row.definition.tank.length;
  row.definition.inputs = {{Input::sensor_position, 0.49 * row.definition.tank.length, "nobody"}};
  EXPECT_GT(row.contributions().input.known(), 0.5) << row.judged().message;
}

// A free wave and its own record: the largest distance of its prediction from it, on 2001 places of
// the interval.
struct FreeWave : OfARecord {
  static constexpr double place = 0.47;
  FreeWave(int mode, Input input, double half_width)
      : OfARecord(Metric::normalised_rms, "whole", "1", 0.05, 0) {
    definition.motion = {};
    definition.gauges.at(0).x = place;
    definition.initial_wave = InitialWaveDefinition{mode, 1e-4};
    definition.inputs = {{input, half_width, "nobody"}};
    definition.refinements.clear();
    for (const char* name : {"theory", "record", "particles"})
      runs.results[name] = execute(definition, definition.runs.at(0), {}, [](double, double) {});
  }
};

template <class Change>
double largest_of(double half_width, const Change& change) {
  double largest = 0;
  for (int i = -1000; i <= 1000; ++i)
    largest = std::max(largest, std::abs(change(i * half_width / 1000)));
  return largest;
}

TEST(RowUncertainty, OfAPlaceIsTheLargestOfAllPlacesOrUnknown) {
  for (const int mode : {1, 5, 26, 34})
    for (const double share : {0.01, 0.2, 0.45, 0.55, 5.0}) {
      const double k = mode * std::numbers::pi, half_width = share * 2 / mode, x = FreeWave::place;
      if (half_width >= x) continue;
      const FreeWave row(mode, Input::sensor_position, half_width);
      if (share > 0.5) {
        EXPECT_FALSE(row.contributions().input.half_width) << mode << " " << share;
        EXPECT_EQ(row.judged().verdict, Verdict::inconclusive) << mode << " " << share;
        continue;
      }
      const double largest = largest_of(
          half_width, [=](double s) { return std::cos(k * (x + s)) / std::cos(k * x) - 1; });
      EXPECT_NEAR(row.contributions().input.known() / largest, 1, 0.05) << mode << " " << share;
    }
}

TEST(RowUncertainty, OfGravityIsTheLargestOfItsIntervalOrUnknown) {
  const double kh = std::numbers::pi * surge_case().liquid.fill_depth;
  const auto distance = [&](double change) {
    double squares = 0, own = 0;
    for (double t = 1; t < 20; t += 0.02) {
      const auto wave = [&](double g) {
        return std::cos(std::sqrt(g * std::numbers::pi * std::tanh(kh)) * t);
      };
      squares += std::pow(wave(9.81 + change) - wave(9.81), 2);
      own += std::pow(wave(9.81), 2);
    }
    return std::sqrt(squares / own);
  };
  for (const double half_width : {0.01, 0.1, 0.3})
    EXPECT_NEAR(FreeWave(1, Input::gravity, half_width).contributions().input.known() /
                    largest_of(half_width, distance),
                1, 0.05)
        << half_width;
  EXPECT_FALSE(FreeWave(1, Input::gravity, 9.0).contributions().input.half_width);
}

}  // namespace
}  // namespace slosh::row_inputs_test
