// What inputs that nobody knows well make of a row: many predictions each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/evidence/tests/row_of_a_record.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::row_inputs_test {
namespace {

// A bound that no tank can have, and one at which theory fails: the row names the input, does not
// pass, and keeps what the other inputs do.
TEST(RowUncertainty, OfAnInputThatCannotBePropagatedIsNamedAndKeepsTheOthers) {
  const InputUncertainty known{Input::amplitude, 0.0002, "a ruler"};
  for (const double height : {0.6, 1.0}) {
    OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0.01);
    row.definition.tank.height = height;
    row.definition.inputs = {known};
    EXPECT_EQ(row.judged().verdict, Verdict::pass);
  }
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
    EXPECT_TRUE(holds(outcome.message, "the sensitivity to " + input_name(input) + " is unknown"));
    EXPECT_TRUE(holds(outcome.message, reason));
    if (input != Input::sensor_position && input != Input::density) continue;
    row.definition.inputs = {{input, half_width, "a guess"}};
    EXPECT_EQ(row.judged().verdict, Verdict::inconclusive) << reason << ", alone";
  }
}

// What the tank's own amplitude or period would make of a candidate that answers as theory does, 2
// % above a record of any height and late by some samples, against what the row counts. Theory is
// far from both.
struct OfAnAnswer : OfARecord {
  static constexpr double factor = 1.02;
  double height;
  std::size_t late;

  OfAnAnswer(Metric metric, const std::string& mode, double high, std::size_t samples_late,
             Input input, double half_width)
      : OfARecord(metric, mode, "1", 0.5, 0), height(high), late(samples_late) {
    definition.runs.pop_back();
    runs.results.erase("coarse_particles");
    runs.status.erase("coarse_particles");
    definition.refinements.clear();
    definition.inputs = {{input, half_width, "nobody"}};
    set("record", scaled(elevation_of({}), height));
    set("particles", answer({}));
  }
  TimeSeries answer(const Theory& tank) const {
    TimeSeries series = scaled(elevation_of(tank), factor * height);
    series.value.insert(series.value.begin(), late, 0.0);
    series.value.resize(series.time.size());
    return series;
  }
  double measured(const Theory& tank) const {
    OfARecord other = *this;
    other.definition.inputs.clear();
    other.set("particles", answer(tank));
    return other.judged().value.value;
  }
  double reach(double own, const std::function<Theory(double)>& tank) const {
    return std::max(std::abs(measured(tank(-1)) - own), std::abs(measured(tank(1)) - own));
  }
};

void expect_of_the_candidate(double height, Metric metric, Input input) {
  const double frequency = Theory().angular_frequency, period = 2 * std::numbers::pi / frequency;
  const bool is_amplitude = input == Input::amplitude;
  const OfAnAnswer row(metric, metric == Metric::amplitude_error ? "forced" : "whole", height, 15,
                       input, is_amplitude ? 0.002 : 0.01 * period);
  const GateOutcome outcome = row.judged();
  const double found = outcome.judgement->contributions.input.known(),
               reach = row.reach(outcome.value.value, [&](double s) {
                 return is_amplitude ? Theory{.amplitude = 0.02 + 0.002 * s}
                                     : Theory{.angular_frequency = frequency / (1 + 0.01 * s)};
               });
  EXPECT_GE(found, 0.97 * reach - 1e-4) << row_name(outcome.row) << " " << height;
  // The series move by more than a distance need do.
  EXPECT_LE(found, metric == Metric::normalised_rms ? 1 : 1.1 * reach + 0.01)
      << row_name(outcome.row) << " " << height;
}

TEST(RowUncertainty, OfAnInputIsOfTheCandidateHoweverFarTheoryIs) {
  expect_of_the_candidate(0.5, Metric::rms_error, Input::amplitude);
  expect_of_the_candidate(2, Metric::normalised_rms, Input::period);
}

// Of a pair the amplitude is refused at another period.
TEST(RowUncertainty, OfEachInputIsOfTheCandidateInEachMetric) {
  for (const double height : {0.5, 2.0}) {
    expect_of_the_candidate(height, Metric::amplitude_error, Input::amplitude);
    for (const Metric metric : {Metric::rms_error, Metric::normalised_rms})
      for (const Input input : {Input::amplitude, Input::period})
        expect_of_the_candidate(height, metric, input);
  }
}

// A wave of another period is drawn along by its difference in frequency: it lags by that times the
// window's middle. Its amplitude moves by some three shares, as the tank's response does, which
// rises as omega^2 / (omega_1^2 - omega^2).
TEST(RowUncertainty, OfAPeriodIsTheLagAtTheWindowsMiddle) {
  const double frequency = Theory().angular_frequency, period = 2 * std::numbers::pi / frequency;
  for (const double share : {0.002, 0.01}) {
    OfAnAnswer row(Metric::phase_lag, "forced", 1, 0, Input::period, share * period);
    row.definition.gate[0].unit = "deg";
    row.definition.gate[0].limit = 90;
    const double middle = (row.definition.window_begin + row.definition.window_end) / 2;
    const double lag = 180 / std::numbers::pi * frequency * share * middle;
    EXPECT_NEAR(row.judged().judgement->contributions.input.known(), lag, 0.05 * lag) << share;
    OfAnAnswer high(Metric::amplitude_error, "forced", 1, 0, Input::period, share * period);
    const double known = high.judged().judgement->contributions.input.known();
    EXPECT_GT(known, 2 * share);
    EXPECT_LT(known, 4 * share);
  }
}

// The band of a record that is half as high as theory says: theory is outside whatever the input
// is.
TEST(RowUncertainty, OfAnInputIsTheTimeThatTheCandidateLeavesTheBandFor) {
  OfARecord row(Metric::outside_band, "whole", "1", 0.3, 0.001);
  const TimeSeries wave = scaled(elevation_of({}), 0.5);
  const double around = 0.05 * 0.5 * *std::max_element(wave.value.begin(), wave.value.end());
  row.set("record", wave);
  RunResult& record = row.runs.results.at("record");
  auto& declared = std::get<RecordRun>(row.definition.runs.at(1).solver);
  declared.has_band = true;
  for (const auto& [suffix, by] : {std::pair{lower_edge, -around}, {upper_edge, around}}) {
    record.series.push_back(wave);
    record.series.back().name += suffix;
    for (double& value : record.series.back().value) value += by;
  }
  row.set("particles", wave);
  row.definition.inputs = {{Input::amplitude, 0.002, "a ruler"}};
  const TimeSeries inside = cut_to_window(wave, {1, 20});
  double outside = 0;  // where a tenth of the wave exceeds the band
  for (const double value : inside.value)
    outside += std::abs(0.1 * value) > around ? 1.0 / static_cast<double>(inside.value.size()) : 0;
  ASSERT_GT(outside, 0.2);
  EXPECT_NEAR(row.contributions().input.known(), outside, 0.02) << row.judged().message;
}

// Waves that are within the band at both steps leave it as far as the refinement leads.
TEST(RowUncertainty, OfAShareIsWhatItsSeriesUncertaintyLeavesTheBandBy) {
  for (const double coarse_error : {0.004, 0.08}) {
    OfARecord row(Metric::outside_band, "whole", "1", 0.05, coarse_error);
    const TimeSeries wave = elevation_of({});
    RunResult& record = row.runs.results["record"];
    std::get<RecordRun>(row.definition.runs.at(1).solver).has_band = true;
    const double around = 0.1 * *std::max_element(wave.value.begin(), wave.value.end());
    for (const auto& [suffix, by] : {std::pair{lower_edge, -around}, {upper_edge, around}}) {
      record.series.push_back(wave);
      record.series.back().name += suffix;
      for (double& value : record.series.back().value) value += by;
    }
    const GateOutcome outcome = row.judged();
    EXPECT_EQ(outcome.value.value, 0);
    const bool is_converged = coarse_error < 0.01;  // three times 8 % exceeds the band of 10 %
    EXPECT_EQ(outcome.judgement->contributions.discretisation.known() == 0, is_converged);
    EXPECT_EQ(outcome.verdict, is_converged ? Verdict::pass : Verdict::inconclusive)
        << outcome.message;
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
    definition.liquid.kinematic_viscosity = 1e-9;  // else theory is out of range for short waves
    definition.inputs = {{input, half_width, "nobody"}};
    definition.refinements.clear();
    const RunResult wave = execute(definition, definition.runs.at(0), {}, [](double, double) {});
    for (const char* name : {"theory", "record", "particles"}) runs.results[name] = wave;
  }
};

template <class Change>
double largest_of(double half_width, const Change& change) {
  double largest = 0;
  for (int i = -1000; i <= 1000; ++i)
    largest = std::max(largest, std::abs(change(i * half_width / 1000)));
  return largest;
}

// Half a centimetre of height is 49 Pa of water, half a centimetre along a long wave is little.
TEST(RowUncertainty, OfAProbesPlaceIsThatOfItsHeightToo) {
  OfARecord row(Metric::mean_offset, "whole", "Pa", 1, 0);
  row.definition.probes = {{"u", 0.5, 0.2}};
  row.definition.gate[0].quantity = "pressure@u";
  std::get<RecordRun>(row.definition.runs.at(1).solver).quantity = "pressure@u";
  row.definition.inputs = {{Input::sensor_position, 0.005, "nobody"}};
  const RunResult surge =
      execute(row.definition, row.definition.runs.at(0), {}, [](double, double) {});
  for (const char* name : {"theory", "record", "particles", "coarse_particles"})
    row.runs.results[name] = surge;
  EXPECT_NEAR(row.contributions().input.known(), 0.005 * 9.81 * 998, 1) << row.judged().message;
}

TEST(RowUncertainty, OfAPlaceIsTheLargestOfAllPlacesOrUnknown) {
  for (const int mode : {1, 5, 26, 34})
    for (const double share : {0.01, 0.2, 0.45, 0.55, 5.0}) {
      const double k = mode * std::numbers::pi, half_width = share * 2 / mode, x = FreeWave::place;
      if (half_width >= x) continue;
      const FreeWave row(mode, Input::sensor_position, half_width);
      const GateOutcome outcome = row.judged();
      const Contribution& input = outcome.judgement->contributions.input;
      if (share > 0.5) {
        EXPECT_FALSE(input.half_width) << mode << " " << share;
        EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << mode << " " << share;
        continue;
      }
      const double largest = largest_of(
          half_width, [=](double s) { return std::cos(k * (x + s)) / std::cos(k * x) - 1; });
      EXPECT_NEAR(input.known() / largest, 1, 0.05) << mode << " " << share;
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

// A free wave of a viscous liquid, with a theory that does not count viscosity before or after the
// one that does, or alone.
struct OfAViscousWave : OfARecord {
  OfAViscousWave(Metric metric, const std::string& unit, const std::vector<std::string>& theories)
      : OfARecord(metric, "natural_1", unit, 0.9, 1e-4) {
    definition.motion = {};
    definition.initial_wave = InitialWaveDefinition{1, 0.01};
    definition.liquid.kinematic_viscosity = 1e-3;
    const RunDefinition first = definition.runs.at(0);
    definition.runs.erase(definition.runs.begin());
    runs.results.erase("theory");
    runs.status.erase("theory");
    RunDefinition viscous = first;
    viscous.solver = ViscousWaveRun{0.1};
    const RunResult wave = execute(definition, viscous, {}, [](double, double) {});
    for (auto& [name, result] : runs.results) {
      result = result_of(name, wave.at(surge_quantity));
      if (name == "coarse_particles") result.series[0] = scaled(result.series[0], 1.0001);
    }
    for (const std::string& name : theories) {
      RunDefinition theory = name == "viscous" ? viscous : first;
      theory.name = name;
      runs.results[name] =
          name == "viscous" ? wave : execute(definition, theory, {}, [](double, double) {});
      runs.status[name] = {RunState::finished, ""};
      definition.runs.push_back(theory);
    }
  }
};

TEST(RowUncertainty, OfViscosityComesFromATheoryThatCountsItOrIsUnknown) {
  const std::vector<std::vector<std::string>> both{{"linear", "viscous"}, {"viscous", "linear"}};
  for (const auto& [metric, unit] :
       {std::pair{Metric::decay_error, "1"}, {Metric::decay_rate, "1/s"}}) {
    OfAViscousWave first(metric, unit, both[0]), second(metric, unit, both[1]),
        alone(metric, unit, {"linear"});
    for (const Input input : {Input::kinematic_viscosity, Input::fill_depth}) {
      for (OfAViscousWave* row : {&first, &second, &alone})
        row->definition.inputs = {{input, input == Input::fill_depth ? 0.02 : 5e-4, "a guess"}};
      const double found = first.contributions().input.half_width.value();
      EXPECT_EQ(found, second.contributions().input.half_width.value()) << "in any order";
      EXPECT_GT(found, input == Input::fill_depth ? 1e-5 : 0.005) << metric_name(metric);
      const GateOutcome outcome = alone.judged();
      EXPECT_FALSE(outcome.judgement->contributions.input.half_width);
      EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
      // Linear theory is outside its range in so thick a liquid.
      EXPECT_TRUE(
          holds(outcome.message, "the sensitivity to " + input_name(input) + " is unknown"));
    }
  }
}

}  // namespace
}  // namespace slosh::row_inputs_test
