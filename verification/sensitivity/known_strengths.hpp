// What earlier reports of a campaign found its gate rows to detect, so that a report after a change
// of one row tries that row alone. A strength is kept under all that it was found from: the judge,
// the case but for its gate rows, what the runs left, and the row itself. Only reports take what is
// kept: `slosh selftest` tries every row.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/gate_strength.hpp"

namespace slosh {

class KnownStrengths {
 public:
  // What the file holds; nothing where it is absent or no such file. `judge` names the program that
  // judges by its content.
  KnownStrengths(std::filesystem::path file, std::string judge);

  // The strengths of a case's rows are looked up and kept under this.
  std::string evidence_of(const CaseAssessment& assessment) const;

  std::optional<GateStrength> find(const std::string& evidence, const GateRow& row) const;
  // From any thread.
  void keep(const std::string& evidence, const GateRow& row, const GateStrength& strength);

  // Replaces the file by what was kept since the construction. Throws
  // std::filesystem::filesystem_error where it cannot be written.
  void write() const;

 private:
  std::filesystem::path file_;
  std::string judge_;
  std::mutex mutex_;                                 // of what is kept
  std::map<std::string, GateStrength> read_, kept_;  // by evidence and row
};

}  // namespace slosh
