// The claims of the papers as data.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/findings.hpp"

namespace slosh {

struct PaperClaim {
  std::string paper;                 // the paper of a campaign file: "li2010", "zhao2021"
  std::string statement;             // in our words
  std::string source;                // where the paper makes it
  std::vector<std::string> figures;  // of the paper that show it (paper_figures.hpp)
  std::vector<FindingRow> findings;
};

// All claims, those of one paper in the order of their numbers.
const std::vector<PaperClaim>& paper_claims();

// The claims of a paper on these results. The cases must outlive what is returned.
std::vector<Claim> claims_of(const std::string& paper, const std::vector<CaseAssessment>& cases);

}  // namespace slosh
