// Where in a campaign's report something stands: its pages and the anchors of its gate rows.
#pragma once

#include <cstddef>
#include <string>

namespace slosh {

inline constexpr const char* problems_page = "problems";
inline constexpr const char* across_page = "across";  // what is told of several cases together

// That of a case: its name, but where another page has it.
std::string page_of_case(const std::string& case_name);

// The id of a gate row, counted from 0 as the case file or the campaign file has them.
std::string case_row_id(const std::string& case_name, std::size_t row);
std::string problem_row_id(const std::string& problem_name, std::size_t row);

}  // namespace slosh
