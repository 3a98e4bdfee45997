// The claims of a paper on cases made by hand, and its section where no figure could be redrawn.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/pages/write_report.hpp"
#include "verification/papers/paper_sections.hpp"

namespace slosh {

using Cases = std::vector<CaseAssessment>;

// Decides the claim and those before it that it rests on, and no others.
inline DecidedClaim claim_of(const std::string& paper, const std::string& number,
                             const Cases& cases) {
  Paper alone = paper_named(paper);
  std::set<std::string> needed{number};
  for (auto one = alone.claims.rbegin(); one != alone.claims.rend(); ++one)
    if (needed.contains(one->number)) needed.insert(one->rests_on.begin(), one->rests_on.end());
  std::erase_if(alone.claims, [&](const Claim& one) { return !needed.contains(one.number); });
  if (alone.claims.empty()) throw std::logic_error("no claim " + number);
  return decided_claims(alone, cases).back();
}

// Expects this of each claim that rests on runs, and that no other one is decided.
inline void expect_all(Held held, const std::string& paper, const Cases& cases) {
  for (const DecidedClaim& one : decided_claims(paper_named(paper), cases)) {
    EXPECT_EQ(one.held, one.claim.not_decidable.empty() ? held : Held::undecided)
        << one.claim.number << ": " << one.found << " WHY " << one.why;
  }
}

inline RedrawnFigures nothing_redrawn(const std::string& paper) {
  RedrawnFigures redrawn;
  for (const PaperFigure& figure : paper_named(paper).figures)
    redrawn.push_back({.number = figure.number, .missing = {"no run"}});
  return redrawn;
}

// The section, which a report can hold.
inline reports::Section section_of(const std::string& paper, const Cases& cases) {
  reports::Report report;
  report.results_json = "{}";
  report.sections = {paper_section(paper_named(paper), cases, nothing_redrawn(paper))};
  EXPECT_NO_THROW(reports::check_report(report));
  return report.sections[0];
}

}  // namespace slosh
