// What the still fields of a case and its film share: the panels of its runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/gate/field_metrics.hpp"

namespace slosh {

// Returns null where the run recorded no field at that time.
const FieldSnapshot* snapshot_at(const CaseAssessment& assessment, const std::string& run,
                                 double time);

// Returns "t = 3.4 s" and, where the tank rolls, its angle. The time has as many decimals as it
// needs, or a given number of them.
std::string moment_label(const CaseDefinition& definition, double time,
                         std::optional<int> decimals = {});

inline constexpr const char* field_quantity = "pressure [Pa]";

// Returns the tank at that time with the run's pressure and velocity; an empty tank that is
// labelled so where the run recorded none.
reports::FieldPanel panel_of(const CaseAssessment& assessment, const std::string& run, double time);

// Returns what colours, arrows and places show, which run is which, and the case's source:
// sentences.
std::string field_caption(const CaseDefinition& definition, const std::vector<std::string>& runs);

// Returns the case's animation: the finest run of each scheme and solver that recorded any of its
// moments, in step, with their history and that of the references. The poster is the moment of the
// highest elevation at the first gauge. Returns std::nullopt where the runs recorded fewer than two
// moments.
std::optional<reports::FieldFigure> case_film(const CaseAssessment& assessment);

}  // namespace slosh
