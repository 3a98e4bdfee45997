// Changes of a baseline as JSON, alike in ledgers and proposals.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

nlohmann::ordered_json json_of(const std::vector<BaselineChange>& changes);

// Throws nlohmann::ordered_json::exception for anything else.
std::vector<BaselineChange> changes_from(const nlohmann::ordered_json& changes);

}  // namespace slosh
