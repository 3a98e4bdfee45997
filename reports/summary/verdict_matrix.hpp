// A campaign's verdicts at a glance: a row for each case and pair of candidate and reference, a
// column for each metric, in a cell the worst of the gate rows that stand there.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/assessment/tolerance_share.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

struct MatrixCell {
  std::size_t rows = 0;  // gate rows that stand here
  // Of the worst by verdict, and among those of one verdict by its share of the tolerance:
  Verdict verdict = Verdict::not_selected;
  double value = 0, half_width = 0;  // in the unit; NaN where there is no number
  std::string unit;
  std::string found;   // the value as text, "1.2 ± 0.3 %"; empty without one
  std::string row_id;  // report_places.hpp
  std::optional<ToleranceShare> share = {};
};

struct MatrixRow {
  std::string name;                         // of the case, or of the problem
  std::string candidate, reference;         // of a problem its measure and "exact solution"
  std::map<std::string, MatrixCell> cells;  // by metric
};

struct VerdictMatrix {
  std::vector<std::string> metrics;  // in the order in which the rows name them
  std::vector<MatrixRow> rows;       // likewise
};

VerdictMatrix verdict_matrix(const std::vector<CaseAssessment>& cases);
VerdictMatrix verdict_matrix(const std::vector<ProblemAssessment>& problems);

// Each cell leads to its gate row; pairs of which no row was selected are only counted. `id` and
// `title` are the table's, `of` heads its first column.
reports::Table matrix_table(const VerdictMatrix& matrix, const std::string& id,
                            const std::string& title, const std::string& of);

}  // namespace slosh
