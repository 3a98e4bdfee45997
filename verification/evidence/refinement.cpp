#include "verification/evidence/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "verification/case/solver_kinds.hpp"
#include "verification/metrics/reading_doubts.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

double recorded(const RunDefinition& run, const CaseRuns& runs, const char* name) {
  const auto& diagnostics = runs.results.at(run.name).diagnostics;
  const auto found = diagnostics.find(name);
  if (found == diagnostics.end())
    throw ComparisonError(fmt::format("the result of {} does not record its {}", run.name, name));
  return found->second;
}

GateRow with(GateRow row, Role role, const std::string& run) {
  (role == Role::candidate ? row.candidate : row.reference) = run;
  return row;
}

DiscretisationUncertainty of_two(const ValueAtStep& fine, const ValueAtStep& coarse,
                                 double at_step) {
  const double difference =
      std::max(std::abs(coarse.value - fine.value), std::hypot(coarse.noise, fine.noise));
  return {.behaviour = StepBehaviour::diverging,
          .order = {},
          .order_used = {},
          .extrapolated = at_step == fine.step ? fine.value : coarse.value,
          .uncertainty = first_order_uncertainty(difference, at_step, fine.step, coarse.step),
          .explanation = "two values have no order: first order and a safety factor of three"};
}

// `values` go from coarse to fine.
DiscretisationUncertainty judge(const std::vector<ValueAtStep>& values, double at_step) {
  return values.size() == 2 ? of_two(values[1], values[0], at_step)
                            : discretisation_uncertainty(values, at_step);
}

struct MeasuredRun {
  std::string name;
  ValueAtStep value;
};

const std::string& run_in(const GateRow& row, Role role) {
  return role == Role::candidate ? row.candidate : row.reference;
}

// The row's metric with each run of the path in the role, coarse to fine.
std::vector<MeasuredRun> measure_path(const RefinementDefinition& path,
                                      const CaseDefinition& definition, const CaseRuns& runs,
                                      const GateRow& row, Role role, const MeasureRow& measure) {
  std::vector<MeasuredRun> measured;
  for (const std::string& name : path.runs) {
    if (!runs.results.contains(name)) continue;
    const double step = step_of(path.number, run_named(definition, name), runs);
    try {
      const Estimate value = measure(with(row, role, name));
      if (std::isfinite(value.value) && std::isfinite(value.half_width))
        measured.push_back({name, {step, value.value, value.half_width}});
    } catch (const std::runtime_error&) {
      continue;  // ComparisonError or ResultError: this run has no such metric
    }
  }
  std::stable_sort(
      measured.begin(), measured.end(),
      [](const MeasuredRun& a, const MeasuredRun& b) { return a.value.step > b.value.step; });
  return measured;
}

// Of runs with nearly the same step, as a default and a number that is written out can have, the
// row's own run counts, or else the one that is declared first.
std::vector<MeasuredRun> one_a_step(const std::vector<MeasuredRun>& measured,
                                    const std::string& own) {
  std::vector<MeasuredRun> kept;
  for (const MeasuredRun& one : measured) {
    const bool repeats =
        !kept.empty() && kept.back().value.step < least_refinement_ratio * one.value.step;
    if (!repeats)
      kept.push_back(one);
    else if (one.name == own)
      kept.back() = one;
  }
  return kept;
}

// Of a program of the user's, by what its results say; false where they do not. Our own solvers
// cannot ignore their spacing.
bool has_no_more_particles(const std::string& coarse, const std::string& fine,
                           const CaseDefinition& definition, const CaseRuns& runs) {
  const double few = runs.results.at(coarse).cost.elements,
               many = runs.results.at(fine).cost.elements;
  const RunDefinition& finer = run_named(definition, fine);
  return !method_of(finer).empty() &&
         particle_spacing(run_named(definition, coarse)) > particle_spacing(finer) && few > 0 &&
         many > 0 && many <= few;
}

// What a finer step changes in a series, in the window.
struct Change {
  std::vector<double> time, value;  // without the mean
  double share = 0;                 // of the series' deviation

  // Whether nothing of it recurs or lasts, as the answer of the flow to another step does: none of
  // its autocorrelations at four samples or more, over which values between samples go on, is above
  // what chance gives white noise. Of 200 of them one in a thousand is above 4.5 / sqrt(n).
  bool is_white() const {
    constexpr double largest = 0.1;  // loads of breaking waves differ by as much from run to run
    constexpr std::size_t first_lag = 4, most_lags = 200;
    const std::size_t count = value.size();
    const double by_chance = 4.5 / std::sqrt(static_cast<double>(count)),
                 power = std::inner_product(value.begin(), value.end(), value.begin(), 0.0);
    if (by_chance > 0.5 || !(power > 0) || share > largest) return false;
    for (std::size_t lag = first_lag; lag < std::min(count / 4, first_lag + most_lags); ++lag)
      if (std::inner_product(value.begin() + static_cast<std::ptrdiff_t>(lag), value.end(),
                             value.begin(), 0.0) > by_chance * power)
        return false;
    return true;
  }

  // Whether both are small and as large, and correlate by -1/2, as three series do that differ by
  // noise of any colour: the changes of an ordered convergence correlate by 1 or -1.
  bool is_as_disordered_as(const Change& coarser) const {
    constexpr double small = 1e-3, as_large = 1.5, lowest = -0.75, highest = -0.25;
    if (!(std::max(share, coarser.share) < small) || time != coarser.time) return false;
    const double ratio = share / coarser.share,
                 correlation =
                     std::inner_product(value.begin(), value.end(), coarser.value.begin(), 0.0) /
                     (rms(value) * rms(coarser.value) * static_cast<double>(value.size()));
    return ratio < as_large && ratio > 1 / as_large && correlation > lowest &&
           correlation < highest;
  }
};

Change change_of(const TimeSeries& coarse, const TimeSeries& fine, TimeWindow window) {
  try {
    const CommonSamples common =
        common_samples(cut_to_window(coarse, window), cut_to_window(fine, window));
    Change change{common.time, without_mean(minus(common.candidate, common.reference)), 0};
    change.share = rms(change.value) / rms(without_mean(common.reference));
    return change;
  } catch (const ComparisonError&) {
    return {};  // one of them does not cover the window
  }
}

// Why the values tell nothing of the discretisation; "" where they do.
std::string why_unknown(const std::vector<MeasuredRun>& measured,
                        const std::vector<MeasuredRun>& kept, const CaseDefinition& definition,
                        const CaseRuns& runs, const std::string& quantity) {
  if (kept.size() < 2)
    return fmt::format("the steps of {} and {} differ by a factor below {}", measured.front().name,
                       measured.back().name, least_refinement_ratio);
  const TimeWindow window{definition.window_begin, definition.window_end};
  std::vector<Change> changes;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const std::string &coarse = kept[i - 1].name, &fine = kept[i].name;
    if (has_no_more_particles(coarse, fine, definition, runs))
      return fmt::format("{} has no more particles than {}: the refinement changed nothing", fine,
                         coarse);
    if (!has_series(runs, coarse, quantity) || !has_series(runs, fine, quantity)) continue;
    const TimeSeries &one = runs.results.at(coarse).at(quantity),
                     &other = runs.results.at(fine).at(quantity);
    if (are_same(one, other, window))
      return fmt::format("{} and {} have the same {}: the refinement changed nothing", coarse, fine,
                         quantity);
    // An impact that comes at another instant differs by as little order.
    if (has_impacts(one.unit)) continue;
    changes.push_back(change_of(one, other, window));
    if (changes.back().is_white() ||
        (changes.size() > 1 && changes.back().is_as_disordered_as(changes[changes.size() - 2])))
      return fmt::format("the {} of {} differs from that of {} by noise alone", quantity, fine,
                         coarse);
  }
  return "";
}

// The half width of the difference between two runs of one path, both fitted together. Returns
// nullopt for a metric whose interval is not that of such a difference.
std::optional<double> noise_of_pair(const GateRow& row, const std::string& run,
                                    const std::string& finest, const MeasureRow& measure) {
  if (metric_entry(row.metric).fitted != FittedTones::of_both) return std::nullopt;
  GateRow pair = row;
  pair.candidate = run;
  pair.reference = finest;
  try {
    const double half_width = measure(pair).half_width;
    return std::isfinite(half_width) ? std::optional(half_width) : std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;  // ComparisonError or ResultError: the two cannot be compared
  }
}

// The runs of a path have the same flow, and the residual of the fit is nearly the same in all of
// them. Between two runs, the interval of their own difference therefore counts. It is split so
// that each difference from the finest run keeps its interval: the finest run has the smallest of
// them over the square root of two, the others have the rest.
void take_noise_of_differences(std::vector<MeasuredRun>& measured, const GateRow& row,
                               const MeasureRow& measure) {
  const std::string finest = measured.back().name;
  std::vector<double> noise;
  for (const MeasuredRun& one : measured) {
    if (one.name == finest) continue;
    const auto of_pair = noise_of_pair(row, one.name, finest, measure);
    if (!of_pair) return;
    noise.push_back(*of_pair);
  }
  const double own = *std::min_element(noise.begin(), noise.end()) / std::sqrt(2.0);
  for (std::size_t i = 0; i < noise.size(); ++i)
    measured[i].value.noise = std::sqrt(noise[i] * noise[i] - own * own);
  measured.back().value.noise = own;
}

// The place s of f + s (g - f) at which a metric sees what it does not see at g.
std::optional<double> other_place(Metric metric) {
  switch (metric_entry(metric).blind_to) {
    case BlindTo::sign:
      return 0.5;
    case BlindTo::side:
      return -1;
    case BlindTo::nothing:
      break;
  }
  return std::nullopt;
}

// f + s (g - f), with the finest series f and a coarser one g, at the times that both cover.
TimeSeries on_the_line(const TimeSeries& finest, const TimeSeries& coarser, TimeWindow window,
                       double place) {
  TimeSeries moved = cut_to_window(finest, window);
  const CommonSamples common = common_samples(cut_to_window(coarser, window), moved);
  const auto first = std::find(moved.time.begin(), moved.time.end(), common.time.front());
  const auto begin = static_cast<std::size_t>(first - moved.time.begin());
  for (std::size_t i = 0; i < common.time.size(); ++i)
    moved.value[begin + i] += place * (common.candidate[i] - common.reference[i]);
  return with_part(finest, moved);
}

// The values as the header has them for a metric that is blind. Throws ComparisonError or
// ResultError where a run has no such series, and where there is no such metric at the place.
std::vector<ValueAtStep> seen_elsewhere(const std::vector<MeasuredRun>& measured, double place,
                                        const CaseDefinition& definition, const CaseRuns& runs,
                                        const GateRow& row, Role role,
                                        const MeasureWithSeries& measure_with) {
  const TimeWindow window{definition.window_begin, definition.window_end};
  const MeasuredRun& finest = measured.back();
  const TimeSeries& own = runs.results.at(finest.name).at(row.quantity);
  std::vector<ValueAtStep> values;
  for (const auto& [name, value] : measured) {
    values.push_back(value);
    if (name == finest.name) continue;
    const double there =
        measure_with(with(row, role, finest.name), finest.name,
                     on_the_line(own, runs.results.at(name).at(row.quantity), window, place))
            .value;
    values.back().value = finest.value.value + std::max(std::abs(value.value - finest.value.value),
                                                        std::abs(there - finest.value.value));
  }
  return values;
}

// A share need not change from run to run, and changes where the series has gone by its whole
// uncertainty: along the line through the finest two runs, both ways.
double change_of_share(const std::vector<MeasuredRun>& measured, const MeasuredRun& own,
                       const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       const MeasureWithSeries& measure_with) {
  const MeasuredRun &fine = measured.back(), &coarse = measured[measured.size() - 2];
  const double from = own.name == fine.name ? 0 : 1,
               reach =
                   first_order_uncertainty(1, own.value.step, fine.value.step, coarse.value.step);
  const TimeWindow window{definition.window_begin, definition.window_end};
  double largest = 0;
  for (const double place : {from - reach, from + reach}) {
    const TimeSeries moved =
        on_the_line(runs.results.at(fine.name).at(row.quantity),
                    runs.results.at(coarse.name).at(row.quantity), window, place);
    const double there =
        measure_with(with(row, Role::candidate, fine.name), fine.name, moved).value;
    largest = std::max(largest, std::abs(there - own.value.value));
  }
  return largest;
}

// By how much the straight line between a sample's neighbours misses it at most.
double missed_by_lines(const TimeSeries& series) {
  const auto& [name, unit, time, value] = series;
  double missed = 0;
  for (std::size_t i = 1; i + 1 < time.size(); ++i) {
    const double share = (time[i] - time[i - 1]) / (time[i + 1] - time[i - 1]);
    missed = std::max(missed, std::abs(value[i] - std::lerp(value[i - 1], value[i + 1], share)));
  }
  return missed;
}

bool has_sample(const TimeSeries& series, double time, double at_once) {
  const auto next = std::lower_bound(series.time.begin(), series.time.end(), time - at_once);
  return next != series.time.end() && *next <= time + at_once;
}

}  // namespace

bool are_same(const TimeSeries& one, const TimeSeries& other, TimeWindow window) {
  constexpr double least_change = 1e-6;  // of the largest magnitude
  try {
    const TimeSeries a = cut_to_window(one, window), b = cut_to_window(other, window);
    const CommonSamples common = common_samples(b, a);
    double largest = 0;
    for (const double value : common.reference) largest = std::max(largest, std::abs(value));
    // Times that differ by less are one: they are printed in another way.
    const double at_once =
        least_change * (a.time.back() - a.time.front()) / static_cast<double>(a.time.size() - 1);
    // A line between neighbours misses a fourth of what one between every second sample does, and
    // the cubic through values on such lines no more: twice that.
    const double between = missed_by_lines(b) / 2;
    for (std::size_t i = 0; i < common.time.size(); ++i) {
      const double unknown = has_sample(b, common.time[i], at_once) ? 0 : between;
      if (std::abs(common.candidate[i] - common.reference[i]) > least_change * largest + unknown)
        return false;
    }
    return common.time.size() >= 2;
  } catch (const ComparisonError&) {
    return false;  // one of them does not cover the window
  }
}

double step_of(RefinedNumber number, const RunDefinition& run, const CaseRuns& runs) {
  switch (number) {
    case RefinedNumber::particle_spacing:
      return particle_spacing(run).value();
    case RefinedNumber::smoothing_length_ratio:
      return 1 / recorded(run, runs, "smoothing_length_ratio");
    case RefinedNumber::speed_of_sound:
      return 1 / recorded(run, runs, "speed_of_sound_m_s");
    case RefinedNumber::courant_number:
      return recorded(run, runs, "courant_number");
    case RefinedNumber::mesh: {
      const InterFoamRun& mesh = std::get<InterFoamRun>(run.solver);
      return 1 / std::sqrt(static_cast<double>(mesh.cells_x) * mesh.cells_z);
    }
  }
  throw std::logic_error("a refined number without a step");
}

Refinements refined_metrics(const CaseDefinition& definition, const CaseRuns& runs,
                            const GateRow& row, Role role, const PathMeasures& measures) {
  const std::string& own = run_in(row, role);
  Refinements found;
  for (const RefinementDefinition& path : definition.refinements) {
    if (std::find(path.runs.begin(), path.runs.end(), own) == path.runs.end()) continue;
    const std::vector<MeasuredRun> all =
        measure_path(path, definition, runs, row, role, measures.row);
    std::vector<MeasuredRun> measured = one_a_step(all, own);
    const auto itself = std::find_if(measured.begin(), measured.end(),
                                     [&](const MeasuredRun& one) { return one.name == own; });
    if (all.size() < 2 || itself == measured.end()) continue;
    if (const std::string why = why_unknown(all, measured, definition, runs, row.quantity);
        !why.empty()) {
      found.unknown.push_back(fmt::format("the refinement {} tells nothing: {}", path.name, why));
      continue;
    }
    take_noise_of_differences(measured, row, measures.row);
    RefinedMetric metric{path.name, {}, {}, {}};
    for (const auto& [name, value] : measured) {
      metric.values.push_back(value);
      metric.runs.push_back(name);
    }
    metric.found = judge(metric.values, itself->value.step);
    try {
      if (const auto place = other_place(row.metric))
        metric.found.uncertainty = std::max(
            metric.found.uncertainty, judge(seen_elsewhere(measured, *place, definition, runs, row,
                                                           role, measures.with_series),
                                            itself->value.step)
                                          .uncertainty);
      if (is_of_band(row.metric))
        metric.found.uncertainty = std::max(
            metric.found.uncertainty,
            change_of_share(measured, *itself, definition, runs, row, measures.with_series));
    } catch (const ComparisonError& error) {
      found.unknown.push_back(fmt::format("the refinement {} tells nothing: between its runs {}",
                                          path.name, error.what()));
      continue;
    }
    found.paths.push_back(std::move(metric));
  }
  return found;
}

double numerical_uncertainty(const std::vector<RefinedMetric>& paths) {
  double squares = 0;
  for (const RefinedMetric& path : paths)
    squares += path.found.uncertainty * path.found.uncertainty;
  return std::sqrt(squares);
}

}  // namespace slosh
