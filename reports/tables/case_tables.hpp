// The tables of one case's page of a report. A table that may be absent is nullopt where the case
// has nothing to show in it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// gate_tables.cpp: what the gate judged.

// Returns "forced amplitude error of elevation@right".
std::string metric_text(const GateRow& row);

// Returns the reference's name, "published impacts" where these are the reference, or "none".
std::string reference_text(const GateRow& row);

// The result, the verdict and the reason of each gate row: those that do not pass or are in doubt,
// worst first, then those that pass, folded. Each row has its anchor (report_places.hpp).
std::vector<reports::Table> gate_tables(const CaseAssessment& assessment);

// For each judged gate row on ensembles: how the metric scatters over the repeats of either side,
// its mean and the interval that they give it (ensemble_mean.hpp).
std::optional<reports::Table> ensemble_table(const CaseAssessment& assessment);

// gate_tables.cpp: how uncertain the gate rows are.

// Returns "u_num 0 %, u_input unknown, u_reference 1.2 %" of a row in that unit.
std::string uncertainties_text(const ThreeWayOutcome& judged, const std::string& unit);

// For each judged row: its kind, the three uncertainties of ASME V&V 20, that of the time series,
// their combination, and what each is based on, or what is missing.
std::optional<reports::Table> uncertainty_table(const CaseAssessment& assessment);

// For each refinement path and each metric that a gate row measures on the path's finest run: the
// values, coarse to fine, how they behave, the order, the extrapolated value and the uncertainty of
// the finest.
std::optional<reports::Table> refinement_table(const CaseAssessment& assessment);

// Returns what would make an inconclusive row conclusive: a longer window, more repeats of a
// candidate that has these, finer steps, or what is missing; "" for any other row.
std::string remedy_text(const CaseDefinition& definition, const GateOutcome& outcome);

// For each inconclusive row: the contributions to its uncertainty, what that would have to fall to,
// and which finer step or longer window reaches it at what cost.
std::optional<reports::Table> remedy_table(const CaseAssessment& assessment);

// comparison_tables.cpp: how the solutions of the case compare.

// For each pair and fitted mode: amplitude error, lag, frequency error and decay rate, with 95 %
// intervals.
reports::Table mode_table(const CaseAssessment& assessment);

// For each pair: normalised rms, largest residual, spectral peaks.
reports::Table history_table(const CaseAssessment& assessment);

// The distance of each solution to every other (solution_distances.hpp). Needs three solutions.
std::optional<reports::Table> distance_table(const CaseAssessment& assessment);

// The observed orders (observed_order.hpp) of each scheme that runs unchanged at three or more
// spacings and is compared with theory or a record there.
std::optional<reports::Table> order_table(const CaseAssessment& assessment);

// ablation_table.cpp

// The errors of each SPH run against theory or a record, its cost, and the ratio of both to those
// of the unchanged run of the same scheme and spacing. Needs a run that changes something and one
// that is compared with theory or a record.
std::optional<reports::Table> ablation_table(const CaseAssessment& assessment);

// comparison_tables.cpp

// For each run and snapshot time the rms of the pressure field against interFoam's, and how the
// liquids overlap (field_difference.hpp). Needs fields that were compared.
std::optional<reports::Table> field_table(const CaseAssessment& assessment);

// impact_tables.cpp

// For each run and pressure: the time and the peak of each impact and the plateau after it; the
// published ones and the record's come first. Needs a case with [impacts].
std::optional<reports::Table> impact_table(const CaseAssessment& assessment);

// For each impact's peak over repeated runs: mean, standard deviation, central 90 % and the area
// metric to the experiment's repeats (distribution.hpp). Needs [impacts] and repeated runs.
std::optional<reports::Table> repeat_table(const CaseAssessment& assessment);

// run_tables.cpp: what the runs recorded of themselves.

// The series that an SPH run of a still tank records beside its elevations
// (sph/recording/still_water.hpp).
inline constexpr const char* rest_quantities[] = {
    "hydrostatic_pressure_error", "kinetic_over_potential_energy", "wall_gap", "volume_drift"};

// The largest values of those series over the whole run and over the comparison window.
std::optional<reports::Table> rest_table(const CaseAssessment& assessment);

// How each run ended, its size, its steps and its cost.
reports::Table cost_table(const CaseAssessment& assessment);

// run_tables.cpp: what a step of a particle costs in each simulation, with the settings that it
// hangs on; nullopt unless an external program that tells its counts is among them, so that codes
// are compared.
std::optional<reports::Table> step_table(const CaseAssessment& assessment);

// The active terms and the diagnostics of each run.
reports::Table terms_table(const CaseAssessment& assessment);

// The versions, the machine, the date and the command of each run.
reports::Table provenance_table(const CaseAssessment& assessment);

// Returns what computed the result of this provenance: a program of the user's, or Slosh itself.
std::string software_text(const std::map<std::string, std::string>& origin);

// The errors of failed runs and the messages of their programs; nullopt where none failed.
std::optional<reports::Table> failure_table(const std::string& name,
                                            const std::map<std::string, RunStatus>& runs);

}  // namespace slosh
