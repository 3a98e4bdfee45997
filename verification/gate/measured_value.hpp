// What a gate row measures: its metric of one comparison, or the mean over an ensemble's.
#pragma once

#include <string>
#include <vector>

#include "verification/gate/gate.hpp"
#include "verification/series/estimate.hpp"

namespace slosh {

// Of a row that was not measured.
inline constexpr Estimate no_value{not_a_number, not_a_number};

// The row's metric of its candidate; where that or the reference is an ensemble the mean over all
// pairs of their members with the interval of ensemble_mean.hpp, which takes the place of those of
// single histories. What an error costs is of no ensemble. Throws as what the evidence is asked
// for, and ComparisonError where the row's unit is not the metric's.
Estimate measured(const GateRow& row, const GateEvidence& evidence);

// Whether the row's candidate or its reference is an ensemble on whose mean it is judged.
bool is_of_ensembles(const GateRow& row, const GateEvidence& evidence);
// The metric of each member of the candidate (outer) against each of the reference. Throws as
// measured().
std::vector<std::vector<Estimate>> measured_pairs(const GateRow& row, const GateEvidence& evidence);

// The run alone where the evidence knows of no ensemble.
EnsembleOfRun ensemble_of(const std::string& run, const GateEvidence& evidence);

// Nothing but itself of a row that has none.
EnsembleOfRun reference_of(const GateRow& row, const GateEvidence& evidence);

bool is_of_candidate_alone(Metric metric);

}  // namespace slosh
