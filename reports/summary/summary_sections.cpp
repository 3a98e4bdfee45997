#include "reports/summary/summary_sections.hpp"

#include <algorithm>

#include "reports/summary/bias_section.hpp"
#include "reports/summary/verdict_matrix.hpp"
#include "reports/summary/worst_first.hpp"
#include "reports/tables/report_places.hpp"
#include "verification/assessment/predictions.hpp"

namespace slosh {
namespace {

// The first column leads to what `section` names for it.
template <class SectionOf>
reports::Table with_first_column_linked(reports::Table table, SectionOf section) {
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.links[i][0] = "section-" + section(table.rows[i][0]);
  return table;
}

}  // namespace

std::vector<reports::Section> summary_sections(const std::vector<CaseAssessment>& cases,
                                               const std::vector<ProblemAssessment>& problems,
                                               const std::string& how_to_repeat) {
  reports::Section gate{"gate", "Verdicts", {how_to_repeat}, {}, {}};
  if (const VerdictMatrix matrix = verdict_matrix(cases); !matrix.rows.empty())
    gate.tables.push_back(
        with_first_column_linked(matrix_table(matrix, "matrix", "Verdicts of the cases", "case"),
                                 [](const std::string& name) { return name + "-gate"; }));
  if (const VerdictMatrix matrix = verdict_matrix(problems); !matrix.rows.empty())
    gate.tables.push_back(with_first_column_linked(
        matrix_table(matrix, "problem-matrix", "Verdicts of the problems", "problem"),
        [](const std::string& name) { return "problem-" + name; }));
  if (gate.tables.empty()) gate.paragraphs.push_back("The campaign has no gate row.");
  std::vector<reports::Section> sections{std::move(gate)};
  if (reports::Table worst = worst_first_table(cases, problems); !worst.rows.empty())
    sections.push_back({"worst", "Worst first", {}, {std::move(worst)}, {}});
  if (!cases.empty()) sections.push_back(bias_section(prediction_sets(cases)));
  return sections;
}

}  // namespace slosh
