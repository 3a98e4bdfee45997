#include "reports/summary/case_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <variant>

#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

std::optional<std::string> outlier_sentence(const CaseAssessment& assessment) {
  const auto [quantity, runs, distances] = solution_distances(assessment);
  if (runs.size() < 3) return {};
  if (const auto odd = outlier(distances))
    return fmt::format("`{}` stands apart from the other {} solutions in {}.", runs[*odd],
                       runs.size() - 1, quantity);
  return fmt::format("No single one of the {} solutions stands apart from all others in {}.",
                     runs.size(), quantity);
}

// A scheme's first measure is the rms of its residual.
std::vector<std::string> order_sentences(const CaseAssessment& assessment) {
  std::vector<std::string> sentences;
  std::set<std::string> told;
  for (const ErrorFamily& family : error_families(assessment)) {
    if (!told.insert(family.name).second) continue;
    const auto line = least_squares_line(family.errors);
    if (!line) continue;
    const std::string order = slope_text(line->order);
    sentences.push_back(fmt::format("The order of convergence of `{}` over {} resolutions is {}.",
                                    family.name, family.errors.size(), order));
  }
  return sentences;
}

std::optional<std::string> coverage_finding(const CaseCoverage& coverage) {
  if (coverage.rows_judged == 0) return {};
  if (const std::vector<std::string> missed = coverage.missed(); !missed.empty())
    return fmt::format("No gate row detects the required error that is made on purpose in: {}.",
                       fmt::join(missed, ", "));
  return fmt::format(
      "Together the gate rows detect the required errors that are made on purpose: {}.",
      fmt::join(names_of_required(), ", "));
}

// For each record that no row judges against, how far the finest runs are from it.
std::vector<std::string> record_sentences(const CaseAssessment& assessment) {
  std::vector<std::string> sentences;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (!std::holds_alternative<RecordRun>(run.solver) ||
        is_judged_against(assessment.definition, run.name))
      continue;
    std::map<std::string, std::vector<std::string>> told;  // of each quantity
    for (const Comparison& pair : assessment.comparisons)
      if (pair.reference == run.name)
        told[pair.quantity].push_back(
            fmt::format("{:.2g} % (`{}`)", 100 * pair.normalised_rms.value, pair.candidate));
    for (const auto& [quantity, errors] : told)
      sentences.push_back(
          fmt::format("No gate row judges against the record `{}`. In {} the normalised rms "
                      "difference from it is {}.",
                      run.name, quantity, fmt::join(errors, ", ")));
  }
  return sentences;
}

}  // namespace

bool is_judged_against(const CaseDefinition& definition, const std::string& reference) {
  return std::any_of(definition.gate.begin(), definition.gate.end(), [&](const GateRow& row) {
    return row.reference == reference || is_of_impacts(row.metric);
  });
}

std::vector<std::string> case_findings(const CaseAssessment& assessment,
                                       const CaseCoverage& coverage) {
  std::vector<std::string> findings = order_sentences(assessment);
  if (auto odd = outlier_sentence(assessment)) findings.insert(findings.begin(), std::move(*odd));
  std::ranges::move(record_sentences(assessment), std::back_inserter(findings));
  if (auto detects = coverage_finding(coverage)) findings.push_back(std::move(*detects));
  return findings;
}

}  // namespace slosh
