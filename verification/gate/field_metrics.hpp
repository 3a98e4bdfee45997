// A run's pressure fields at the case's snapshot times, compared with those of an interFoam run of
// the same case on that run's mesh (field_difference.hpp). With P = density gravity fill_depth:
//   pressure_field_rms      pressure_rms / P
//   pressure_field_tension  tension_share: of the compared cells those with a pressure below
//                           -small_tension_share P
// A row of the mode "moment_n" is of the n-th snapshot time, one of "whole" of the mean over all.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/metrics/field_difference.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// Of P. No tension is expected under air; a twentieth leaves room for the cells and particles of a
// torn surface: interFoam's lowest cell of the violent roll has -0.057 P on 90 x 51 cells.
inline constexpr double small_tension_share = 0.05;

// The differences at all snapshot times, in their order.
struct FieldComparison {
  std::string candidate, reference;
  std::vector<FieldDifference> moments;
};

// P [Pa].
double pressure_under_depth(const CaseDefinition& definition);

// Returns null where the run recorded no field at that time, to half a sample.
const FieldSnapshot* snapshot_at(const CaseDefinition& definition, const RunResult& result,
                                 double time);

// The difference at the n-th snapshot time, n from 0. Throws ComparisonError as field_difference()
// does, and where one of the runs has no field at that time.
FieldDifference field_difference_at(std::size_t n, const RunResult& candidate,
                                    const RunResult& reference, const CaseDefinition& definition);

// Throws ComparisonError as field_difference_at() does, and where the case has no snapshot times.
FieldComparison compare_fields(const RunResult& candidate, const RunResult& reference,
                               const CaseDefinition& definition);

// The differences that a row of this mode rests on: that of one moment, or all. Throws
// ComparisonError as compare_fields() does, and for a moment that the case does not have.
std::vector<FieldDifference> judged_moments(const std::string& mode, const RunResult& candidate,
                                            const RunResult& reference,
                                            const CaseDefinition& definition);

// The row's metric in its unit. Throws what judged_moments() throws.
double field_metric(const GateRow& row, const RunResult& candidate, const RunResult& reference,
                    const CaseDefinition& definition);

}  // namespace slosh
