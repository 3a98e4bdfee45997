// The subcommand selftest: tests on a campaign's own results what its gate rows detect. Starts no
// solver.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "reports/summary/sensitivity_tables.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/sensitivity/selftest_record.hpp"

namespace slosh {
namespace {

// Returns a row of the table as a line: its name, then each value after its heading.
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
  std::vector<std::string> blind;  // rows
  std::vector<CaseCoverage> cases;

  std::size_t missed() const {
    return static_cast<std::size_t>(std::count_if(
        cases.begin(), cases.end(), [](const CaseCoverage& one) { return !one.missed().empty(); }));
  }
};

Found test(const AssessedCampaign& assessed) {
  Found found;
  for (const CaseAssessment& one : assessed.cases) {
    const std::vector<RowSensitivity> sensitivity = gate_sensitivity(one);
    std::cout << one.definition.name << ":\n";
    print(sensitivity_table(one, sensitivity));
    for (const RowSensitivity& row : sensitivity) found.tried += row.detects.size();
    for (const std::string& row : blind_rows(sensitivity))
      found.blind.push_back(one.definition.name + ": " + row);
    found.cases.push_back(case_coverage(one, sensitivity));
  }
  return found;
}

// Returns the cases with selected runs.
std::vector<CaseCoverage> selected(const AssessedCampaign& assessed,
                                   std::vector<CaseCoverage> cases) {
  std::vector<CaseCoverage> kept;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (has_selected_runs(assessed.cases[i])) kept.push_back(std::move(cases[i]));
  return kept;
}

struct SelftestOptions {
  CampaignOptions campaign;
  bool record = false;  // write the findings beside the baselines (selftest_record.hpp)
};

// Prints what each row detects, and what the rows of each case detect together. Returns
// exit_violated if a row passes with a truncated series or NaN, or if the rows of a case together
// miss what every case must detect (with --only or --tag the latter is printed but does
// not count), and exit_not_compared if no row could be tried. Throws CaseFileError if a part of a
// campaign is to be recorded.
int selftest_campaign(const SelftestOptions& given, const Installation& installation) {
  const CampaignOptions& options = given.campaign;
  const RunSelection& selection = options.selection;
  const bool is_whole = selection.only.empty() && selection.tags.empty();
  if (given.record && !is_whole)
    throw CaseFileError("--record: expected a whole campaign, without --only and --tag");
  const AssessedCampaign assessed = assess_present(options, installation);
  Found found = test(assessed);
  found.cases = selected(assessed, std::move(found.cases));
  std::cout << "Together:\n";
  print(coverage_table("coverage", found.cases));
  for (const std::string& row : found.blind) std::cout << "BLIND " << row << "\n";
  if (given.record) {
    const std::string& name = assessed.definition.name;
    const auto file = selftest_record_file(baselines_of(assessed.definition, installation), name,
                                           selection.quick);
    write_selftest_record({name, selection.quick, found.cases}, file);
    std::cout << "record: " << file.string() << "\n";
  }
  const bool holds = found.blind.empty() && (found.missed() == 0 || !is_whole);
  std::cout << fmt::format(
      "{}: {} spoilings were tried, {} of NaN or a truncated series were let pass; the rows of {} "
      "of {} cases miss "
      "what every case must detect\n",
      holds && found.tried > 0 ? "PASS" : "FAIL", found.tried, found.blind.size(), found.missed(),
      found.cases.size());
  if (found.tried == 0) return exit_not_compared;
  return holds ? exit_pass : exit_violated;
}

}  // namespace

void add_selftest_command(const CommandTree& tree) {
  const auto record = std::make_shared<bool>(false);
  const auto [selftest, selftest_options] = add_command_on_campaign(
      tree,
      {"selftest",
       "Spoils each candidate on purpose, on the existing results, and tests whether the rows of "
       "each case together detect what every case must detect",
       {"./slosh selftest " + std::string(example_run)}},
      [tree, record](const CampaignOptions& options) {
        return selftest_campaign({options, *record}, tree.installation);
      });
  add_selection_options(*selftest, selftest_options->selection);
  selftest->add_flag("--record", *record,
                     "Write the findings to verification/baselines/NAME.selftest.json, with -quick "
                     "after the NAME of a quick form");
}

}  // namespace slosh
