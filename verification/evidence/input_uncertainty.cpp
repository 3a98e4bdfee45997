#include "verification/evidence/input_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/evidence/row_uncertainty.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

bool counts_viscosity(const RunDefinition& theory) {
  return std::holds_alternative<ViscousWaveRun>(theory.solver);
}

bool is_of_decay(Metric metric) {
  return metric == Metric::decay_rate || metric == Metric::decay_error;
}

// The first theory inside its range that may predict the input's effect; where rows rest on a
// decay, the first that has one. Returns nullptr where there is none.
const RunDefinition* theory_in_range(const CaseDefinition& definition, const CaseRuns& runs,
                                     Input input) {
  const bool is_of_decays = std::any_of(definition.gate.begin(), definition.gate.end(),
                                        [](const GateRow& row) { return is_of_decay(row.metric); });
  const RunDefinition* first = nullptr;
  for (const RunDefinition& run : definition.runs) {
    const auto status = runs.status.find(run.name);
    if (!may_predict(run, input) || status == runs.status.end() ||
        status->second.state != RunState::finished)
      continue;
    if (!first || (is_of_decays && counts_viscosity(run) && !counts_viscosity(*first)))
      first = &run;
  }
  return first;
}

RunResult predicted(const CaseDefinition& definition, const RunDefinition& theory, Input input,
                    double change) {
  RunSettings settings;
  settings.with_left_out = false;
  return execute(with_input(definition, input, change), theory, settings, [](double, double) {});
}

bool is_open(const RunStatus& status) {
  return status.state == RunState::failed || status.state == RunState::missing;
}

// The number of half waves of the shortest wave that carries much: that of the initial wave, or
// the one that the fastest part of the motion is nearest to.
int half_waves(const CaseDefinition& definition) {
  double fastest = 0;
  for (const ForcedMode& mode : forced_modes(definition))
    fastest = std::max(fastest, mode.angular_frequency);
  constexpr int most_in_rectangle = 64;
  const std::vector<double> natural =
      natural_frequencies(definition, is_rectangle(definition.tank) ? most_in_rectangle : 1);
  const auto slower =
      std::count_if(natural.begin(), natural.end(), [=](double one) { return one < fastest; });
  return std::max(1 + static_cast<int>(slower),
                  definition.initial_wave ? definition.initial_wave->mode : 1);
}

// The change of an input within which the response repeats itself: a whole turn of the start, a
// wave's length, or what moves the phase at the window's end by a turn. That to the others is
// monotone.
double repeats_after(const CaseDefinition& definition, Input input) {
  const int waves = half_waves(definition);
  const auto turns_at = [&](double frequency) {  // by the window's end
    return std::max(1.0, definition.window_end * frequency / (2 * std::numbers::pi));
  };
  const auto natural_turns = [&] {
    const std::vector<double> natural = natural_frequencies(definition, waves);
    return turns_at(natural.empty() ? 0 : natural.back());
  };
  switch (input) {
    case Input::start_phase:
      return 360;
    case Input::sensor_position:
      return 2 * definition.tank.length / waves;
    case Input::period:
      return 2 * std::numbers::pi / forcing_frequency(definition) /
             turns_at(forcing_frequency(definition));
    case Input::fill_depth:  // d omega / omega <= dh / 2 h
      return 2 * definition.liquid.fill_depth / natural_turns();
    case Input::gravity:  // d omega / omega = dg / 2 g
      return 2 * definition.gravity / natural_turns();
    case Input::amplitude:
    case Input::density:
    case Input::kinematic_viscosity:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

// Throws ComparisonError where the input's bounds are not predicted.
const InputBounds& bounds_of(const CaseDefinition& definition, const CaseRuns& runs,
                             const InputUncertainty& one) {
  for (const double change : {-one.half_width, one.half_width})
    if (const auto why = impossible(with_input(definition, one.input, change)))
      throw ComparisonError("a bound of its interval is impossible: " + *why);
  if (const auto bounds = runs.input_bounds.find(one.input); bounds != runs.input_bounds.end())
    return bounds->second;
  const auto why = runs.not_predicted.find(one.input);
  throw ComparisonError(
      why != runs.not_predicted.end()
          ? why->second
          : fmt::format("no theory of the liquid alone{} predicts the case at both bounds, and no "
                        "coarse_run was computed at both",
                        one.input == Input::kinematic_viscosity ? " that counts viscosity" : ""));
}

// Two runs at the bounds show a response that turns only where they are so near.
constexpr double most_for_two_runs = 1.0 / 20;
// Theory is asked so often while the response repeats itself once.
constexpr double places_of_a_repeat = 32;

// The changes of the input that theory shows beside the bounds of its half width: as many as the
// response needs, up to one that repeats itself once. A start that may be anywhere is half a turn
// wide. Throws ComparisonError for any other input that wide.
std::vector<double> between_bounds(const CaseDefinition& definition, const InputUncertainty& one) {
  const double repeat = repeats_after(definition, one.input);
  const bool is_anywhere = one.half_width > repeat / 2;
  if (is_anywhere && one.input != Input::start_phase)
    throw ComparisonError(fmt::format(
        "its half width of {:.4g} {unit} exceeds {:.4g} {unit}, half of what the waves repeat "
        "themselves within",
        one.half_width, repeat / 2, fmt::arg("unit", input_unit(one.input, definition.motion))));
  const double half = is_anywhere ? repeat / 2 : one.half_width;
  const int steps = static_cast<int>(std::ceil(2 * half / repeat * places_of_a_repeat));
  std::vector<double> changes;
  for (int i = is_anywhere ? 0 : 1; i < steps; ++i)
    if (2 * i != steps) changes.push_back(half * (2.0 * i / steps - 1));
  return changes;
}

// What an input's effect is measured as (the header).
enum class Response { ratio, difference, distance, share_outside };

Response response_of(Metric metric) {
  if (is_of_band(metric)) return Response::share_outside;
  if (metric_entry(metric).blind_to == BlindTo::side) return Response::distance;
  return metric_unit(metric, "") == "1" ? Response::ratio : Response::difference;
}

// The series of the prediction as the case is, and with the input changed.
struct Prediction {
  const TimeSeries &own, &changed;
  double before;  // unchanged_value()
};

double swing(const TimeSeries& cut) { return rms(without_mean(cut.value)); }

// At times that it may miss by a sample.
std::vector<double> values_at(const TimeSeries& cut, std::vector<double> times) {
  for (double& one : times) one = std::clamp(one, cut.time.front(), cut.time.back());
  return interpolate(cut, times);
}

// The candidate's series with the change of the prediction, whose swing is that of a wave as high
// as the candidate's.
TimeSeries moved_by(const TimeSeries& whole, const Prediction& by, TimeWindow window) {
  TimeSeries moved = cut_to_window(whole, window);
  const TimeSeries own = cut_to_window(by.own, window);
  const std::vector<double> change =
      minus(values_at(cut_to_window(by.changed, window), moved.time), values_at(own, moved.time));
  const double shift = mean(change), scale = swing(moved) / swing(own);
  for (std::size_t i = 0; i < change.size(); ++i)
    moved.value[i] += shift + scale * (change[i] - shift);
  return with_part(whole, moved);
}

struct EffectMeasures {
  const CaseDefinition& definition;
  const CaseRuns& runs;
  const MeasureWithSeries& measure_with;

  double with(const GateRow& row, const TimeSeries& series) const {
    return measure_with(row, row.candidate, series).value;
  }
};

// The metric before the input changes: of the prediction, or of the candidate that it moves. A
// distance has none.
double unchanged_value(const GateRow& row, const TimeSeries& own, const EffectMeasures& by) {
  switch (response_of(row.metric)) {
    case Response::distance:
      return 0;
    case Response::share_outside:
      return by.with(row, by.runs.results.at(row.candidate).at(row.quantity));
    default:
      return by.with(row, own);
  }
}

// Of one changed prediction; NaN where it has no such metric.
InputEffect effect_of(const GateRow& row, const Prediction& prediction, const EffectMeasures& by) {
  InputEffect effect;
  switch (response_of(row.metric)) {
    case Response::ratio:
      effect.of_wave = (1 + by.with(row, prediction.changed)) / (1 + prediction.before) - 1;
      break;
    case Response::difference:
      effect.of_wave = by.with(row, prediction.changed) - prediction.before;
      if (is_angle(row.metric)) effect.of_wave = std::remainder(effect.of_wave, 360);
      break;
    case Response::distance: {
      const Comparison apart = compare(prediction.changed, prediction.own,
                                       compared_window(by.definition, row.reference), {});
      if (row.metric == Metric::aligned_rms) {
        effect.of_wave = apart.alignment.normalised_rms;
      } else {
        effect.of_wave = normalised_rms_without_offset(apart);
        effect.of_mean = std::abs(apart.candidate_wave.mean - apart.reference_wave.mean);
      }
      break;
    }
    case Response::share_outside: {
      const TimeSeries& candidate = by.runs.results.at(row.candidate).at(row.quantity);
      const TimeWindow window = compared_window(by.definition, row.reference);
      effect.of_wave = by.with(row, moved_by(candidate, prediction, window)) - prediction.before;
      break;
    }
  }
  effect.of_wave = std::abs(effect.of_wave);
  return effect;
}

// Throws ComparisonError where the input's predictions tell nothing of the row.
void require_seen(const CaseDefinition& definition, const InputUncertainty& one, const GateRow& row,
                  const InputBounds& bounds, const TimeSeries& own) {
  const RunDefinition& run = run_named(definition, bounds.own);
  if (is_theory(run)) {
    if (is_of_decay(row.metric) && !counts_viscosity(run))
      throw ComparisonError(bounds.own + " does not count viscosity, so that no wave of it decays");
    return;
  }
  if (bounds.between.empty() &&
      one.half_width > repeats_after(definition, one.input) * most_for_two_runs)
    throw ComparisonError(
        "two runs at the bounds of so wide an interval do not show how the metric turns between");
  const TimeWindow window{definition.window_begin, definition.window_end};
  if (one.input != Input::density && are_same(bounds.lower.at(row.quantity), own, window) &&
      are_same(bounds.upper.at(row.quantity), own, window))
    throw ComparisonError(
        fmt::format("it changes nothing of {}, which does not see it", bounds.own));
}

// The largest effects of all the input's predictions.
InputEffect largest_effect(const InputUncertainty& one, const GateRow& row,
                           const EffectMeasures& measures) {
  if (is_of_repeats(row.metric))
    throw ComparisonError(
        "a distribution has no prediction at both bounds; an ensemble with vary_inputs = true "
        "would count it");
  const CaseDefinition& definition = measures.definition;
  const InputBounds& bounds = bounds_of(definition, measures.runs, one);
  const auto as_it_is = measures.runs.results.find(bounds.own);
  if (as_it_is == measures.runs.results.end())
    throw ComparisonError("there is no result of " + bounds.own);
  const TimeSeries& own = as_it_is->second.at(row.quantity);
  require_seen(definition, one, row, bounds, own);
  std::vector<const RunResult*> all{&bounds.lower, &bounds.upper};
  for (const RunResult& between : bounds.between) all.push_back(&between);
  const double before = unchanged_value(row, own, measures);
  InputEffect largest;
  for (const RunResult* changed : all) {
    const InputEffect effect = effect_of(row, {own, changed->at(row.quantity), before}, measures);
    if (!std::isfinite(effect.of_wave) || !std::isfinite(effect.of_mean))
      throw ComparisonError("the prediction has no such metric");
    largest.of_wave = std::max(largest.of_wave, effect.of_wave);
    largest.of_mean = std::max(largest.of_mean, effect.of_mean);
  }
  return largest;
}

// A probe in the liquid may be off in both directions, of which with_input() changes x.
CaseDefinition with_raised_probes(CaseDefinition definition, double change) {
  for (ProbeDefinition& probe : definition.probes) probe.z += change;
  return definition;
}

}  // namespace

bool may_predict(const RunDefinition& run, Input input) {
  return is_theory(run) && !sees_gas(run) &&
         (input != Input::kinematic_viscosity || counts_viscosity(run));
}

void predict_input_bounds(const CaseDefinition& definition, CaseRuns& runs) {
  const bool is_needed =
      std::any_of(definition.gate.begin(), definition.gate.end(),
                  [&](const GateRow& row) { return rests_on_experiment(definition, row); });
  if (!is_needed) return;
  for (const InputUncertainty& one : definition.inputs) {
    const RunDefinition* theory = theory_in_range(definition, runs, one.input);
    if (!theory) continue;
    try {
      const auto at = [&](double change) {
        return predicted(definition, *theory, one.input, change);
      };
      const std::vector<double> between = between_bounds(definition, one);
      InputBounds bounds{at(-one.half_width), at(one.half_width), {}, theory->name};
      for (const double change : between) bounds.between.push_back(at(change));
      if (one.input == Input::sensor_position && !definition.probes.empty())
        for (const double change : {-one.half_width, one.half_width})
          bounds.between.push_back(
              predicted(with_raised_probes(definition, change), *theory, one.input, 0));
      runs.input_bounds[one.input] = std::move(bounds);
    } catch (const std::exception& error) {
      runs.not_predicted[one.input] = error.what();
    }
  }
}

void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs) {
  std::map<Input, std::map<bool, RunResult>> ends;  // by input; true: at the upper bound
  std::map<Input, std::string> repeated;
  const std::vector<RunDefinition> all = std::move(definition.runs);
  definition.runs.clear();
  for (const RunDefinition& run : all) {
    if (!run.at_input || is_open(runs.status.at(run.name))) {
      definition.runs.push_back(run);
      continue;
    }
    repeated[run.at_input->input] = run.at_input->repeated_run;
    if (const auto result = runs.results.extract(run.name))
      ends[run.at_input->input][run.at_input->change > 0] = result.mapped();
    runs.status.erase(run.name);
    runs.timings.erase(run.name);
  }
  for (auto& [input, found] : ends)
    if (found.size() == 2 && !runs.input_bounds.contains(input))
      runs.input_bounds[input] = {
          std::move(found[false]), std::move(found[true]), {}, repeated[input]};
}

std::vector<InputEffect> input_effects(const CaseDefinition& definition, const CaseRuns& runs,
                                       const GateRow& row, const MeasureWithSeries& measure_with) {
  std::vector<InputEffect> effects;
  for (const InputUncertainty& one : definition.inputs) {
    try {
      effects.push_back(largest_effect(one, row, {definition, runs, measure_with}));
    } catch (const std::runtime_error& error) {  // ComparisonError and ResultError
      effects.push_back({});
      effects.back().unknown = error.what();
    }
    effects.back().input = input_name(one.input);
  }
  return effects;
}

CandidateScale candidate_scale(const CaseDefinition& definition, const GateRow& row, double value,
                               const FindComparison& comparison) {
  const Response response = response_of(row.metric);
  if (response == Response::ratio) return {std::abs(1 + value), 0};
  if (response != Response::distance) return {};
  CandidateScale scale{0, 0};
  for (const std::string& member : members_of(definition, row.candidate)) {
    const Comparison& one = comparison(member, row.reference, row.quantity);
    scale.wave = std::max(scale.wave, one.candidate_wave.deviation / one.reference_wave.deviation);
    scale.mean = 1 / one.reference_wave.deviation;
  }
  return scale;
}

Contribution input_uncertainty(const std::vector<InputEffect>& effects, const GateRow& row,
                               const CandidateScale& scale) {
  if (effects.empty())
    return Contribution::unknown(
        "the uncertainty of the experiment's inputs is unknown: the case declares no [[input]]");
  double squares = 0;
  std::vector<std::string> counted, not_counted;
  for (const InputEffect& one : effects) {
    if (!one.unknown.empty()) {
      not_counted.push_back(
          fmt::format("the sensitivity to {} is unknown: {}", one.input, one.unknown));
      continue;
    }
    const double change = std::hypot(scale.wave * one.of_wave, scale.mean * one.of_mean);
    squares += change * change;
    counted.push_back(fmt::format("{} {}", one.input, in_unit(change, row.unit)));
  }
  const std::string missing = fmt::format("{}", fmt::join(not_counted, "; "));
  Contribution found = counted.empty() ? Contribution::unknown(missing)
                                       : Contribution(std::sqrt(squares),
                                                      fmt::format("{}", fmt::join(counted, ", ")));
  found.not_counted = missing;
  return found;
}

}  // namespace slosh
