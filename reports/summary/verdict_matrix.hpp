// A campaign's gate rows, and its verdicts at a glance: one row for each case and pair of candidate
// and reference, one column for each metric; a cell shows the worst of its gate rows.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// A gate row of a case or a problem, as tables of the whole campaign show it.
struct ShownRow {
  std::string name;                  // of the case, or of the problem
  std::string candidate, reference;  // of a problem: its error measure and "exact solution"
  std::string shown_reference;       // reference_text() of case_tables.hpp
  bool of_mesh = false;              // whether the candidate is a run of OpenFOAM
  bool regression = false;           // its limit comes from an earlier measurement
  std::string metric, metric_text;   // the name alone, and with the mode and the quantity
  Verdict verdict = Verdict::not_selected;
  double value = 0, half_width = 0;  // in the unit; NaN where there is none
  std::string unit;
  std::string found;    // the value as text, "1.2 ± 0.3 %"; empty for one that is not finite
  std::string message;  // of the gate
  std::string remedy;   // what would make an inconclusive row conclusive; else empty
  std::string row_id;   // report_places.hpp
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

// All rows, in the order of the case, of the cases or of the problems.
std::vector<ShownRow> shown_rows(const CaseAssessment& assessment);
std::vector<ShownRow> shown_rows(const std::vector<CaseAssessment>& cases);
std::vector<ShownRow> shown_rows(const std::vector<ProblemAssessment>& problems);

struct MatrixCell {
  std::size_t rows = 0;  // number of gate rows in this cell
  ShownRow worst;        // is_worse()
};

struct MatrixRow {
  std::string name, candidate, reference, shown_reference;  // as of a ShownRow
  std::map<std::string, MatrixCell> cells;                  // by metric
};

struct VerdictMatrix {
  std::vector<std::string> metrics;  // in the order in which the rows name them
  std::vector<MatrixRow> rows;       // likewise
};

VerdictMatrix verdict_matrix(const std::vector<ShownRow>& rows);

}  // namespace slosh
