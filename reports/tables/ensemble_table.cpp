#include "reports/tables/ensemble_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

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

// The standard deviation over a side's members of the mean over the other side's.
std::string spread_text(const Pairs& pairs, const std::string& unit) {
  if (pairs.size() < 2) return "of one";
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
          in_unit(outcome.value.value, row.unit),
          in_unit(outcome.value.half_width, row.unit),
          spread_text(pairs, row.unit),
          row.reference.empty() ? "" : spread_text(transposed(pairs), row.unit),
          fmt::format("{} to {}", in_unit(least, row.unit), in_unit(most, row.unit)),
          verdict_name(outcome.verdict)};
}

}  // namespace

std::optional<reports::Table> ensemble_table(const CaseAssessment& assessment) {
  CaseEvidence known(assessment.definition, assessment.runs, &assessment.fitted);
  const GateEvidence evidence = known.gate_evidence();
  reports::Table table{
      assessment.definition.name + "-ensembles",
      "Ensembles",
      "Rows that are judged on repeats with disturbed starts: the mean over all pairs of candidate "
      "and reference and its 95 % interval, which rests on the spread of the repeats alone; beside "
      "them the standard deviations over the candidates and over the references, and the range of "
      "all pairs. Figures show the first of each ensemble.",
      {"row", "candidates x references", "mean", "half width", "sd of candidates",
       "sd of references", "range", "verdict"},
      {}};
  for (const GateOutcome& outcome : assessment.gate)
    if (is_judged(outcome.verdict) && is_of_ensembles(outcome.row, evidence))
      table.rows.push_back(line_of(outcome, measured_pairs(outcome.row, evidence)));
  if (table.rows.empty()) return std::nullopt;
  return table;
}

}  // namespace slosh
