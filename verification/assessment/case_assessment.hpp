// A case after its runs: which of them have a result, how they compare in pairs, and the verdicts
// of the gate. Nothing here runs a solver, except the theory that the input uncertainty needs.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

struct CaseAssessment {
  CaseDefinition definition;
  CaseRuns runs;
  // By candidate, reference and quantity. Every solver is compared with every theory of its kind
  // (SPH and external programs with one layer; interFoam with two layers where the case declares
  // them; all with the viscous wave) and with every published record over the record's part of the
  // window. SPH and external programs are also compared with the finest interFoam.
  std::vector<Comparison> comparisons;
  std::vector<std::string> not_comparable;  // "CANDIDATE against REFERENCE: why"
  std::vector<GateOutcome> gate;
  // Those comparisons, and all others that the rows and their uncertainties rest on.
  FittedComparisons fitted = {};
  // Of each other run that recorded fields at all snapshot times against the finest interFoam and
  // against those that gate rows on fields name.
  std::vector<FieldComparison> fields = {};
  // "doubtful: CASE: ...", what a reader must know beside the verdicts (verdict_doubts.hpp).
  std::vector<std::string> doubts = {};
};

// Marks references that have left their declared range, compares the runs and judges the gate rows.
CaseAssessment assess(CaseDefinition definition, CaseRuns runs);

// The comparison of the two runs' fields. Returns nullptr where there is none.
const FieldComparison* fields_compared(const CaseAssessment& assessment,
                                       const std::string& candidate, const std::string& reference);

// Whether the user selected any of the case's runs.
bool has_selected_runs(const CaseAssessment& assessment);

// For each candidate the comparison on the case's first quantity (quantities.hpp) with its first
// reference inside its range: theory or a record where there is one, otherwise the finest
// interFoam.
std::vector<const Comparison*> judging_comparisons(const CaseAssessment& assessment);

// The run's judging comparison with theory or a record. Returns nullptr where there is none.
const Comparison* comparison_with_truth(const CaseAssessment& assessment, const std::string& run);

// The series of the first record that has the quantity. Returns nullptr where none is supplied.
const TimeSeries* series_of_record(const CaseAssessment& assessment, const std::string& quantity);

// The parts of an exit status.
struct Standing {
  std::vector<Verdict> verdicts;  // of all gate rows
  bool run_failed = false;
  bool left_open = false;  // a run without a result, or a case of which no pair could be compared
};
Standing standing_of(const std::vector<CaseAssessment>& cases);
int exit_status(const Standing& standing);

// The exit status of all cases together. A run that failed or has no result counts even where no
// gate row names it, and so does a case of which no pair could be compared. A record that is not
// supplied does not count.
int exit_status(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
