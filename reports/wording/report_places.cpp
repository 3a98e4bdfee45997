#include "reports/wording/report_places.hpp"

#include <fmt/format.h>

namespace slosh {

std::string page_of_case(const std::string& case_name) {
  const bool taken = case_name == "index" || case_name == problems_page || case_name == across_page;
  return taken ? "case-" + case_name : case_name;
}

std::string appendix_of_case(const std::string& case_name) {
  return page_of_case(case_name) + "-appendix";
}

std::string case_row_id(const std::string& case_name, std::size_t row) {
  return fmt::format("{}-{}", case_name, row + 1);
}

std::string problem_row_id(const std::string& problem_name, std::size_t row) {
  return fmt::format("problem-{}-{}", problem_name, row + 1);
}

}  // namespace slosh
