// The changes of a campaign's gate rows since their baseline: by how many uncertainties each metric
// has moved, and which tolerances were loosened. A metric has moved where its change exceeds both
// intervals together and the round-off that differs between compilers and processors. Timings
// belong to one machine and have no baseline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_change.hpp"

namespace slosh {

struct RowMovement {
  std::string row;  // its name in the campaign
  std::string unit;
  std::optional<BaselineValue> before, after;  // nullopt: no such row, or no value now
  // |after - before| over the root of the sum of both half widths' squares. It is infinite for a
  // moved value without any half width, and zero where before or after is missing.
  double uncertainties = 0;
  bool loosened = false;  // whether the tolerance accepts more than before at either end
  bool declared = true;   // whether the campaign still has the row

  // Whether the row appeared, was lost, moved or has another tolerance.
  bool has_changed() const;
};

// The row's name in the campaign: "CASE: " and its name in the case (gate.hpp).
std::string row_name(const std::string& case_name, const GateRow& row);

// The row's metric and tolerance. Returns nullopt where the metric was not measured.
std::optional<BaselineValue> baseline_value(const GateOutcome& outcome);

// Every row of the campaign, in its order, then those of the baseline that it no longer has. A row
// that this form of the campaign leaves out, or whose record is not supplied, keeps its baseline
// and is not among them.
std::vector<RowMovement> movements(const Baseline& baseline,
                                   const std::vector<CaseAssessment>& cases);

// The changes of the rows that have changed. A row that has lost its value keeps its baseline: a
// failed measurement is no new value. A row that the campaign no longer declares is removed.
std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements);

// "+1.2 % -> +1.9 % (2.3 uncertainties)", "new: 1.2 %", "no value any more", followed by a loosened
// tolerance: "tolerance loosened: -1.5 % .. 1.5 % -> -2 % .. 2 %".
std::string movement_text(const RowMovement& movement);

}  // namespace slosh
