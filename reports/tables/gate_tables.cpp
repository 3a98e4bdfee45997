#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/evidence/case_evidence.hpp"
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

std::vector<double> values_of(const std::vector<Estimate>& estimates) {
  std::vector<double> values;
  for (const Estimate& estimate : estimates) values.push_back(estimate.value);
  return values;
}

// The standard deviation, over the members of one side, of the mean over the other side.
std::string spread_text(const Pairs& pairs, const std::string& unit) {
  if (pairs.size() < 2) return "single run";
  std::vector<double> means;
  for (const auto& of_member : pairs) means.push_back(mean(values_of(of_member)));
  const double n = static_cast<double>(means.size());
  return in_unit(rms(without_mean(means)) * std::sqrt(n / (n - 1)), unit);
}

std::vector<std::string> line_of(const GateOutcome& outcome, const Pairs& pairs) {
  const GateRow& row = outcome.row;
  double least = outcome.value.value, most = least;
  for (const auto& of_candidate : pairs)
    for (const double value : values_of(of_candidate)) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  return {row_name(row),
          fmt::format("{} x {}", pairs.size(), pairs.front().size()),
          with_interval(outcome.value, row.unit),
          spread_text(pairs, row.unit),
          row.reference.empty() ? "" : spread_text(transposed(pairs), row.unit),
          fmt::format("{} to {}", in_unit(least, row.unit), in_unit(most, row.unit)),
          verdict_name(outcome.verdict)};
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

Table gate_table(const CaseAssessment& assessment) {
  const std::string& name = assessment.definition.name;
  Table table{
      case_id(name) + "-gate",
      "Gate rows",
      "A row does not pass where a value is NaN, a series ends early, or the reference is "
      "missing or out of its range. The reason for a limit is told once where the rows that "
      "follow have the same, and at each judged row that does not pass.",
      {"verdict", "candidate", "reference", "metric", "result"},
      {}};
  std::string last;
  for (const GateOutcome& outcome : assessment.gate) {
    table.row_ids.push_back(case_row_id(name, table.rows.size()));
    table.rows.push_back({verdict_name(outcome.verdict), outcome.row.candidate,
                          reference_text(outcome.row), metric_text(outcome.row), outcome.message});
    const bool fails = is_judged(outcome.verdict) && outcome.verdict != Verdict::pass;
    const std::string reason = limit_reason(outcome.row.reason, outcome.row.source);
    table.reasons.push_back(reason == last && !fails ? "" : reason);
    last = reason;
  }
  return table;
}

std::optional<Table> ensemble_table(const CaseAssessment& assessment) {
  CaseEvidence known(assessment.definition, assessment.runs, &assessment.fitted);
  Table table{
      case_id(assessment.definition.name) + "-ensembles",
      "Ensembles",
      "Gate rows judged on ensembles of runs with perturbed initial states: the mean over all "
      "pairs of candidate and reference (of impacts the median over the candidates) with its 95 % "
      "interval (from the scatter of the repeats alone), the standard deviations (sd) over the "
      "candidates and over the "
      "references, and the range of all pairs. Figures show the first member of each ensemble.",
      {"row", "candidates x references", "mean", "sd of candidates", "sd of references", "range",
       "verdict"},
      {}};
  for (const GateOutcome& outcome : assessment.gate) {
    const GateEvidence evidence = known.over_time_of(outcome.row).gate_evidence();
    if (is_judged(outcome.verdict) && is_of_ensembles(outcome.row, evidence))
      table.rows.push_back(line_of(outcome, measured_pairs(outcome.row, evidence)));
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

}  // namespace slosh
