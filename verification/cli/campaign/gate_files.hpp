// What a judged campaign says below its rows: on a terminal, and in the files by which the gate
// reports to continuous integration and to reviewers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/summary/gate_document.hpp"
#include "reports/summary/headline.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"

namespace slosh {

// The headline with its verdict, and the row that decides it or is nearest to its limit.
std::string verdict_text(const AssessedCampaign& assessed, const std::vector<HeadlineLine>& lines,
                         int status);

// The same, the doubts about runs, and a line for each case and code, which
// begins with how it stands. `status` is that of the verdict.
std::string headline_text(const AssessedCampaign& assessed, int status);

// How many rows hold, how many of the declared ones are judged, and what they rest on: sentences.
std::string rows_text(const AssessedCampaign& assessed);

// What the gate has found beside the assessment.
struct GateFindings {
  std::vector<RowMovement> movements;  // since the baseline
  bool has_baseline = false;           // whether the ledger holds one
  int status = 0;                      // the exit status, unless the user replaces that of
                                       // inconclusive rows
  bool inconclusive_passes = false;    // whether the user replaces it by 0
};

// Returns the gate rows with their changes since the baseline, the lost rows, and the runs without
// a result. Where the exit status is not 0 for anything else, an entry of the campaign says why.
// The paths of files below `source` are relative to it, and those of other files below the current
// directory to that, as code forges require.
reports::GateDocument gate_document(const AssessedCampaign& assessed, const GateFindings& findings,
                                    const std::filesystem::path& source);

// Returns an entry without a value, as of a run or of the campaign itself.
reports::GateEntry bare_entry(const std::string& group, const std::string& name, Verdict verdict,
                              const std::string& message);

inline constexpr const char *junit_name = "junit.xml", *gate_page_name = "gate.md";

// Writes <directory>/junit.xml and gate.md, each atomically. Throws
// std::filesystem::filesystem_error.
void write_gate_files(const reports::GateDocument& document,
                      const std::filesystem::path& directory);

}  // namespace slosh
