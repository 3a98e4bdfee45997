#include "verification/evidence/case_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/row_uncertainty.hpp"
#include "verification/evidence/run_cost.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/gate/distributions/holm_correction.hpp"
#include "verification/gate/distributions/repeated_impacts.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/solvers/external/external_script.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// A record of an earlier run may be that of the candidate's own method.
bool are_of_two_methods(const CaseDefinition& definition, const std::string& one,
                        const std::string& reference) {
  const RunDefinition &candidate = run_named(definition, one),
                      &other = run_named(definition, reference);
  const auto* record = std::get_if<RecordRun>(&other.solver);
  return !is_theory(other) && candidate.solver.index() != other.solver.index() &&
         !(record && record->earlier_run);
}

const RecordRun* record_named(const CaseDefinition& definition, const std::string& run) {
  return std::get_if<RecordRun>(&run_named(definition, run).solver);
}

// Whether the window is long enough for the modes, and the record, where one is given, dense
// enough.
bool resolves(const std::vector<ToneRequest>& modes, TimeWindow window,
              const TimeSeries* record = nullptr) try {
  require_resolved(window, modes);
  if (record) require_sampled(cut_to_window(*record, window), modes);
  return true;
} catch (const ComparisonError&) {
  return false;
}

// Describes where an elevation leaves the tank by more than a twentieth of its height; returns ""
// for all other series.
std::string outside_tank(const CaseDefinition& definition, const std::string& quantity,
                         const std::string& role, const TimeSeries& cut) {
  if (!quantity.starts_with("elevation@") || cut.value.empty()) return "";
  const double lowest = -definition.liquid.fill_depth, height = definition.tank.height,
               margin = height / 20;
  for (std::size_t i = 0; i < cut.value.size(); ++i)
    if (cut.value[i] < lowest - margin || cut.value[i] > lowest + height + margin)
      return fmt::format(
          "the {}'s surface lies {:.3g} m above the still level at {:.4g} s, outside "
          "of the tank, from {:g} to {:g} m",
          role, cut.value[i], cut.time[i], lowest, lowest + height);
  return "";
}

// Throws ResultError for a run without a result, such as a failed member of an ensemble.
const RunResult& result_of(const CaseRuns& runs, const std::string& run) {
  const auto found = runs.results.find(run);
  if (found == runs.results.end()) throw ResultError("there is no result of " + run);
  return found->second;
}

const TimeSeries& series_of(const CaseRuns& runs, const std::string& run,
                            const std::string& quantity) {
  return result_of(runs, run).at(quantity);
}

// The series of a filtered pressure before its filter, which smooths what the sensor cuts off; else
// the quantity itself.
std::string as_read(const CaseRuns& runs, const std::string& run, const std::string& quantity) {
  if (!is_filtered(quantity)) return quantity;
  const std::string raw = quantity.substr(0, quantity.size() - std::strlen(through_filter));
  return has_series(runs, run, raw) ? raw : quantity;
}

TimeSeries moved_series(const CaseRuns& runs, const std::string& run, const std::string& quantity,
                        const Moved& moved) {
  TimeSeries series = series_of(runs, run, quantity);
  if (moved.share == 0) return series;
  const TimeSeries& other = series_of(runs, run, quantity + moved.suffix);
  // Potential flow and the one with fewer nodes have their samples in common.
  const std::size_t common = std::min(series.value.size(), other.value.size());
  for (std::size_t i = 0; i < common; ++i)
    series.value[i] += moved.share * (other.value[i] - series.value[i]);
  return series;
}

}  // namespace

std::vector<ToneRequest> modes_of(const CaseDefinition& definition, int count) {
  std::vector<ToneRequest> modes;
  for (const ForcedMode& forced : forced_modes(definition))
    modes.push_back({forced.name, forced.angular_frequency, false});
  for (const auto& [number, frequency] : excited_frequencies(definition, count))
    modes.push_back({fmt::format("natural_{}", number), frequency, true});
  return modes;
}

std::vector<ToneRequest> fitted_modes(const CaseDefinition& definition) {
  return modes_of(definition, definition.natural_modes);
}

NeededModes modes_needed_by(const std::vector<GateRow>& rows) {
  NeededModes needed{Detail::spectrum_alone};
  bool of_all = false;
  for (const GateRow& row : rows) {
    of_all |= is_cost(row.metric);
    if (of_all || metric_entry(row.metric).fitted != FittedTones::none)
      needed.detail = Detail::fitted_tones;
    needed.names.insert(row.mode);
  }
  if (of_all) needed.names.clear();
  return needed;
}

CaseEvidence::CaseEvidence(const CaseDefinition& definition, const CaseRuns& runs,
                           const FittedComparisons* known, NeededModes needed)
    : definition_(definition),
      runs_(runs),
      known_(known),
      needed_(std::move(needed)),
      modes_(fitted_modes(definition)) {}

CaseEvidence& CaseEvidence::over_time_of(const GateRow& row) {
  const std::pair<double, double> time = judged_time(row, definition_);
  if (time == std::pair(definition_.window_begin, definition_.window_end)) return *this;
  std::shared_ptr<CaseEvidence>& here = other_times_[time];
  if (here) return *here;
  here = std::make_shared<CaseEvidence>(
      other_definitions_.emplace_back(judged_over(row, definition_)), runs_, nullptr, needed_);
  // A row on a mode over so short a time is refused before anything runs.
  if (!resolves(modes_, {time.first, time.second})) here->modes_.clear();
  return *here;
}

const PreparedSeries& CaseEvidence::prepared(const std::string& role, const std::string& run,
                                             const std::string& quantity, const Moved& moved,
                                             TimeWindow window,
                                             const std::vector<ToneRequest>& modes) {
  const PreparedKey key{role, run, quantity + moved.text(), window.begin, window.end, modes.size()};
  if (known_)
    if (const auto known = known_->series.find(key); known != known_->series.end())
      return *known->second;
  std::shared_ptr<const PreparedSeries>& here = fitted_.series[key];
  if (!here) {
    auto made = std::make_shared<PreparedSeries>(role, moved_series(runs_, run, quantity, moved),
                                                 window, modes, needed_.detail);
    if (has_series(runs_, run, quantity + lower_edge))
      made->add_band({series_of(runs_, run, quantity + lower_edge),
                      series_of(runs_, run, quantity + upper_edge)});
    made->readings.rests = resting_values(definition_, quantity);
    if (const std::string raw = as_read(runs_, run, quantity); raw != quantity)
      made->readings.limits = sensor_limits(series_of(runs_, run, raw), window);
    // No sensor reads a theory: it stays at a value where the tank stands still.
    if (is_theory(run_named(definition_, run))) made->readings.limits = {};
    here = std::move(made);
  }
  return *here;
}

// Where a record cannot resolve the modes, the histories alone are compared. A candidate that
// cannot resolve them is refused.
Comparison CaseEvidence::compared(const std::string& candidate, const std::string& reference,
                                  const std::string& quantity, const Moved& moved) {
  const TimeWindow window = compared_window(definition_, reference);
  const RecordRun* record = record_named(definition_, reference);
  if (record && !(window.end > window.begin))
    throw ComparisonError(fmt::format(
        "{}: the record covers {:.6g} s to {:.6g} s; expected a part of {:g} s to {:g} s",
        reference, record->time.front(), record->time.back(), definition_.window_begin,
        definition_.window_end));
  std::vector<ToneRequest> modes;
  if (has_modes(quantity)) modes = modes_;
  if (record && !resolves(modes, window, &series_of(runs_, reference, quantity))) modes.clear();
  Comparison comparison =
      compare(prepared("candidate", candidate, quantity, {}, window, modes),
              prepared("reference", reference, quantity, moved, window, modes), needed_.names);
  if (needed_.with_what_is_beside)
    for (ModeComparison& mode : comparison.modes) mode.beside.reset();
  const auto gap = longest_gap(prepared("candidate", candidate, quantity, {}, window, modes).series,
                               window, definition_.sample_interval);
  if (gap && modes.empty())  // else the modes ask for samples
    comparison.doubts.push_back(fmt::format(
        "the candidate has no sample between {:.4g} and {:.4g} s", gap->begin, gap->end));
  if (record)
    comparison.covered = std::min(
        comparison.covered, covered_share(series_of(runs_, reference, quantity),
                                          {definition_.window_begin, definition_.window_end}));
  for (const auto& [role, run] : {std::pair{"candidate", candidate}, {"reference", reference}})
    if (const std::string doubt = outside_tank(
            definition_, quantity, role, cut_to_window(series_of(runs_, run, quantity), window));
        !doubt.empty())
      comparison.doubts.push_back(doubt);
  // Two methods never give the same digits; a program may print those of a theory that it solves.
  if (comparison.maximum_residual == 0 && !comparison.reference_is_constant &&
      moved.suffix.empty() && are_of_two_methods(definition_, candidate, reference))
    comparison.doubts.push_back("the candidate has the reference's values to the last digit");
  comparison.candidate = candidate;
  comparison.reference = reference;
  return comparison;
}

const Comparison& CaseEvidence::comparison(const std::string& candidate,
                                           const std::string& reference,
                                           const std::string& quantity) {
  return comparison_with(candidate, reference, quantity, {});
}

const Comparison& CaseEvidence::comparison_with(const std::string& candidate,
                                                const std::string& reference,
                                                const std::string& quantity, const Moved& moved) {
  read_.insert({candidate, reference});
  const std::array<std::string, 3> key{candidate, reference, quantity + moved.text()};
  if (known_)
    if (const auto known = known_->of.find(key); known != known_->of.end()) return known->second;
  if (const auto fitted = fitted_.of.find(key); fitted != fitted_.of.end()) return fitted->second;
  return fitted_.of.emplace(key, compared(candidate, reference, quantity, moved)).first->second;
}

std::vector<InputEffect> CaseEvidence::effects_of_inputs(const GateRow& row) {
  if (is_of_band(row.metric)) return input_effects(definition_, runs_, row, measure_with_series());
  const std::string key = row_name(row);
  if (known_)
    if (const auto known = known_->input.find(key); known != known_->input.end())
      return known->second;
  if (const auto found = fitted_.input.find(key); found != fitted_.input.end())
    return found->second;
  return fitted_.input.emplace(key, input_effects(definition_, runs_, row, measure_with_series()))
      .first->second;
}

Contribution CaseEvidence::input_contribution(const GateRow& row, double value) {
  const FindComparison find = [this](const auto&... names) -> const Comparison& {
    return comparison(names...);
  };
  for (const auto& [input, bounds] : runs_.input_bounds) read_.insert(bounds.own);
  return input_uncertainty(effects_of_inputs(row), row,
                           candidate_scale(definition_, row, value, find));
}

// The series stands for all of an ensemble that the run begins.
MeasureWithSeries CaseEvidence::measure_with_series() const {
  return [this](const GateRow& row, const std::string& run, const TimeSeries& series) {
    CaseDefinition definition = definition_;
    std::erase_if(definition.runs, [&](const RunDefinition& one) {
      return is_later_member(one) && one.ensemble == run;
    });
    CaseRuns replaced;
    for (const RunDefinition& one : definition.runs) {
      const std::string& named = one.ensemble.empty() ? one.name : one.ensemble;
      const auto result = runs_.results.find(one.name);
      const bool is_needed = named == row.candidate || named == row.reference || is_record(one);
      if (!is_needed || result == runs_.results.end()) continue;
      replaced.results[one.name] = judged_part(result->second, row.quantity);
      replaced.status[one.name] = runs_.status.at(one.name);
    }
    for (TimeSeries& one : replaced.results.at(run).series)
      if (one.name == row.quantity) one = series;
    NeededModes needed = modes_needed_by({row});
    needed.with_what_is_beside = true;
    CaseEvidence evidence(definition, replaced, nullptr, std::move(needed));
    return measured(row, evidence.gate_evidence());
  };
}

const Estimate& CaseEvidence::of_repeats(const std::vector<std::string>& members,
                                         const GateRow& row) {
  read_.insert(members.begin(), members.end());
  const std::string key = row_name(row);
  if (const auto found = of_repeats_.find(key); found != of_repeats_.end()) return found->second;
  std::vector<const TimeSeries*> pressures;
  for (const std::string& run : members) pressures.push_back(&series_of(runs_, run, row.quantity));
  return of_repeats_
      .emplace(key,
               repeated_impact_metric(
                   row, pressures, series_of_record(definition_, runs_, row.quantity), definition_))
      .first->second;
}

// A row of the family that cannot be compared tests nothing, so that it is not counted.
Estimate CaseEvidence::corrected_p_value(const std::vector<std::string>& members,
                                         const GateRow& row) {
  std::vector<Estimate> family{of_repeats(members, row)};
  for (const GateRow& other : rest_of_family(row, definition_.gate)) {
    try {
      family.push_back(of_repeats(members, other));
    } catch (const std::runtime_error&) {
      continue;  // ComparisonError or ResultError
    }
  }
  if (std::isnan(family.front().value)) return family.front();
  return holm_corrected(family, 0);
}

// A run that is not sound keeps the row from passing, whether the row names it or rests on it, but
// for a row on what the run records of itself, such as its energy budget, which judges just that.
// What it does later is no doubt of its start.
RowDoubts CaseEvidence::doubts_of_runs(const GateRow& row, const std::set<std::string>& rests_on) {
  RowDoubts doubts;
  std::set<std::string> named{row.candidate, row.reference, row.improves_on.value_or("")};
  named.erase("");
  for (const std::string& one : named)
    if (const std::string doubt = script_doubt(run_named(definition_, one), definition_);
        !doubt.empty()) {
      doubts.text += "; doubtful: " + doubt;
      doubts.is_doubtful = true;
    }
  if (row.metric == Metric::mean_offset &&
      counts_from_its_first_value(definition_, row.candidate, row.quantity))
    doubts.text +=
        "; the candidate counts from its first value, so that an offset at the start is not "
        "seen";
  named.insert(rests_on.begin(), rests_on.end());
  const std::string unsound = row.metric == Metric::initial_value
                                  ? std::string()
                                  : soundness_doubt(definition_, runs_, named);
  const bool is_of_itself = !row.quantity.empty() && !find_quantity(row.quantity);
  if (!unsound.empty()) doubts = {doubts.text + "; doubtful: " + unsound, !is_of_itself, true};
  if (!is_cost(row.metric)) return doubts;
  const RowDoubts of_cost = left_out_as_compiling(definition_, runs_, row);
  doubts.text += of_cost.text;
  doubts.is_doubtful |= of_cost.is_doubtful;
  return doubts;
}

GateEvidence CaseEvidence::gate_evidence() {
  const FindComparison find = [this](const std::string& candidate, const std::string& reference,
                                     const std::string& quantity) -> const Comparison& {
    return comparison(candidate, reference, quantity);
  };
  const FindSeries find_series = [this](const std::string& run, const std::string& quantity) {
    read_.insert(run);
    return cut_to_window(series_of(runs_, run, quantity),
                         {definition_.window_begin, definition_.window_end});
  };
  const FindHistory history = [this](const std::string& run, const std::string& quantity) {
    read_.insert(run);
    return series_of(runs_, run, quantity);
  };
  const MeasureImpacts measure_impacts = [this](const std::string& run, const GateRow& of) {
    read_.insert(run);
    return impact_metric(of.metric, of.mode, series_of(runs_, run, of.quantity),
                         series_of_record(definition_, runs_, of.quantity), definition_);
  };
  const MeasureCost cost = [this, find](const GateRow& row) {
    return cost_to_reach(definition_, runs_, row, find);
  };
  const MeasureFields fields = [this](const GateRow& row) {
    read_.insert({row.candidate, row.reference});
    return field_metric(row, result_of(runs_, row.candidate), result_of(runs_, row.reference),
                        definition_);
  };
  const FindEnsemble ensemble = [this](const std::string& run) {
    const RunDefinition& first = run_named(definition_, run);
    return EnsembleOfRun{members_of(definition_, run), !is_simulation(first), may_repeat(first)};
  };
  const MeasureRepeats repeats = [this](const std::vector<std::string>& members,
                                        const GateRow& row) {
    return is_p_value(row.metric) ? corrected_p_value(members, row) : of_repeats(members, row);
  };
  const GateEvidence evidence{find,     find_series, measure_impacts, {},     cost,
                              ensemble, history,     fields,          repeats};
  const auto against_moved = [this, evidence](const GateRow& row, const std::string& suffix,
                                              double share) {
    GateEvidence moved = evidence;
    moved.comparison = [&](const std::string& candidate, const std::string& reference,
                           const std::string& quantity) -> const Comparison& {
      return comparison_with(candidate, reference, quantity,
                             reference == row.reference ? Moved{suffix, share} : Moved{});
    };
    return measured(row, moved);
  };
  const RowMeasures measures{
      .comparison = find,
      .measure = [evidence](const GateRow& row) { return measured(row, evidence); },
      .measure_against_moved = against_moved,
      .input =
          [this, evidence](const GateRow& row) {
            return input_contribution(row, measured(row, evidence).value);
          },
      .pairs = [evidence](const GateRow& row) { return measured_pairs(row, evidence); },
      .measure_with = measure_with_series()};
  const FindUncertainty uncertainty = [this, measures](const GateRow& row) {
    return row_uncertainty(definition_, runs_, row, measures);
  };
  const DoubtRuns doubts = [this, cost](const GateRow& row) {
    if (!is_cost(row.metric)) return doubts_of_runs(row, read_);
    const std::vector<std::string> runs = cost(row).rests_on;
    return doubts_of_runs(row, {runs.begin(), runs.end()});
  };
  return {find,
          find_series,
          measure_impacts,
          uncertainty,
          cost,
          ensemble,
          history,
          fields,
          repeats,
          doubts,
          definition_.sample_interval,
          {definition_.window_begin, definition_.window_end},
          [this](const std::string& run, const std::string& quantity) {
            return series_of(runs_, run, as_read(runs_, run, quantity));
          },
          [this](const std::string& quantity) { return resting_values(definition_, quantity); }};
}

GateOutcome CaseEvidence::judge(const GateRow& row) {
  CaseEvidence& here = over_time_of(row);
  here.read_.clear();
  GateOutcome outcome = evaluate(row, runs_.status, here.gate_evidence());
  outcome.measured_with = std::exchange(here.read_, {});
  return outcome;
}

}  // namespace slosh
