#include "verification/selftest_command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "verification/campaign/row_strength.hpp"

namespace slosh {
namespace {

void print(const reports::Table& table) {
  for (const std::vector<std::string>& row : table.rows)
    std::cout << fmt::format(
        "{}: amplitude {} %, lag {} %, frequency {} %, noise {} %; does not "
        "notice: {}\n",
        row[0], row[1], row[2], row[3], row[4], row[5]);
}

}  // namespace

int selftest_campaign(const CampaignOptions& given, const Installation& installation) {
  CampaignOptions options = given;
  options.solve = false;
  const std::atomic<bool> never{false};
  const AssessedCampaign assessed = assess_campaign(options, installation, never);
  std::size_t tried = 0;
  std::vector<std::string> broken;
  for (const CaseAssessment& one : assessed.cases) {
    const std::vector<RowStrength> strengths = row_strengths(one, options.at_once);
    std::cout << one.definition.name << ":\n";
    print(strength_table(one, strengths));
    for (const RowStrength& row : strengths) tried += row.strength.outcomes.size();
    for (const std::string& claim : broken_claims(strengths))
      broken.push_back(one.definition.name + ": " + claim);
  }
  for (const std::string& claim : broken) std::cout << "BROKEN " << claim << "\n";
  std::cout << fmt::format("{}: {} changes were tried, {} that a row claims to detect passed\n",
                           broken.empty() && tried > 0 ? "PASS" : "FAIL", tried, broken.size());
  if (!broken.empty()) return exit_violated;
  return tried > 0 ? exit_pass : exit_not_compared;
}

}  // namespace slosh
