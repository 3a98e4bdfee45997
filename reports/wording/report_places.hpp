// Places in a campaign's report: its pages and the anchors of its gate rows.
#pragma once

#include <cstddef>
#include <string>

namespace slosh {

inline constexpr const char* problems_page = "problems";
inline constexpr const char* across_page = "across";  // results of several cases together

// The id of a name of letters, digits, _ and -, as a part of longer ids, whose parts a single -
// joins: a - in the name is doubled, so that the parts tell apart what "wave-appendix" names.
std::string name_id(const std::string& name);

// The id of a case's page, with which those of its sections, tables and figures begin: its
// name_id(), or "case-NAME" for a name that something else in the report has.
std::string case_id(const std::string& case_name);

// Returns the page of a case's further figures and tables.
std::string appendix_of_case(const std::string& case_name);

// Returns the id of a gate row, counted from 0 in the order of the case or campaign file.
std::string case_row_id(const std::string& case_name, std::size_t row);
std::string problem_row_id(const std::string& problem_name, std::size_t row);

}  // namespace slosh
