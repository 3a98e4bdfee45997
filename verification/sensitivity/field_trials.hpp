// The trials of gate rows on pressure fields: the rows judge their real candidate with its fields
// made wrong on purpose (field_mutation.hpp), at the strengths of mutation_trials.hpp. With E the
// value that the row measures of the candidate as it is, C the rms of the candidate's own pressure
// over the compared cells and the datum P (field_metrics.hpp; the mean over the judged moments),
// the metric as_field_rms (metric_table.hpp) of the mutated candidate is by the triangle inequality
//   |f - 1| C / P - E  or more for a pressure scaled by f
//   s - E              or more for a pressure off by s P
// The row claims the mutation where this lies above its bound. Rows on ensembles claim no change of
// values, nor do other metrics and rows that compare two errors (improves_on). Every row claims
// NaN, and the loss of a moment that it judges.
#pragma once

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/mutation_trials.hpp"

namespace slosh {

// The outcome is one of the assessment's, judged and on fields. All members of an ensemble are
// mutated alike.
MutationTrials try_field_mutations(const CaseAssessment& assessment, const GateOutcome& outcome);

}  // namespace slosh
