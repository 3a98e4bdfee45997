// The files by which the gate reports to continuous integration and to reviewers.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/gate_documents/gate_document.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/cli/campaign/assessed_campaign.hpp"

namespace slosh {

// Returns the gate rows with their changes since the baseline (movements() of the cases). The paths
// of files below `source` are relative to it, and those of other files below the current directory
// to that, as code forges require.
reports::GateDocument gate_document(const AssessedCampaign& assessed,
                                    const std::vector<RowMovement>& movements,
                                    const std::filesystem::path& source);

// Throws OutputError where a file of write_gate_files() would replace an input.
void require_gate_places(const std::filesystem::path& directory);

// Writes <directory>/junit.xml and gate.md, each atomically. Throws
// std::filesystem::filesystem_error.
void write_gate_files(const reports::GateDocument& document,
                      const std::filesystem::path& directory);

}  // namespace slosh
