// Which runs of a case a figure shows, how each is drawn, and what captions call it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Of each family the finest run that left a result with `has`, in the order of the case file; one
// that changes something of its scheme only where the family has no other, then the one that
// changes least.
std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::function<bool(const RunResult&)>& has);

// Of those that left the series.
std::vector<std::string> finest_runs(const CaseAssessment& assessment, const std::string& quantity);

// The run's name, and that it is out of its range where it is.
std::string run_label(const CaseAssessment& assessment, const std::string& run);

// From the series' units to a figure's.
struct AxisScales {
  double time = 1, value = 1;
};

// A record as points with its uncertainty, one of many samples and anything else as a line. The run
// left the series.
reports::Curve history_curve(const CaseAssessment& assessment, const std::string& run,
                             const std::string& quantity, const AxisScales& scales);

// As bars of points and as a ribbon of anything else; half widths [the curve's unit]. Throws
// std::invalid_argument unless there are as many as it has samples.
void set_uncertainty(reports::Curve& curve, const std::vector<double>& half_widths);

// Of the finest run of each scheme and solver the judging comparison.
std::vector<const Comparison*> shown_comparisons(const CaseAssessment& assessment);

// What no metric of the case looks at, for an axis of time.
std::vector<reports::Span> outside_window(const CaseDefinition& definition, double time_scale = 1);

// "recommended_10mm: SPH, scheme recommended, 10 mm; ..." and, of records with an uncertainty, what
// their bars are; ends in a full stop.
std::string who_is_who(const CaseDefinition& definition, const std::vector<std::string>& runs);

}  // namespace slosh
