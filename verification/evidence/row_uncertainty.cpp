#include "verification/evidence/row_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/evidence/repeat_spread.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

// The limit of a regression row was measured with the same runs against the same reference, so that
// the uncertainty cancels.
Contribution as_when_measured(const char* how) {
  return {0, fmt::format("as large as when the limit was measured, {}", how)};
}

// The numerical uncertainty of the run in this role, from its refinement paths.
Contribution numerical(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       Role role, const RowMeasures& measures) {
  if (row.kind == RowKind::regression) return as_when_measured("with the same step");
  const Refinements found =
      refined_metrics(definition, runs, row, role, {measures.measure, measures.measure_with});
  const std::string unknown = fmt::format("{}", fmt::join(found.unknown, "; "));
  if (!found.paths.empty()) {
    std::vector<std::string> names;
    for (const RefinedMetric& path : found.paths)
      names.push_back(path.path + (path.values.size() == 2 ? " (two values only)"
                                   : takes_other_order(path.found)
                                       ? " of order " + observed_order_text(path.found)
                                       : ""));
    Contribution counted{numerical_uncertainty(found.paths),
                         fmt::format("refinement of the {}", fmt::join(names, ", "))};
    counted.not_counted = unknown;
    return counted;
  }
  return Contribution::unknown(fmt::format(
      "the numerical uncertainty of the {} {} is unknown; {}",
      role == Role::candidate ? "candidate" : "reference",
      role == Role::candidate ? row.candidate : row.reference,
      unknown.empty() ? "a [[refinement]] of it with another step would provide it" : unknown));
}

Contribution of_record(const CaseRuns& runs, const GateRow& row, const RecordRun& record,
                       const RowMeasures& measures) {
  if (row.kind == RowKind::regression) return as_when_measured("against the same record");
  if (is_of_band(row.metric))
    return {0,
            "the band is what the experiment's repeats span; how well its edges are known is "
            "not counted"};
  if (!record.uncertainty)
    return Contribution::unknown(fmt::format(
        "the record {} declares no uncertainty; the key `uncertainty` of its run would provide it",
        row.reference));
  const Comparison& comparison = measures.comparison(row.candidate, row.reference, row.quantity);
  return {record_uncertainty(row, runs.results.at(row.reference).at(row.quantity), comparison,
                             *record.uncertainty, measures.measure_with),
          "the record's declared uncertainty"};
}

// What a p-value says of a difference does not depend on where the difference comes from.
constexpr const char* of_the_ensemble = "the test is of the ensemble as it is";

// The uncertainty of the published figures of the impacts.
Contribution of_impacts(const ImpactsDefinition& impacts, const GateRow& row, double value) {
  const auto half_width = [&](const std::optional<double>& declared, double scale,
                              const char* key) {
    return declared ? Contribution(*declared * scale, "declared in [impacts]")
                    : Contribution::unknown(fmt::format(
                          "[impacts] declares no uncertainty; its key {} would provide it", key));
  };
  if (row.metric == Metric::plateau_error)
    return half_width(impacts.plateau_half_width, std::abs(1 + value) / impacts.plateau,
                      "plateau_half_width_Pa");
  const auto of_impact = [&](const std::vector<double>& values) {
    for (std::size_t n = 0; n < values.size(); ++n)
      if (row.mode == fmt::format("impact_{}", n + 1)) return values[n];
    return not_a_number;
  };
  if (row.metric == Metric::impact_arrival)
    return half_width(impacts.arrivals.value().half_width, 1, "arrivals_half_width_s");
  if (row.metric == Metric::impact_peak_error)
    return half_width(impacts.peaks_half_width, std::abs(1 + value) / of_impact(impacts.peak_means),
                      "peaks_half_width_Pa");
  if (row.metric == Metric::impulse_error)
    return half_width(impacts.impulses.value().half_width,
                      std::abs(1 + value) / of_impact(impacts.impulses->values),
                      "impulses_half_width_Pa_s");
  throw std::logic_error("no uncertainty is published for " + metric_name(row.metric));
}

// What a theory leaves beside its series, and the multiple of the distance that counts.
struct LeftBeside {
  const char *suffix, *text;
  double factor;
};
constexpr LeftBeside left_beside_theory[] = {
    {coarser, "the same potential flow with fewer nodes", 1},
    {finer, "more modes", reliable_safety_factor},
    {nonlinear, "the third order", 1}};

bool leaves(const RunDefinition& run, std::string_view suffix) {
  const auto& all = solver_kind(run).leaves;
  return std::any_of(all.begin(), all.end(), [&](const char* one) { return one && one == suffix; });
}

Contribution of_theory(const CaseRuns& runs, const RunDefinition& reference, const GateRow& row,
                       const RowMeasures& measures) {
  if (row.kind == RowKind::regression) return as_when_measured("against the same theory");
  const Estimate own = measures.measure(row);
  double squares = 0;
  std::vector<std::string> counted;
  for (const auto& [suffix, text, factor] : left_beside_theory) {
    if (!leaves(reference, suffix)) continue;
    if (!has_series(runs, reference.name, row.quantity + suffix))
      return Contribution::unknown(
          fmt::format("{} of {} that {} leaves is unknown: the series {}{} "
                      "is missing",
                      text, row.quantity, reference.name, row.quantity, suffix));
    double largest = 0;
    // A metric without a fit need not change steadily; its interval is what it cannot tell apart.
    const bool is_fitted = metric_entry(row.metric).fitted != FittedTones::none;
    std::set<double> shares{factor, -factor};
    if (!is_fitted) shares.insert({1, -1});
    for (const double share : shares) {
      const Estimate moved = measures.measure_against_moved(row, suffix, share);
      double change = moved.value - own.value;
      if (is_angle(row.metric)) change = std::remainder(change, 360);
      change = std::abs(change);
      if (!is_fitted) change += std::max(0.0, moved.half_width - own.half_width);
      largest = std::isnan(change) ? change : std::max(largest, change);
      if (std::isnan(largest)) break;
    }
    squares += largest * largest;
    counted.push_back(fmt::format("{} {}", text, in_unit(largest, row.unit)));
  }
  return {std::sqrt(squares), fmt::format("{}", fmt::join(counted, ", "))};
}

Contribution of_reference(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const RowMeasures& measures) {
  if (is_of_repeats(row.metric))
    return {0, "the finite number of the experiment's repeats is in the metric's own interval"};
  if (is_of_impacts(row.metric))
    return row.kind == RowKind::regression
               ? as_when_measured("against the same published impacts")
               : of_impacts(definition.impacts.value(), row, measures.measure(row).value);
  if (row.reference.empty()) return {0, "the row has no reference"};
  if (metric_entry(row.metric).fitted == FittedTones::of_candidate)
    return {0, "the decay is the candidate's own: the reference only provides its frequency"};
  const RunDefinition& reference = run_named(definition, row.reference);
  if (const auto* record = std::get_if<RecordRun>(&reference.solver))
    return of_record(runs, row, *record, measures);
  if (is_theory(reference)) return of_theory(runs, reference, row, measures);
  return numerical(definition, runs, row, Role::reference, measures);
}

// What the inputs' intervals do to the metric of one member, where each member draws them. The
// interval of the mean, which falls with their number, is that of the time series.
Contribution of_members(const GateRow& row, const RowMeasures& measures) {
  if (is_of_repeats(row.metric))
    return {0, "the ensemble draws its inputs: they are in its own scatter"};
  std::vector<double> values;
  for (const std::vector<Estimate>& against : measures.pairs(row)) {
    values.push_back(0);
    for (const Estimate& one : against)
      values.back() += one.value / static_cast<double>(against.size());
  }
  return {half_width_of_95_percent(values),
          fmt::format("the scatter of the {} members, which draw the inputs", values.size())};
}

Contribution of_inputs(const CaseDefinition& definition, const GateRow& row,
                       const RowMeasures& measures) {
  if (is_p_value(row.metric)) return {0, of_the_ensemble};
  if (!rests_on_experiment(definition, row))
    return {0, "both sides have the same tank, liquid and motion"};
  if (row.kind == RowKind::regression) return as_when_measured("with the same inputs");
  if (run_named(definition, row.candidate).varies_inputs) return of_members(row, measures);
  return measures.input(row);
}

// An arrival is sought within a quarter of the period: its uncertainty is no larger, however the
// numbers that it is estimated from scatter.
void limit_to_search_window(const CaseDefinition& definition, UncertaintyContributions& found) {
  found.at_most = definition.impacts.value().period / 4;
  for (Contribution* one : {&found.discretisation, &found.time_series, &found.input})
    if (one->half_width) one->half_width = std::min(*one->half_width, found.at_most);
}

}  // namespace

bool rests_on_experiment(const CaseDefinition& definition, const GateRow& row) {
  if (row.reference.empty()) return is_of_impacts(row.metric);
  return is_record(run_named(definition, row.reference));
}

bool rests_on_input_bounds(const CaseDefinition& definition, const GateRow& row) {
  return row.kind == RowKind::validation && rests_on_experiment(definition, row) &&
         !is_of_repeats(row.metric) && !is_cost(row.metric) &&
         !run_named(definition, row.candidate).varies_inputs;
}

UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const RowMeasures& measures) {
  UncertaintyContributions found;
  if (is_cost(row.metric)) return found;
  found.time_series = repeat_spread(definition, runs, row, measures.measure, measures.comparison);
  found.reference = of_reference(definition, runs, row, measures);
  if (is_p_value(row.metric))
    found.discretisation = {0, of_the_ensemble};
  else if (rests_on_experiment(definition, row))
    found.discretisation = numerical(definition, runs, row, Role::candidate, measures);
  else
    found.discretisation = {
        0, row.reference.empty()
               ? "not counted: a row without a reference judges the run with the spacing it has"
               : "the candidate's discretisation error is what the row measures"};
  found.input = of_inputs(definition, row, measures);
  if (row.metric == Metric::impact_arrival) limit_to_search_window(definition, found);
  return found;
}

}  // namespace slosh
