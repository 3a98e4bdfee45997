// Baselines: what this project's own earlier runs gave, approved by somebody for a reason. They are
// no references: they tell that a number has moved, not that it is right. A ledger holds those of
// one campaign and form as lines of JSON, one for each approval:
//   {"campaign", "when_utc", "who", "reason", "changes": [{"row", "old", "new"}], "previous"}
// old and new are {"value", "half_width_95", "lower", "upper"} or null; `previous` is the hash of
// all lines before it, so that an approval that is altered or taken out later is found. Lines are
// only ever added: the baseline is what remains of all changes, taken in their order.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh {

// A gate row's metric and its tolerance, in the row's unit.
struct BaselineValue {
  double value, half_width;            // half_width: of the 95 % interval, zero where there is none
  std::optional<double> lower, upper;  // none of a row that is to improve on another run

  bool operator==(const BaselineValue&) const = default;
};

// By the row's name (baseline_diff.hpp).
using Baseline = std::map<std::string, BaselineValue>;

struct BaselineChange {
  std::string row;
  std::optional<BaselineValue> before, after;

  bool operator==(const BaselineChange&) const = default;
};

struct Approval {
  std::string campaign, when_utc, who, reason;
  std::vector<BaselineChange> changes;
};

// A ledger that cannot be read or written, or whose lines do not follow from one another. what()
// says FILE:LINE.
struct LedgerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// An absent file holds no approval.
std::vector<Approval> read_ledger(const std::filesystem::path& file);

// Throws LedgerError where a change's old value is not what the changes before it leave.
Baseline baseline_of(const std::vector<Approval>& approvals);

// Adds a line; what is there stays byte for byte. Throws LedgerError.
void append_approval(const Approval& approval, const std::filesystem::path& file);

}  // namespace slosh
