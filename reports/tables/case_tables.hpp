// The tables of one case's page of a report.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// "forced amplitude error of elevation@right"
std::string measure_name(const GateRow& row);

// The case's gate rows: what was found and the verdict. Each has its anchor (report_places.hpp).
reports::Table gate_table(const CaseAssessment& assessment);

// A case's limits, why they stand and where they come from; rows alike but for their runs are
// one line.
reports::Table limits_table(const CaseAssessment& assessment);

// Per pair and fitted mode: amplitude error, lag, frequency error, decay, with 95 % intervals.
reports::Table mode_table(const CaseAssessment& assessment);

// Per pair: normalised rms, largest residual, spectral peaks.
reports::Table history_table(const CaseAssessment& assessment);

// Per run: how it ended, its size, steps and cost.
reports::Table cost_table(const CaseAssessment& assessment);

// Per run: active terms and what the run recorded of itself.
reports::Table terms_table(const CaseAssessment& assessment);

// Per run: versions, machine, date, and the command that repeats it.
reports::Table provenance_table(const CaseAssessment& assessment);

// What failed runs and their programs said of it; none where all went well.
std::optional<reports::Table> failure_table(const std::string& name,
                                            const std::map<std::string, RunStatus>& runs);

}  // namespace slosh
