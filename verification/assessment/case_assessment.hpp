// A case after its runs: which of them stand, how each pair of them compares, and what the gate
// says. Nothing here runs a solver.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

struct CaseAssessment {
  CaseDefinition definition;
  CaseRuns runs;
  // By candidate, reference and quantity: every solver against every reference of its kind of
  // theory (SPH and external programs: one layer; interFoam: two layers where declared; all: the
  // viscous wave), against every published record over the record's part of the window, and SPH and
  // external programs against the finest interFoam.
  std::vector<Comparison> comparisons;
  std::vector<std::string> not_comparable;  // "CANDIDATE against REFERENCE: why"
  std::vector<GateOutcome> gate;
  // Those comparisons and the ones that rows and their uncertainties rest on.
  FittedComparisons fitted = {};
};

// Marks references that have left their declared range, compares and gates.
CaseAssessment assess(CaseDefinition definition, CaseRuns runs);

// Whether the user selected any of its runs.
bool has_selected_runs(const CaseAssessment& assessment);

// Of each candidate the comparison on the case's first quantity (quantities.hpp) with its first
// reference that is in its range: theory or a record where there is one, else the finest interFoam.
std::vector<const Comparison*> judging_comparisons(const CaseAssessment& assessment);

// Of a run the judging comparison with theory or a record; null where there is none.
const Comparison* comparison_with_truth(const CaseAssessment& assessment, const std::string& run);

// That of the first record that has it; null where none is supplied.
const TimeSeries* series_of_record(const CaseAssessment& assessment, const std::string& quantity);

// What an exit status is made of.
struct Standing {
  std::vector<Verdict> verdicts;  // of all gate rows
  bool run_failed = false;
  bool left_open = false;  // a run without a result, or a case of which no pair could be compared
};
Standing standing_of(const std::vector<CaseAssessment>& cases);
int exit_status(const Standing& standing);

// Exit status of the whole: a run that failed or has no result counts even where no gate row names
// it, and so does a case of which no pair could be compared. A record that is not supplied does
// not.
int exit_status(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
