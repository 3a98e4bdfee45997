// A case after its runs: which of them stand, how each pair of them compares, and what the gate
// says. Nothing here runs a solver.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/case_file/case_definition.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"
#include "verification/runs/result_file.hpp"

namespace slosh {

// The runs of a case: how each ended, and the results of those that finished.
struct CaseRuns {
  std::map<std::string, RunStatus> status;   // of every run that the case declares
  std::map<std::string, RunResult> results;  // of the finished ones and those out of their range
};

struct CaseAssessment {
  CaseDefinition definition;
  CaseRuns runs;
  // By candidate, reference and quantity: every solver against every reference of its kind of
  // theory (SPH: one layer; interFoam: two layers where declared; both: the viscous wave), against
  // every published record over the record's part of the window, and SPH against the finest
  // interFoam.
  std::vector<Comparison> comparisons;
  std::vector<std::string> not_comparable;  // "CANDIDATE against REFERENCE: why"
  std::vector<GateOutcome> gate;
};

// The forcing, where the motion has one, and the first `count` natural modes (natural_modes.hpp).
std::vector<ToneRequest> modes_of(const CaseDefinition& definition, int count);

// Of these, the ones that the case's comparisons fit.
std::vector<ToneRequest> fitted_modes(const CaseDefinition& definition);

// Marks references that have left their declared range, compares and gates.
CaseAssessment assess(const CaseDefinition& definition, CaseRuns runs);

// Of each candidate the comparison on the case's first quantity (quantities.hpp) with its first
// reference that is in its range: theory or a record where there is one, else the finest interFoam.
std::vector<const Comparison*> judging_comparisons(const CaseAssessment& assessment);

// Of a run the judging comparison with theory or a record; null where there is none.
const Comparison* comparison_with_truth(const CaseAssessment& assessment, const std::string& run);

// That of the first record that has it; null where none is supplied.
const TimeSeries* series_of_record(const CaseAssessment& assessment, const std::string& quantity);

bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity);

// The run's definition by its name; the case has one.
const RunDefinition& run_named(const CaseDefinition& definition, const std::string& name);

// Exit status of the whole: a run that failed or has no result counts even where no gate row names
// it, and so does a case of which no pair could be compared. A record that is not supplied does
// not.
int exit_status(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
