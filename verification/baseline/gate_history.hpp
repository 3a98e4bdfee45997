// The history of a campaign's gate rows: what they were at each run of the campaign with a store of
// results. One line of JSON for each run whose values or results differ from those of the line
// before:
//   {"when_utc", "rows": [{"row", "holds", "value"}], "results": {"CASE/RUN": KEY}}
// with the value as in baseline_change.hpp. The keys name the results in the store
// (result_store.hpp) as long as the store keeps them. The history is written by machine and nobody
// approves it: it shows when a value moved, and judges nothing.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_change.hpp"

namespace slosh {

struct JudgedValue {
  BaselineValue value;
  bool holds;  // whether the verdict was "pass"

  bool operator==(const JudgedValue&) const = default;
};

// What one run of a campaign came to.
struct CampaignState {
  std::string when_utc;
  std::map<std::string, JudgedValue> rows;     // by row_name() (baseline_diff.hpp)
  std::map<std::string, std::string> results;  // "CASE/RUN" -> key
};

// The state of rows that are judged on a finite value, and of all results.
CampaignState state_of(const std::vector<CaseAssessment>& cases, const std::string& when_utc);

// Returns no states where the file does not exist. Throws ResultError (result_error.hpp) with
// FILE:LINE.
std::vector<CampaignState> read_history(const std::filesystem::path& file);

// Appends the state unless its rows and results are those of the last line. It holds FILE.lock
// meanwhile, and replaces the file as a whole. Throws ResultError; the file then stays as it is.
void append_state(const CampaignState& state, const std::filesystem::path& file);

}  // namespace slosh
