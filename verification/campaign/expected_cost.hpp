// What a run is expected to cost before it has run.
#pragma once

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// Core-seconds, of SPH with `recommended` and of interFoam as measured on two-core machines; other
// schemes take up to five times as long, theory next to nothing (0). Orders the queue of a
// campaign, longest first, so that no long run is left alone at the end.
double expected_cost(const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh
