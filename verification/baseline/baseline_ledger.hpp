// The ledger of a campaign's baselines. A baseline holds values of this project's own earlier runs,
// approved by somebody for a reason. It is no reference: it shows that a number has moved, not that
// it is right. A ledger holds the approvals of one campaign and form, one line of JSON each:
//   {"campaign", "when_utc", "who", "reason", "changes": [{"row", "old", "new"}], "previous"}
// `previous` is the hash of all lines before it, so that an
// approval that is altered, moved or removed later is detected. The head, a file beside the ledger,
// records the number of lines and the hash of all of them, which guards the last line too:
//   FILE.head: {"lines", "hash"}
// Lines are only ever appended: the baseline is the result of all changes in their order. The hash
// detects accidents and careless edits; somebody who rewrites the ledger and its head together
// shows up in the version control that holds both.
// A change reads in JSON
//   {"row", "old", "new"}, with old and new {"value", "half_width_95", "lower", "upper",
//   "uncertainty_95", "terms"} or null, and terms {"kind", "window", "inputs", "setup", "evidence",
//   "measured_with", "tags"},
// in ledgers and proposals alike. Older ledgers record not all of it. A proposal of changes lies
// beside the results until somebody approves it.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh {

// What a row is judged on beside its tolerance, as texts that are equal where it is the same.
struct RowTerms {
  std::string kind;    // "validation" or "regression"
  std::string window;  // "1 .. 8 s"; empty of a problem's row, as the two below
  std::string inputs;  // "amplitude +- 0.001 m, period +- 0.01 s": those declared uncertain
  // Hashes: of the case's physics and the settings of the row's runs; of all else that the case
  // declares of the row's verdict; of the settings of the runs that it was measured with, where it
  // was. Older ledgers lack the later ones.
  std::string setup;
  // What else the verdict rests on: "2 natural modes; refinement spacing: a, b; ...". Empty of a
  // problem's row, and where it is not recorded.
  std::string evidence = {};
  // "m20, m40, s (3), theory": the runs that the verdict and its interval were measured with, those
  // of an ensemble counted. Empty where it was not measured, and where it is not recorded.
  std::string measured_with = {};
  // Of the case, by which `--tag` selects it; empty where they are not recorded.
  std::vector<std::string> tags = {};

  bool operator==(const RowTerms&) const = default;
};

// A gate row's metric and its tolerance, in the row's unit.
struct BaselineValue {
  std::optional<double> value;         // nullopt where it was not measured, and of a cost
  double half_width;                   // of the 95 % interval, zero if unknown
  std::optional<double> lower, upper;  // nullopt for a row that must improve on another run
  std::optional<RowTerms> terms = {};  // nullopt: not recorded
  // The half width that the verdict rests on, infinite where a part of it is unknown; nullopt of a
  // row without a bound or a value, of a cost and of a problem, and where it is not recorded.
  std::optional<double> uncertainty = {};

  bool operator==(const BaselineValue&) const = default;
};

// The key is the row's name (baseline_diff.hpp).
using Baseline = std::map<std::string, BaselineValue>;

struct BaselineChange {
  std::string row;
  std::optional<BaselineValue> before, after;

  bool operator==(const BaselineChange&) const = default;
};

nlohmann::ordered_json json_of(const BaselineValue& value);
nlohmann::ordered_json json_of(const std::vector<BaselineChange>& changes);

// Both throw nlohmann::ordered_json::exception for anything that json_of() does not write.
BaselineValue value_from(const nlohmann::ordered_json& value);
std::vector<BaselineChange> changes_from(const nlohmann::ordered_json& changes);

// A ledger or proposal cannot be read or written, the lines of a ledger do not follow from one
// another, or it differs from what its head records. what() begins with FILE:LINE, or FILE.
struct LedgerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The changes that would make a campaign's present values its baseline.
struct Proposal {
  std::string campaign;
  std::vector<BaselineChange> changes;
};

// Both throw LedgerError.
void write_proposal(const Proposal& proposal, const std::filesystem::path& file);
Proposal read_proposal(const std::filesystem::path& file);

struct Approval {
  std::string campaign, when_utc, who, reason;
  std::vector<BaselineChange> changes;
};

// The path FILE.head.
std::filesystem::path head_of(const std::filesystem::path& ledger);

// Whether the file exists and is not empty.
bool holds_approvals(const std::filesystem::path& file);

// Returns no approvals where neither the file nor its head exists. Throws LedgerError.
std::vector<Approval> read_ledger(const std::filesystem::path& file);

// The baseline after all approvals. Throws LedgerError where a change's old value differs from the
// result of the changes before it.
Baseline baseline_of(const std::vector<Approval>& approvals);

// Appends a line and records the new head; the existing lines stay byte for byte. It holds
// FILE.lock meanwhile, so that simultaneous approvals follow one another. Throws LedgerError, also
// where the changes do not follow from the ledger's present content; nothing is written in that
// case.
void append_approval(const Approval& approval, const std::filesystem::path& file);

}  // namespace slosh
