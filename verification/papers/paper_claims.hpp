// The claims of the papers and what is not as printed in their schemes and cases, as data: rows of
// li2010_claims.cpp and zhao2021_claims.cpp.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/findings.hpp"

namespace slosh {

// A claim has findings, rests on others, or has the reason why no run can decide it.
struct PaperClaim {
  std::string number;                     // the paper's: "C5.1", "conclusion 3"
  std::string statement;                  // in our words
  std::vector<std::string> figures = {};  // of the paper that show it (paper_figures.hpp)
  std::string printed = {};               // its own numbers
  std::vector<FindingRow> findings = {};
  std::vector<std::string> rests_on = {};  // numbers of claims whose findings are its own too
  std::string not_decidable = {};
};

// What a scheme or a case of a paper does in another way than the paper says.
struct Deviation {
  std::string of;       // the schemes or cases
  std::string printed;  // what the paper says, or that it says nothing
  std::string here;
  std::string why;
};

struct ClaimsOfPaper {
  std::string paper;  // of a campaign file: "li2010", "zhao2021"
  std::vector<PaperClaim> claims;
  std::vector<Deviation> deviations;
};

const ClaimsOfPaper& li2010_claims();
const ClaimsOfPaper& zhao2021_claims();

// Throws std::invalid_argument where no paper has the name.
const ClaimsOfPaper& claims_named(const std::string& paper);

// The claims of a paper on these results. The cases must outlive what is returned.
std::vector<Claim> claims_of(const std::string& paper, const std::vector<CaseAssessment>& cases);
std::vector<Claim> claims_of(const std::string& paper,
                             std::vector<CaseAssessment>&& cases) = delete;

reports::Table deviations_table(const std::string& paper);

}  // namespace slosh
