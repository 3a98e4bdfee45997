// The text of a convergence study.
#pragma once

#include <string>

#include "verification/assessment/convergence.hpp"

namespace slosh {

struct ConvergenceStudy {
  CaseAssessment assessment;
  ConvergenceQuestion question;
  Convergence found;
};

std::string text_of(const ConvergenceStudy& study);

// The units stand in the keys or beside the values. A missing number is null.
std::string json_of(const ConvergenceStudy& study);

}  // namespace slosh
