// How much a run computes, as far as that is known before it runs.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

struct RunEffort {
  double steps = 0;     // in time; of potential flow and theory the samples
  double elements = 0;  // particles, cells, nodes or modes
  // Of interFoam, pressure equations solved in each step.
  int pressure_corrections = 0;
};

// Flow so violent that it shortens the steps takes more of them, potential flow that leaves its
// range fewer. Nothing is known of an external program, and a record is only read.
RunEffort run_effort(const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh
