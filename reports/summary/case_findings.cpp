#include "reports/summary/case_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>

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
  return fmt::format("None of the {} solutions stands apart from the others in {}.", runs.size(),
                     quantity);
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
  std::vector<std::string> missed;
  for (const RequiredDetection& one : required_detections)
    if (coverage.detections.at(one.name).coverage == Coverage::missed) missed.push_back(one.name);
  if (missed.empty()) return "The gate rows detect every error that is made on purpose.";
  return fmt::format("No gate row detects an error that is made on purpose in: {}.",
                     fmt::join(missed, ", "));
}

}  // namespace

std::vector<std::string> case_findings(const CaseAssessment& assessment,
                                       const CaseCoverage& coverage) {
  std::vector<std::string> findings = order_sentences(assessment);
  if (auto odd = outlier_sentence(assessment)) findings.insert(findings.begin(), std::move(*odd));
  if (auto detects = coverage_finding(coverage)) findings.push_back(std::move(*detects));
  return findings;
}

}  // namespace slosh
