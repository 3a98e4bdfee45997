// What has changed of a campaign's gate rows since their baseline: by how many uncertainties each
// metric has moved, and whose tolerance was loosened. A metric has moved where its change exceeds
// both intervals together and what compilers and processors round differently; timings, which
// belong to one machine, have no baseline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

// Whether the tolerance lets more pass than the baseline's, by either end.
bool is_loosened(const BaselineValue& before, const BaselineValue& after);

struct RowMovement {
  std::string row;  // its name in the campaign
  std::string unit;
  std::optional<BaselineValue> before, after;  // none: not there, or without a value now
  // |after - before| over the root of the sum of both half widths' squares; infinite where it has
  // moved and neither has any; zero where one of them is missing.
  double uncertainties = 0;
  bool loosened = false;
  bool declared = true;  // by the campaign as it is now

  // Appeared, lost, moved or held to another tolerance.
  bool has_changed() const;
};

// Its name in the campaign: "CASE: " before its name in the case (gate.hpp).
std::string row_name(const std::string& case_name, const GateRow& row);

// Every row of the campaign, in its order, then those of the baseline that it no longer has. A row
// that this form of the campaign leaves out, or whose record is not supplied, keeps its baseline
// and is not among them.
std::vector<RowMovement> movements(const Baseline& baseline,
                                   const std::vector<CaseAssessment>& cases);

// "+1.2 % -> +1.9 % (2.3 uncertainties)", "new: 1.2 %", "no value any more", with the tolerance
// where that was loosened: "tolerance loosened: -1.5 % .. 1.5 % -> -2 % .. 2 %".
std::string movement_text(const RowMovement& movement);

}  // namespace slosh
