// The changes of a campaign's gate rows since their baseline: by how many uncertainties each metric
// has moved, which rows were lost, are new or have another name, and which tolerances, intervals
// and terms (baseline_ledger.hpp) are others. An interval is another where it is more than twice as
// wide or less than half as wide, and the change is more than a hundredth of the larger of metric
// and tolerance. A metric has moved where its change exceeds both intervals together and the
// round-off that differs between compilers and processors. Timings belong to one machine: a row on
// a cost has its tolerance and its terms in the baseline, and no figure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

struct RowMovement {
  std::string row;  // its name in the campaign
  std::string unit;
  std::optional<BaselineValue> before, after;  // nullopt: there is no such row
  // |after - before| over the root of the sum of both half widths' squares. It is infinite for a
  // moved value without any half width, and zero where before or after is missing.
  double uncertainties = 0;
  bool loosened = false;  // whether the tolerance accepts more than before at either end
  Verdict verdict = Verdict::not_compared;  // of the row as it is now
  std::string other_name = {};  // of a lost row the new one, of a new row the lost one, if any fits
  bool lost_tag = false;  // the row is there, but its case has no tag of the selection any more

  // Whether this form of the campaign no longer has the row: nothing declares it, the whole form
  // leaves its run out, or a selection does whose tag its case has lost.
  bool lost() const { return !after; }
  // Whether the row would have a value if the user had its record.
  bool lacks_record() const { return verdict == Verdict::not_supplied; }
  // Whether the row appeared, was lost, moved, or has another tolerance, interval or other terms.
  bool has_changed() const;
  // Whether the baseline's row was one of validation (or of a kind that was not recorded) and the
  // row is lost or a regression now, or rests on a record that is not supplied and did not before.
  bool loses_validation() const;
};

// What a campaign has come to, and of one that was judged by a selection of its runs whether this
// takes a run of a case with such tags.
struct JudgedCampaign {
  const std::vector<CaseAssessment>& cases;
  const std::vector<ProblemAssessment>& problems;
  std::function<bool(const CaseDefinition&, const RunDefinition&)> selects = {};
};

// The row's name in the campaign: "CASE: " and its name in the case (gate.hpp), or "PROBLEM: METRIC
// of MEASURE".
std::string row_name(const std::string& case_name, const GateRow& row);
std::string row_name(const std::string& problem, const ProblemGateRow& row);

// Every row of the campaign, in its order, then those of the baseline that are lost. A row that a
// selection leaves out keeps its baseline and is not among them, unless its case has lost the tag.
std::vector<RowMovement> movements(const Baseline& baseline, const JudgedCampaign& campaign);

// The changes of the rows that have changed. A row that has lost its value keeps its baseline: a
// failed measurement is no new value. A lost row is removed. A row that has not changed and whose
// terms are not recorded in full keeps its figures and gets its terms.
std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements);

// "+1.2 % -> +1.9 % (2.3 uncertainties)", "new: 1.2 %", "no value any more", "not supplied", "no
// row of this form any more", followed by a changed tolerance, "tolerance loosened: -1.5 % .. 1.5 %
// -> -2 % .. 2 %", a changed interval, "U: 49 % -> 0.01 %", and by changed terms, "kind: validation
// -> regression".
std::string movement_text(const RowMovement& movement);

// A line for each row that has changed, which begins with "lost", "moved" or "new".
std::string changed_lines(const std::vector<RowMovement>& movements);

// "Rows since the baseline: 2 lost (1 of validation), 1 new, 3 changed." Returns "" where there is
// nothing to tell.
std::string changes_sentence(const std::vector<RowMovement>& movements);

}  // namespace slosh
