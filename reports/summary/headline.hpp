// What a campaign shows first: by how much a code under test departs, and from what.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// How a code stands in one case. Its run is the one that decides where a row is violated or
// inconclusive, else the finest that a validation row compares with a reference.
struct HeadlineLine {
  std::string name;                  // of the case, or of the problem
  Verdict verdict;                   // the worst of the code's rows
  std::string standing;              // standing_name()
  std::string candidate, reference;  // "SPH at 5 mm", "linear theory"; the latter may be empty
  std::string amplitude = {}, lag = {}, rms = {};  // with their intervals; empty for none
  std::string decides;  // the row that is nearest to its limit or worst, and its result
  std::string row_id;   // of that row (case_text.hpp)
  std::string section;  // of the case or the problem
};

// One line for each case and code that has judged rows, and one for each problem. A code of which
// no row has a reference has a line for each row.
std::vector<HeadlineLine> headline_lines(const std::vector<CaseAssessment>& cases,
                                         const std::vector<ProblemAssessment>& problems);

bool has_numbers(const HeadlineLine& line);

// Of rows that all pass: whether some are regression rows, and none compares with a reference for
// validation. What was found earlier is watched, and nothing is validated.
bool is_only_watched(const std::vector<HeadlineLine>& lines);

// "SPH at 5 mm against linear theory: amplitude -0.08 ± 0.13 %, lag 0.01 ± 0.08 deg, rms 5.2 ± 1.5
// %"
std::string line_text(const HeadlineLine& line);

// Returns "19 of 19 gate rows hold, 12 not selected."
std::string verdict_sentence(const std::vector<CaseAssessment>& cases,
                             const std::vector<ProblemAssessment>& problems = {});

// The lines of the case that decides: the one with the worst verdict, or else the first that is
// validated. There must be a line.
std::string headline_sentence(const std::vector<HeadlineLine>& lines);

// "PASS", "WATCHED, NOT VALIDATED" where is_only_watched(), or what headline_word() of a status
// says.
std::string headline_word(int status, const std::vector<HeadlineLine>& lines);

// The table of all lines; its rows link to the rows that decide.
reports::Table headline_table(const std::vector<HeadlineLine>& lines);

// The speed at equal error of the first case that has one, as a sentence; "" where none has.
std::string speed_sentence(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
