// A campaign's verdicts at a glance: one row for each case and pair of candidate and reference, one
// column for each metric; a cell shows the worst of its gate rows.
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

struct MatrixCell {
  std::size_t rows = 0;  // number of gate rows in this cell
  // The worst row: by verdict, then by its error over the tolerance.
  Verdict verdict = Verdict::not_selected;
  double value = 0, half_width = 0;  // in the unit; NaN where there is none
  std::string unit;
  std::string found;   // the value as text, "1.2 ± 0.3 %"; empty without one
  std::string row_id;  // report_places.hpp
  std::optional<ErrorOverTolerance> share = {};
};

struct MatrixRow {
  std::string name;                         // of the case, or of the problem
  std::string candidate, reference;         // of a problem: its error measure and "exact solution"
  std::map<std::string, MatrixCell> cells;  // by metric
};

struct VerdictMatrix {
  std::vector<std::string> metrics;  // in the order in which the rows name them
  std::vector<MatrixRow> rows;       // likewise
};

VerdictMatrix verdict_matrix(const std::vector<CaseAssessment>& cases);
VerdictMatrix verdict_matrix(const std::vector<ProblemAssessment>& problems);

// Each cell links to its gate row; pairs without a selected row are only counted. `id` and `title`
// are those of the table; `of` is the heading of its first column.
reports::Table matrix_table(const VerdictMatrix& matrix, const std::string& id,
                            const std::string& title, const std::string& of);

}  // namespace slosh
