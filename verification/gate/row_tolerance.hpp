// What the gate allows a metric that a figure shows.
#pragma once

#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// By the case's first row with a limit or a range on this metric of the compared runs' quantity and
// mode, in the row's unit; nothing where there is none.
std::optional<AllowedRange> tolerance_of(const CaseDefinition& definition,
                                         const Comparison& comparison, const std::string& mode,
                                         Metric metric);

}  // namespace slosh
