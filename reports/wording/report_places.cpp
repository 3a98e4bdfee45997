#include "reports/wording/report_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace slosh {

std::string name_id(const std::string& name) {
  std::string id;
  for (const char c : name) id += c == '-' ? "--" : std::string(1, c);
  return id;
}

std::string case_id(const std::string& case_name) {
  constexpr std::string_view taken[] = {
      "index", problems_page, across_page, "gate", "worst",  "bias",
      "walls", "problem",     "matrix",    "case", "li2010", "zhao2021",
  };
  const bool is_taken = std::ranges::find(taken, case_name) != std::end(taken);
  return is_taken ? "case-" + case_name : name_id(case_name);
}

std::string appendix_of_case(const std::string& case_name) {
  return case_id(case_name) + "-appendix";
}

std::string case_row_id(const std::string& case_name, std::size_t row) {
  return fmt::format("{}-{}", case_id(case_name), row + 1);
}

std::string problem_row_id(const std::string& problem_name, std::size_t row) {
  return fmt::format("problem-{}-{}", problem_name, row + 1);
}

}  // namespace slosh
