#include "verification/cli/campaign/selftest_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "verification/input/case_file_error.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/sensitivity/row_strength.hpp"
#include "verification/sensitivity/selftest_record.hpp"

namespace slosh {
namespace {

// A row of the table in a line: its name, then each figure under its heading.
std::string line_of(const reports::Table& table, const std::vector<std::string>& row) {
  std::vector<std::string> parts;
  for (std::size_t i = 1; i < row.size(); ++i)
    if (!row[i].empty()) parts.push_back(fmt::format("{}: {}", table.header[i], row[i]));
  return fmt::format("{}: {}\n", row.front(), fmt::join(parts, ", "));
}

void print(const reports::Table& table) {
  for (const std::vector<std::string>& row : table.rows) std::cout << line_of(table, row);
}

struct Found {
  std::size_t tried = 0;
  std::vector<std::string> broken;
  std::vector<CaseCoverage> cases;

  std::size_t missed() const {
    return static_cast<std::size_t>(std::count_if(
        cases.begin(), cases.end(), [](const CaseCoverage& one) { return !one.is_complete(); }));
  }
};

Found test(const AssessedCampaign& assessed, int at_once) {
  Found found;
  for (const CaseAssessment& one : assessed.cases) {
    const std::vector<RowStrength> strengths = row_strengths(one, at_once);
    std::cout << one.definition.name << ":\n";
    print(strength_table(one, strengths));
    for (const RowStrength& row : strengths) found.tried += row.strength.outcomes.size();
    for (const std::string& claim : broken_claims(strengths))
      found.broken.push_back(one.definition.name + ": " + claim);
    found.cases.push_back(case_coverage(one, strengths));
  }
  return found;
}

// Of what the user selected, what could be judged at all.
std::vector<CaseCoverage> selected(const AssessedCampaign& assessed,
                                   std::vector<CaseCoverage> cases) {
  std::vector<CaseCoverage> kept;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (has_selected_runs(assessed.cases[i])) kept.push_back(std::move(cases[i]));
  return kept;
}

}  // namespace

int selftest_campaign(const SelftestOptions& given, const Installation& installation) {
  CampaignOptions options = given.campaign;
  const RunSelection& selection = options.selection;
  const bool is_whole = selection.only.empty() && selection.tags.empty();
  if (given.record && !is_whole)
    throw CaseFileError("--record: expected a whole campaign, without --only and --tag");
  options.solve = false;
  const std::atomic<bool> never{false};
  const AssessedCampaign assessed = assess_campaign(options, installation, never);
  Found found = test(assessed, options.at_once);
  found.cases = selected(assessed, std::move(found.cases));
  std::cout << "Together:\n";
  print(coverage_table("coverage", found.cases));
  for (const std::string& claim : found.broken) std::cout << "BROKEN " << claim << "\n";
  if (given.record) {
    const std::string& name = assessed.definition.name;
    const auto file = selftest_record_file(installation.baselines, name, selection.quick);
    write_selftest_record({name, selection.quick, found.cases}, file);
    std::cout << "record: " << file.string() << "\n";
  }
  const bool holds = found.broken.empty() && (found.missed() == 0 || !is_whole);
  std::cout << fmt::format(
      "{}: {} changes were tried, {} claims are broken; the rows of {} of {} cases miss what every "
      "case must detect\n",
      holds && found.tried > 0 ? "PASS" : "FAIL", found.tried, found.broken.size(), found.missed(),
      found.cases.size());
  if (found.tried == 0) return exit_not_compared;
  return holds ? exit_pass : exit_violated;
}

}  // namespace slosh
