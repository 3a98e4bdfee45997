#include "verification/gate/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

constexpr Estimate no_value{std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::quiet_NaN()};

std::string with_interval(const Estimate& estimate, const std::string& unit) {
  const std::string value = in_unit(estimate.value, unit);
  if (!(estimate.half_width > 0)) return value;  // a whole-window metric has none
  return value + " +- " + in_unit(estimate.half_width, unit);
}

const ModeComparison& mode_of(const Comparison& comparison, const std::string& mode) {
  const auto found = std::find_if(comparison.modes.begin(), comparison.modes.end(),
                                  [&](const ModeComparison& one) { return one.mode == mode; });
  if (found == comparison.modes.end())
    throw ComparisonError("the mode " + mode + " was not fitted");
  for (const Tone* tone : {&found->candidate, &found->reference})
    if (!tone->resolved)
      throw ComparisonError(fmt::format("the {}'s mode {} cannot be told from the rest",
                                        tone == &found->candidate ? "candidate" : "reference",
                                        mode));
  if (found->beside)
    throw ComparisonError(fmt::format(
        "the window of {:.4g} s cannot tell the mode {} from what the difference has at {:.4g} Hz",
        comparison.window.end - comparison.window.begin, mode,
        *found->beside / (2 * std::numbers::pi)));
  return *found;
}

// Of a reference that does not decay, as potential flow, there is nothing to take a share of.
Estimate decay_error_of(const ModeComparison& mode) {
  if (!(mode.reference.decay_rate.value > mode.reference.decay_rate.half_width))
    throw ComparisonError("the reference's mode " + mode.mode +
                          " does not decay; expected a viscous one, or the metric decay_rate");
  return mode.decay_error;
}

Estimate metric_value(Metric metric, const std::string& mode, const Comparison& comparison) {
  switch (metric) {
    case Metric::amplitude_error:
      return mode_of(comparison, mode).amplitude_error;
    case Metric::phase_lag:
      return mode_of(comparison, mode).phase_lag_degrees;
    case Metric::frequency_error:
      return mode_of(comparison, mode).frequency_error;
    case Metric::decay_rate:
      return mode_of(comparison, mode).decay_rate;
    case Metric::decay_error:
      return decay_error_of(mode_of(comparison, mode));
    case Metric::normalised_rms:
      // Of the declared window, whose samples are all there: its interval tells of other windows.
      return {comparison.normalised_rms.value, 0};
    case Metric::maximum_residual:
      return {comparison.maximum_residual, 0};
    case Metric::time_lag:
      return {comparison.alignment.lag, 0};
    case Metric::aligned_rms:
      return {comparison.alignment.normalised_rms, 0};
    case Metric::largest_magnitude:
    case Metric::impact_time:
    case Metric::plateau_error:
    case Metric::impact_percentile:
    case Metric::cost_to_reach:
      break;  // of no single comparison
  }
  throw std::logic_error("a metric without a value");
}

// As wide as the interval's upper end, the further one: it is symmetric in the logarithm. Of the
// declared window, like normalised_rms: what the errors' bars add tells of other windows.
Estimate cost_value(const CostAtError& found) {
  if (found.reach == Reach::not_at_all) return no_value;
  return {found.cost, found.cost * std::expm1(found.cost_spread)};
}

// No number where a value is none or where there is no value at all.
double largest_magnitude(const TimeSeries& series) {
  double largest = series.value.empty() ? no_value.value : 0;
  for (const double value : series.value) {
    if (std::isnan(value)) return value;
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

void require_unit(const GateRow& row, const std::string& quantity_unit) {
  const std::string unit = metric_unit(row.metric, quantity_unit);
  if (unit == row.unit) return;
  throw ComparisonError(
      fmt::format("{} is in {}, the row's limit in {}", metric_name(row.metric), unit, row.unit));
}

// Nearer to zero by more than both intervals together, or by an interval that holds zero itself.
bool improves(const Estimate& estimate, const Estimate& other) {
  const double gain = std::abs(other.value) - std::abs(estimate.value);
  const bool clearly = gain > std::hypot(estimate.half_width, other.half_width);
  const bool to_zero = std::abs(estimate.value) <= estimate.half_width &&
                       estimate.half_width < std::abs(other.value);
  return gain > 0 && (clearly || to_zero);
}

// Written so that a value that is no number is not better.
Verdict verdict_on_improvement(const Estimate& estimate, const Estimate& other) {
  if (improves(estimate, other)) return Verdict::pass;
  const double loss = std::abs(estimate.value) - std::abs(other.value);
  return std::abs(loss) < std::hypot(estimate.half_width, other.half_width) ? Verdict::inconclusive
                                                                            : Verdict::violated;
}

GateOutcome judge_improvement(const GateRow& row, const Estimate& value,
                              const GateEvidence& evidence) {
  const std::string& other = row.improves_on.value();
  GateRow others_row = row;
  others_row.candidate = other;
  const Estimate others = measured(others_row, evidence);
  const Verdict verdict = verdict_on_improvement(value, others);
  return {row, verdict, value,
          fmt::format("|{}| {} |{}| of {}", with_interval(value, row.unit),
                      verdict == Verdict::pass ? "<" : "is not clearly <",
                      with_interval(others, row.unit), other)};
}

Verdict verdict_of(ThreeWayVerdict verdict) {
  switch (verdict) {
    case ThreeWayVerdict::pass:
      return Verdict::pass;
    case ThreeWayVerdict::fail:
      return Verdict::violated;
    case ThreeWayVerdict::inconclusive:
      return Verdict::inconclusive;
  }
  throw std::logic_error("a verdict of no kind");
}

// Whether it is no number for want of what the row looks for.
bool is_lost(const GateRow& row, double value) {
  return std::isnan(value) && (is_of_impacts(row.metric) || row.metric == Metric::cost_to_reach);
}

std::string lost_text(const GateRow& row, const GateEvidence& evidence) {
  return is_of_impacts(row.metric) ? "no impact" : not_reached_text(evidence.cost(row), row.unit);
}

// "13.9 % +- 4 % <= 20 %", "|-1 %| <= 2 %", "3 % is not within 1 % .. 2 %".
std::string bound_text(const GateRow& row, const ThreeWayOutcome& judged,
                       const GateEvidence& evidence) {
  const std::string shown = is_lost(row, judged.error)
                                ? lost_text(row, evidence)
                                : with_interval({judged.error, judged.uncertainty}, row.unit);
  const auto phrase = [&](const char* holds, const char* does_not) {
    switch (judged.verdict) {
      case ThreeWayVerdict::pass:
        return holds;
      case ThreeWayVerdict::fail:
        return does_not;
      case ThreeWayVerdict::inconclusive:
        break;
    }
    return "cannot be told from";
  };
  if (row.limit)
    return fmt::format("{} {} {}", judged.error < 0 ? "|" + shown + "|" : shown,
                       phrase("<=", "is not <="), in_unit(*row.limit, row.unit));
  return fmt::format("{} {} {} .. {}", shown, phrase("within", "is not within"),
                     in_unit(row.between->first, row.unit), in_unit(row.between->second, row.unit));
}

GateOutcome judge_bound(const GateRow& row, const Estimate& value, const GateEvidence& evidence) {
  UncertaintyContributions contributions;
  if (evidence.uncertainty) contributions = evidence.uncertainty(row);
  contributions.statistics = std::hypot(contributions.statistics, value.half_width);
  const ThreeWayOutcome judged = judge_error(value.value, contributions, allowed_by(row));
  return {row, verdict_of(judged.verdict), value, bound_text(row, judged, evidence), judged};
}

bool needs_reference(Metric metric) {
  return metric != Metric::largest_magnitude && !is_of_impacts(metric);
}

struct RoleInRow {
  std::string role, run;
};

std::vector<RoleInRow> runs_of(const GateRow& row) {
  std::vector<RoleInRow> runs{{"candidate", row.candidate}};
  if (needs_reference(row.metric)) runs.push_back({"reference", row.reference});
  if (row.improves_on) runs.push_back({"run to improve on", *row.improves_on});
  return runs;
}

// Why a row cannot be evaluated, most telling first; nothing where it can.
std::optional<std::pair<Verdict, std::string>> obstacle(
    const GateRow& row, const std::map<std::string, RunStatus>& runs) {
  struct Obstacle {
    RunState state;
    Verdict verdict;
    const char* text;
  };
  constexpr std::array<Obstacle, 5> obstacles{{
      {RunState::not_selected, Verdict::not_selected, "is not selected"},
      {RunState::not_supplied, Verdict::not_supplied, "is not supplied"},
      {RunState::failed, Verdict::solver_failed, "failed"},
      {RunState::missing, Verdict::not_compared, "has no result"},
      {RunState::out_of_range, Verdict::not_compared, "is outside its declared range"},
  }};
  for (const auto& [role, run] : runs_of(row)) {
    if (!runs.contains(run))
      return {{Verdict::not_compared, fmt::format("the {} {} is missing", role, run)}};
  }
  for (const Obstacle& one : obstacles) {
    for (const auto& [role, run] : runs_of(row)) {
      const RunStatus& status = runs.at(run);
      if (status.state != one.state) continue;
      const std::string detail = status.message.empty() ? "" : ": " + status.message;
      return {{one.verdict, fmt::format("the {} {} {}{}", role, run, one.text, detail)}};
    }
  }
  return std::nullopt;
}

}  // namespace

AllowedRange allowed_by(const GateRow& row) {
  if (row.limit) return {-*row.limit, *row.limit};
  return {row.between->first, row.between->second};
}

Estimate measured(const GateRow& row, const GateEvidence& evidence) {
  if (row.metric == Metric::largest_magnitude) {
    const TimeSeries series = evidence.series(row.candidate, row.quantity);
    require_unit(row, series.unit);
    return {largest_magnitude(series), 0};
  }
  if (is_of_impacts(row.metric)) {
    require_unit(row, "Pa");
    return {evidence.impacts(row.candidate, row), 0};
  }
  if (row.metric == Metric::cost_to_reach) {
    require_unit(row, "s");
    return cost_value(evidence.cost(row));
  }
  const Comparison& comparison = evidence.comparison(row.candidate, row.reference, row.quantity);
  require_unit(row, comparison.unit);
  return metric_value(row.metric, row.mode, comparison);
}

GateOutcome evaluate(const GateRow& row, const std::map<std::string, RunStatus>& runs,
                     const GateEvidence& evidence) {
  if (const auto found = obstacle(row, runs)) return {row, found->first, no_value, found->second};
  try {
    const Estimate value = measured(row, evidence);
    return row.improves_on ? judge_improvement(row, value, evidence)
                           : judge_bound(row, value, evidence);
  } catch (const NotSuppliedError& error) {
    return {row, Verdict::not_supplied, no_value, error.what()};
  } catch (const NotSelectedError& error) {
    return {row, Verdict::not_selected, no_value, error.what()};
  } catch (const std::runtime_error&
               error) {  // ComparisonError and ResultError: there is nothing to compare
    return {row, Verdict::not_compared, no_value, error.what()};
  }
}

int exit_status(const std::vector<GateOutcome>& outcomes) {
  std::vector<Verdict> verdicts;
  for (const GateOutcome& outcome : outcomes) verdicts.push_back(outcome.verdict);
  return exit_status_of(verdicts);
}

int exit_status_of(const std::vector<Verdict>& verdicts) {
  const auto any = [&](Verdict verdict) {
    return std::find(verdicts.begin(), verdicts.end(), verdict) != verdicts.end();
  };
  if (any(Verdict::solver_failed)) return exit_solver_failed;
  if (any(Verdict::violated)) return exit_violated;
  if (any(Verdict::not_compared)) return exit_not_compared;
  if (any(Verdict::inconclusive)) return exit_inconclusive;
  return any(Verdict::pass) ? exit_pass : exit_not_compared;
}

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::violated:
      return "violated";
    case Verdict::inconclusive:
      return "inconclusive";
    case Verdict::solver_failed:
      return "solver failed";
    case Verdict::not_compared:
      return "not compared";
    case Verdict::not_selected:
      return "not selected";
    case Verdict::not_supplied:
      return "not supplied";
  }
  throw std::logic_error("a verdict without a name");
}

std::string state_name(RunState state) {
  switch (state) {
    case RunState::finished:
      return "finished";
    case RunState::failed:
      return "solver failed";
    case RunState::missing:
      return "no result";
    case RunState::not_selected:
      return "not selected";
    case RunState::not_supplied:
      return "not supplied";
    case RunState::out_of_range:
      return "out of range";
  }
  throw std::logic_error("a state without a name");
}

std::string metric_name(Metric metric) {
  switch (metric) {
    case Metric::amplitude_error:
      return "amplitude_error";
    case Metric::phase_lag:
      return "phase_lag";
    case Metric::frequency_error:
      return "frequency_error";
    case Metric::decay_rate:
      return "decay_rate";
    case Metric::decay_error:
      return "decay_error";
    case Metric::normalised_rms:
      return "normalised_rms";
    case Metric::maximum_residual:
      return "maximum_residual";
    case Metric::time_lag:
      return "time_lag";
    case Metric::aligned_rms:
      return "aligned_rms";
    case Metric::largest_magnitude:
      return "largest_magnitude";
    case Metric::impact_time:
      return "impact_time";
    case Metric::plateau_error:
      return "plateau_error";
    case Metric::impact_percentile:
      return "impact_percentile";
    case Metric::cost_to_reach:
      return "cost_to_reach";
  }
  throw std::logic_error("a metric without a name");
}

std::string metric_unit(Metric metric, const std::string& quantity_unit) {
  switch (metric) {
    case Metric::amplitude_error:
    case Metric::frequency_error:
    case Metric::decay_error:
    case Metric::normalised_rms:
    case Metric::aligned_rms:
    case Metric::plateau_error:
    case Metric::impact_percentile:
      return "1";
    case Metric::phase_lag:
      return "deg";
    case Metric::decay_rate:
      return "1/s";
    case Metric::time_lag:
    case Metric::impact_time:
    case Metric::cost_to_reach:
      return "s";
    case Metric::maximum_residual:
    case Metric::largest_magnitude:
      return quantity_unit;
  }
  throw std::logic_error("a metric without a unit");
}

std::string measured_name(const GateRow& row) {
  const std::string name = metric_name(row.metric);
  return row.error ? fmt::format("{} {}", name, in_unit(*row.error, "1")) : name;
}

std::string not_reached_text(const CostAtError& found, const std::string& unit) {
  if (!found.most_exact) return "not reached (no run has a cost and an error)";
  return fmt::format("not reached ({} at {})", in_unit(found.most_exact->error.value, "1"),
                     in_unit(found.most_exact->cost.value, unit));
}

std::string row_name(const GateRow& row) {
  return fmt::format("{}{}, {} {} of {}{}", row.candidate,
                     row.reference.empty() ? "" : " against " + row.reference, row.mode,
                     measured_name(row), row.quantity,
                     row.improves_on ? ", below that of " + *row.improves_on : "");
}

std::string in_unit(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.3g} {}", value, unit);
}

}  // namespace slosh
