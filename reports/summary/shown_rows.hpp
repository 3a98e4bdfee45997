// A campaign's gate rows as its report and its headline show them, and which of them is the worst.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// A gate row of a case or of a problem.
struct ShownRow {
  std::string name;                      // of the case, or of the problem
  std::string candidate, reference;      // of a problem: its error measure and "exact solution"
  const GateOutcome* outcome = nullptr;  // of a case's assessment, which must outlive the row
  bool of_mesh = false;                  // whether the candidate is a run of OpenFOAM
  bool regression = false;               // its limit comes from an earlier measurement
  std::string metric, metric_text;       // the name alone, and with the mode and the quantity
  Verdict verdict = Verdict::not_selected;
  double value = 0, half_width = 0;  // in the unit; NaN where there is none
  std::string unit;
  std::string message;  // of the gate
  std::string row_id;   // case_text.hpp
  std::optional<ErrorOverTolerance> share = {};

  // Whether the row was to be judged: it is selected, and its record is supplied.
  bool counts() const {
    return verdict != Verdict::not_selected && verdict != Verdict::not_supplied;
  }
  // The far end of the 95 % interval as a share of the tolerance. Among rows of one verdict those
  // without a number come first where they do not pass, and last where they do.
  double reach() const;
};

// Whether the first row is worse: by verdict (severity()), then by reach().
bool is_worse(const ShownRow& one, const ShownRow& other);

// All rows, in the order of the file.
std::vector<ShownRow> shown_rows(const CaseAssessment& assessment);
std::vector<ShownRow> shown_rows(const ProblemAssessment& assessment);

// The table has all rows that do not pass, and at least `fewest` rows where there are as many; the
// caption states the number of all rows. Rows that do not count are left out.
reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest = 20);

// Returns what decides the campaign, and its place in the report: the worst row, of those with its
// verdict the worst that does not judge OpenFOAM, with its figure and its limit, and for an
// inconclusive one what would decide it; where a run without a row decides, the run and why; where
// all rows pass, the row nearest to its limit.
reports::Decision decision_of(const std::vector<CaseAssessment>& cases,
                              const std::vector<ProblemAssessment>& problems);

// Returns the candidate of the case's worst judged row; "" where none is judged.
std::string worst_candidate(const CaseAssessment& assessment);

}  // namespace slosh
