// The mutation trials that earlier reports of a campaign made, so that a report after a change of
// one row tries that row alone. Trials are cached under everything that determines them: the
// judging program, the case except its gate rows, the results of the runs, and the row itself. Only
// reports use the cache: `slosh selftest` tries every row.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/mutation_trials.hpp"

namespace slosh {

// What a row judges, as text: its name, unit and bounds.
std::string row_identity(const GateRow& row);

class SensitivityCache {
 public:
  // Reads the file; the cache is empty where it is absent or no such file. `judge` identifies the
  // judging program by its content.
  SensitivityCache(std::filesystem::path file, std::string judge);

  // The hash of the case and its results, under which the trials of its rows are cached.
  std::string evidence_of(const CaseAssessment& assessment) const;

  std::optional<MutationTrials> find(const std::string& evidence, const GateRow& row) const;
  // Any thread may call this.
  void keep(const std::string& evidence, const GateRow& row, const MutationTrials& trials);

  // Replaces the file by all that was kept since the construction. Throws
  // std::filesystem::filesystem_error where it cannot be written.
  void write() const;

 private:
  std::filesystem::path file_;
  std::string judge_;
  std::mutex mutex_;                                   // guards kept_
  std::map<std::string, MutationTrials> read_, kept_;  // by evidence and row
};

}  // namespace slosh
