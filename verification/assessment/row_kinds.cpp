#include "verification/assessment/row_kinds.hpp"

#include <fmt/format.h>

#include <map>

#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/row_uncertainty.hpp"

namespace slosh {
namespace {

struct Tally {
  struct OfKind {
    int judged = 0, passed = 0;
  };
  std::map<RowKind, OfKind> kinds;
  std::map<RowBasis, int> bases;
  int judged = 0, unknown_references = 0;

  void add(RowKind kind, RowBasis basis, Verdict verdict) {
    if (verdict == Verdict::not_selected || verdict == Verdict::not_supplied) return;
    ++judged;
    ++kinds[kind].judged;
    kinds[kind].passed += verdict == Verdict::pass;
    ++bases[basis];
  }
};

Tally tally_of(const std::vector<CaseAssessment>& cases,
               const std::vector<ProblemAssessment>& problems) {
  Tally tally;
  for (const CaseAssessment& one : cases)
    for (const GateOutcome& outcome : one.gate) {
      tally.add(outcome.row.kind, basis_of(one.definition, outcome.row), outcome.verdict);
      tally.unknown_references +=
          outcome.judgement && !outcome.judgement->contributions.reference.half_width;
    }
  for (const ProblemAssessment& one : problems)
    for (const ProblemGateOutcome& outcome : one.gate)
      tally.add(outcome.row.kind,
                outcome.row.kind == RowKind::regression ? RowBasis::earlier_measurement
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

std::string kinds_sentence(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems) {
  Tally tally = tally_of(cases, problems);
  if (tally.judged == 0) return "";
  const Tally::OfKind validation = tally.kinds[RowKind::validation],
                      regression = tally.kinds[RowKind::regression];
  const int experiments = tally.bases[RowBasis::experiment],
            solutions = tally.bases[RowBasis::exact_solution],
            tolerances = tally.bases[RowBasis::harness_tolerance];
  return fmt::format(
      "Validation rows: {} of {} pass; regression rows: {} of {}. {:.0f} % of the rows rest on an "
      "experiment ({}), an exact solution ({}) or a tolerance of this harness ({}). {} {} a "
      "reference whose uncertainty is unknown.",
      validation.passed, validation.judged, regression.passed, regression.judged,
      100.0 * (experiments + solutions + tolerances) / tally.judged, experiments, solutions,
      tolerances, tally.unknown_references,
      tally.unknown_references == 1 ? "row has" : "rows have");
}

}  // namespace slosh
