// The ledger of a campaign's baselines. A baseline holds values of this project's own earlier runs,
// approved by somebody for a reason. It is no reference: it shows that a number has moved, not that
// it is right. A ledger holds the approvals of one campaign and form, one line of JSON each:
//   {"campaign", "when_utc", "who", "reason", "changes": [{"row", "old", "new"}], "previous"}
// (changes as in baseline_change.hpp). `previous` is the hash of all lines before it, so that an
// approval that is altered, moved or removed later is detected. The head, a file beside the ledger,
// records the number of lines and the hash of all of them, which guards the last line too:
//   FILE.head: {"lines", "hash"}
// Lines are only ever appended: the baseline is the result of all changes in their order. The hash
// detects accidents and careless edits; somebody who rewrites the ledger and its head together
// shows up in the version control that holds both.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/baseline/baseline_change.hpp"

namespace slosh {

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
