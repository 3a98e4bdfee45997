// The tables of one case's page of a report; the captions say what each shows. A table without a
// row has nothing to show, and its section leaves it out.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

using TableRow = std::vector<std::string>;

inline void append(TableRow& row, const TableRow& cells) {
  row.insert(row.end(), cells.begin(), cells.end());
}

// A table without a row; its id is `id` behind that of the case.
reports::Table case_table(const CaseDefinition& definition, const std::string& id,
                          const std::string& title, const std::string& caption,
                          const TableRow& header);

// The result of the run; null where it left none.
const RunResult* find_result(const CaseRuns& runs, const std::string& run);

// gate_tables.cpp: what the gate judged, and how uncertain that is.

// Returns "forced amplitude error of elevation@right".
std::string metric_text(const GateRow& row);

// Returns the reference's name, "published impacts" where these are the reference, or "none".
std::string reference_text(const GateRow& row);

// Returns "u_num 0 %, u_input unknown, u_reference 1.2 %" of a row in that unit.
std::string uncertainties_text(const ThreeWayOutcome& judged, const std::string& unit);

// Returns what would make an inconclusive row conclusive: a longer window, more repeats of a
// candidate that has these, finer steps, or what is missing; "" for any other row.
std::string remedy_text(const CaseDefinition& definition, const GateOutcome& outcome);

// Those that do not pass or are in doubt, worst first, then those that pass, folded. Each row has
// its anchor (case_text.hpp).
std::vector<reports::Table> gate_tables(const CaseAssessment& assessment);

// Each judged row on ensembles (ensemble_mean.hpp).
reports::Table ensemble_table(const CaseAssessment& assessment);
reports::Table uncertainty_table(const CaseAssessment& assessment);

// Each refinement path and each metric that a gate row measures on the path's finest run.
reports::Table refinement_table(const CaseAssessment& assessment);
reports::Table remedy_table(const CaseAssessment& assessment);

// comparison_tables.cpp: how the solutions of the case compare.

reports::Table mode_table(const CaseAssessment& assessment);
reports::Table history_table(const CaseAssessment& assessment);

// The distance of each solution to every other (solution_distances.hpp). Needs three solutions.
reports::Table distance_table(const CaseAssessment& assessment);

// The observed orders (observed_order.hpp) of each scheme that runs unchanged at three or more
// spacings and is compared with theory or a record there.
reports::Table order_table(const CaseAssessment& assessment);

// The pressure fields against interFoam's (field_difference.hpp).
reports::Table field_table(const CaseAssessment& assessment);

// The ablation. Needs a run that changes something and one that is compared with theory or a
// record.
reports::Table ablation_table(const CaseAssessment& assessment);

// impact_tables.cpp: of a case with [impacts].

// The published impacts and the record's come first.
reports::Table impact_table(const CaseAssessment& assessment);

// The peaks over repeated runs and the experiment's repeats (distribution.hpp).
reports::Table repeat_table(const CaseAssessment& assessment);

// run_tables.cpp: what the runs recorded of themselves.

// The series that an SPH run of a still tank records beside its elevations
// (sph/recording/still_water.hpp).
inline constexpr const char* rest_quantities[] = {
    "hydrostatic_pressure_error", "kinetic_over_potential_energy", "wall_gap", "volume_drift"};

reports::Table rest_table(const CaseAssessment& assessment);
reports::Table cost_table(const CaseAssessment& assessment);

// Empty unless an external program that tells its counts is among the runs, so that codes are
// compared.
reports::Table step_table(const CaseAssessment& assessment);
reports::Table terms_table(const CaseAssessment& assessment);
reports::Table provenance_table(const CaseAssessment& assessment);

// Returns what computed the result of this provenance: a program of the user's, or Slosh itself.
std::string software_text(const std::map<std::string, std::string>& origin);

reports::Table failure_table(const std::string& name, const std::map<std::string, RunStatus>& runs);

}  // namespace slosh
