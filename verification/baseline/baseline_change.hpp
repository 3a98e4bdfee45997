// The baseline of a campaign, changes of it, and a proposal of such changes. A change reads in JSON
//   {"row", "old", "new"}, with old and new {"value", "half_width_95", "lower", "upper",
//   "uncertainty_95", "terms"} or null, and terms {"kind", "window", "inputs", "setup", "evidence",
//   "measured_with", "tags"},
// in ledgers (baseline_ledger.hpp) and proposals alike. Older ledgers record not all of it. A
// proposal lies beside the results until somebody approves it.
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

}  // namespace slosh
