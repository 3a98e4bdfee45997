#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

using reports::Table;

using Pairs = std::vector<std::vector<Estimate>>;  // [candidate][reference]

Pairs transposed(const Pairs& pairs) {
  Pairs turned(pairs.front().size());
  for (const std::vector<Estimate>& row : pairs)
    for (std::size_t j = 0; j < row.size(); ++j) turned[j].push_back(row[j]);
  return turned;
}

// The standard deviation, over the members of one side, of the mean over the other side.
std::string spread_text(const Pairs& pairs, const std::string& unit) {
  if (pairs.size() < 2) return "single run";
  std::vector<double> means;
  for (const std::vector<Estimate>& of_member : pairs) {
    std::vector<double> values;
    for (const Estimate& estimate : of_member) values.push_back(estimate.value);
    means.push_back(mean(values));
  }
  const double n = static_cast<double>(means.size());
  return in_unit(rms(without_mean(means)) * std::sqrt(n / (n - 1)), unit);
}

TableRow ensemble_row(const GateOutcome& outcome, const Pairs& pairs) {
  const GateRow& row = outcome.row;
  double least = outcome.value.value, most = least;
  for (const auto& of_candidate : pairs)
    for (const Estimate& estimate : of_candidate) {
      least = std::min(least, estimate.value);
      most = std::max(most, estimate.value);
    }
  return {row_name(row),
          fmt::format("{} x {}", pairs.size(), pairs.front().size()),
          with_interval(outcome.value, row.unit),
          spread_text(pairs, row.unit),
          row.reference.empty() ? "" : spread_text(transposed(pairs), row.unit),
          fmt::format("{} to {}", in_unit(least, row.unit), in_unit(most, row.unit)),
          verdict_name(outcome.verdict)};
}

TableRow path_row(const RefinedMetric& path, const GateRow& row) {
  TableRow values;
  for (const ValueAtStep& one : path.values) values.push_back(in_unit(one.value, row.unit));
  return {path.path,
          fmt::format("{}, {}", row.candidate, metric_text(row)),
          fmt::format("{}", fmt::join(path.runs, ", ")),
          fmt::format("{}", fmt::join(values, ", ")),
          path.values.size() == 2 ? "two values" : behaviour_name(path.found.behaviour),
          observed_order_text(path.found),
          in_unit(path.found.extrapolated, row.unit),
          "± " + in_unit(path.found.uncertainty, row.unit)};
}

std::string half_width_text(const Contribution& contribution, const std::string& unit) {
  return contribution.half_width ? "± " + in_unit(*contribution.half_width, unit) : "unknown";
}

std::string contributions_text(const ThreeWayOutcome& judged, const std::string& unit) {
  const UncertaintyContributions& of = judged.contributions;
  TableRow parts;
  for (const auto& [name, one] : {std::pair{"time series", &of.time_series},
                                  {"reference", &of.reference},
                                  {"discretisation", &of.discretisation},
                                  {"input", &of.input}}) {
    if (!one->half_width) parts.push_back(fmt::format("{} unknown", name));
    if (one->known() != 0) parts.push_back(fmt::format("{} {}", name, in_unit(one->known(), unit)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Returns the number of repeats whose mean has an interval narrower by the root of the factor.
std::string more_repeats(std::size_t repeats, double factor) {
  const auto half_width = [](std::size_t count) {
    const auto n = static_cast<double>(count);
    return t95(n - 1) / std::sqrt(n);
  };
  std::size_t needed = repeats + 1;
  while (needed < most_repeats && half_width(needed) > half_width(repeats) / std::sqrt(factor))
    ++needed;
  return fmt::format("{}{} repeats of the candidate in place of {}, if they scatter alike",
                     needed == most_repeats ? "at least " : "", needed, repeats);
}

}  // namespace

std::string metric_text(const GateRow& row) {
  std::string metric = measured_name(row);
  std::replace(metric.begin(), metric.end(), '_', ' ');
  return (row.mode == "whole" ? "" : row.mode + " ") + metric + " of " + row.quantity;
}

std::string reference_text(const GateRow& row) {
  if (is_of_impacts(row.metric)) return "published impacts";
  return row.reference.empty() ? "none" : row.reference;
}

std::vector<Table> gate_tables(const CaseAssessment& assessment) {
  const std::string& name = assessment.definition.name;
  Table open = case_table(
      assessment.definition, "gate", "Gate rows that do not pass, or are in doubt",
      "A row does not pass where a value is NaN, a series ends early, or the reference is "
      "missing or out of its range. The reason for a limit is told once where the rows that "
      "follow have the same, and at each judged row that does not pass.",
      {"verdict", "candidate", "reference", "metric", "result"});
  Table passing = open;
  passing.id += "-passing";
  passing.title = "Gate rows that pass";
  passing.is_folded = true;
  std::vector<std::size_t> worst_first(assessment.gate.size());
  std::iota(worst_first.begin(), worst_first.end(), 0);
  std::ranges::stable_sort(worst_first, std::greater(),
                           [&](std::size_t i) { return severity(assessment.gate[i].verdict); });
  std::string last;
  for (const std::size_t i : worst_first) {
    const GateOutcome& outcome = assessment.gate[i];
    Table& table = outcome.verdict == Verdict::pass && !outcome.is_doubtful ? passing : open;
    if (table.rows.empty()) last = "";
    table.row_ids.push_back(case_row_id(name, i));
    table.rows.push_back({verdict_name(outcome.verdict), outcome.row.candidate,
                          reference_text(outcome.row), metric_text(outcome.row), outcome.message});
    const bool fails = is_judged(outcome.verdict) && outcome.verdict != Verdict::pass;
    const std::string reason = limit_reason(outcome.row.reason, outcome.row.source);
    table.reasons.push_back(reason == last && !fails ? "" : reason);
    last = reason;
  }
  std::vector<Table> tables{std::move(open), std::move(passing)};
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

Table ensemble_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "ensembles", "Ensembles",
      "Gate rows judged on ensembles of runs with perturbed initial states: the mean over all "
      "pairs of candidate and reference (of impacts the median over the candidates) with its 95 % "
      "interval (from the scatter of the repeats alone), the standard deviations (sd) over the "
      "candidates and over the "
      "references, and the range of all pairs. Figures show the first member of each ensemble.",
      {"row", "candidates x references", "mean", "sd of candidates", "sd of references", "range",
       "verdict"});
  CaseEvidence known(assessment.definition, assessment.runs, &assessment.fitted);
  for (const GateOutcome& outcome : assessment.gate) {
    const GateEvidence evidence = known.over_time_of(outcome.row).gate_evidence();
    if (is_judged(outcome.verdict) && is_of_ensembles(outcome.row, evidence))
      table.rows.push_back(ensemble_row(outcome, measured_pairs(outcome.row, evidence)));
  }
  return table;
}

std::string remedy_text(const CaseDefinition& definition, const GateOutcome& outcome) {
  if (outcome.verdict != Verdict::inconclusive || !outcome.judgement) return "";
  const ThreeWayOutcome& judged = *outcome.judgement;
  TableRow ways;
  if (const auto repeats = longer_window(judged); repeats && is_cost(outcome.row.metric))
    return fmt::format("{:.3g} times as many timings", repeats->factor);
  const std::size_t repeats = members_of(definition, outcome.row.candidate).size();
  if (const auto window = longer_window(judged); window && repeats > 1)
    ways.push_back(more_repeats(repeats, window->factor));
  else if (window)
    ways.push_back(fmt::format("a window {:.3g} times as long, at {:.3g} times the cost",
                               window->factor, window->cost_ratio));
  if (const auto step = finer_step(judged, 1))
    ways.push_back(fmt::format("steps {:.3g} times as fine, at {:.3g} times the cost (first order)",
                               step->factor, step->cost_ratio));
  if (const std::string missing = missing_for_validation(judged.contributions); !missing.empty())
    ways.push_back(missing);
  if (ways.empty())
    return fmt::format("no single finer or longer run is enough; the largest part is the {}",
                       dominant_contribution(judged.contributions));
  return fmt::format("{}", fmt::join(ways, "; or "));
}

std::string uncertainties_text(const ThreeWayOutcome& judged, const std::string& unit) {
  const UncertaintyContributions& of = judged.contributions;
  return fmt::format("u_num {}, u_input {}, u_reference {}",
                     half_width_text(of.discretisation, unit), half_width_text(of.input, unit),
                     half_width_text(of.reference, unit));
}

Table uncertainty_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "uncertainties", "Uncertainties of the gate rows",
      "Half widths of 95 % intervals after ASME V&V 20. u_num: discretisation of the candidate; "
      "u_input: inputs taken from the experiment; u_reference: the reference; time series: finite "
      "length of the series and scatter of repeats. The interval of the result combines those "
      "that are known: the root of the sum of their squares.",
      {"row", "kind", "result", "u_num", "u_input", "u_reference", "time series", "basis of u_num",
       "basis of u_input", "basis of u_reference"});
  for (const GateOutcome& outcome : assessment.gate) {
    if (!outcome.judgement) continue;
    const std::string& unit = outcome.row.unit;
    const UncertaintyContributions& of = outcome.judgement->contributions;
    table.rows.push_back(
        {row_name(outcome.row), kind_name(outcome.row.kind),
         with_interval({outcome.value.value, outcome.judgement->uncertainty}, unit),
         half_width_text(of.discretisation, unit), half_width_text(of.input, unit),
         half_width_text(of.reference, unit), half_width_text(of.time_series, unit),
         of.discretisation.basis, of.input.basis, of.reference.basis});
  }
  return table;
}

Table refinement_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "refinement", "Numerical uncertainty",
      "Metrics over runs that differ in one number only, coarse to fine. Behaviour, order, "
      "extrapolated value and 95 % uncertainty after Celik et al. 2008 and Eca & Hoekstra 2014. "
      "Two values have no order: the error is estimated from their difference as if it fell with "
      "the first power of the step, and the uncertainty is three times that estimate, but at least "
      "three times the difference.",
      {"path", "row", "runs", "values", "behaviour", "order", "extrapolated", "uncertainty"});
  CaseEvidence known(assessment.definition, assessment.runs, &assessment.fitted);
  for (const GateOutcome& outcome : assessment.gate) {
    const GateRow& row = outcome.row;
    if (!std::isfinite(outcome.value.value) || is_cost(row.metric) || is_p_value(row.metric))
      continue;  // the cost rests on all runs of a path together, a p-value has no discretisation
    CaseEvidence& evidence = known.over_time_of(row);
    const GateEvidence gate = evidence.gate_evidence();
    const MeasureRow measure = [&](const GateRow& one) { return measured(one, gate); };
    for (const Role role : {Role::candidate, Role::reference})
      for (const RefinedMetric& path :
           refined_metrics(assessment.definition, assessment.runs, row, role,
                           {measure, evidence.measure_with_series()})
               .paths)
        if (TableRow cells = path_row(path, row);
            std::ranges::find(table.rows, cells) == table.rows.end())
          table.rows.push_back(std::move(cells));
  }
  return table;
}

Table remedy_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "remedies", "What would make inconclusive rows conclusive",
      "Half widths of 95 % intervals. The estimate assumes that the value itself stays the same; a "
      "finer or longer run also moves the value, so plan for at least this effort.",
      {"row", "result", "uncertainty from", "conclusive below", "what would reach it"});
  for (const GateOutcome& outcome : assessment.gate) {
    if (outcome.verdict != Verdict::inconclusive || !outcome.judgement) continue;
    const ThreeWayOutcome& judged = *outcome.judgement;
    table.rows.push_back({row_name(outcome.row), outcome.message,
                          contributions_text(judged, outcome.row.unit),
                          "± " + in_unit(judged.conclusive_uncertainty, outcome.row.unit),
                          remedy_text(assessment.definition, outcome)});
  }
  return table;
}

}  // namespace slosh
