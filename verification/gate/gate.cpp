#include "verification/gate/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

// Two errors against one reference, by intervals of their own, and what moves both alike.
struct Improvement {
  Estimate estimate, other;
  double common;      // half width of what the reference and the inputs may be off
  double as_good_at;  // how far off they make both as good

  bool outweighs() const { return std::abs(as_good_at) > common; }  // false for NaN
};

// The estimate must be nearer to zero by more than both intervals together, or its interval must
// hold zero and have a half width below the other's magnitude; and by more than what moves both.
Verdict verdict_on(const Improvement& of) {
  const auto& [estimate, other, common, as_good_at] = of;
  const double gain = std::abs(other.value) - std::abs(estimate.value),
               intervals = std::hypot(estimate.half_width, other.half_width);
  const bool to_zero = std::abs(estimate.value) <= estimate.half_width &&
                       estimate.half_width < std::abs(other.value);
  if (!std::isfinite(gain)) return Verdict::violated;
  if (gain > 0 && (gain > intervals || to_zero) && of.outweighs()) return Verdict::pass;
  return std::abs(gain) < intervals || !of.outweighs() ? Verdict::inconclusive : Verdict::violated;
}

UncertaintyContributions contributions_to(const GateRow& row, const GateEvidence& evidence) {
  return evidence.uncertainty ? evidence.uncertainty(row) : UncertaintyContributions{};
}

// A validation row does not pass while its numerical uncertainty or its reference's is unknown.
Verdict verdict_of_kind(const GateRow& row, Verdict verdict, const std::string& missing) {
  const bool rests_on_unknown = row.kind == RowKind::validation && !missing.empty();
  return verdict == Verdict::pass && rests_on_unknown ? Verdict::inconclusive : verdict;
}

std::string with_missing(const std::string& text, const std::string& missing) {
  return missing.empty() ? text : text + "; not included: " + missing;
}

// What the reference and the inputs may be off: the larger of both runs' or NaN.
double common_to(const UncertaintyContributions& one, const UncertaintyContributions& other) {
  const double a = std::hypot(one.reference.known(), one.input.known()),
               b = std::hypot(other.reference.known(), other.input.known());
  return std::isnan(b) ? b : std::max(a, b);
}

// A reference that is off by d moves errors by d alike, so that errors of the mean -d are as good.
// Two distances it may move by d apart.
double as_good_at(Metric metric, double one, double other) {
  return (other + (metric_entry(metric).blind_to == BlindTo::side ? -one : one)) / 2;
}

std::string outweighed_text(const Improvement& found, const std::string& unit) {
  if (found.outweighs()) return "";
  const std::string off =
      std::isfinite(found.common) ? in_unit(found.common, unit) : "an unknown amount";
  return fmt::format("; the reference and the inputs may be off by {}, and both are as good at {}",
                     off, in_unit(found.as_good_at, unit));
}

// With what each run has of its own beside: its scatter and its discretisation.
Estimate with_own(const Estimate& value, const UncertaintyContributions& of) {
  return {value.value,
          std::hypot(value.half_width, of.time_series.known(), of.discretisation.known())};
}

constexpr double hardly_moves =
    0.95;  // of the error of nothing: a twentieth of the wave, a convention

// Returns whether the error is smaller than that of a candidate that hardly moves: such a candidate
// improves on every run with a larger error.
bool is_better_than_nothing(Metric metric, const Estimate& value) {
  const double nothing = hardly_moves * std::abs(metric_entry(metric).widest.nothing);
  return std::isnan(nothing) || std::abs(value.value) + value.half_width < nothing;
}

// Wide bounds may hold the error of a candidate that hardly moves, though not that of nothing.
RowDoubts like_nothing(const GateRow& row, const Estimate& value) {
  const WidestBound& widest = metric_entry(row.metric).widest;
  const double share = value.value / widest.nothing;
  if (row.improves_on || std::abs(widest.nothing) != 1 ||
      !(share + std::abs(value.half_width) >= hardly_moves))
    return {};
  return {.text = fmt::format("; doubtful: {}", widest.because),
          .keep_from_passing = true,
          .is_doubtful = true};
}

GateOutcome judge_improvement(const GateRow& row, const Estimate& value,
                              const GateEvidence& evidence) {
  GateRow others_row = row;
  others_row.candidate = row.improves_on.value();
  const Estimate other = measured(others_row, evidence);
  const UncertaintyContributions own = contributions_to(row, evidence),
                                 others = contributions_to(others_row, evidence);
  const Improvement found{with_own(value, own), with_own(other, others), common_to(own, others),
                          as_good_at(row.metric, value.value, other.value)};
  const Verdict verdict = verdict_on(found);
  std::string missing = missing_for_validation(own),
              others_missing = missing_for_validation(others);
  if (others_missing != missing && !others_missing.empty())
    missing += (missing.empty() ? "" : "; ") + others_missing;
  const bool is_nothing =
      verdict == Verdict::pass && !is_better_than_nothing(row.metric, found.estimate);
  return {row, is_nothing ? Verdict::inconclusive : verdict_of_kind(row, verdict, missing), value,
          with_missing(fmt::format("|{}| {} |{}| of {}", with_interval(found.estimate, row.unit),
                                   verdict == Verdict::pass ? "<" : "is not clearly <",
                                   with_interval(found.other, row.unit), others_row.candidate) +
                           outweighed_text(found, row.unit) +
                           (is_nothing ? "; a candidate of nothing is as good" : ""),
                       missing)};
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
  throw std::logic_error("an unknown verdict");
}

// Whether the value is NaN because the impact did not occur or the error was not reached.
bool is_lost(const GateRow& row, double value) {
  return std::isnan(value) && (is_of_impacts(row.metric) || is_cost(row.metric));
}

// "not reached (5.7 % at 85 s)": the smallest error that any run has, and its cost.
std::string not_reached_text(const CostAtError& found, const std::string& unit) {
  if (!found.most_exact) return "not reached (no run has a cost and an error)";
  return fmt::format("not reached ({} at {})", in_unit(found.most_exact->error.value, "1"),
                     in_unit(found.most_exact->cost.value, unit));
}

std::string lost_text(const GateRow& row, const GateEvidence& evidence) {
  return is_of_impacts(row.metric) ? "no impact in the candidate's " + row.quantity
                                   : not_reached_text(evidence.cost(row), row.unit);
}

// A limit with all digits that the case file gives it.
std::string as_declared(double limit, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.12g} %", 100 * limit)
                     : fmt::format("{:.12g} {}", limit, unit);
}

// "14 ± 4 % ≤ 20 %", "|-1 %| ≤ 2 %", "3 % is not within 1 % to 2 %", "at most 0.04 % is not ≥ 5 %".
std::string bound_text(const GateRow& row, const ThreeWayOutcome& judged,
                       const GateEvidence& evidence) {
  const std::string shown = is_lost(row, judged.error)
                                ? lost_text(row, evidence)
                                : value_text(row, {judged.error, judged.uncertainty});
  const auto phrase = [&](const char* holds, const char* does_not) {
    switch (judged.verdict) {
      case ThreeWayVerdict::pass:
        return holds;
      case ThreeWayVerdict::fail:
        return does_not;
      case ThreeWayVerdict::inconclusive:
        break;
    }
    return "cannot be distinguished from";
  };
  if (row.limit)
    return fmt::format("{} {} {}", judged.error < 0 ? "|" + shown + "|" : shown,
                       phrase("≤", "is not ≤"), as_declared(*row.limit, row.unit));
  if (std::isinf(allowed_by(row).upper))
    return fmt::format("{} {} {}", shown, phrase("≥", "is not ≥"),
                       as_declared(row.between->first, row.unit));
  return fmt::format("{} {} {} to {}", shown, phrase("within", "is not within"),
                     as_declared(row.between->first, row.unit),
                     as_declared(row.between->second, row.unit));
}

// "; mean over 4 x 3 repeats" for ensembles, with the span of the members' values where there is no
// reference, "; median of 8 repeats" for their impacts, "; 20 repeats" for the distribution of
// their peaks, "" for single runs.
std::string repeats_text(const GateRow& row, const GateEvidence& evidence) {
  if (is_of_repeats(row.metric))
    return fmt::format("; {} repeats{}", ensemble_of(row.candidate, evidence).members.size(),
                       is_p_value(row.metric) ? ", Holm's correction" : "");
  if (!is_of_ensembles(row, evidence)) return "";
  const std::size_t candidates = ensemble_of(row.candidate, evidence).members.size();
  if (is_of_impacts(row.metric)) return fmt::format("; median of {} repeats", candidates);
  if (!row.reference.empty())
    return fmt::format("; mean over {} x {} repeats", candidates,
                       reference_of(row, evidence).members.size());
  const auto [least, most] =
      std::ranges::minmax(measured_pairs(row, evidence), {},
                          [](const std::vector<Estimate>& member) { return member.front().value; });
  return fmt::format("; mean over {} repeats of {} to {}", candidates,
                     in_unit(least.front().value, row.unit), in_unit(most.front().value, row.unit));
}

GateOutcome judge_bound(const GateRow& row, const Estimate& value, const GateEvidence& evidence) {
  UncertaintyContributions contributions = contributions_to(row, evidence);
  contributions.time_series.half_width =
      std::hypot(contributions.time_series.known(), value.half_width);
  const ThreeWayOutcome judged = judge_error(value.value, contributions, allowed_by(row));
  const std::string missing = missing_for_validation(contributions);
  const bool is_limited =
      std::isfinite(judged.uncertainty) && judged.uncertainty == contributions.at_most;
  const char* limited = is_limited ? "; U is limited to what is searched to either side" : "";
  return {row, verdict_of_kind(row, verdict_of(judged.verdict), missing), value,
          with_missing(bound_text(row, judged, evidence) + repeats_text(row, evidence) + limited,
                       missing),
          judged};
}

bool needs_reference(Metric metric) {
  return !is_of_candidate_alone(metric) && !is_of_impacts(metric);
}

struct RoleInRow {
  std::string role, run;
};

// Every member of an ensemble is needed: fewer members would be another ensemble.
std::vector<RoleInRow> runs_of(const GateRow& row, const GateEvidence& evidence) {
  std::vector<RoleInRow> runs;
  const auto add = [&](const char* role, const std::string& named) {
    for (const std::string& run : ensemble_of(named, evidence).members) runs.push_back({role, run});
  };
  add("candidate", row.candidate);
  if (needs_reference(row.metric)) add("reference", row.reference);
  if (row.improves_on) add("run to improve on", *row.improves_on);
  return runs;
}

// Why a run in a state has no series to judge, the most important reason first.
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

std::optional<std::pair<Verdict, std::string>> obstacle_to(
    const GateRow& row, const std::map<std::string, RunStatus>& runs,
    const GateEvidence& evidence) {
  const std::vector<RoleInRow> needed = runs_of(row, evidence);
  for (const auto& [role, run] : needed) {
    if (!runs.contains(run))
      return {{Verdict::not_compared, fmt::format("the {} {} is missing", role, run)}};
  }
  for (const Obstacle& one : obstacles)
    for (const auto& [role, run] : needed)
      if (runs.at(run).state == one.state)  // why a run failed is told of the run, once
        return obstacle_of(fmt::format("the {} {}", role, run),
                           one.state == RunState::failed ? RunStatus{one.state, ""} : runs.at(run));
  return std::nullopt;
}

// When the largest magnitude occurs and over which time it is sought, of an ensemble that of its
// highest member, and a larger one at another time.
struct PlaceOfPeak {
  std::string when, larger_outside;
};

PlaceOfPeak place_of_peak(const GateRow& row, const GateEvidence& evidence) {
  Peak peak{-1, not_a_number}, other{-1, not_a_number};
  TimeSeries series, whole;
  for (const std::string& run : ensemble_of(row.candidate, evidence).members) {
    TimeSeries one = evidence.series(run, row.quantity);
    if (!(largest_of(one).magnitude > peak.magnitude)) continue;
    peak = largest_of(one);
    series = std::move(one);
    if (evidence.history) whole = evidence.history(run, row.quantity);
  }
  if (series.time.empty()) return {};  // NaN
  const double begin = series.time.front(), end = series.time.back();
  for (std::size_t i = 0; i < whole.time.size(); ++i)
    if (whole.time[i] >= begin && whole.time[i] <= end) whole.value[i] = 0;
  if (!whole.time.empty()) other = largest_of(whole);
  PlaceOfPeak place{fmt::format("; at {:.4g} s of {:.4g} to {:.4g} s", peak.time, begin, end), ""};
  if (other.magnitude > peak.magnitude)
    place.larger_outside = fmt::format("; LARGER outside of that time: {} at {:.4g} s",
                                       in_unit(other.magnitude, row.unit), other.time);
  return place;
}

// The time over which a frequency without a reference is measured: it falls as a high wave decays.
std::string span_text(const GateRow& row, const GateEvidence& evidence) {
  return row.metric != Metric::frequency || row.part
             ? ""
             : fmt::format("; over {:g} to {:g} s", evidence.judged.begin, evidence.judged.end);
}

// A single impact scatters, and one run does not tell by how much.
std::string single_run_text(const GateRow& row, const GateEvidence& evidence) {
  const bool is_peak = row.metric == Metric::impact_peak_error ||
                       row.metric == Metric::impulse_error ||
                       (row.metric == Metric::largest_magnitude && find_quantity(row.quantity));
  const EnsembleOfRun runs = ensemble_of(row.candidate, evidence);
  if (!is_peak || runs.exact || runs.members.size() != 1) return "";
  return runs.may_repeat
             ? "; single run: `repeats` of " + row.candidate + " tell how its peaks scatter"
             : "; single run: how its peaks scatter is not known";
}

// What the samples and the runs leave open.
void add_remarks(const std::string& larger_outside, const Estimate& value,
                 const GateEvidence& evidence, GateOutcome& outcome) {
  std::vector<RowDoubts> doubts{{larger_outside}, doubts_of_samples(outcome.row, evidence)};
  if (outcome.verdict == Verdict::pass) doubts.push_back(like_nothing(outcome.row, value));
  if (evidence.doubts_of_runs) doubts.push_back(evidence.doubts_of_runs(outcome.row));
  for (const RowDoubts& one : doubts) {
    outcome.remarks += one.text;
    outcome.is_doubtful |= one.is_doubtful;
    if (one.keep_from_passing && outcome.verdict == Verdict::pass &&
        outcome.row.kind != RowKind::regression)
      outcome.verdict = Verdict::inconclusive;
  }
  outcome.message += outcome.remarks;
}

}  // namespace

AllowedRange allowed_by(const GateRow& row) {
  if (row.limit) return {-*row.limit, *row.limit};
  const bool unbounded = is_p_value(row.metric) && row.between->second >= 1;
  return {row.between->first,
          unbounded ? std::numeric_limits<double>::infinity() : row.between->second};
}

// The interval of a p-value that is small would reach below zero.
std::string value_text(const GateRow& row, const Estimate& value) {
  if (is_p_value(row.metric) && value.half_width >= value.value)
    return "at most " + in_unit(value.value + value.half_width, row.unit);
  return with_interval(value, row.unit);
}

std::optional<AllowedRange> tolerance_of(const CaseDefinition& definition,
                                         const Comparison& comparison, const std::string& mode,
                                         Metric metric) {
  for (const GateRow& row : definition.gate)
    if (row.metric == metric && row.mode == mode && !row.part && (row.limit || row.between) &&
        row.candidate == comparison.candidate && row.reference == comparison.reference &&
        row.quantity == comparison.quantity)
      return allowed_by(row);
  return std::nullopt;
}

std::optional<std::pair<Verdict, std::string>> obstacle_of(const std::string& subject,
                                                           const RunStatus& status) {
  for (const Obstacle& one : obstacles)
    if (status.state == one.state)
      return {{one.verdict, fmt::format("{} {}{}{}", subject, one.text,
                                        status.message.empty() ? "" : ": ", status.message)}};
  return std::nullopt;
}

GateOutcome evaluate(const GateRow& row, const std::map<std::string, RunStatus>& runs,
                     const GateEvidence& evidence) {
  if (const auto found = obstacle_to(row, runs, evidence))
    return {row, found->first, no_value, found->second};
  try {
    const Estimate value = measured(row, evidence);
    GateOutcome outcome = row.improves_on ? judge_improvement(row, value, evidence)
                                          : judge_bound(row, value, evidence);
    const PlaceOfPeak place =
        row.metric == Metric::largest_magnitude ? place_of_peak(row, evidence) : PlaceOfPeak{};
    outcome.message += place.when + span_text(row, evidence) + single_run_text(row, evidence);
    add_remarks(place.larger_outside, value, evidence, outcome);
    if (row.kind == RowKind::regression) outcome.message += " (regression)";
    return outcome;
  } catch (const NotSuppliedError& error) {
    return {row, Verdict::not_supplied, no_value, error.what()};
  } catch (const NotSelectedError& error) {
    return {row, Verdict::not_selected, no_value, error.what()};
  } catch (const std::runtime_error& error) {
    // ComparisonError or ResultError: there is nothing to compare.
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

std::string headline_word(int status) {
  switch (status) {
    case exit_pass:
      return "PASS";
    case exit_violated:
    case exit_solver_failed:
      return "FAIL";
    case exit_not_compared:
      return "NOT COMPARED";
    case exit_inconclusive:
      return "INCONCLUSIVE";
    default:
      throw std::logic_error(fmt::format("no verdict has the exit status {}", status));
  }
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

std::string measured_name(const GateRow& row) {
  const std::string name = metric_name(row.metric);
  if (row.part)
    return fmt::format("{} from {:g} to {:g} s", name, row.part->first, row.part->second);
  return row.error ? fmt::format("{} {}", name, in_unit(*row.error, "1")) : name;
}

std::string row_name(const GateRow& row) {
  return fmt::format("{}{}, {} {} of {}{}", row.candidate,
                     row.reference.empty() ? "" : " against " + row.reference, row.mode,
                     measured_name(row), row.quantity,
                     row.improves_on ? ", below that of " + *row.improves_on : "");
}

std::string in_unit(double value, const std::string& unit) {
  return unit == "1" ? three_digits(100 * value) + " %" : three_digits(value) + " " + unit;
}

std::string with_interval(const Estimate& estimate, const std::string& unit) {
  return unit == "1" ? percent_interval_text(estimate) : interval_text(estimate) + " " + unit;
}

}  // namespace slosh
