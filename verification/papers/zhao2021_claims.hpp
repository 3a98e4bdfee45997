// The conclusions of Zhao et al. 2021 as restated: its mild and its violent roll, with dynamic
// boundary particles that move with the tank ("moving") or are fixed in the tank's frame ("fixed").
#pragma once

#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/claims.hpp"

namespace slosh {

// The cases must outlive what is returned.
std::vector<Claim> zhao2021_claims(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
