// Conclusions (1) to (4) of Li et al. 2010. A claim on the scheme is decided by the paper's own
// scheme at its spacing; one on the flow also by the finest interFoam that the case declares.
#pragma once

#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/claims.hpp"

namespace slosh {

// The cases must outlive what is returned.
std::vector<Claim> li2010_claims(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
