// The theories of a case side by side, as one result: their series, where each is valid, and how
// certain it is. The series "elevation@right" of the run "linear" is "elevation@right/linear"
// there. Potential flow has for each series the half widths of its 95 % intervals as well
// (history_uncertainty.hpp), "elevation@right/potential/half_width".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

inline constexpr const char *half_width_suffix = "/half_width",
                            *outside_its_range = "_outside_its_range";

struct TheoryRemarks {
  std::string run, solution;  // its name; what is solved, in words
  std::string range, uncertainty;
  std::optional<std::string> outside = {};  // why it is outside its range in this case
};

struct CaseTheories {
  RunResult result;
  std::vector<TheoryRemarks> remarks;  // in the order of the case's runs
};

// Joins the theories among the results. The remarks are also texts of the joint result's
// provenance: "linear", "linear_range", "linear_uncertainty" and "linear_outside_its_range".
CaseTheories case_theories(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh
