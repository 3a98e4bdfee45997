// Baselines: what this project's own earlier runs gave, approved by somebody for a reason. They are
// no references: they tell that a number has moved, not that it is right. A ledger holds those of
// one campaign and form as lines of JSON, one for each approval:
//   {"campaign", "when_utc", "who", "reason", "changes": [{"row", "old", "new"}], "previous"}
// old and new are {"value", "half_width_95", "lower", "upper"} or null; `previous` is the hash of
// all lines before it, so that an approval that is altered, moved or taken out later is found. The
// head, a file beside the ledger, records the number of lines and the hash of all of them:
//   FILE.head: {"lines", "hash"}
// so that the last line is held too. Lines are only ever added: the baseline is what remains of all
// changes, taken in their order. The hash finds accidents and careless edits; whoever rewrites the
// ledger and its head together is seen in the version control that holds both.
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

// A ledger that cannot be read or written, whose lines do not follow from one another, or that is
// not the one its head records. what() says FILE:LINE, or FILE.
struct LedgerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// FILE.head
std::filesystem::path head_of(const std::filesystem::path& ledger);

// Whether the file is there and not empty.
bool holds_approvals(const std::filesystem::path& file);

// An absent file without a head holds no approval.
std::vector<Approval> read_ledger(const std::filesystem::path& file);

// Throws LedgerError where a change's old value is not what the changes before it leave.
Baseline baseline_of(const std::vector<Approval>& approvals);

// Adds a line and records the new head; what is there stays byte for byte. Holds FILE.lock
// meanwhile, so that approvals at one time follow one another. Throws LedgerError, also where the
// changes do not follow from what the ledger holds by then: nothing is written in that case.
void append_approval(const Approval& approval, const std::filesystem::path& file);

}  // namespace slosh
