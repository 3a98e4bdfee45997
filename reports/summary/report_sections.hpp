// The report of a campaign with its assessed cases and problems, and its sections, one function for
// each.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/predictions.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/sensitivity/gate_sensitivity.hpp"

namespace slosh {

// `command` is the command that repeats the campaign.
reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::string& command,
                                const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems = {});

// Of an exit status.
reports::Outcome outcome_of(int status);

// The spoilings that each row detects, and those that the rows of each case detect together.
reports::Table sensitivity_table(const CaseAssessment& assessment,
                                 const std::vector<RowSensitivity>& sensitivity);
reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases);

// The sections of a case: on its page what its tables find, its gate, the case in words and its
// main figures; on its appendix further figures, and its tables.
std::vector<reports::Section> case_sections(const CaseAssessment& assessment,
                                            const std::vector<RowSensitivity>& sensitivity,
                                            const CaseCoverage& coverage);

// The statement, the source, the exact solution, errors and observed orders over the resolutions,
// the figures, and the limits with their reasons, on the page of the problems.
reports::Section problem_section(const ProblemAssessment& assessment);

// Bias and scatter of the models, after NIST's FDS validation guide: a table and, for each kind of
// quantity, the ratios of the predicted values to the reference's with their intervals and each
// model's band. Models with too few comparisons are only listed. Without any set the section says
// why.
reports::Section bias_section(const std::vector<PredictionSet>& sets);

// The cost to reach an error in core-seconds and in memory.
std::vector<reports::Table> work_precision_tables(const CaseAssessment& assessment);

}  // namespace slosh
