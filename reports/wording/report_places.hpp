// Places in a campaign's report: its pages and the anchors of its gate rows.
#pragma once

#include <cstddef>
#include <string>

namespace slosh {

inline constexpr const char* problems_page = "problems";
inline constexpr const char* across_page = "across";  // results of several cases together

// Returns the page of a case: the case's name, or "case-NAME" where another page has that name.
std::string page_of_case(const std::string& case_name);

// Returns the page of a case's further figures and tables.
std::string appendix_of_case(const std::string& case_name);

// Returns the id of a gate row, counted from 0 in the order of the case or campaign file.
std::string case_row_id(const std::string& case_name, std::size_t row);
std::string problem_row_id(const std::string& problem_name, std::size_t row);

}  // namespace slosh
