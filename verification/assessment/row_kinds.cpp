#include "verification/assessment/row_kinds.hpp"

#include <fmt/format.h>

#include <map>

#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/row_uncertainty.hpp"

namespace slosh {
namespace {

struct Tally {
  std::map<RowBasis, int> bases;
  int judged = 0, unknown_references = 0;

  void add(RowBasis basis, Verdict verdict) {
    if (verdict == Verdict::not_selected || verdict == Verdict::not_supplied) return;
    ++judged;
    ++bases[basis];
  }
};

Tally tally_of(const std::vector<CaseAssessment>& cases,
               const std::vector<ProblemAssessment>& problems) {
  Tally tally;
  for (const CaseAssessment& one : cases)
    for (const GateOutcome& outcome : one.gate) {
      tally.add(basis_of(one.definition, outcome.row), outcome.verdict);
      tally.unknown_references +=
          outcome.judgement && !outcome.judgement->contributions.reference.half_width;
    }
  for (const ProblemAssessment& one : problems)
    for (const ProblemGateOutcome& outcome : one.gate)
      tally.add(outcome.row.kind == RowKind::regression ? RowBasis::earlier_measurement
                                                        : RowBasis::exact_solution,
                outcome.verdict);
  return tally;
}

}  // namespace

RowBasis basis_of(const CaseDefinition& definition, const GateRow& row) {
  if (row.kind == RowKind::regression) return RowBasis::earlier_measurement;
  if (rests_on_experiment(definition, row)) return RowBasis::experiment;
  if (row.reference.empty()) return RowBasis::harness_tolerance;
  const bool exact = is_theory(run_named(definition, row.reference));
  return exact ? RowBasis::exact_solution : RowBasis::harness_tolerance;
}

std::string basis_sentence(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems) {
  Tally tally = tally_of(cases, problems);
  if (tally.judged == 0) return "";
  std::string text = fmt::format(
      "Rows: {} against exact solutions, {} own tolerances, {} regression, {} experiments",
      tally.bases[RowBasis::exact_solution], tally.bases[RowBasis::harness_tolerance],
      tally.bases[RowBasis::earlier_measurement], tally.bases[RowBasis::experiment]);
  if (tally.unknown_references > 0)
    text += fmt::format("; {} of them against a reference of unknown uncertainty",
                        tally.unknown_references);
  return text + ".";
}

}  // namespace slosh
