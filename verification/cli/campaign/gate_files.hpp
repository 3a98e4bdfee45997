// What the gate leaves for the machines and people that decide on a change.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/gate_documents/gate_document.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/cli/campaign/campaign_command.hpp"

namespace slosh {

// The rows with what has moved since the baseline (movements() of the cases). Places in files below
// `source` are told relative to it, as a forge that shows the change wants them.
reports::GateDocument gate_document(const AssessedCampaign& assessed,
                                    const std::vector<RowMovement>& movements,
                                    const std::filesystem::path& source);

// <directory>/junit.xml, gate.md, gate.sarif, each replaced as a whole. Throws
// std::filesystem::filesystem_error.
void write_gate_files(const reports::GateDocument& document,
                      const std::filesystem::path& directory);

}  // namespace slosh
