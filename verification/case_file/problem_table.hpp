// The [[problem]] tables of a campaign file; campaign_parser.hpp has their keys.
#pragma once

#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

// Throws CaseFileError, also for a problem that is one of `others` already and for one without a
// gate row, which could not fail.
ProblemDefinition read_problem(const TomlTable& table, const std::vector<KnownProblem>& known,
                               const std::vector<ProblemDefinition>& others);

std::string metric_name(ProblemMetric metric);  // as in the campaign file

}  // namespace slosh
